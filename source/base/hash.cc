// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/hash.h>

#include <boost/crc.hpp>
#include <cstdint>
#include <cstdio>

namespace Waker
{
  std::string
  hash_of_text(const std::string &text)
  {
    std::uint64_t hash = 14695981039346656037ull;
    for (const char c : text)
      hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;

    char digits[17];
    std::snprintf(digits,
                  sizeof digits,
                  "%016llx",
                  static_cast<unsigned long long>(hash));
    return digits;
  }


  std::string
  checksum_of_text(const std::string &text, const std::string &key)
  {
    boost::crc_32_type crc;
    crc.process_bytes(key.data(), key.size());
    crc.process_bytes(text.data(), text.size());

    char digits[9];
    std::snprintf(digits,
                  sizeof digits,
                  "%08lx",
                  static_cast<unsigned long>(crc.checksum()));
    return digits;
  }


  namespace
  {
    const std::string seal_begin = ",\"crc\":\"";
    const std::string seal_end   = "\"}";
    const std::size_t n_digits   = 8;
  } // namespace


  std::string
  sealed(const std::string &object, const std::string &key)
  {
    const std::string text = object.substr(0, object.size() - 1);
    return text + seal_begin + checksum_of_text(text, key) + seal_end;
  }


  Seal
  check_seal(const std::string &line, const std::string &key)
  {
    const std::size_t size = seal_begin.size() + n_digits + seal_end.size();
    if (line.size() <= size ||
        line.compare(line.size() - size, seal_begin.size(), seal_begin) != 0)
      return Seal::none;
    const std::string text = line.substr(0, line.size() - size);
    return line.substr(text.size()) ==
               seal_begin + checksum_of_text(text, key) + seal_end
             ? Seal::whole
             : Seal::broken;
  }
} // namespace Waker
