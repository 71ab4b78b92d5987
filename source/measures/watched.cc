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
  largest_settlement(const Body<dim> &body)
  {
    const MaterialPoints<dim> &points  = body.own();
    double                     largest = 0.;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      largest = std::max(largest,
                         points.initial_position[p][1] - points.position[p][1]);
    return body.largest(largest);
  }


  namespace
  {
    template <int dim>
    double
    largest_displacement(const Body<dim> &body)
    {
      const MaterialPoints<dim> &points = body.own();
      double                     square = 0.;
      for (std::size_t p = 0; p < points.n_points(); ++p)
        square = std::max(square,
                          points.position[p].distance_square(
                            points.initial_position[p]));
      return std::sqrt(body.largest(square));
    }


    template <int dim>
    double
    settlement_of(const Body<dim> &body, const std::vector<double> &load)
    {
      const MaterialPoints<dim> &points  = body.own();
      double                     sums[2] = {0., 0.}; // weighted, of weights
      for (std::size_t p = 0; p < load.size(); ++p)
        {
          sums[0] +=
            load[p] * (points.initial_position[p][1] - points.position[p][1]);
          sums[1] += load[p];
        }
      body.sum(sums, 2);
      return sums[1] > 0. ? sums[0] / sums[1]
                          : std::numeric_limits<double>::quiet_NaN();
    }


    template <int dim>
    double
    largest_plastic_strain(const Body<dim> &body)
    {
      const int i = body.own().find_scalar("plastic strain");
      if (i < 0)
        return std::numeric_limits<double>::quiet_NaN();
      const auto &values = body.own().scalars[i].values;
      return body.largest(
        values.empty() ? 0. : *std::max_element(values.begin(), values.end()));
    }
  } // namespace


  template <int dim>
  double
  watched_value(const Watched              watched,
                const Body<dim>           &body,
                const FailureRecord       &failure,
                const double               settlement_rate,
                const std::vector<double> &load)
  {
    switch (watched)
      {
        case Watched::nothing:
          break;
        case Watched::largest_settlement:
          return largest_settlement(body);
        case Watched::largest_settlement_rate:
          return settlement_rate;
        case Watched::largest_displacement:
          return largest_displacement(body);
        case Watched::settlement_of_load:
          return settlement_of(body, load);
        case Watched::plastic_strain:
          return largest_plastic_strain(body);
        case Watched::loss_of_height:
          return failure.initial_height - failure.geometry.height;
        case Watched::loss_of_width:
          return failure.initial_width - failure.geometry.width;
      }
    return std::numeric_limits<double>::quiet_NaN();
  }


  template double
  largest_settlement(const Body<2> &);
  template double
  largest_settlement(const Body<3> &);
  template double
  watched_value(const Watched,
                const Body<2> &,
                const FailureRecord &,
                const double,
                const std::vector<double> &);
  template double
  watched_value(const Watched,
                const Body<3> &,
                const FailureRecord &,
                const double,
                const std::vector<double> &);
} // namespace Waker
