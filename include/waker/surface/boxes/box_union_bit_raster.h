// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_surface_boxes_box_union_bit_raster_h
#define waker_surface_boxes_box_union_bit_raster_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace Waker
{
  /**
   * A raster of bits, x fastest, with the operations of morphology: whole words
   * at a time, in a number of passes that grows with the logarithm of the
   * distance. Beyond the raster all bits are zero.
   *
   * Rows are whole numbers of 512 bits long, so that loops need no remainder.
   */
  class BitRaster
  {
  public:
    using Word = std::uint64_t;

    /// All bits zero.
    void
    reinit(const std::size_t n_columns, const std::size_t n_rows);

    /// Words in a row of so many bits.
    static std::size_t
    words(const std::size_t n_columns)
    {
      return (n_columns + 511) / 512 * 8;
    }

    std::size_t
    words_per_row() const
    {
      return n_words;
    }

    Word *
    row(const std::size_t j)
    {
      return bits.data() + j * n_words;
    }

    const Word *
    row(const std::size_t j) const
    {
      return bits.data() + j * n_words;
    }

    void
    set(const unsigned int i, const unsigned int j)
    {
      bits[j * n_words + (i >> 6)] |= Word(1) << (i & 63u);
    }

    bool
    test(const unsigned int i, const unsigned int j) const
    {
      return bits[j * n_words + (i >> 6)] >> (i & 63u) & 1u;
    }

    /// Set the bits from begin to before end in a row.
    void
    set(const int begin, const int end, const std::size_t row);

    /// Set the next `up` bits above, and the next `down` bits below, each bit
    /// that is set.
    void
    dilate_x(const unsigned int up, const unsigned int down);

    /// Set the next `up` bits above each bit that is set, then clear those of
    /// which one of the next `down` bits above is not set.
    void
    dilate_and_erode_x(const unsigned int up, const unsigned int down);

    /// The same along y, upwards only.
    void
    dilate_y(const unsigned int up);

    /// Set the zeros in columns of at most `gap` between ones.
    void
    close_y(const unsigned int gap);

  private:
    void
    load(const std::size_t row);

    void
    store(const std::size_t row);

    // Of the row that is loaded.
    void
    dilate_up(const unsigned int distance);
    void
    dilate_down(const unsigned int distance);
    void
    erode_down(const unsigned int distance);

    std::size_t       n_words = 0;
    std::size_t       n_rows  = 0;
    std::vector<Word> bits;
    std::vector<Word> copy;

    // A row, with a word of zeros at either end, and room for the next.
    std::vector<Word> loaded;
    std::vector<Word> next;
  };
} // namespace Waker

#endif
