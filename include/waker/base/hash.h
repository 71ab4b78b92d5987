// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_hash_h
#define waker_base_hash_h

#include <string>

namespace Waker
{
  /// FNV-1a, 64 bit, as 16 hexadecimal digits: tells texts apart, protects
  /// against nothing.
  std::string
  hash_of_text(const std::string &text);
} // namespace Waker

#endif
