// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_random_numbers_h
#define waker_base_random_numbers_h

#include <cstddef>
#include <cstdint>

namespace Waker
{
  /// Which white noise: the same three numbers give the same noise on every
  /// machine, whatever has been drawn before.
  struct NoiseKey
  {
    std::uint64_t seed        = 0; // of the campaign
    std::uint64_t realisation = 0;
    std::uint32_t stream      = 0; // one per use: the fields have stream 0
  };

  /**
   * Independent standard normal numbers: number `first + i` of the sequence
   * that the key stands for goes to values[i], i < n. Bit-identical everywhere:
   * Philox 4x32-10 (Salmon et al. 2011) counts, standard_normal_quantile()
   * transforms.
   */
  void
  white_noise(const NoiseKey     &key,
              const std::uint64_t first,
              const std::size_t   n,
              double             *values);

  /**
   * z with Phi(z) = p, 0 < p < 1, relative error below 1e-15 (algorithm AS 241,
   * Wichura 1988). Only additions, products, divisions and square roots, and a
   * logarithm of our own made of them: the C library's may differ in the last
   * bit from machine to machine.
   */
  double
  standard_normal_quantile(const double p);

  /// Phi(z).
  double
  standard_normal_distribution(const double z);
} // namespace Waker

#endif
