// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/choice.h>
#include <waker/base/errors.h>
#include <waker/base/random_numbers.h>
#include <waker/fields/marginal.h>

#include "user_errors.h"
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace fields_marginal
{
  namespace
  {
    using namespace Waker;
    using Kind = Marginal::Kind;

    const double infinity = std::numeric_limits<double>::infinity();

    struct Moments
    {
      double mean, sd;
    };


    /// Of value(z) for a standard normal z, by the trapezoidal rule.
    Moments
    moments(const Marginal &marginal, const double mean, const double sd)
    {
      const double dz = 1e-3, scale = 1. / std::sqrt(2. * std::acos(-1.));
      double       first = 0., second = 0.;
      for (int i = -9000; i <= 9000; ++i)
        {
          const double z = i * dz, x = marginal.value(z, mean, sd) - mean;
          const double w = dz * scale * std::exp(-0.5 * z * z);
          first += w * x;
          second += w * x * x;
        }
      return {mean + first, std::sqrt(second - first * first)};
    }


    TEST(Marginal, normal_is_cut_off_at_its_limits)
    {
      // Chapter 5: mean 13 kPa, coefficient of variation 0.20: at -5.
      const Marginal normal(Kind::normal);
      EXPECT_DOUBLE_EQ(normal.value(1.5, 13., 2.6), 16.9);
      EXPECT_EQ(normal.value(-5.001, 13., 2.6), 0.);
      EXPECT_GT(normal.value(-4.999, 13., 2.6), 0.);
      EXPECT_NEAR(standard_normal_distribution(-5.), 2.866516e-7, 1e-13);
      EXPECT_NEAR(standard_normal_distribution(-4.), 3.167124e-5, 1e-11);

      const Marginal between(Kind::normal, 10., 20.);
      EXPECT_EQ(between.value(5., 13., 2.6), 20.);
      EXPECT_EQ(between.value(-5., 13., 2.6), 10.);
      EXPECT_EQ(Marginal(Kind::normal, -infinity).value(-10., 1., 1.), -9.);
    }


    TEST(Marginal, lognormal_has_the_given_moments)
    {
      const Marginal lognormal(Kind::lognormal);
      for (const double sd : {0.1, 2.6, 8.})
        {
          const Moments m = moments(lognormal, 13., sd);
          EXPECT_NEAR(m.mean, 13., 1e-11);
          EXPECT_NEAR(m.sd, sd, 1e-11);
        }
      EXPECT_NEAR(lognormal.value(0., 13., 2.6), 13. / std::sqrt(1.04), 1e-13);
      EXPECT_EQ(Marginal(Kind::lognormal, 5., 20.).value(4., 13., 2.6), 20.);
    }


    TEST(Marginal, beta_has_the_given_moments)
    {
      const Marginal beta(Kind::beta, 2., 30.);
      const Moments  m = moments(beta, 13., 4.);
      EXPECT_NEAR(m.mean, 13., 1e-11);
      EXPECT_NEAR(m.sd, 4., 1e-11);

      // Mean 1/2 and variance 1/12 of the unit interval: the uniform
      // distribution, whose quantile function is Phi.
      const Marginal uniform(Kind::beta, 0., 1.);
      for (const double z : {-6., -1., 0., 0.3, 4.})
        EXPECT_NEAR(uniform.value(z, 0.5, std::sqrt(1. / 12.)) /
                      standard_normal_distribution(z),
                    1.,
                    1e-10);
    }


    TEST(Marginal, truncated_normal_also_far_out)
    {
      // Its definition: P(X < x) = (Phi(x) - Phi(from)) / (Phi(to) -
      // Phi(from)).
      const Marginal truncated(Kind::truncated_normal, 10., 14.);
      const auto     score = [](const double x) { return (x - 13.) / 2.6; };
      const double   from  = standard_normal_distribution(score(10.));
      const double   to    = standard_normal_distribution(score(14.));
      for (const double z : {-3., -0.5, 0., 1., 3.})
        {
          const double x = truncated.value(z, 13., 2.6);
          EXPECT_NEAR((standard_normal_distribution(score(x)) - from) /
                        (to - from),
                      standard_normal_distribution(z),
                      1e-13);
        }

      // Beyond s standard deviations from its mean the normal distribution is
      // nearly exponential: P(X > x) = Phi(-x) / Phi(-s), from either side.
      for (const double s : {8., 20., 35.})
        for (const double z : {-7., -1., 0., 2., 7.})
          {
            const Marginal above(Kind::truncated_normal, s);
            const Marginal below(Kind::truncated_normal, -infinity, -s);
            const double   x = above.value(z, 0., 1.);
            EXPECT_GE(x, s);
            EXPECT_NEAR(standard_normal_distribution(-x) /
                          standard_normal_distribution(-s) /
                          standard_normal_distribution(-z),
                        1.,
                        1e-10)
              << s << ' ' << z;
            EXPECT_NEAR(below.value(-z, 0., 1.), -x, 1e-12 * x);
          }
    }


    TEST(Marginal, normal_score_is_the_inverse)
    {
      for (const Marginal &marginal :
           {Marginal(Kind::normal),
            Marginal(Kind::lognormal),
            Marginal(Kind::truncated_normal, 4., 25.),
            Marginal(Kind::truncated_normal, 14., 25.),
            Marginal(Kind::truncated_normal, 1., 8.),
            Marginal(Kind::beta, 2., 30.)})
        for (const double z : {-4.5, -2., -0.1, 0., 0.7, 3., 4.5})
          EXPECT_NEAR(marginal.normal_score(marginal.value(z, 13., 2.6),
                                            13.,
                                            2.6),
                      z,
                      1e-9);
    }


    TEST(Marginal, averages_keep_the_mean)
    {
      // z = sqrt(v) u with a standard normal u; sd of the lognormal averages:
      // mean sqrt(exp(v s^2) - 1).
      const double variance = 0.4, root = std::sqrt(variance);
      for (const Kind kind : {Kind::normal, Kind::lognormal})
        {
          const Marginal marginal(kind, -infinity);
          const double   dz = 1e-3, scale = 1. / std::sqrt(2. * std::acos(-1.));
          double         mean = 0., square = 0.;
          for (int i = -9000; i <= 9000; ++i)
            {
              const double u = i * dz, w = dz * scale * std::exp(-0.5 * u * u);
              const double x = marginal.value(root * u, 13., 8., variance);
              mean += w * x;
              square += w * x * x;
              if (std::abs(u) < 5.)
                {
                  ASSERT_NEAR(marginal.normal_score(x, 13., 8., variance),
                              root * u,
                              1e-12);
                }
            }
          EXPECT_NEAR(mean, 13., 1e-11);
          const double s2 = std::log1p(64. / 169.);
          const double sd = kind == Kind::normal
                              ? 8. * root
                              : 13. * std::sqrt(std::expm1(variance * s2));
          EXPECT_NEAR(std::sqrt(square - mean * mean), sd, 1e-11);
        }
    }


    TEST(Marginal, values_without_a_score_are_named)
    {
      const Marginal normal(Kind::normal, 5., 20.);
      for (const double value : {5., 13., 20.})
        EXPECT_EQ(normal.value_problem(value, 13., 2.6), "");
      EXPECT_EQ(normal.value_problem(4.9, 13., 2.6), "at least 5, at most 20");
      EXPECT_NE(normal.value_problem(20.1, 13., 2.6), "");
      EXPECT_NE(normal.value_problem(13., 13., 0.), "");
      EXPECT_NE(normal.value_problem(std::nan(""), 13., 2.6), "");
      EXPECT_EQ(Marginal(Kind::normal, -infinity).value_problem(-9., 1., 1.),
                "");
      EXPECT_NE(Marginal(Kind::normal).value_problem(infinity, 13., 2.6), "");

      const Marginal lognormal(Kind::lognormal, -infinity);
      EXPECT_EQ(lognormal.value_problem(0.1, 13., 2.6), "");
      EXPECT_EQ(lognormal.value_problem(0., 13., 2.6), "above 0");

      for (const Kind kind : {Kind::truncated_normal, Kind::beta})
        {
          const Marginal between(kind, 5., 20.);
          EXPECT_EQ(between.value_problem(5.5, 13., 2.6), "");
          for (const double value : {4., 5., 20., 21.})
            EXPECT_EQ(between.value_problem(value, 13., 2.6),
                      "above 5, below 20");
        }
      // No number for its probability.
      const Marginal far(Kind::truncated_normal, -infinity);
      EXPECT_EQ(far.value_problem(-200., 13., 2.6), "nearer to the mean, 13");
    }


    TEST(Marginal, share_beyond_the_limits_is_that_of_both_tails)
    {
      const auto tail = [](const double x) {
        return 0.5 * std::erfc(x / std::sqrt(2.));
      };
      EXPECT_NEAR(Marginal(Kind::normal).share_beyond(13., 2.6),
                  tail(5.),
                  1e-16);
      EXPECT_NEAR(Marginal(Kind::normal, 10., 20.).share_beyond(13., 2.6),
                  tail(3. / 2.6) + tail(7. / 2.6),
                  1e-14);
      EXPECT_EQ(Marginal(Kind::normal, -infinity).share_beyond(13., 2.6), 0.);
      // The logarithm is normal: sd^2 = ln(1 + 0.2^2), mean ln 13 - sd^2 / 2.
      const double sd = std::sqrt(std::log(1.04)),
                   m  = std::log(13.) - sd * sd / 2;
      EXPECT_NEAR(Marginal(Kind::lognormal, 10., 20.).share_beyond(13., 2.6),
                  tail((m - std::log(10.)) / sd) +
                    tail((std::log(20.) - m) / sd),
                  1e-14);
      EXPECT_EQ(Marginal(Kind::lognormal).share_beyond(13., 2.6), 0.);
      EXPECT_EQ(Marginal(Kind::lognormal, -1.).share_beyond(13., 2.6), 0.);
      // These take no value beyond their limits, nor does what has no spread.
      for (const Kind kind : {Kind::truncated_normal, Kind::beta})
        EXPECT_EQ(Marginal(kind, 10., 20.).share_beyond(13., 2.6), 0.);
      EXPECT_EQ(Marginal(Kind::normal, 10., 20.).share_beyond(13., 0.), 0.);
    }


    TEST(Marginal, values_rise_within_the_limits)
    {
      for (const Kind kind :
           {Kind::normal, Kind::lognormal, Kind::truncated_normal, Kind::beta})
        {
          const Marginal marginal(kind, 3., 21.);
          double         last = 3.;
          for (double z = -40.; z <= 40.; z += 0.25)
            {
              const double x = marginal.value(z, 13., 2.6);
              EXPECT_TRUE(std::isfinite(x));
              EXPECT_GE(x, last) << int(kind) << ' ' << z;
              EXPECT_LE(x, 21.);
              last = x;
            }
          EXPECT_GT(last, 20.);
          EXPECT_EQ(marginal.value(2., 13., 0.), 13.);
        }
    }


    TEST(Marginal, impossible_distributions_are_named)
    {
      EXPECT_EQ(Marginal(Kind::normal).problem(13., 2.6), "");
      EXPECT_EQ(Marginal(Kind::normal).problem(13., 0.), "");
      EXPECT_NE(Marginal(Kind::normal).problem(13., -1.), "");
      EXPECT_NE(Marginal(Kind::normal).problem(infinity, 1.), "");
      EXPECT_NE(Marginal(Kind::normal, 5., 5.).problem(13., 1.), "");

      EXPECT_EQ(Marginal(Kind::lognormal).problem(13., 2.6), "");
      EXPECT_NE(Marginal(Kind::lognormal).problem(0., 2.6), "");

      EXPECT_EQ(Marginal(Kind::truncated_normal).problem(13., 2.6), "");
      EXPECT_EQ(Marginal(Kind::truncated_normal, 15.).problem(13., 2.6), "");
      EXPECT_NE(Marginal(Kind::truncated_normal, 15.).problem(13., 0.01), "");
      EXPECT_NE(Marginal(Kind::truncated_normal, 15.).problem(13., 0.), "");

      EXPECT_EQ(Marginal(Kind::beta, 2., 30.).problem(13., 2.6), "");
      EXPECT_NE(Marginal(Kind::beta).problem(13., 2.6), "");
      EXPECT_NE(Marginal(Kind::beta, 2., 30.).problem(1., 2.6), "");
      EXPECT_NE(Marginal(Kind::beta, 2., 30.).problem(13., 14.), "");
    }


    TEST(Marginal, names)
    {
      const auto named = [](const std::string &name) {
        return choice_named<Kind>(name, "Distribution");
      };
      EXPECT_EQ(named("normal"), Kind::normal);
      EXPECT_EQ(named("lognormal"), Kind::lognormal);
      EXPECT_EQ(named("truncated normal"), Kind::truncated_normal);
      EXPECT_EQ(named("beta"), Kind::beta);
      EXPECT_USER_ERROR(named("gamma"), "Distribution", "is \"gamma\"");
    }
  } // namespace
} // namespace fields_marginal
