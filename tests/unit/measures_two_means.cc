// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/measures/two_means.h>

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace measures_two_means
{
  using namespace Waker;

  namespace
  {
    /// Weighted sum of squared distances to the mean of the marked values.
    double
    scatter(const std::vector<double> &values,
            const std::vector<double> &weights,
            const unsigned int         marks,
            const bool                 marked)
    {
      double weight = 0., mean = 0., sum = 0.;
      for (unsigned int i = 0; i < values.size(); ++i)
        if (((marks >> i) & 1U) == marked)
          {
            weight += weights[i];
            mean += weights[i] * values[i];
          }
      mean /= weight;
      for (unsigned int i = 0; i < values.size(); ++i)
        if (((marks >> i) & 1U) == marked)
          sum += weights[i] * (values[i] - mean) * (values[i] - mean);
      return sum;
    }
  } // namespace


  // Against all 2^n partitions, not only those into intervals.
  TEST(Measures, two_means_are_the_best_of_all_partitions)
  {
    std::mt19937                           generator(7);
    std::uniform_real_distribution<double> uniform(0., 1.);
    for (unsigned int repetition = 0; repetition < 200; ++repetition)
      {
        const unsigned int  n      = 2 + repetition % 9;
        const double        offset = repetition % 3 == 0 ? 1e5 : 0.;
        std::vector<double> values(n), weights(n);
        for (unsigned int i = 0; i < n; ++i)
          {
            values[i]  = offset + std::pow(uniform(generator), 3);
            weights[i] = 0.1 + uniform(generator);
          }
        double best = 1e300;
        for (unsigned int marks = 1; marks + 1 < (1U << n); ++marks)
          best = std::min(best,
                          scatter(values, weights, marks, true) +
                            scatter(values, weights, marks, false));

        const TwoMeans split = two_means(values, weights);
        unsigned int   upper = 0;
        double         sum = 0., weight = 0.;
        for (unsigned int i = 0; i < n; ++i)
          if (values[i] >= split.threshold)
            {
              upper |= 1U << i;
              weight += weights[i];
              sum += weights[i] * values[i];
            }
        ASSERT_NE(upper, 0U);
        ASSERT_NE(upper, (1U << n) - 1);
        EXPECT_NEAR(scatter(values, weights, upper, true) +
                      scatter(values, weights, upper, false),
                    best,
                    1e-9);
        EXPECT_NEAR(split.upper_weight, weight, 1e-12);
        EXPECT_NEAR(split.upper_mean, sum / weight, 1e-9);
        // The border lies half way between the means.
        for (unsigned int i = 0; i < n; ++i)
          EXPECT_EQ(values[i] >= split.threshold,
                    values[i] > 0.5 * (split.lower_mean + split.upper_mean));
      }
  }


  TEST(Measures, two_means_of_two_groups_with_weights)
  {
    const TwoMeans split = two_means({5., 0., 4., 1.}, {1., 2., 3., 2.});
    EXPECT_EQ(split.threshold, 4.);
    EXPECT_DOUBLE_EQ(split.lower_mean, 0.5);
    EXPECT_DOUBLE_EQ(split.upper_mean, 4.25);
    EXPECT_DOUBLE_EQ(split.upper_weight, 4.);
  }


  TEST(Measures, two_means_without_a_difference_have_no_upper_cluster)
  {
    for (const std::vector<double> &values :
         {std::vector<double>{}, {3.}, {3., 3., 3.}})
      {
        const TwoMeans split =
          two_means(values, std::vector<double>(values.size(), 1.));
        EXPECT_TRUE(std::isinf(split.threshold));
        EXPECT_EQ(split.upper_weight, 0.);
        EXPECT_EQ(split.lower_mean, values.empty() ? 0. : 3.);
        EXPECT_EQ(split.upper_mean, split.lower_mean);
      }
  }
} // namespace measures_two_means
