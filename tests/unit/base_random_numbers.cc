// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/random_numbers.h>

#include <array>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <vector>

namespace base_random_numbers
{
  namespace
  {
    using namespace Waker;

    std::vector<double>
    noise(const NoiseKey &key, const std::uint64_t first, const std::size_t n)
    {
      std::vector<double> values(n);
      white_noise(key, first, n, values.data());
      return values;
    }


    NoiseKey
    key(const std::uint64_t seed,
        const std::uint64_t realisation,
        const std::uint32_t stream)
    {
      NoiseKey k;
      k.seed        = seed;
      k.realisation = realisation;
      k.stream      = stream;
      return k;
    }


    /// The number that two words of Philox stand for.
    double
    of_words(const std::uint32_t low, const std::uint32_t high)
    {
      const std::uint64_t k = (std::uint64_t(high) << 32 | low) >> 12;
      return standard_normal_quantile((double(k) + 0.5) / 4503599627370496.);
    }


    double
    correlation(const std::vector<double> &a, const std::vector<double> &b)
    {
      double sum = 0.;
      for (std::size_t i = 0; i < a.size(); ++i)
        sum += a[i] * b[i];
      return sum / a.size();
    }


    // The vectors of Random123's kat_vectors for philox4x32 10.
    TEST(RandomNumbers, philox_known_answers)
    {
      const std::vector<double> zeros = noise(key(0, 0, 0), 0, 2);
      EXPECT_EQ(zeros[0], of_words(0x6627e8d5, 0xe169c58d));
      EXPECT_EQ(zeros[1], of_words(0xbc57ac4c, 0x9b00dbd8));

      // The digits of pi: counter 243f6a88 85a308d3 13198a2e 03707344, key
      // a4093822 299f31d0.
      const std::vector<double> pi =
        noise(key(0x299f31d0a4093822, 0x0370734413198a2e, 0x85a308d3),
              2 * std::uint64_t(0x243f6a88),
              2);
      EXPECT_EQ(pi[0], of_words(0xd16cfe09, 0x94fdcceb));
      EXPECT_EQ(pi[1], of_words(0x5001e420, 0x24126ea1));
    }


    // If this fails, the numbers of all campaigns have changed, or the compiler
    // contracts products and sums.
    TEST(RandomNumbers, noise_is_the_same_bits_everywhere)
    {
      const std::array<double, 20> expected{
        {-0x1.edfc5e692c021p-1, -0x1.52d34a5f93025p-1, -0x1.9ddbe5d0eb4dcp-2,
         0x1.ae6bc7d66115ep-3,  -0x1.335574a1b7f89p+0, -0x1.961fe197a281ap-6,
         -0x1.9db7eb613308ap+0, -0x1.a6bd097c7a96fp-1, -0x1.01d5215655p-2,
         0x1.4a0b0ec9d25b6p-1,  0x1.538031ce50c47p-4,  -0x1.4f68cfc31ff95p+0,
         0x1.ca90ebad55853p+0,  0x1.5a2aac421516dp-4,  -0x1.d9f0fe75d4f75p-1,
         -0x1.00915b1e197dp-1,  0x1.3095235e83dc2p-4,  0x1.817d7e15ed271p+0,
         -0x1.556821c714b81p-1, -0x1.2819076ee756fp+0}};
      const std::vector<double> values = noise(key(5, 1234, 0), 1000, 20);
      for (unsigned int i = 0; i < 20; ++i)
        EXPECT_EQ(values[i], expected[i]) << i;

      // The middle and the tails, of the vectorised and the single transform.
      const std::vector<double> many = noise(key(5, 1234, 0), 0, 20000);
      std::uint64_t             hash = 1469598103934665603u;
      for (const double x : many)
        {
          std::uint64_t bits;
          static_assert(sizeof bits == sizeof x);
          std::memcpy(&bits, &x, sizeof x);
          hash = (hash ^ bits) * 1099511628211u;
        }
      EXPECT_EQ(hash, 5170212474489017271u);
    }


    TEST(RandomNumbers, any_range_equals_the_whole)
    {
      const std::vector<double> whole = noise(key(3, 7, 1), 0, 2000);
      for (const std::size_t first : {0, 1, 2, 255, 256, 257, 1001})
        for (const std::size_t n : {0, 1, 2, 3, 255, 256, 257, 700})
          {
            const std::vector<double> part = noise(key(3, 7, 1), first, n);
            for (std::size_t i = 0; i < n; ++i)
              ASSERT_EQ(part[i], whole[first + i]) << first << ' ' << n;
          }
    }


    TEST(RandomNumbers, quantile_is_exact_to_1e_15)
    {
      using Real         = long double;
      const auto compare = [](const double p) {
        const Real x = p <= 0.5 ? Real(p) : 1.L - Real(p);
        const Real z = (p <= 0.5 ? -1.L : 1.L) * std::sqrt(2.L) *
                       boost::math::erfc_inv(2.L * x);
        const double q = standard_normal_quantile(p);
        EXPECT_LE(std::fabs(double((q - z) / z)), 1e-15) << p;
      };
      for (int i = 1; i < 2000; ++i)
        if (i != 1000)
          compare(i / 2000.);
      for (double p = 0.3; p > 1e-300; p *= 0.37)
        {
          compare(p);
          if (p > 1e-15)
            compare(1. - p);
        }
      for (int e = 2; e < 30; ++e)
        {
          compare(0.5 + std::ldexp(1., -e));
          compare(0.5 - std::ldexp(1., -e));
        }
      // Where one formula follows another, the extremes of white noise, and the
      // smallest number of all.
      for (const double p : {0.075, 0.925, std::exp(-25.)})
        for (const double factor : {1. - 1e-12, 1. - 2e-16, 1., 1. + 3e-16})
          compare(p * factor);
      compare(0x1p-53);
      compare(1. - 0x1p-53);
      compare(1e-310);
      EXPECT_EQ(standard_normal_quantile(0.5), 0.);
    }


    // The transform of white_noise() works on blocks, that of one number does
    // not: the same numbers?
    TEST(RandomNumbers, noise_equals_the_quantile_of_its_probability)
    {
      const std::vector<double> values = noise(key(8, 0, 0), 0, 100000);
      double                    sum = 0., worst = 0.;
      for (const double z : values)
        {
          const double p    = standard_normal_distribution(-std::fabs(z));
          const double back = -standard_normal_quantile(p);
          worst             = std::max(worst, std::fabs(back - std::fabs(z)));
          sum += p;
        }
      EXPECT_LT(worst, 1e-14);
      // p is uniform on (0, 1/2): 4.5 standard errors.
      EXPECT_NEAR(sum / 1e5, 0.25, 4.5 * 0.5 / std::sqrt(12. * 1e5));
    }


    TEST(RandomNumbers, noise_is_standard_normal)
    {
      const std::size_t            n      = 1000000;
      const std::vector<double>    values = noise(key(1, 0, 0), 0, n);
      std::array<double, 5>        moment{};
      std::array<std::size_t, 100> count{};
      for (const double z : values)
        {
          double power = 1.;
          for (double &m : moment)
            {
              m += power / n;
              power *= z;
            }
          ++count[static_cast<std::size_t>(100. *
                                           standard_normal_distribution(z))];
        }
      // 4.5 standard errors each (probability of a false alarm 7e-6); the
      // variances of z, z^2, z^3, z^4 are 1, 2, 15, 96.
      const double error = 4.5 / std::sqrt(double(n));
      EXPECT_NEAR(moment[1], 0., error);
      EXPECT_NEAR(moment[2], 1., error * std::sqrt(2.));
      EXPECT_NEAR(moment[3], 0., error * std::sqrt(15.));
      EXPECT_NEAR(moment[4], 3., error * std::sqrt(96.));

      // chi^2 with 99 degrees of freedom: 99 +- 14, its 1 - 1e-5 quantile 172.
      double chi2 = 0.;
      for (const std::size_t c : count)
        chi2 += (c - n / 100.) * (c - n / 100.) / (n / 100.);
      EXPECT_LT(chi2, 172.);
    }


    TEST(RandomNumbers, other_keys_are_independent)
    {
      const std::size_t                n = 40000;
      std::vector<std::vector<double>> sequences;
      for (const std::uint64_t seed : {1ul, 2ul, 1ul << 32})
        for (const std::uint64_t realisation : {0ul, 1ul, 1ul << 32})
          for (const std::uint32_t stream : {0u, 1u})
            sequences.push_back(noise(key(seed, realisation, stream), 0, n));
      // And neighbours in a sequence.
      for (const std::uint64_t lag : {1, 2, 3, 240, 480})
        sequences.push_back(noise(key(1, 0, 0), lag, n));

      // 253 pairs and 253 of squares; 5 standard errors: false alarm 3e-4.
      const double bound = 5. / std::sqrt(double(n));
      for (std::size_t a = 0; a < sequences.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
          {
            EXPECT_LT(std::fabs(correlation(sequences[a], sequences[b])), bound)
              << a << ' ' << b;
            std::vector<double> a2(n), b2(n);
            for (std::size_t i = 0; i < n; ++i)
              {
                a2[i] = (sequences[a][i] * sequences[a][i] - 1.) / 2.;
                b2[i] = (sequences[b][i] * sequences[b][i] - 1.);
              }
            EXPECT_LT(std::fabs(correlation(a2, b2)), bound) << a << ' ' << b;
          }
    }
  } // namespace
} // namespace base_random_numbers
