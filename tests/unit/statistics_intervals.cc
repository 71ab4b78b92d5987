// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/statistics/intervals.h>

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace statistics_intervals
{
  namespace
  {
    using namespace Waker;

    /// Binomial probabilities of 0 .. n.
    std::vector<double>
    binomial(const unsigned int n, const double p)
    {
      std::vector<double> result(n + 1);
      for (unsigned int k = 0; k <= n; ++k)
        result[k] = std::exp(std::lgamma(n + 1.) - std::lgamma(k + 1.) -
                             std::lgamma(n - k + 1.) + k * std::log(p) +
                             (n - k) * std::log1p(-p));
      return result;
    }


    /// Exact probability that the interval after k of n holds p; and of a miss
    /// on either side.
    struct Coverage
    {
      double inside = 0., below = 0., above = 0.;
    };

    template <typename Function>
    Coverage
    coverage(const unsigned int n, const double p, const Function &interval)
    {
      const std::vector<double> weights = binomial(n, p);
      Coverage                  result;
      for (unsigned int k = 0; k <= n; ++k)
        {
          const Interval i = interval(k, n);
          (p < i.low    ? result.below
           : p > i.high ? result.above
                        : result.inside) += weights[k];
        }
      return result;
    }
  } // namespace


  TEST(Intervals, cover_the_probability_in_95_of_100_campaigns_at_least)
  {
    double least = 1.;
    for (const unsigned int n : {20, 50, 100, 300, 1000})
      {
        std::vector<Interval> table;
        for (unsigned int k = 0; k <= n; ++k)
          table.push_back(clopper_pearson(k, n));
        for (const double p :
             {0.001, 0.003, 0.01, 0.03, 0.0633, 0.1, 0.12, 0.2, 0.35, 0.5})
          {
            const Coverage c =
              coverage(n, p, [&](const unsigned int k, const unsigned int) {
                return table[k];
              });
            EXPECT_NEAR(c.inside + c.below + c.above, 1., 1e-9);
            EXPECT_GE(c.inside, 0.95) << "n " << n << ", p " << p;
            EXPECT_LE(c.below, 0.025 + 1e-12);
            EXPECT_LE(c.above, 0.025 + 1e-12);
            least = std::min(least, c.inside);
          }
      }
    // and are not wider than they need be
    EXPECT_LT(least, 0.956);
  }


  TEST(Intervals, normal_ones_do_not)
  {
    EXPECT_LT(coverage(100, 0.01, normal_interval).inside, 0.70);
    EXPECT_GT(coverage(1000, 0.5, normal_interval).inside, 0.94);
  }


  TEST(Intervals, of_flooding_given_initial_failure_cover)
  {
    // n realisations fail with p, then flood with r: the interval is that of a
    // proportion of n_S1, which is itself random
    for (const unsigned int n : {20, 100, 200})
      for (const double p : {0.01, 0.12, 0.5})
        for (const double r : {0.1, 0.5, 0.75, 0.9})
          {
            const std::vector<double> failures = binomial(n, p);
            double                    inside   = failures[0]; // [0, 1]
            for (unsigned int m = 1; m <= n; ++m)
              if (failures[m] > 1e-12)
                inside += failures[m] * coverage(m,
                                                 r,
                                                 [](const unsigned int k,
                                                    const unsigned int m) {
                                                   return clopper_pearson(k, m);
                                                 })
                                          .inside;
            EXPECT_GE(inside, 0.95) << n << " " << p << " " << r;
          }
  }


  TEST(Intervals, of_counts_in_closed_form_and_in_tables)
  {
    for (const unsigned int n : {1, 20, 4000})
      {
        const Interval none = clopper_pearson(0, n);
        EXPECT_EQ(none.low, 0.);
        EXPECT_NEAR(none.high, 1. - std::pow(0.025, 1. / n), 1e-12);
        const Interval all = clopper_pearson(n, n);
        EXPECT_NEAR(all.low, std::pow(0.025, 1. / n), 1e-12);
        EXPECT_EQ(all.high, 1.);
      }
    // R: binom.test(9, 12), binom.test(1, 10)
    EXPECT_NEAR(clopper_pearson(9, 12).low, 0.4281415, 1e-6);
    EXPECT_NEAR(clopper_pearson(9, 12).high, 0.9451394, 1e-6);
    EXPECT_NEAR(clopper_pearson(1, 10).low, 0.002528579, 1e-8);
    EXPECT_NEAR(clopper_pearson(1, 10).high, 0.4450161, 1e-6);

    const Proportion nothing = proportion(0, 0);
    EXPECT_TRUE(std::isnan(nothing.estimate));
    EXPECT_EQ(nothing.low, 0.);
    EXPECT_EQ(nothing.high, 1.);
  }


  TEST(Intervals, reliability_index_and_coefficient_of_variation)
  {
    EXPECT_NEAR(reliability_index(1e-5), 4.264891, 1e-6);
    EXPECT_NEAR(reliability_index(0.5), 0., 1e-15);
    EXPECT_NEAR(reliability_index(normal_distribution(-7.5)), 7.5, 1e-12);
    EXPECT_TRUE(reliability_index(0.) > 1e300);
    EXPECT_TRUE(reliability_index(1.) < -1e300);
    EXPECT_TRUE(std::isnan(reliability_index(NAN)));

    EXPECT_NEAR(coefficient_of_variation(100, 1000), std::sqrt(0.009), 1e-15);
    EXPECT_TRUE(std::isinf(coefficient_of_variation(0, 1000)));
    EXPECT_EQ(coefficient_of_variation(5, 5), 0.);
  }


  TEST(Intervals, what_an_estimate_says)
  {
    EXPECT_EQ(to_string(kind_of(proportion(0, 20).estimate)), "upper bound");
    EXPECT_EQ(to_string(kind_of(proportion(1, 20).estimate)), "estimate");
    EXPECT_EQ(to_string(kind_of(proportion(20, 20).estimate)), "lower bound");
    EXPECT_EQ(to_string(kind_of(proportion(0, 0).estimate)), "unknown");
  }
} // namespace statistics_intervals
