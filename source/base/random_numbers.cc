// SPDX-License-Identifier: LGPL-2.1-or-later
// Compiled with -ffp-contract=off (CMakeLists.txt): a fused multiply-add rounds
// once where the standard's product and sum round twice, and not every
// processor has it.
#include <deal.II/base/exceptions.h>

#include <waker/base/random_numbers.h>

#include <Random123/philox.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace Waker
{
  using namespace dealii;

  namespace
  {
    /// c[0] + c[1] x + ... + c[n-1] x^(n-1).
    template <std::size_t n>
    inline double
    polynomial(const std::array<double, n> &c, const double x)
    {
      double sum = c[n - 1];
      for (std::size_t i = n - 1; i-- > 0;)
        sum = sum * x + c[i];
      return sum;
    }


    double
    from_bits(const std::uint64_t bits)
    {
      double x;
      std::memcpy(&x, &bits, sizeof x);
      return x;
    }


    /**
     * Natural logarithm of a normal number x > 0: x = m 2^e with
     * sqrt(1/2) <= m < sqrt(2), and log m = 2 atanh s, s = (m - 1) / (m + 1),
     * |s| < 0.172, by its series. Without branches and calls, so that loops
     * over it are vectorised.
     */
    inline double
    logarithm(const double x)
    {
      constexpr std::uint64_t one       = 0x3ff0000000000000; // bits of 1
      constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcd; // of sqrt(1/2)
      constexpr std::uint64_t magic     = 0x4330000000000000; // of 2^52

      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof bits);
      bits += one - root_half;
      const double e = from_bits(bits >> 52 | magic) - (0x1p52 + 1023.);
      const double m = from_bits((bits & 0x000fffffffffffff) + root_half);

      constexpr std::array<double, 12> atanh_series{{1.,
                                                     1. / 3.,
                                                     1. / 5.,
                                                     1. / 7.,
                                                     1. / 9.,
                                                     1. / 11.,
                                                     1. / 13.,
                                                     1. / 15.,
                                                     1. / 17.,
                                                     1. / 19.,
                                                     1. / 21.,
                                                     1. / 23.}};
      // log 2 in two parts: the first ends in zeros, so its product with e is
      // exact.
      constexpr double log_2_high = 0x1.62e42fee00000p-1;
      constexpr double log_2_low  = 0x1.a39ef35793c76p-33;

      const double s = (m - 1.) / (m + 1.);
      return e * log_2_high +
             (2. * s * polynomial(atanh_series, s * s) + e * log_2_low);
    }


    // Algorithm AS 241, PPND16 (Wichura 1988): numerators and denominators for
    // the middle, the tails and the far tails.
    constexpr std::array<double, 8> a{{3.3871328727963666080e0,
                                       1.3314166789178437745e2,
                                       1.9715909503065514427e3,
                                       1.3731693765509461125e4,
                                       4.5921953931549871457e4,
                                       6.7265770927008700853e4,
                                       3.3430575583588128105e4,
                                       2.5090809287301226727e3}};
    constexpr std::array<double, 8> b{{1.0,
                                       4.2313330701600911252e1,
                                       6.8718700749205790830e2,
                                       5.3941960214247511077e3,
                                       2.1213794301586595867e4,
                                       3.9307895800092710610e4,
                                       2.8729085735721942674e4,
                                       5.2264952788528545610e3}};
    constexpr std::array<double, 8> c{{1.42343711074968357734e0,
                                       4.63033784615654529590e0,
                                       5.76949722146069140550e0,
                                       3.64784832476320460504e0,
                                       1.27045825245236838258e0,
                                       2.41780725177450611770e-1,
                                       2.27238449892691845833e-2,
                                       7.74545014278341407640e-4}};
    constexpr std::array<double, 8> d{{1.0,
                                       2.05319162663775882187e0,
                                       1.67638483018380384940e0,
                                       6.89767334985100004550e-1,
                                       1.48103976427480074590e-1,
                                       1.51986665636164571966e-2,
                                       5.47593808499534494600e-4,
                                       1.05075007164441684324e-9}};
    constexpr std::array<double, 8> e{{6.65790464350110377720e0,
                                       5.46378491116411436990e0,
                                       1.78482653991729133580e0,
                                       2.96560571828504891230e-1,
                                       2.65321895265761230930e-2,
                                       1.24266094738807843860e-3,
                                       2.71155556874348757815e-5,
                                       2.01033439929228813265e-7}};
    constexpr std::array<double, 8> f{{1.0,
                                       5.99832206555887937690e-1,
                                       1.36929880922735805310e-1,
                                       1.48753612908506148525e-2,
                                       7.86869131145613259100e-4,
                                       1.84631831751005468180e-5,
                                       1.42151175831644588870e-7,
                                       2.04426310338993978564e-15}};


    /// q = p - 1/2, |q| <= 0.425.
    inline double
    middle(const double q)
    {
      const double r = 0.180625 - q * q;
      return q * polynomial(a, r) / polynomial(b, r);
    }


    /// r = sqrt(-log p) <= 5.
    inline double
    tail(const double r)
    {
      return polynomial(c, r - 1.6) / polynomial(d, r - 1.6);
    }


    /// r = sqrt(-log p) > 5.
    inline double
    far_tail(const double r)
    {
      return polynomial(e, r - 5.) / polynomial(f, r - 5.);
    }


    /// Probabilities to quantiles, n of them at most. Three plain loops that
    /// the compiler vectorises, instead of one with branches.
    constexpr std::size_t chunk = 256;

    void
    quantiles(const std::size_t n, double *const values)
    {
      std::array<double, chunk>      p, r;
      std::array<std::size_t, chunk> place;

      std::copy_n(values, n, p.begin());
      for (std::size_t i = 0; i < n; ++i)
        values[i] = middle(p[i] - 0.5);

      std::size_t n_tail = 0;
      for (std::size_t i = 0; i < n; ++i)
        {
          place[n_tail] = i;
          r[n_tail]     = std::min(p[i], 1. - p[i]);
          n_tail += std::fabs(p[i] - 0.5) > 0.425;
        }
      std::array<double, chunk> z;
      for (std::size_t i = 0; i < n_tail; ++i)
        {
          r[i] = std::sqrt(-logarithm(r[i]));
          z[i] = tail(r[i]);
        }
      for (std::size_t i = 0; i < n_tail; ++i)
        {
          const double size = r[i] <= 5. ? z[i] : far_tail(r[i]);
          values[place[i]]  = p[place[i]] < 0.5 ? -size : size;
        }
    }


    /// A number in (0, 1) from 64 random bits: the middle of one of 2^52
    /// intervals. Exact, and p and 1 - p are equally likely.
    inline double
    open_unit_interval(const std::uint32_t low, const std::uint32_t high)
    {
      const std::uint64_t bits = (std::uint64_t(high) << 32 | low) >> 12;
      return (static_cast<double>(bits) + 0.5) * 0x1p-52;
    }
  } // namespace


  void
  white_noise(const NoiseKey     &key,
              const std::uint64_t first,
              const std::size_t   n,
              double             *values)
  {
    // A block of 128 bits makes two numbers; blocks are counted in 32 bits.
    Assert(first + n <= std::uint64_t(1) << 33,
           ExcMessage("A stream has 2^33 numbers only."));

    using Generator = r123::Philox4x32; // ten rounds
    const Generator           generator;
    const Generator::key_type seed = {
      {static_cast<std::uint32_t>(key.seed),
       static_cast<std::uint32_t>(key.seed >> 32)}};

    for (std::size_t begin = 0; begin < n; begin += chunk)
      {
        const std::size_t end = std::min(n, begin + chunk);
        for (std::size_t i = begin; i < end;)
          {
            const std::uint64_t       number  = first + i;
            const Generator::ctr_type counter = {
              {static_cast<std::uint32_t>(number / 2),
               key.stream,
               static_cast<std::uint32_t>(key.realisation),
               static_cast<std::uint32_t>(key.realisation >> 32)}};
            const Generator::ctr_type bits = generator(counter, seed);
            if (number % 2 == 0)
              values[i++] = open_unit_interval(bits[0], bits[1]);
            if (i < end)
              values[i++] = open_unit_interval(bits[2], bits[3]);
          }
        quantiles(end - begin, values + begin);
      }
  }


  double
  standard_normal_quantile(const double p)
  {
    Assert(p > 0. && p < 1., ExcMessage("A probability between 0 and 1."));
    const double q = p - 0.5;
    if (std::fabs(q) <= 0.425)
      return middle(q);

    const double x = std::min(p, 1. - p);
    // Numbers below 2^-1022 have no exponent of their own.
    const double minus_log = x < 0x1p-1022
                               ? -(logarithm(x * 0x1p100) - logarithm(0x1p100))
                               : -logarithm(x);
    const double r         = std::sqrt(minus_log);
    const double z         = r <= 5. ? tail(r) : far_tail(r);
    return q < 0. ? -z : z;
  }


  double
  standard_normal_distribution(const double z)
  {
    return 0.5 * std::erfc(-z * 0.70710678118654752440);
  }
} // namespace Waker
