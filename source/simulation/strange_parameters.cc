// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/expression_pattern.h>
#include <waker/case/load_programmes.h>
#include <waker/mechanics/time_scheme.h>
#include <waker/particles/layer_gaps.h>
#include <waker/simulation/plausibility.h>

#include "plausible_ranges.h"
#include <cmath>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// Set, but of no effect with what has been chosen.
    void
    warn_unused(const bool                is_set,
                const std::string        &path,
                const std::string        &choice,
                std::vector<std::string> &warnings)
    {
      if (is_set)
        warnings.push_back(path + " is not used with " + choice);
    }


    void
    check_unused(const Parameters &p, std::vector<std::string> &warnings)
    {
      for (const TractionParameters &t : p.tractions)
        {
          const TractionParameters usual;
          const std::string        path = "Tractions/" + t.name + "/";
          const std::string choice = std::string("Kind = ") + name_of(t.kind);
          const bool        liquid = t.kind == TractionKind::hydrostatic;
          warn_unused(!liquid && t.level != usual.level,
                      path + "Level",
                      choice,
                      warnings);
          warn_unused(!liquid && t.unit_weight != usual.unit_weight,
                      path + "Unit weight",
                      choice,
                      warnings);
          warn_unused(liquid && t.value != usual.value,
                      path + "Value",
                      choice,
                      warnings);
        }
      const WaterParameters dry;
      if (!p.water.stands())
        warn_unused(p.water.unit_weight != dry.unit_weight,
                    "Water/Unit weight",
                    "Side = none",
                    warnings);
      warn_unused(!p.gravity.initial_stress && p.gravity.initial_share != 1.,
                  "Gravity/Initial share",
                  "Initial stress = false",
                  warnings);
      const TimeParameters usual;
      warn_unused(scheme_traits(p.time).is_implicit &&
                    p.time.courant_number != usual.courant_number,
                  "Time stepping/Courant number",
                  std::string("Scheme = ") + name_of(p.time.scheme),
                  warnings);
    }


    /// Legal, and apt to give a failure that is none.
    void
    check_water(const Parameters &p, std::vector<std::string> &warnings)
    {
      if (p.surface.method == SurfaceMethod::contour &&
          !std::isnan(p.water.level) &&
          p.initial_failure.limits.width_change < p.grid.cell_size)
        {
          std::ostringstream text;
          text << "Initial failure/Width change: "
               << p.initial_failure.limits.width_change
               << " m, but on the contour the width moves in steps of up to a "
                  "cell, "
               << p.grid.cell_size
               << " m, where a support domain passes the level";
          warnings.push_back(text.str());
        }
      if (p.water.stands() &&
          p.mapping.volumetric_strain == VolumetricStrain::b_bar_everywhere)
        warnings.push_back(
          "Kinematics and mapping/Volumetric strain = B-bar in all cells: soil "
          "in cells that it hardly fills may boil under water; B-bar leaves "
          "those alone");
      if (p.water.stands() && p.water.minimum_support < 1e-3)
        {
          std::ostringstream text;
          text << "Water/Minimum support: water may load nodes with hardly any "
                  "soil ("
               << p.water.minimum_support
               << "; 0.01 is usual): the soil there may move for ever, or the "
                  "dyke seem to fail";
          warnings.push_back(text.str());
        }
    }


    void
    check_material(const MaterialParameters &m, Ranges &ranges)
    {
      const std::string path = "Materials/" + m.name + "/";
      ranges.check(
        path + "Unit weight", m.unit_weight, 5., 30., " kN/m^3", "soils have");
      ranges.check(path + "Young's modulus",
                   m.elastic.youngs_modulus,
                   50.,
                   3e8,
                   " kPa",
                   "peat to steel has");
      ranges.check(path + "Poisson's ratio",
                   m.elastic.poissons_ratio,
                   0.,
                   0.495,
                   "",
                   "usual is");
      // Of an expression the points know the values.
      if (m.strength() == nullptr)
        return;
      if (const auto strength = plain_number(*m.strength()))
        check_strength(path, *strength, m.elastic.youngs_modulus, ranges);
    }
  } // namespace


  std::vector<std::string>
  strange_parameters(const Parameters &p)
  {
    std::vector<std::string> warnings;
    Ranges                   ranges(warnings);
    for (const MaterialParameters &material : p.materials)
      check_material(material, ranges);
    if (p.gravity.acceleration > 0.)
      ranges.check("Gravity/Acceleration",
                   p.gravity.acceleration,
                   9.7,
                   10.,
                   " m/s^2",
                   "on earth it is");
    if (p.water.stands())
      ranges.check("Water/Unit weight",
                   p.water.unit_weight,
                   9.5,
                   11.,
                   " kN/m^3",
                   "fresh to muddy water has");
    for (const TractionParameters &traction : p.tractions)
      if (traction.kind == TractionKind::hydrostatic)
        ranges.check("Tractions/" + traction.name + "/Unit weight",
                     traction.unit_weight,
                     5.,
                     25.,
                     " kN/m^3",
                     "liquids have");
    if (p.points.points_per_direction == 1)
      warnings.push_back("Material points/Points per direction is 1: stresses "
                         "will be coarse; 2 is usual");

    check_unused(p, warnings);
    check_water(p, warnings);
    for (const std::string &text : unused_in_load_programmes(p))
      warnings.push_back(text);

    for (const LayerGap &gap : layer_gaps(p.layers, 2. * p.grid.cell_size))
      {
        std::ostringstream text;
        text << "Soil profile: between " << gap.one << " and " << gap.other
             << " there is a gap of " << gap.width << " m, " << gap.length
             << " m long, around (" << gap.middle[0] << ", " << gap.middle[1]
             << ") m; layers usually touch";
        warnings.push_back(text.str());
      }
    return warnings;
  }
} // namespace Waker
