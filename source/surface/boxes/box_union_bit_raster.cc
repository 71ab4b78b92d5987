// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/surface/boxes/box_union_bit_raster.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    using Word = BitRaster::Word;

    /// Cover a distance in steps that double: call step(s) so that the sum of
    /// all s is the distance and none exceeds one plus the sum before it.
    template <typename Step>
    void
    double_up_to(const unsigned int distance, const Step &step)
    {
      for (unsigned int done = 0; done < distance;)
        {
          const unsigned int s = std::min({done + 1, distance - done, 63u});
          step(s);
          done += s;
        }
    }
  } // namespace



  void
  BitRaster::reinit(const std::size_t n_columns, const std::size_t new_n_rows)
  {
    n_words = words(n_columns);
    n_rows  = new_n_rows;
    bits.assign(n_words * n_rows, 0);
    loaded.assign(n_words + 2, 0);
    next.assign(n_words + 2, 0);
  }



  void
  BitRaster::set(const int begin, const int end, const std::size_t j)
  {
    if (begin >= end)
      return;
    Word *const r     = row(j);
    const int   first = begin >> 6;
    const int   last  = (end - 1) >> 6;
    const Word  head  = ~Word(0) << (begin & 63);
    const Word  tail  = ~Word(0) >> (63 - ((end - 1) & 63));
    if (first == last)
      {
        r[first] |= head & tail;
        return;
      }
    r[first] |= head;
    std::fill(r + first + 1, r + last, ~Word(0));
    r[last] |= tail;
  }



  void
  BitRaster::load(const std::size_t j)
  {
    std::copy_n(row(j), n_words, loaded.data() + 1);
  }



  void
  BitRaster::store(const std::size_t j)
  {
    std::copy_n(loaded.data() + 1, n_words, row(j));
  }



  void
  BitRaster::dilate_up(const unsigned int distance)
  {
    const std::size_t n = n_words;
    double_up_to(distance, [this, n](const unsigned int s) {
      const Word *const __restrict in = loaded.data() + 1;
      Word *const __restrict out      = next.data() + 1;
      for (std::size_t w = 0; w < n; ++w)
        out[w] = in[w] | in[w] << s | in[w - 1] >> (64 - s);
      loaded.swap(next);
    });
  }



  void
  BitRaster::dilate_down(const unsigned int distance)
  {
    const std::size_t n = n_words;
    double_up_to(distance, [this, n](const unsigned int s) {
      const Word *const __restrict in = loaded.data() + 1;
      Word *const __restrict out      = next.data() + 1;
      for (std::size_t w = 0; w < n; ++w)
        out[w] = in[w] | in[w] >> s | in[w + 1] << (64 - s);
      loaded.swap(next);
    });
  }



  void
  BitRaster::erode_down(const unsigned int distance)
  {
    const std::size_t n = n_words;
    double_up_to(distance, [this, n](const unsigned int s) {
      const Word *const __restrict in = loaded.data() + 1;
      Word *const __restrict out      = next.data() + 1;
      for (std::size_t w = 0; w < n; ++w)
        out[w] = in[w] & (in[w] >> s | in[w + 1] << (64 - s));
      loaded.swap(next);
    });
  }



  void
  BitRaster::dilate_x(const unsigned int up, const unsigned int down)
  {
    for (std::size_t j = 0; j < n_rows; ++j)
      {
        load(j);
        dilate_up(up);
        dilate_down(down);
        store(j);
      }
  }



  void
  BitRaster::dilate_and_erode_x(const unsigned int up, const unsigned int down)
  {
    for (std::size_t j = 0; j < n_rows; ++j)
      {
        load(j);
        dilate_up(up);
        erode_down(down);
        store(j);
      }
  }



  void
  BitRaster::dilate_y(const unsigned int up)
  {
    const std::size_t n = n_words;
    double_up_to(up, [this, n](const unsigned int s) {
      for (std::size_t j = n_rows; j-- > s;)
        {
          Word *const __restrict to         = row(j);
          const Word *const __restrict from = row(j - s);
          for (std::size_t w = 0; w < n; ++w)
            to[w] |= from[w];
        }
    });
  }



  void
  BitRaster::close_y(const unsigned int gap)
  {
    if (gap == 0)
      return;
    copy = bits;
    dilate_y(gap);
    const std::size_t n = n_words;
    double_up_to(gap, [this, n](const unsigned int s) {
      for (std::size_t j = 0; j < n_rows; ++j)
        {
          Word *const __restrict to = row(j);
          if (j + s >= n_rows)
            {
              std::fill_n(to, n, 0);
              continue;
            }
          const Word *const __restrict from = row(j + s);
          for (std::size_t w = 0; w < n; ++w)
            to[w] &= from[w];
        }
    });
    for (std::size_t w = 0; w < bits.size(); ++w)
      bits[w] |= copy[w];
  }
} // namespace Waker
