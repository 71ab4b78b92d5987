// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/hash.h>

#include <cstdint>
#include <cstdio>
#include <zlib.h>

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
    return checksum_of_pieces({check_piece(key), check_piece(text)});
  }


  CheckedPiece
  check_piece(const std::string_view piece)
  {
    const uLong crc =
      crc32_z(0, reinterpret_cast<const Bytef *>(piece.data()), piece.size());
    return {static_cast<std::uint32_t>(crc), piece.size()};
  }


  CheckedPiece
  joined(const std::vector<CheckedPiece> &pieces)
  {
    uLong         crc  = 0;
    std::uint64_t size = 0;
    for (const CheckedPiece &piece : pieces)
      {
        crc = crc32_combine(crc, piece.crc, static_cast<z_off_t>(piece.size));
        size += piece.size;
      }
    return {static_cast<std::uint32_t>(crc), size};
  }


  std::string
  checksum_of_pieces(const std::vector<CheckedPiece> &pieces)
  {
    char digits[9];
    std::snprintf(digits,
                  sizeof digits,
                  "%08lx",
                  static_cast<unsigned long>(joined(pieces).crc));
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
