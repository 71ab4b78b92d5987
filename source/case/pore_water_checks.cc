// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pore_water_checks.h"

#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>

#include "head_line_checks.h"
#include <algorithm>

namespace Waker
{
  namespace
  {
    /// Is there no water in it, ever?
    bool
    stays_above_line(const Parameters &p, const MaterialParameters &material)
    {
      return !tidy(material.below_line).empty() &&
             p.pore_water.pressure_of == PorePressureOf::soil &&
             p.pore_water.largest_suction == 0.;
    }


    /// Also without a line, for names are names.
    void
    check_below_line(const Parameters &p, const MaterialParameters &material)
    {
      const std::string path = "Materials/" + material.name + "/Below the line";
      const std::string below = tidy(material.below_line);
      if (below.empty())
        return;
      std::string others;
      for (const MaterialParameters &other : p.materials)
        if (other.name != material.name && tidy(other.below_line).empty())
          others += (others.empty() ? "" : ", ") + other.name;
      const bool is_known = std::any_of(p.materials.begin(),
                                        p.materials.end(),
                                        [&](const MaterialParameters &other) {
                                          return other.name == below &&
                                                 &other != &material &&
                                                 tidy(other.below_line).empty();
                                        });
      if (!is_known)
        throw UserError(path,
                        "is " + in_quotes(below),
                        "another material that is itself below the line" +
                          (others.empty() ? "; there is none" : ": " + others));
      for (const InflowParameters &inflow : p.inflows)
        if (inflow.material == material.name)
          throw UserError(path,
                          "is " + in_quotes(below) +
                            ", but the soil flows in (Inflow/" + inflow.name +
                            "), above the line or below",
                          "nothing for soil that flows in");
    }
  } // namespace


  void
  check_pore_water(const Parameters &p)
  {
    p.pore_water.check();
    check_quick_loads(p);
    for (const MaterialParameters &material : p.materials)
      {
        check_below_line(p, material);
        // Its law would get no stress that it could take the pressure from.
        if (material.pore_fluid_stiffness > 0. &&
            p.mapping.strain == StrainMeasure::logarithmic)
          throw UserError("Materials/" + material.name +
                            "/Pore fluid stiffness",
                          "is " + in_digits(material.pore_fluid_stiffness) +
                            " kPa, with logarithmic strain",
                          "0, or Kinematics and mapping/Strain = step");
      }
    if (!p.pore_water.is_there())
      {
        check_without_line(p);
        if (!tidy(p.pore_water.daily_phreatic_line).empty())
          throw UserError("Pore water/Daily phreatic line",
                          "is there, and Phreatic line is empty",
                          "empty, or a phreatic line as well");
        for (const MaterialParameters &material : p.materials)
          if (p.water.stands() && material.has_friction())
            throw UserError("Materials/" + material.name + "/Model",
                            std::string("is ") + name_of(material.model) +
                              " with friction, and water stands on the " +
                              name_of(p.water.side) +
                              ": as on a watertight skin, its pressure would "
                              "press the grains together",
                            "a phreatic line (Pore water/Phreatic line; below "
                            "all soil if that is dry), or Water/Side = none");
        return;
      }
    for (const MaterialParameters &material : p.materials)
      {
        const std::string path =
          "Materials/" + material.name + "/Saturated unit weight";
        if (!(material.saturated_unit_weight > 0.))
          continue;
        // Its volume without strain is that of the mass and the density.
        if (p.mapping.strain == StrainMeasure::logarithmic)
          throw UserError(path,
                          "is " + in_digits(material.saturated_unit_weight) +
                            " kN/m^3, with logarithmic strain",
                          "0, or Kinematics and mapping/Strain = step");
        for (const InflowParameters &inflow : p.inflows)
          if (inflow.material == material.name)
            throw UserError(path,
                            "is " + in_digits(material.saturated_unit_weight) +
                              " kN/m^3, but the soil flows in (Inflow/" +
                              inflow.name + "), above the line or below",
                            "0 for soil that flows in");
      }
    // The pressure in the ground acts on nodes with hardly any soil, too:
    // they are in balance only if that of the water outside does, on the same
    // surface of the support domains.
    const bool is_drained =
      std::any_of(p.materials.begin(),
                  p.materials.end(),
                  [&](const MaterialParameters &m) {
                    return m.is_drained() && !stays_above_line(p, m);
                  });
    for (const WallParameters &wall : p.walls)
      if (is_drained && wall.type == WallType::frictional &&
          wall.friction() > 0.)
        throw UserError(
          "Walls/" + wall.name + "/Type",
          "is frictional, and there is drained soil with water in "
          "it, whose pressure would count as friction",
          "rough, smooth, Adhesion instead of friction, or no "
          "phreatic line");
    if (is_drained && p.water.stands() && p.water.minimum_support > 0.)
      throw UserError("Water/Minimum support",
                      "is " + in_digits(p.water.minimum_support) +
                        ", but there is drained soil with water in it, which "
                        "would boil",
                      "0");
    if (is_drained && p.water.stands() &&
        p.surface.method != SurfaceMethod::contour)
      throw UserError("Surface/Method",
                      std::string("is ") + name_of(p.surface.method) +
                        ", but there is drained soil with water in it, which "
                        "would boil",
                      "contour");
    // Where soil is lower than the section by a hair, the load of that is on
    // nodes without any.
    if (is_drained && p.dimension == 3 && p.surface.prismatic &&
        p.water.stands())
      throw UserError("Surface/Prismatic",
                      "is true, but there is drained soil with water in it, "
                      "which would boil: the water outside must act where each "
                      "place along z ends",
                      "false, or the plane (Dimension = 2)");
    for (const TractionParameters &traction : p.tractions)
      if (is_drained && traction.kind == TractionKind::hydrostatic &&
          traction.minimum_support > 0.)
        throw UserError("Tractions/" + traction.name + "/Minimum support",
                        "is " + in_digits(traction.minimum_support) +
                          ", but there is drained soil with water in it, "
                          "which would boil",
                        "0");
    check_lines_of_water(p);
  }
} // namespace Waker
