// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/base/numbers.h>
#include <waker/statistics/intervals.h>

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <limits>

namespace Waker
{
  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
  } // namespace


  std::string
  to_string(const EstimateKind kind)
  {
    switch (kind)
      {
        case EstimateKind::estimate:
          return "estimate";
        case EstimateKind::upper_bound:
          return "upper bound";
        case EstimateKind::lower_bound:
          return "lower bound";
        case EstimateKind::unknown:
          return "unknown";
      }
    Assert(false, dealii::ExcInternalError());
    return "";
  }


  EstimateKind
  kind_of(const double estimate)
  {
    if (std::isnan(estimate))
      return EstimateKind::unknown;
    return estimate <= 0.   ? EstimateKind::upper_bound
           : estimate >= 1. ? EstimateKind::lower_bound
                            : EstimateKind::estimate;
  }


  Interval
  clopper_pearson(const std::uint64_t count,
                  const std::uint64_t n,
                  const double        confidence)
  {
    Assert(count <= n, dealii::ExcMessage("More events than realisations"));
    const double tail    = 0.5 * (1. - confidence);
    const double events  = static_cast<double>(count);
    const double missing = static_cast<double>(n - count);

    using Beta = boost::math::beta_distribution<>;
    return {count == 0 ? 0.
                       : boost::math::quantile(Beta(events, missing + 1), tail),
            count == n
              ? 1.
              : boost::math::quantile(
                  boost::math::complement(Beta(events + 1, missing), tail))};
  }


  Proportion
  proportion(const std::uint64_t count, const std::uint64_t n)
  {
    const Interval interval = clopper_pearson(count, n);
    return {count,
            n,
            n == 0 ? nan : static_cast<double>(count) / n,
            interval.low,
            interval.high};
  }


  double
  normal_distribution(const double x)
  {
    return boost::math::cdf(boost::math::normal(), x);
  }


  double
  reliability_index(const double probability)
  {
    if (std::isnan(probability))
      return nan;
    Assert(probability >= 0. && probability <= 1., dealii::ExcInternalError());
    if (probability <= 0.)
      return infinity;
    if (probability >= 1.)
      return -infinity;
    return -boost::math::quantile(boost::math::normal(), probability);
  }


  double
  coefficient_of_variation(const std::uint64_t count, const std::uint64_t n)
  {
    if (count == 0)
      return infinity;
    const double p = static_cast<double>(count) / n;
    return std::sqrt((1. - p) / (n * p));
  }


  Interval
  normal_interval(const std::uint64_t count, const std::uint64_t n)
  {
    if (n == 0)
      return {nan, nan};
    const double p    = static_cast<double>(count) / n;
    const double half = boost::math::quantile(boost::math::normal(),
                                              0.5 * (1. + confidence_level)) *
                        std::sqrt(p * (1. - p) / n);
    return {p - half, p + half};
  }
} // namespace Waker
