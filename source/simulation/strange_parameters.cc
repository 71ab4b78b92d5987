// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/expression_pattern.h>
#include <waker/base/text.h>
#include <waker/case/load_programmes.h>
#include <waker/loads/water_level.h>
#include <waker/materials/shear_strength_table.h>
#include <waker/mechanics/time_scheme.h>
#include <waker/particles/layer_gaps.h>
#include <waker/simulation/plausibility.h>

#include "plausible_ranges.h"
#include "storm_warnings.h"
#include "strange_cam_clay.h"
#include "strange_pore_water.h"
#include "strange_softening.h"
#include "strange_water.h"
#include "unused_parameters.h"
#include "wall_warnings.h"
#include <algorithm>
#include <cmath>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// A liquid on soil with friction, and water in it.
    void
    check_liquids(const Parameters &p, std::vector<std::string> &warnings)
    {
      const bool is_drained =
        std::any_of(p.materials.begin(),
                    p.materials.end(),
                    [](const MaterialParameters &m) {
                      return m.is_drained() && m.pore_fluid_stiffness == 0.;
                    });
      if (p.pore_water.is_there())
        {
          const PhreaticLine line =
            p.pore_water.lines().at(WaterLevel(p.water).at(0.));
          const double left  = line.height(line.begin()),
                       right = line.height(line.end());
          const auto check =
            [&](const std::string &path, const double level, const double end) {
              std::ostringstream text;
              text << "Pore water/Phreatic line ends at " << end << " m, but "
                   << path << " is " << level << " m";
              if (std::abs(end - level) > p.grid.cell_size)
                warnings.push_back(text.str());
            };
          if (p.water.stands())
            check("Water/Level",
                  p.pore_water.follows_water() ? WaterLevel(p.water).at(0.)
                                               : p.water.level,
                  p.water.side == WaterSide::right ? right : left);
          for (const TractionParameters &t : p.tractions)
            if (const auto level = plain_number(t.level);
                t.kind == TractionKind::hydrostatic && level)
              check("Tractions/" + t.name + "/Level",
                    *level,
                    std::abs(left - *level) < std::abs(right - *level) ? left
                                                                       : right);
          bool moves = WaterLevel(p.water).moves();
          for (const LoadProgrammeParameters &programme : p.load_programmes)
            moves = moves || programme.drives == LoadTarget::water;
          for (const TractionParameters &t : p.tractions)
            moves = moves || (t.kind == TractionKind::hydrostatic &&
                              !plain_number(t.level));
          if (is_drained && moves && !p.pore_water.follows_water())
            warnings.push_back(
              "Pore water/Phreatic line stays as it is, but the water outside "
              "moves: what it adds presses the grains together, as on a "
              "watertight skin");
          return;
        }
      const bool has_friction = std::any_of(p.materials.begin(),
                                            p.materials.end(),
                                            [](const MaterialParameters &m) {
                                              return m.has_friction();
                                            });
      for (const TractionParameters &t : p.tractions)
        if (has_friction && t.kind == TractionKind::hydrostatic)
          warnings.push_back(
            "Tractions/" + t.name +
            ": a liquid on soil with friction presses its grains together, as "
            "on a watertight skin; there is no pore water");
    }


    /// Of `all`, the names of those that are not in `left`.
    template <typename Thing>
    std::string
    names_not_in(const std::vector<Thing> &left, const std::vector<Thing> &all)
    {
      std::string names;
      for (const Thing &thing : all)
        if (std::none_of(left.begin(), left.end(), [&](const Thing &other) {
              return other.name == thing.name;
            }))
          names += (names.empty() ? "" : ", ") + thing.name;
      return names;
    }


    /// What a section does not meet, but for what lies across z.
    void
    check_section(const Parameters &p, std::vector<std::string> &warnings)
    {
      if (!p.in_space)
        return;
      const auto along_z = [](const auto &things, const auto &region) {
        auto result = things;
        result.erase(std::remove_if(result.begin(),
                                    result.end(),
                                    [&](const auto &thing) {
                                      const FixityRegion r = region(thing);
                                      return r == FixityRegion::back ||
                                             r == FixityRegion::front;
                                    }),
                     result.end());
        return result;
      };
      const auto region_of_condition = [](const FixityParameters &condition) {
        return condition.region;
      };
      const auto region_of_outlet = [](const OutletParameters &outlet) {
        return region_of(outlet.face);
      };
      const auto warn = [&](const char *const  section,
                            const std::string &names) {
        std::ostringstream text;
        text << "Cross-section is " << p.section_z << " m, beside " << section
             << "/" << names << ": left away";
        if (!names.empty())
          warnings.push_back(text.str());
      };
      warn("Soil profile", names_not_in(p.layers, p.in_space->layers));
      warn("Boundary conditions",
           names_not_in(p.fixities,
                        along_z(p.in_space->fixities, region_of_condition)));
      warn("Outflow",
           names_not_in(p.outlets,
                        along_z(p.in_space->outlets, region_of_outlet)));
    }


    void
    check_friction(const std::string           &path,
                   const MohrCoulombParameters &p,
                   Ranges                      &ranges)
    {
      const auto c   = plain_number(p.cohesion),
                 phi = plain_number(p.friction_angle),
                 psi = plain_number(p.dilatancy_angle);
      if (c)
        check_cohesion(path, *c, ranges);
      if (phi)
        check_friction_angle(path, *phi, ranges);
      if (psi)
        ranges.check(
          path + "Dilatancy angle", *psi, 0., 20., " degrees", "soils have");
    }


    /// Of a table the strongest entry, and the steepest line.
    void
    check_table(const std::string           &path,
                const MohrCoulombParameters &p,
                Ranges                      &ranges)
    {
      const std::string name = path + "Shear strength table";
      double            most = 0., steepest = 0.;
      for (const auto &entry : shear_strength_entries(p.strength_table, name))
        most = std::max(most, entry.second);
      for (const ShearStrengthTable::Line &line :
           lines_through(shear_strength_entries(p.strength_table, name)))
        steepest = std::max(steepest, line.tan_phi);
      ranges.check(
        name + " (largest strength)", most, 0.5, 2000., " kPa", "soils have");
      ranges.check(
        name + " (steepest slope)", steepest, 0., 1.5, "", "soils have");
      if (const auto psi = plain_number(p.dilatancy_angle))
        ranges.check(
          path + "Dilatancy angle", *psi, 0., 20., " degrees", "soils have");
    }


    /// Undrained soil that grows weaker with stress.
    void
    check_strength_table(const std::string                 &path,
                         const UndrainedStrengthParameters &strength,
                         std::vector<std::string>          &warnings)
    {
      const auto list = strength.entries(path);
      for (std::size_t i = 1; i < list.size(); ++i)
        if (list[i].second < list[i - 1].second)
          {
            std::ostringstream text;
            text << path << "Strength table falls from " << list[i - 1].second
                 << " to " << list[i].second << " kPa as the stress grows from "
                 << list[i - 1].first << " to " << list[i].first
                 << " kPa; soils have strengths that grow by 0.15 to 0.6 kPa "
                    "per kPa, or stay";
            warnings.push_back(text.str());
          }
    }


    /// Springs of boundary conditions.
    void
    check_penalties(const Parameters &p, Ranges &ranges)
    {
      for (const FixityParameters &condition : p.fixities)
        if (condition.method == FixityMethod::penalty)
          check_penalty_factor("Boundary conditions/" + condition.name + "/",
                               condition.penalty_factor,
                               ranges);
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
      if (m.model == MaterialModel::mohr_coulomb && m.mohr_coulomb.has_table())
        check_table(path, m.mohr_coulomb, ranges);
      else if (m.model == MaterialModel::mohr_coulomb)
        check_friction(path, m.mohr_coulomb, ranges);
      const UndrainedStrengthParameters &strength = m.von_mises.strength;
      if (m.model == MaterialModel::von_mises_softening &&
          strength.from == StrengthFrom::shansep)
        {
          ranges.check(path + "Strength ratio",
                       strength.ratio,
                       0.15,
                       0.6,
                       "",
                       "clay and peat have");
          ranges.check(path + "Strength exponent",
                       strength.exponent,
                       0.7,
                       1.,
                       "",
                       "clay and peat have");
          ranges.check(
            path + "POP", strength.pop, 0., 100., " kPa", "usual is");
        }
      // Of an expression the points know the values.
      const auto undrained = m.undrained_strength();
      if (!undrained)
        return;
      if (const auto strength = plain_number(*undrained))
        check_strength(path,
                       m.von_mises.strength.name_of_parameter(),
                       *strength,
                       m.elastic.youngs_modulus,
                       ranges);
    }
  } // namespace


  std::vector<std::string>
  strange_parameters(const Parameters &p)
  {
    std::vector<std::string> warnings;
    Ranges                   ranges(warnings);
    for (const MaterialParameters &material : p.materials)
      {
        check_material(material, ranges);
        if (material.model == MaterialModel::von_mises_softening &&
            material.von_mises.strength.from == StrengthFrom::table)
          check_strength_table("Materials/" + material.name + "/",
                               material.von_mises.strength,
                               warnings);
        warn_of_cam_clay(material, p.dimension, warnings);
        check_softening(material,
                        p.grid,
                        p.points.points_per_direction,
                        warnings);
      }
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

    check_penalties(p, ranges);
    warn_of_unused(p, warnings);
    warn_of_friction(p, warnings);
    check_section(p, warnings);
    warn_of_water(p, warnings);
    check_liquids(p, warnings);
    warn_of_pore_water(p, warnings);
    for (const std::string &text : storm_warnings(p))
      warnings.push_back(text);
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
