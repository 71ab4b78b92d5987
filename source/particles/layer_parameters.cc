// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/particles/soil_profile.h>

#include <algorithm>

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
                      "either orientation. In 3D it is a prism along z.",
                      Patterns::Anything());
    prm.add_parameter("Extent",
                      extent,
                      "3D only: the layer reaches from z0 to z1 (m), \"z0, "
                      "z1\". Empty: over the whole grid.",
                      Patterns::List(Patterns::Double()));
    prm.add_parameter("Top",
                      top,
                      "3D only: file of a height map (m). What lies above it "
                      "is no part of the layer. A table with commas, its first "
                      "line \"x, z, y\", of the heights y at all places of a "
                      "rectangular grid, or an STL surface (*.stl). Empty: "
                      "none.",
                      Patterns::FileName(Patterns::FileName::input));
    prm.add_parameter("Bottom",
                      bottom,
                      "3D only: as Top, but what lies below is no part of the "
                      "layer. Layers that have one file as Top and Bottom "
                      "touch.",
                      Patterns::FileName(Patterns::FileName::input));
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
                      "needs Gravity/Initial stress = false, and a law that "
                      "bears it, with the material's own strength, whatever "
                      "a random field makes of that. Empty: none, or that of "
                      "the gravity step.",
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
                      "volume is lost. Only with Placement = sub-cells.",
                      Patterns::Double(0., 0.5));
    add_choice(prm,
               "Placement",
               placement,
               "sub-cells: points on the lattice of the grid's "
               "sub-cells, cut by the layers' edges. whole sub-cells: a "
               "point of whole volume in each sub-cell that soil fills at "
               "least by half, so that slopes are stairs. rows: each row of "
               "sub-cells is divided into rectangles from edge to edge "
               "of a layer, so that support domains fill it and slopes "
               "cut the middle of the outermost ones; corners of "
               "slopes should lie on lines between the rows.");
  }
} // namespace Waker
