// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/hash.h>

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
} // namespace Waker
