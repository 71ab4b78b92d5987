// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/numbers.h>

#include <waker/base/errors.h>
#include <waker/base/text.h>
#include <waker/loads/facet_clip.h>
#include <waker/loads/traction.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    template <int dim>
    Tensor<1, dim>
    to_tensor(const std::vector<double> &values)
    {
      Assert(values.size() == dim, ExcDimensionMismatch(values.size(), dim));
      Tensor<1, dim> x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = values[d];
      return x;
    }
  } // namespace


  template <int dim>
  Traction<dim>::Traction(const TractionParameters &parameters,
                          const double              tolerance)
    : kind(parameters.kind)
    , liquid{parameters.unit_weight, 0.}
    , tolerance(tolerance)
    , holes(parameters.holes)
  {
    const std::string path = "Tractions/" + parameters.name + "/";
    if (kind == TractionKind::hydrostatic)
      level = TimeFunction(parameters.level, path + "Level");
    else
      {
        const std::vector<std::string> parts = split(parameters.value, ';');
        const unsigned int n = kind == TractionKind::vector ? dim : 1;
        if (parts.size() != n ||
            std::count(parts.begin(), parts.end(), "") != 0)
          throw UserError(path + "Value",
                          "\"" + parameters.value + "\" has " +
                            std::to_string(parts.size()) +
                            " numbers or expressions",
                          std::to_string(n) + " (kPa) for a " +
                            name_of(parameters.kind) + " in " +
                            std::to_string(dim) + "D, with \";\" between them");
        for (const std::string &part : parts)
          {
            expressions.emplace_back(part, path + "Value");
            uniform = uniform && expressions.back().is_uniform();
          }
      }

    if (!parameters.from.empty())
      {
        has_box = true;
        lower   = Point<dim>(to_tensor<dim>(parameters.from));
        upper   = Point<dim>(to_tensor<dim>(parameters.to));
      }
    if (!parameters.facing.empty())
      {
        faces  = true;
        facing = to_tensor<dim>(parameters.facing);
        facing /= facing.norm();
        // A normal at the very limit belongs to it.
        least_cosine = std::cos(parameters.opening * numbers::PI / 180.) - 1e-9;
      }
    set_time(0.);
  }


  template <int dim>
  void
  Traction<dim>::select(const Facets<dim> &surface, Facets<dim> &part)
  {
    part.clear();
    for (const Facet<dim> &facet : surface)
      if (facet.on_face < 0 && (holes || !facet.in_hole) &&
          !(faces && facet.normal * facing < least_cosine))
        part.push_back(facet);
    if (has_box)
      for (unsigned int d = 0; d < dim; ++d)
        {
          Tensor<1, dim> axis;
          axis[d] = 1.;
          keep_below(axis, upper[d], tolerance, part, work);
          keep_below(-axis, -lower[d], tolerance, part, work);
        }
  }


  template <int dim>
  void
  Traction<dim>::set_time(const double t)
  {
    time         = t;
    liquid.level = level.value(t);
    if (uniform)
      for (unsigned int i = 0; i < expressions.size(); ++i)
        constant[i] = expressions[i].value(Point<dim>(), t);
  }


  template <int dim>
  void
  Traction<dim>::keep_loaded(Facets<dim> &part)
  {
    if (kind != TractionKind::hydrostatic)
      return;
    Tensor<1, dim> up;
    up[1] = 1.;
    keep_below(up, liquid.level, 0., part, work);
  }


  template <int dim>
  Tensor<1, dim>
  Traction<dim>::value(const Tensor<1, dim> &normal, const Point<dim> &x) const
  {
    const auto number = [&](const unsigned int i) {
      return uniform ? constant[i] : expressions[i].value(x, time);
    };
    switch (kind)
      {
        case TractionKind::vector:
          {
            Tensor<1, dim> q;
            for (unsigned int d = 0; d < dim; ++d)
              q[d] = number(d);
            return q;
          }
        case TractionKind::pressure:
          return -number(0) * normal;
        case TractionKind::hydrostatic:
          return -liquid.pressure(x[1]) * normal;
      }
    Assert(false, ExcInternalError());
    return {};
  }


  template <int dim>
  Tensor<1, dim>
  Traction<dim>::force(const double          start_measure,
                       const Tensor<1, dim> &area,
                       const Point<dim>     &X) const
  {
    Assert(kind != TractionKind::hydrostatic, ExcInternalError());
    return kind == TractionKind::vector ? start_measure * value(area, X)
                                        : value(area, X);
  }


  template <int dim>
  bool
  Traction<dim>::moves() const
  {
    return level.moves() ||
           std::any_of(expressions.begin(),
                       expressions.end(),
                       [](const Expression<dim> &e) { return e.moves(); });
  }


  template <int dim>
  double
  Traction<dim>::last_change() const
  {
    double last = level.last_change();
    for (const Expression<dim> &expression : expressions)
      last = std::max(last, expression.last_change());
    return last;
  }


  template <int dim>
  bool
  Traction<dim>::varies(const Facets<dim> &surface,
                        const double       from,
                        const double       to) const
  {
    if (level.varies(from, to))
      return true;
    // A hundred of the facets will do.
    const std::size_t stride = surface.size() / 100 + 1;
    for (const Expression<dim> &expression : expressions)
      {
        if (expression.is_uniform() &&
            expression.varies(Point<dim>(), from, to))
          return true;
        for (std::size_t f = 0; f < surface.size() && !expression.is_uniform();
             f += stride)
          if (expression.varies(surface[f].vertices[0], from, to))
            return true;
      }
    return false;
  }


  template class Traction<2>;
  template class Traction<3>;
} // namespace Waker
