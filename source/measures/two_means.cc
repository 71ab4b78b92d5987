// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/measures/two_means.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace Waker
{
  TwoMeans
  two_means(const std::vector<double> &values,
            const std::vector<double> &weights)
  {
    AssertDimension(values.size(), weights.size());
    const std::size_t        n = values.size();
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(),
              order.end(),
              [&](const std::size_t a, const std::size_t b) {
                return values[a] < values[b] ||
                       (values[a] == values[b] && a < b);
              });

    double weight = 0., sum = 0.;
    for (const std::size_t i : order)
      {
        weight += weights[i];
        sum += weights[i] * values[i];
      }
    const double mean = n > 0 ? sum / weight : 0.;
    TwoMeans result = {std::numeric_limits<double>::infinity(), mean, mean, 0.};

    // Least within the clusters is most between them: w0 w1 (m1 - m0)^2 / w.
    // Values relative to the mean, so that large ones cost no digits.
    double best = 0., lower_weight = 0., lower_sum = 0.;
    for (std::size_t k = 0; k + 1 < n; ++k)
      {
        const std::size_t i = order[k];
        lower_weight += weights[i];
        lower_sum += weights[i] * (values[i] - mean);
        const double next = values[order[k + 1]];
        if (!(next > values[i]))
          continue;
        const double upper_weight = weight - lower_weight;
        const double between =
          lower_sum * lower_sum * (1. / lower_weight + 1. / upper_weight);
        if (between > best)
          {
            best   = between;
            result = {next,
                      mean + lower_sum / lower_weight,
                      mean - lower_sum / upper_weight,
                      upper_weight};
          }
      }
    return result;
  }
} // namespace Waker
