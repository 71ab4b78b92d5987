// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/base/numbers.h>
#include <waker/statistics/estimates.h>
#include <waker/statistics/fragility.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

namespace Waker
{
  namespace
  {
    /// Slope at an end: of the parabola through three points, kept from
    /// overshooting (Moler 2004, "pchip").
    double
    end_slope(const double h0,
              const double h1,
              const double d0,
              const double d1)
    {
      const double slope = ((2. * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
      if (slope * d0 <= 0.)
        return 0.;
      if (d0 * d1 <= 0. && std::abs(slope) > 3. * std::abs(d0))
        return 3. * d0;
      return slope;
    }


    std::vector<double>
    monotone_slopes(const std::vector<double> &x, const std::vector<double> &y)
    {
      const std::size_t   n = x.size();
      std::vector<double> slopes(n, 0.), h, d;
      for (std::size_t i = 0; i + 1 < n; ++i)
        {
          h.push_back(x[i + 1] - x[i]);
          d.push_back((y[i + 1] - y[i]) / h.back());
        }
      if (n == 2)
        slopes = {d[0], d[0]};
      if (n < 3)
        return slopes;
      for (std::size_t i = 1; i + 1 < n; ++i)
        if (d[i - 1] * d[i] > 0.)
          {
            const double w0 = 2. * h[i] + h[i - 1];
            const double w1 = h[i] + 2. * h[i - 1];
            slopes[i]       = (w0 + w1) / (w0 / d[i - 1] + w1 / d[i]);
          }
      slopes.front() = end_slope(h[0], h[1], d[0], d[1]);
      slopes.back()  = end_slope(h[n - 2], h[n - 3], d[n - 2], d[n - 3]);
      return slopes;
    }


    /// Of a point: its bounds, or those of its proportion.
    Interval
    interval_of(const FragilityPoint &point,
                Proportion FragilityPoint::*const which,
                std::optional<Interval> FragilityPoint::*const bounds)
    {
      const Proportion &p = point.*which;
      return (point.*bounds).value_or(Interval{p.low, p.high});
    }


    BoundedCurve
    make_curve(const std::vector<FragilityPoint> &points,
               Proportion FragilityPoint::*const which,
               std::optional<Interval> FragilityPoint::*const bounds,
               const bool                                     rising)
    {
      Assert(!points.empty(), dealii::ExcInternalError());
      std::vector<double> levels, weights, estimates, low, high;
      for (const FragilityPoint &point : points)
        if ((point.*which).n > 0)
          {
            const Proportion &p = point.*which;
            const Interval    b = interval_of(point, which, bounds);
            levels.push_back(point.water_level);
            weights.push_back(static_cast<double>(p.n));
            estimates.push_back(p.estimate);
            low.push_back(b.low);
            high.push_back(b.high);
          }
      if (rising)
        for (std::vector<double> *const values : {&estimates, &low, &high})
          *values = make_rising(*values, weights);
      const FragilityCurve estimate = levels.empty()
                                        ? FragilityCurve({0.}, {nan})
                                        : FragilityCurve(levels, estimates);

      // Where none counts, the bounds of others hold that rise to it.
      std::vector<double> all_levels, all_low, all_high;
      std::size_t         next = 0; // level at which realisations count
      for (const FragilityPoint &point : points)
        {
          all_levels.push_back(point.water_level);
          if ((point.*which).n > 0)
            {
              all_low.push_back(low[next]);
              all_high.push_back(high[next]);
              ++next;
              continue;
            }
          Interval b = interval_of(point, which, bounds);
          if (rising && next > 0)
            b.low = std::max(b.low, low[next - 1]);
          if (rising && next < levels.size())
            b.high = std::min(b.high, high[next]);
          all_low.push_back(b.low);
          all_high.push_back(b.high);
        }
      return {estimate,
              FragilityCurve(all_levels, all_low),
              FragilityCurve(all_levels, all_high)};
    }


    Interval
    interval(const BoundedProbability &p)
    {
      return {p.low, p.high};
    }


    double
    integrate(const FragilityCurve    &curve,
              const LevelDistribution &distribution)
    {
      std::vector<double> knots = curve.levels;
      for (const double level : distribution.table_levels())
        if (level > curve.levels.front() && level < curve.levels.back())
          knots.push_back(level);
      std::sort(knots.begin(), knots.end());

      const auto integrand = [&](const double level) {
        return curve.slope(level) * distribution.exceedance(level);
      };
      double result = curve.values.front();
      for (std::size_t i = 0; i + 1 < knots.size(); ++i)
        if (knots[i] < knots[i + 1])
          result +=
            boost::math::quadrature::gauss_kronrod<double, 15>::integrate(
              integrand, knots[i], knots[i + 1], 15, 1e-10);
      return result;
    }
  } // namespace


  std::vector<FragilityPoint>
  fragility_points(const CampaignInfo                     &info,
                   const std::vector<std::vector<Record>> &records_by_scenario)
  {
    AssertDimension(info.scenarios.size(), records_by_scenario.size());
    std::vector<FragilityPoint> points;
    for (std::size_t s = 0; s < info.scenarios.size(); ++s)
      {
        const ScenarioInfo    &scenario = info.scenarios[s];
        const ScenarioEstimate e =
          estimate(records_by_scenario[s], scenario.may_flood());
        // without water there is no level
        if (e.n + e.n_lost() > 0 && scenario.may_flood())
          points.push_back({scenario.water_level,
                            scenario.crest_level - scenario.water_level,
                            e.by_any.initial,
                            e.by_any.flooding,
                            e.n_lost(),
                            e.n_not_final,
                            interval(e.initial()),
                            interval(e.flooding())});
      }
    std::sort(points.begin(), points.end(), [](const auto &a, const auto &b) {
      return a.water_level < b.water_level;
    });
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      if (points[i].water_level == points[i + 1].water_level)
        return {};
    return points;
  }


  std::string
  equal_levels_note(const CampaignInfo &info)
  {
    const std::vector<ScenarioInfo> &all = info.scenarios;
    if (info.sweeps_water_level())
      for (std::size_t s = 0; s < all.size(); ++s)
        for (std::size_t t = s + 1; t < all.size(); ++t)
          if (all[s].water_level == all[t].water_level)
            return "No fragility curve: " + info.swept_parameter + " = " +
                   all[s].value + " and " + all[t].value +
                   " are the same level.";
    return "";
  }


  std::vector<double>
  make_rising(const std::vector<double> &values,
              const std::vector<double> &weights)
  {
    AssertDimension(values.size(), weights.size());
    struct Block
    {
      double      value;
      double      weight;
      std::size_t size;
    };
    std::vector<Block> blocks;
    for (std::size_t i = 0; i < values.size(); ++i)
      {
        blocks.push_back({values[i], weights[i], 1});
        while (blocks.size() > 1 &&
               blocks[blocks.size() - 2].value > blocks.back().value)
          {
            const Block last = blocks.back();
            blocks.pop_back();
            Block       &b      = blocks.back();
            const double weight = b.weight + last.weight;
            b.value  = (b.value * b.weight + last.value * last.weight) / weight;
            b.weight = weight;
            b.size += last.size;
          }
      }
    std::vector<double> result;
    for (const Block &block : blocks)
      result.insert(result.end(), block.size, block.value);
    return result;
  }


  FragilityCurve::FragilityCurve(const std::vector<double> &levels,
                                 const std::vector<double> &values)
    : levels(levels)
    , values(values)
    , slopes(monotone_slopes(levels, values))
  {
    Assert(!levels.empty(), dealii::ExcInternalError());
    AssertDimension(levels.size(), values.size());
  }


  double
  FragilityCurve::operator()(const double level) const
  {
    if (level <= levels.front())
      return values.front();
    if (level >= levels.back())
      return values.back();
    const std::size_t i =
      std::upper_bound(levels.begin(), levels.end(), level) - levels.begin() -
      1;
    const double h = levels[i + 1] - levels[i], t = (level - levels[i]) / h;
    const double u = 1. - t;
    return values[i] * (1. + 2. * t) * u * u + slopes[i] * h * t * u * u +
           values[i + 1] * (3. - 2. * t) * t * t -
           slopes[i + 1] * h * t * t * u;
  }


  double
  FragilityCurve::slope(const double level) const
  {
    if (level <= levels.front() || level >= levels.back())
      return 0.;
    const std::size_t i =
      std::upper_bound(levels.begin(), levels.end(), level) - levels.begin() -
      1;
    const double h = levels[i + 1] - levels[i], t = (level - levels[i]) / h;
    return 6. * t * (1. - t) * (values[i + 1] - values[i]) / h +
           slopes[i] * (1. - t) * (1. - 3. * t) +
           slopes[i + 1] * t * (3. * t - 2.);
  }


  BoundedIndex
  reliability_index(const BoundedProbability &probability)
  {
    const auto finite = [](const double p) {
      const double beta = reliability_index(p);
      return std::isfinite(beta) ? beta : nan;
    };
    return {finite(probability.estimate),
            finite(probability.high),
            finite(probability.low)};
  }


  BoundedProbability
  BoundedCurve::at(const double level) const
  {
    const double p = estimate(level);
    return {p, std::fmin(p, low(level)), std::fmax(p, high(level))};
  }


  BoundedProbability
  BoundedCurve::at(const FragilityPoint &point) const
  {
    BoundedProbability p = at(point.water_level);
    if (point.flooding.n == 0)
      p = {nan, low(point.water_level), high(point.water_level)};
    return p;
  }


  BoundedCurve
  initial_failure_curve(const std::vector<FragilityPoint> &points)
  {
    return make_curve(points,
                      &FragilityPoint::initial,
                      &FragilityPoint::initial_bounds,
                      false);
  }


  BoundedCurve
  flooding_curve(const std::vector<FragilityPoint> &points)
  {
    return make_curve(points,
                      &FragilityPoint::flooding,
                      &FragilityPoint::flooding_bounds,
                      true);
  }


  BoundedProbability
  yearly_probability(const BoundedCurve      &curve,
                     const LevelDistribution &distribution)
  {
    const double p = integrate(curve.estimate, distribution);
    // as in BoundedCurve::at()
    return {p,
            std::fmin(p, integrate(curve.low, distribution)),
            std::fmax(p, integrate(curve.high, distribution))};
  }
} // namespace Waker
