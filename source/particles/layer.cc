// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <waker/base/errors.h>
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
    prm.add_parameter(
      "Velocity",
      velocity,
      "Initial velocity of the layer (m/s): per component a "
      "number or an expression of x, y, z (m);     prm.add_parameter(" Initial
        stress ",
      initial_stress,
      "Initial stress of the layer (kPa, tension positive): "
      "xx, yy, zz, xy and, in 3D, xz, yz, each a number or an "
      "expression of x, y, z (m), separated by semicolons. It "
      "needs Gravity/Initial stress = false. Empty: none.",
      Patterns::Anything());
for example "
                      "\"0.1*sin(pi*x/50); 0\". Empty: at rest.",
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
    const char separator = velocity.find(';') != std::string::npos ? ';' : ',';
    const std::vector<std::string> parts =
      Utilities::split_string_list(velocity, separator);
    if (!parts.empty() && (parts.size() != dim ||
                           std::count(parts.begin(), parts.end(), "") != 0))
      throw UserError("Soil profile/" + name + "/Velocity",
                      "\"" + velocity + "\" has " +
                        std::to_string(parts.size()) +
                        " numbers or expressions",
                      std::to_string(dim) + " numbers or expressions in " +
                        std::to_string(dim) +
                        "D with \";\" between them, or nothing");
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
                      "volume is lost.",
                      Patterns::Double(0., 0.5));
    prm.add_parameter("Placement",
                      placement,
                      "sub-cells: points on the lattice of the grid's "
                      "sub-cells, cut by the layers' edges. rows: each row of "
                      "sub-cells is divided into rectangles from edge to edge "
                      "of a layer, so that support domains fill it and slopes "
                      "cut the middle of the outermost ones.",
                      Patterns::Selection("sub-cells|rows"));
  }


  namespace
  {
    std::string
    interval(const double begin, const double end)
    {
      return to_text(begin) + " to " + to_text(end) + " m";
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
                          "the corner (" + to_text(corner[0]) + ", " +
                            to_text(corner[1]) + ") lies outside the grid",
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

    const std::string path = layer.path + "/Velocity";
    for (const std::string &text : parameters.velocity_components(dim))
      {
        layer.velocity.emplace_back(text, path);
        if (layer.velocity.back().moves())
          throw UserError(path,
                          "\"" + text + "\" depends on the time t",
                          "expressions of the place only");
      }
  }


  template <int dim>
  Tensor<1, dim>
  Layer<dim>::velocity_at(const Point<dim> &x) const
  {
    Tensor<1, dim> v;
    for (unsigned int d = 0; d < velocity.size(); ++d)
      {
        v[d] = velocity[d].value(x, 0.);
        if (!std::isfinite(v[d]))
          {
            std::ostringstream where;
            where << "\"" << velocity[d].text() << "\" is " << v[d]
                  << " at the point (" << x << ") m";
            throw UserError(path + "/Velocity",
                            where.str(),
                            "a finite number (m/s) at every point");
          }
      }
    return v;
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
                              to_text(area) + " m^2",
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
