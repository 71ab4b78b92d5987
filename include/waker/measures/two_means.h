// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_measures_two_means_h
#define waker_measures_two_means_h

#include <vector>

namespace Waker
{
  /// Two clusters of numbers, the lower and the upper ones.
  struct TwoMeans
  {
    /// The least value of the upper cluster: a value belongs to it if it is
    /// not less. Infinite if all values are equal, or there are none.
    double threshold;
    double lower_mean; // of the values, weighted; 0 if there are none
    double upper_mean; // equal to lower_mean if there is no upper cluster
    double upper_weight;
  };

  /**
   * The split into two clusters with the least weighted sum of squared
   * distances to the clusters' means: exact, by sorting (in one dimension the
   * best clusters are intervals; Fisher 1958), so it needs no first guess. Of
   * equally good splits the lowest.
   *
   * @param values any numbers, in any order
   * @param weights one each, above 0
   */
  TwoMeans
  two_means(const std::vector<double> &values,
            const std::vector<double> &weights);
} // namespace Waker

#endif
