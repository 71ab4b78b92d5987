// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/places.h>
#include <waker/particles/layer.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Waker
{
  void
  LayerParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Material",
                      material,
                      "Material of the layer: one of Materials/Names.",
                      Patterns::Anything());
    prm.add_parameter("Polygon",
                      polygon,
                      "Corners of the layer (m), \"x1, y1; x2, y2; ...\", in "
                      "either orientation. In 3D it is extruded along z.",
                      Patterns::Anything());
    prm.add_parameter("Extent",
                      extent,
                      "3D only: the layer reaches from z0 to z1 (m), \"z0, "
                      "z1\". Empty: over the whole grid.",
                      Patterns::List(Patterns::Double()));
    prm.add_parameter("Velocity",
                      velocity,
                      "Initial velocity of the layer (m/s): per component a "
                      "number or an expression of x, y, z (m), with \";\" "
                      "between them; for example \"0.1*sin(pi*x/50); 0\". "
                      "Empty: at rest.",
                      Patterns::Anything());
    prm.add_parameter("Initial stress",
                      initial_stress,
                      "Initial stress of the layer (kPa, tension positive): "
                      "xx; yy; zz; xy and, in 3D, xz; yz, each a number or an "
                      "expression of x, y, z (m), with \";\" between them. It "
                      "needs Gravity/Initial stress = false. Empty: none, or "
                      "that of the gravity step.",
                      Patterns::Anything());
  }


  Polygon
  LayerParameters::corners() const
  {
    return parse_polygon(polygon, "Soil profile/" + name + "/Polygon");
  }


  std::vector<std::string>
  LayerParameters::velocity_components(const unsigned int dim) const
  {
    const std::vector<std::string> parts =
      Utilities::split_string_list(velocity, ';');
    if (!parts.empty() && (parts.size() != dim ||
                           std::count(parts.begin(), parts.end(), "") != 0))
      throw UserError(
        "Soil profile/" + name + "/Velocity",
        "\"" + velocity + "\" has " + std::to_string(parts.size()) +
          (parts.size() == 1 ? " number or expression"
                             : " numbers or expressions"),
        std::to_string(dim) + " numbers or expressions in " +
          std::to_string(dim) + "D with \";\" between them, or nothing" +
          (velocity.find(',') != std::string::npos ? decimals_with_a_point
                                                   : ""));
    return parts;
  }


  std::vector<std::string>
  LayerParameters::stress_components(const unsigned int dim) const
  {
    const std::vector<std::string> parts =
      Utilities::split_string_list(initial_stress, ';');
    const unsigned int n = dim == 2 ? 4 : 6;
    if (!parts.empty() &&
        (parts.size() != n || std::count(parts.begin(), parts.end(), "") != 0))
      throw UserError("Soil profile/" + name + "/Initial stress",
                      "\"" + initial_stress + "\" has " +
                        std::to_string(parts.size()) +
                        " numbers or expressions",
                      std::string(dim == 2 ? "\"xx; yy; zz; xy\" in 2D"
                                           : "\"xx; yy; zz; xy; xz; yz\" in "
                                             "3D") +
                        ", or nothing");
    return parts;
  }


  void
  MaterialPointParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Points per direction",
                      points_per_direction,
                      "Material points per cell and direction (1 to 10).",
                      Patterns::Integer(1, 10));
    prm.add_parameter("Minimum cut",
                      minimum_cut,
                      "A point's sub-cell of which a slope leaves less than "
                      "this share (0 to 0.5) is given to its neighbour; no "
                      "volume is lost. Rows have no cut sub-cells.",
                      Patterns::Double(0., 0.5));
    add_choice(prm,
               "Placement",
               placement,
               "sub-cells: points on the lattice of the grid's "
               "sub-cells, cut by the layers' edges. rows: each row of "
               "sub-cells is divided into rectangles from edge to edge "
               "of a layer, so that support domains fill it and slopes "
               "cut the middle of the outermost ones; corners of "
               "slopes should lie on lines between the rows.");
  }


  namespace
  {
    std::string
    interval(const double begin, const double end)
    {
      return in_digits(begin) + " to " + in_digits(end) + " m";
    }


    template <int dim>
    std::vector<Expression<dim>>
    expressions_of_place(const std::vector<std::string> &texts,
                         const std::string              &path)
    {
      std::vector<Expression<dim>> expressions;
      for (const std::string &text : texts)
        {
          try
            {
              expressions.emplace_back(text, path);
            }
          catch (const UserError &)
            {
              // The same, but t is not offered.
              NamedExpression(text,
                              path,
                              dim == 2
                                ? std::vector<std::string>{"x", "y"}
                                : std::vector<std::string>{"x", "y", "z"});
              throw;
            }
          if (expressions.back().moves())
            throw UserError(path,
                            "\"" + text + "\" depends on the time t",
                            "expressions of the place only");
        }
      return expressions;
    }


    /// @throws UserError if the value at x is no finite number
    template <int dim>
    double
    finite_value(const Expression<dim> &expression,
                 const Point<dim>      &x,
                 const std::string     &path,
                 const std::string     &unit)
    {
      const double value = expression.value(x, 0.);
      if (!std::isfinite(value))
        {
          std::ostringstream where;
          where << "\"" << expression.text() << "\" is ";
          if (std::isnan(value))
            where << "not a number";
          else
            where << value;
          where << " at the point " << place_text(x) << " m";
          throw UserError(path,
                          where.str(),
                          "a finite number (" + unit + ") at every point");
        }
      return value;
    }
  } // namespace


  template <int dim>
  Layer<dim>
  place_layer(const BackgroundGrid<dim> &grid,
              const LayerParameters     &parameters)
  {
    const Point<dim> &lower     = grid.lower_corner();
    const Point<dim> &upper     = grid.upper_corner();
    const double      tolerance = 1e-10 * grid.cell_size();

    Layer<dim> layer;
    layer.path    = "Soil profile/" + parameters.name;
    layer.corners = parameters.corners();
    for (const auto &corner : layer.corners)
      for (unsigned int d = 0; d < 2; ++d)
        if (!(corner[d] >= lower[d] - tolerance &&
              corner[d] <= upper[d] + tolerance))
          throw UserError(layer.path + "/Polygon",
                          "the corner (" + in_digits(corner[0]) + ", " +
                            in_digits(corner[1]) + ") lies outside the grid",
                          "x from " + interval(lower[0], upper[0]) +
                            " and y from " + interval(lower[1], upper[1]));

    const std::vector<double> &extent = parameters.extent;
    if (dim == 2 && !extent.empty())
      throw UserError(layer.path + "/Extent",
                      "is given, but the case is 2D",
                      "no extent in 2D");
    if (dim == 3)
      {
        const std::string allowed =
          "two numbers \"z0, z1\", z0 below z1, from " +
          interval(lower[dim - 1], upper[dim - 1]) + ", or nothing";
        if (!extent.empty() && extent.size() != 2)
          throw UserError(layer.path + "/Extent",
                          "has " + std::to_string(extent.size()) + " numbers",
                          allowed);
        layer.begin = extent.empty() ? lower[dim - 1] : extent[0];
        layer.end   = extent.empty() ? upper[dim - 1] : extent[1];
        if (!(layer.begin >= lower[dim - 1] - tolerance &&
              layer.end <= upper[dim - 1] + tolerance &&
              layer.end - layer.begin > tolerance))
          throw UserError(layer.path + "/Extent",
                          "reaches from " + interval(layer.begin, layer.end),
                          allowed);
      }
    return layer;
  }


  template <int dim>
  void
  fill_layer(const LayerParameters          &parameters,
             const std::vector<std::string> &material_names,
             Layer<dim>                     &layer)
  {
    const auto material = std::find(material_names.begin(),
                                    material_names.end(),
                                    parameters.material);
    if (material == material_names.end())
      {
        std::string known;
        for (const std::string &name : material_names)
          known += (known.empty() ? "" : ", ") + name;
        throw UserError(layer.path + "/Material",
                        "the material \"" + parameters.material +
                          "\" is unknown",
                        known.empty() ? "(there are no materials)" : known);
      }
    layer.material = material - material_names.begin();

    layer.velocity =
      expressions_of_place<dim>(parameters.velocity_components(dim),
                                layer.path + "/Velocity");
    layer.stress = expressions_of_place<dim>(parameters.stress_components(dim),
                                             layer.path + "/Initial stress");
  }


  template <int dim>
  Tensor<1, dim>
  Layer<dim>::velocity_at(const Point<dim> &x) const
  {
    Tensor<1, dim> v;
    for (unsigned int d = 0; d < velocity.size(); ++d)
      v[d] = finite_value(velocity[d], x, path + "/Velocity", "m/s");
    return v;
  }


  template <int dim>
  SymmetricTensor<2, 3>
  Layer<dim>::stress_at(const Point<dim> &x) const
  {
    // The order in which the user writes the components.
    constexpr unsigned int places[6][2] = {
      {0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
    SymmetricTensor<2, 3> sigma;
    for (unsigned int k = 0; k < stress.size(); ++k)
      sigma[places[k][0]][places[k][1]] =
        finite_value(stress[k], x, path + "/Initial stress", "kPa");
    return sigma;
  }


  template <int dim>
  void
  check_overlap(const std::vector<Layer<dim>> &layers)
  {
    for (unsigned int i = 0; i < layers.size(); ++i)
      for (unsigned int j = 0; j < i; ++j)
        {
          const Layer<dim> &a = layers[i], &b = layers[j];
          const double      depth =
            std::min(a.end, b.end) - std::max(a.begin, b.begin);
          if (depth <= 1e-9 * std::min(a.end - a.begin, b.end - b.begin))
            continue;
          const double area = common_area(a.corners, b.corners);
          if (area >
              1e-9 * std::min(signed_area(a.corners), signed_area(b.corners)))
            throw UserError(a.path + "/Polygon",
                            "overlaps \"" + b.path + "\" over " +
                              in_digits(area) + " m^2",
                            "layers that touch at most");
        }
  }


  template struct Layer<2>;
  template struct Layer<3>;
  template Layer<2>
  place_layer(const BackgroundGrid<2> &, const LayerParameters &);
  template Layer<3>
  place_layer(const BackgroundGrid<3> &, const LayerParameters &);
  template void
  fill_layer(const LayerParameters &,
             const std::vector<std::string> &,
             Layer<2> &);
  template void
  fill_layer(const LayerParameters &,
             const std::vector<std::string> &,
             Layer<3> &);
  template void
  check_overlap(const std::vector<Layer<2>> &);
  template void
  check_overlap(const std::vector<Layer<3>> &);
} // namespace Waker
