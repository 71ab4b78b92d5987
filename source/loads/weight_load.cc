// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/checks.h>
#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/loads/weight_load.h>
#include <waker/mapping/stencil.h>

#include <algorithm>
#include <array>
#include <limits>

namespace Waker
{
  void
  WeightLoadParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("From",
                      from,
                      "Weight: corner of the rectangle on which it is built "
                      "up, seen from above (m): x; in 3D x, z. All of it lies "
                      "over soil that is level to within a cell.",
                      Patterns::List(Patterns::Double(), 0, 2));
    prm.add_parameter("To",
                      to,
                      "Weight: the opposite corner (m).",
                      Patterns::List(Patterns::Double(), 0, 2));
    prm.add_parameter("Unit weight",
                      unit_weight,
                      "Weight: of what is built up (kN/m^3), above 0. The "
                      "factor is its height (m).",
                      Patterns::Double(0.));
    add_choice(prm,
               "Points",
               points,
               "Weight: which points become heavier, those at the top below "
               "the rectangle, or the whole column of them, by their volume. "
               "They carry it along as they move.");
    add_choice(prm,
               "Mass",
               mass,
               "Weight: has what is built up no inertia (weight alone), or "
               "does it become mass of the points (with mass)? Mass comes "
               "with the velocity of its point.");
  }


  void
  WeightLoadParameters::check(const unsigned int dim,
                              const std::string &path) const
  {
    for (const auto &[entry, values] :
         {std::make_pair("From", &from), std::make_pair("To", &to)})
      if (values->size() != dim - 1)
        throw UserError(path + entry,
                        "has " + counted(values->size(), "number"),
                        std::string(dim == 2 ? "1 number, x"
                                             : "2 numbers, x and z") +
                          " (Dimension = " + std::to_string(dim) + ")" +
                          decimals_with_a_point);
    for (unsigned int d = 0; d < dim - 1; ++d)
      if (!(from[d] < to[d]))
        throw UserError(path + "To",
                        "is " + in_digits(to[d]) + " m in direction " +
                          (d == 0 ? "x" : "z") + ", From " +
                          in_digits(from[d]) + " m",
                        "above From");
    require_positive(path + "Unit weight", unit_weight, " kN/m^3");
  }


  double
  WeightLoadParameters::area() const
  {
    double area = 1.;
    for (std::size_t d = 0; d < from.size(); ++d)
      area *= to[d] - from[d];
    return area;
  }


  namespace
  {
    /// Of a rectangle, seen from above, in parts that lie each within or
    /// without the domain of any point.
    template <int dim>
    class Parts
    {
    public:
      Parts(const WeightLoadParameters &rectangle,
            const double                tolerance,
            const MaterialPoints<dim>  &points)
        : tolerance(tolerance)
      {
        for (unsigned int d = 0; d < dim - 1; ++d)
          {
            const unsigned int   axis = 2 * d; // x, z
            std::vector<double> &e    = edges[d];
            e                         = {rectangle.from[d], rectangle.to[d]};
            for (std::size_t p = 0; p < points.n_points(); ++p)
              for (const double side : {-1., 1.})
                {
                  const double x =
                    points.position[p][axis] + side * points.half_size[p][axis];
                  if (x > rectangle.from[d] && x < rectangle.to[d])
                    e.push_back(x);
                }
            std::sort(e.begin(), e.end());
            // What round-off has parted is one.
            const double last = e.back();
            e.erase(std::unique(e.begin(),
                                e.end(),
                                [&](const double a, const double b) {
                                  return b - a <= tolerance;
                                }),
                    e.end());
            e.back() = last;
            n[d]     = e.size() - 1;
          }
      }

      std::size_t
      size() const
      {
        return dim == 2 ? n[0] : n[0] * n[dim - 2];
      }

      double
      area(const std::size_t part) const
      {
        const std::size_t i = part % n[0];
        double            a = edges[0][i + 1] - edges[0][i];
        if (dim == 3)
          {
            const std::vector<double> &z = edges[dim - 2];
            const std::size_t          k = part / n[0];
            a *= z[k + 1] - z[k];
          }
        return a;
      }

      /// f(part) for each one below which the point lies.
      template <typename Function>
      void
      for_each_over(const MaterialPoints<dim> &points,
                    const std::size_t          p,
                    const Function            &f) const
      {
        std::array<std::size_t, 2> first{{0, 0}}, last{{0, 1}};
        for (unsigned int d = 0; d < dim - 1; ++d)
          {
            const unsigned int axis = 2 * d;
            const double       x    = points.position[p][axis];
            const double       half = points.half_size[p][axis];
            first[d]                = place(d, x - half);
            last[d]                 = place(d, x + half);
          }
        for (std::size_t k = first[1]; k < last[1]; ++k)
          for (std::size_t i = first[0]; i < last[0]; ++i)
            f(k * n[0] + i);
      }

      /// Middle of a part in a direction (m).
      double
      middle(const std::size_t part, const unsigned int d) const
      {
        const std::size_t i = d == 0 ? part % n[0] : part / n[0];
        return 0.5 * (edges[d][i] + edges[d][i + 1]);
      }

    private:
      /// Number of the edge at x; the first one beyond, if there is none.
      std::size_t
      place(const unsigned int d, const double x) const
      {
        const std::vector<double> &e = edges[d];
        return std::min<std::size_t>(
          std::lower_bound(e.begin(), e.end(), x - tolerance) - e.begin(),
          n[d]);
      }

      std::array<std::vector<double>, dim - 1> edges;
      std::array<std::size_t, dim - 1>         n;
      double                                   tolerance;
    };


    template <int dim>
    double
    top_of(const MaterialPoints<dim> &points, const std::size_t p)
    {
      return points.position[p][1] + points.half_size[p][1];
    }


    /// The highest point of each part.
    /// @throws UserError if there is none, or if they are not level
    template <int dim>
    std::vector<std::size_t>
    highest_points(const Parts<dim>          &parts,
                   const std::string         &path,
                   const double               cell_size,
                   const MaterialPoints<dim> &points)
    {
      constexpr auto           none = std::numeric_limits<std::size_t>::max();
      std::vector<std::size_t> highest(parts.size(), none);
      for (std::size_t p = 0; p < points.n_points(); ++p)
        parts.for_each_over(points, p, [&](const std::size_t part) {
          if (highest[part] == none ||
              top_of(points, p) > top_of(points, highest[part]))
            highest[part] = p;
        });
      double lowest_top  = std::numeric_limits<double>::max();
      double highest_top = std::numeric_limits<double>::lowest();
      for (std::size_t part = 0; part < parts.size(); ++part)
        {
          if (highest[part] == none)
            throw UserError(
              path + "From",
              "the rectangle reaches beyond the soil: there is none at x = " +
                in_digits(parts.middle(part, 0)) +
                (dim == 3 ? ", z = " + in_digits(parts.middle(part, dim - 2))
                          : std::string()) +
                " m",
              "a rectangle all of which lies over soil");
          lowest_top  = std::min(lowest_top, top_of(points, highest[part]));
          highest_top = std::max(highest_top, top_of(points, highest[part]));
        }
      if (highest_top - lowest_top > cell_size * (1. + 1e-9))
        throw UserError(path + "From",
                        "the soil below the rectangle is not level: it rises "
                        "to " +
                          in_digits(lowest_top) + " m in one place, to " +
                          in_digits(highest_top) + " m in another",
                        "a rectangle on the crest, or on other ground that is "
                        "level to within a cell (" +
                          in_digits(cell_size) + " m)");
      return highest;
    }
  } // namespace


  template <int dim>
  std::vector<double>
  weight_per_metre(const WeightLoadParameters &parameters,
                   const std::string          &path,
                   const double                cell_size,
                   const MaterialPoints<dim>  &points)
  {
    const Parts<dim>               parts(parameters, 1e-9 * cell_size, points);
    const std::vector<std::size_t> highest =
      highest_points(parts, path, cell_size, points);
    std::vector<double> weight(points.n_points());
    if (parameters.points == LoadedPoints::top)
      {
        for (std::size_t part = 0; part < parts.size(); ++part)
          weight[highest[part]] += parameters.unit_weight * parts.area(part);
        return weight;
      }

    // Volume of a point per area of its domain: what it has below a part.
    const auto depth = [&](const std::size_t p) {
      double area = 1.;
      for (unsigned int d = 0; d < dim; d += 2)
        area *= 2. * points.half_size[p][d];
      return points.volume[p] / area;
    };
    std::vector<double> total(parts.size());
    for (std::size_t p = 0; p < points.n_points(); ++p)
      parts.for_each_over(points, p, [&](const std::size_t part) {
        total[part] += depth(p);
      });
    for (std::size_t p = 0; p < points.n_points(); ++p)
      parts.for_each_over(points, p, [&](const std::size_t part) {
        weight[p] +=
          parameters.unit_weight * parts.area(part) * depth(p) / total[part];
      });
    return weight;
  }


  template <int dim>
  void
  add_weight(const std::vector<double> &weight,
             const double               factor,
             const Weights<dim>        &weights,
             NodalVector               &force)
  {
    if (factor == 0.)
      return;
    const Stencil<dim> stencil(weights.background_grid());
    for (std::size_t p = 0; p < weight.size(); ++p)
      if (weight[p] != 0.)
        {
          Tensor<1, dim> f;
          f[1] = -factor * weight[p];
          stencil.scatter_value(weights[p], f, force.begin());
        }
  }


  template std::vector<double>
  weight_per_metre(const WeightLoadParameters &,
                   const std::string &,
                   const double,
                   const MaterialPoints<2> &);
  template std::vector<double>
  weight_per_metre(const WeightLoadParameters &,
                   const std::string &,
                   const double,
                   const MaterialPoints<3> &);
  template void
  add_weight(const std::vector<double> &,
             const double,
             const Weights<2> &,
             NodalVector &);
  template void
  add_weight(const std::vector<double> &,
             const double,
             const Weights<3> &,
             NodalVector &);
} // namespace Waker
