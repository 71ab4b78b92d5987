// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/measures/watched.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Waker
{
  WatchedFacts
  facts_of(const Watched watched)
  {
    WatchedFacts facts{"m"};
    switch (watched)
      {
        case Watched::nothing:
          facts.unit = "-";
          return facts;
        case Watched::largest_settlement:
        case Watched::largest_displacement:
          facts.needs_motion = true;
          return facts;
        case Watched::largest_settlement_rate:
          facts.unit         = "m/s";
          facts.needs_motion = true;
          return facts;
        case Watched::settlement_of_load:
          facts.needs_motion = true;
          facts.needs_load   = true;
          return facts;
        case Watched::plastic_strain:
          facts.unit = "-";
          return facts;
        case Watched::loss_of_height:
        case Watched::loss_of_width:
          facts.needs_motion = true;
          return facts;
      }
    Assert(false, ExcInternalError());
    return facts;
  }


  template <int dim>
  double
  largest_settlement(const MaterialPoints<dim> &points)
  {
    double largest = 0.;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      largest = std::max(largest,
                         points.initial_position[p][1] - points.position[p][1]);
    return largest;
  }


  namespace
  {
    template <int dim>
    double
    largest_displacement(const MaterialPoints<dim> &points)
    {
      double square = 0.;
      for (std::size_t p = 0; p < points.n_points(); ++p)
        square = std::max(square,
                          points.position[p].distance_square(
                            points.initial_position[p]));
      return std::sqrt(square);
    }


    template <int dim>
    double
    settlement_of(const MaterialPoints<dim> &points,
                  const std::vector<double> &load)
    {
      double sum = 0., total = 0.;
      for (std::size_t p = 0; p < load.size(); ++p)
        {
          sum +=
            load[p] * (points.initial_position[p][1] - points.position[p][1]);
          total += load[p];
        }
      return total > 0. ? sum / total
                        : std::numeric_limits<double>::quiet_NaN();
    }


    template <int dim>
    double
    largest_plastic_strain(const MaterialPoints<dim> &points)
    {
      const int i = points.find_scalar("plastic strain");
      if (i < 0)
        return std::numeric_limits<double>::quiet_NaN();
      const auto &values = points.scalars[i].values;
      return values.empty() ? 0.
                            : *std::max_element(values.begin(), values.end());
    }
  } // namespace


  template <int dim>
  double
  watched_value(const Watched              watched,
                const MaterialPoints<dim> &points,
                const FailureRecord       &failure,
                const double               settlement_rate,
                const std::vector<double> &load)
  {
    switch (watched)
      {
        case Watched::nothing:
          break;
        case Watched::largest_settlement:
          return largest_settlement(points);
        case Watched::largest_settlement_rate:
          return settlement_rate;
        case Watched::largest_displacement:
          return largest_displacement(points);
        case Watched::settlement_of_load:
          return settlement_of(points, load);
        case Watched::plastic_strain:
          return largest_plastic_strain(points);
        case Watched::loss_of_height:
          return failure.initial_height - failure.geometry.height;
        case Watched::loss_of_width:
          return failure.initial_width - failure.geometry.width;
      }
    return std::numeric_limits<double>::quiet_NaN();
  }


  template double
  largest_settlement(const MaterialPoints<2> &);
  template double
  largest_settlement(const MaterialPoints<3> &);
  template double
  watched_value(const Watched,
                const MaterialPoints<2> &,
                const FailureRecord &,
                const double,
                const std::vector<double> &);
  template double
  watched_value(const Watched,
                const MaterialPoints<3> &,
                const FailureRecord &,
                const double,
                const std::vector<double> &);
} // namespace Waker
