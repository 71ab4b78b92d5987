// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/particles/point_loads.h>
#include <waker/particles/polygon.h>

#include <limits>

namespace Waker
{
  void
  PointLoadParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("From",
                      from,
                      "The points that lie in the box From .. To (m) at the "
                      "start share the force by their volumes. Without To: the "
                      "point nearest to From, at most a cell away.",
                      Patterns::List(Patterns::Double(), 0, 3));
    prm.add_parameter("To",
                      to,
                      "Upper corner of that box (m).",
                      Patterns::List(Patterns::Double(), 0, 3));
    prm.add_parameter("Force",
                      force,
                      "Total force (kN; kN per m in 2D), constant in "
                      "direction; it rides on the points.",
                      Patterns::List(Patterns::Double(), 0, 3));
  }


  void
  PointLoadParameters::check(const unsigned int dim) const
  {
    const std::string path    = "Point loads/" + name + "/";
    const auto        require = [&](const std::string         &entry,
                             const std::vector<double> &values) {
      if (values.size() != dim)
        throw UserError(path + entry,
                        "has " + counted(values.size(), "number"),
                        std::to_string(dim) + " numbers (Dimension = " +
                          std::to_string(dim) + ")" + decimals_with_a_point);
    };
    require("From", from);
    require("Force", force);
    if (to.empty())
      return;
    require("To", to);
    for (unsigned int d = 0; d < dim; ++d)
      if (!(from[d] <= to[d]))
        throw UserError(path + "To",
                        "lies below From in direction " +
                          std::string(1, "xyz"[d]),
                        "a box from its lower to its upper corner");
  }


  namespace
  {
    template <int dim>
    std::vector<std::size_t>
    loaded_points(const PointLoadParameters &load,
                  const double               cell_size,
                  const MaterialPoints<dim> &points)
    {
      Point<dim> from, to;
      for (unsigned int d = 0; d < dim; ++d)
        {
          from[d] = load.from[d];
          to[d]   = load.to.empty() ? from[d] : load.to[d];
        }
      std::vector<std::size_t> list;
      if (load.to.empty())
        {
          std::size_t best     = 0;
          double      shortest = std::numeric_limits<double>::max();
          for (std::size_t p = 0; p < points.n_points(); ++p)
            {
              // Points at the same distance but for round-off: the first.
              const double distance = points.position[p].distance(from);
              if (distance < shortest * (1. - 1e-12))
                {
                  shortest = distance;
                  best     = p;
                }
            }
          if (points.n_points() > 0 && !(shortest <= cell_size))
            throw UserError("Point loads/" + load.name + "/From",
                            "is " + in_digits(shortest) +
                              " m from the nearest material point",
                            "a place in the soil, or at most a cell (" +
                              in_digits(cell_size) + " m) from its points");
          if (points.n_points() > 0)
            list.push_back(best);
          return list;
        }

      for (std::size_t p = 0; p < points.n_points(); ++p)
        {
          bool inside = true;
          for (unsigned int d = 0; d < dim; ++d)
            {
              const double x         = points.position[p][d];
              const double tolerance = 1e-9 * points.half_size[p][d];
              inside =
                inside && x >= from[d] - tolerance && x <= to[d] + tolerance;
            }
          if (inside)
            list.push_back(p);
        }
      return list;
    }
  } // namespace


  template <int dim>
  std::vector<double>
  shares_of_points(const PointLoadParameters &load,
                   const double               cell_size,
                   const MaterialPoints<dim> &points)
  {
    const std::vector<std::size_t> list =
      loaded_points(load, cell_size, points);
    double volume = 0.;
    for (const std::size_t p : list)
      volume += points.volume[p];
    if (list.empty())
      throw UserError("Point loads/" + load.name + "/From",
                      "there is no point in the box",
                      "a box that holds material points");
    std::vector<double> shares(points.n_points());
    for (const std::size_t p : list)
      shares[p] = points.volume[p] / volume;
    return shares;
  }


  template <int dim>
  void
  apply_point_loads(const std::vector<PointLoadParameters> &loads,
                    const double                            cell_size,
                    MaterialPoints<dim>                    &points)
  {
    if (loads.empty())
      return;
    points.load.assign(points.n_points(), Tensor<1, dim>());
    for (const PointLoadParameters &load : loads)
      {
        const std::vector<double> shares =
          shares_of_points(load, cell_size, points);
        for (std::size_t p = 0; p < points.n_points(); ++p)
          for (unsigned int d = 0; d < dim; ++d)
            points.load[p][d] += shares[p] * load.force[d];
      }
  }


  template std::vector<double>
  shares_of_points(const PointLoadParameters &,
                   const double,
                   const MaterialPoints<2> &);
  template std::vector<double>
  shares_of_points(const PointLoadParameters &,
                   const double,
                   const MaterialPoints<3> &);
  template void
  apply_point_loads(const std::vector<PointLoadParameters> &,
                    const double,
                    MaterialPoints<2> &);
  template void
  apply_point_loads(const std::vector<PointLoadParameters> &,
                    const double,
                    MaterialPoints<3> &);
} // namespace Waker
