// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_hash_h
#define waker_base_hash_h

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace Waker
{
  /// FNV-1a, 64 bit, as 16 hexadecimal digits: tells texts apart, protects
  /// against nothing.
  std::string
  hash_of_text(const std::string &text);

  /// CRC-32, as 8 hexadecimal digits, of `key` and `text` one after the other:
  /// finds every damage of up to 32 bits in a row, and others but for one in
  /// four thousand millions. The key says what the text belongs to.
  std::string
  checksum_of_text(const std::string &text, const std::string &key = "");

  /// What the checksum of a text needs of a piece of it.
  struct CheckedPiece
  {
    std::uint32_t crc;
    std::uint64_t size; // bytes
  };

  CheckedPiece
  check_piece(const std::string_view piece);

  /// The pieces, one after the other, as one.
  CheckedPiece
  joined(const std::vector<CheckedPiece> &pieces);

  /// checksum_of_text() of the pieces, one after the other.
  std::string
  checksum_of_pieces(const std::vector<CheckedPiece> &pieces);

  /**
   * A JSON object on one line with the checksum of the rest of it and of `key`
   * as its last member, "crc".
   *
   * @param object "{...}" with at least one member, without "crc"
   */
  std::string
  sealed(const std::string &object, const std::string &key);

  enum class Seal
  {
    none,   // of an earlier version of the program, or not of sealed()
    broken, // damaged, or of another key
    whole
  };

  /// Of a line without its end.
  Seal
  check_seal(const std::string &line, const std::string &key);
} // namespace Waker

#endif
