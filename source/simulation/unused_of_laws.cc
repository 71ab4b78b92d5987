// SPDX-License-Identifier: LGPL-2.1-or-later
#include "unused_of_laws.h"

#include <waker/base/text.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    /// A parameter of a material, and the laws that know it.
    struct Entry
    {
      const char                *name;
      bool                       is_set;
      std::vector<MaterialModel> laws;
    };


    std::vector<Entry>
    entries_of_laws(const MaterialParameters &m)
    {
      constexpr MaterialModel clay = MaterialModel::von_mises_softening,
                              sand = MaterialModel::mohr_coulomb,
                              cam  = MaterialModel::modified_cam_clay;
      const VonMisesSofteningParameters  von_mises;
      const UndrainedStrengthParameters  strength;
      const MohrCoulombParameters        friction;
      const ModifiedCamClayParameters    cam_clay;
      const auto                        &of_clay = m.von_mises;
      const auto                        &of_sand = m.mohr_coulomb;
      const auto                        &of_cam  = m.cam_clay;
      const UndrainedStrengthParameters &from    = of_clay.strength;
      return {
        {"Initial strength",
         of_clay.initial_strength != von_mises.initial_strength,
         {clay}},
        {"Residual strength",
         of_clay.residual_strength != von_mises.residual_strength,
         {clay}},
        {"Softening modulus",
         of_clay.softening_modulus != von_mises.softening_modulus,
         {clay}},
        {"Plastic strain invariant",
         of_clay.plastic_strain_invariant != von_mises.plastic_strain_invariant,
         {clay}},
        {"Strength from", from.from != strength.from, {clay}},
        {"Strength ratio", from.ratio != strength.ratio, {clay}},
        {"Strength exponent", from.exponent != strength.exponent, {clay}},
        {"POP", from.pop != strength.pop, {clay, cam}},
        {"Strength table", !tidy(from.table).empty(), {clay}},
        {"Strength at top", from.at_top != strength.at_top, {clay}},
        {"Strength growth", from.growth != strength.growth, {clay}},
        {"Cohesion", of_sand.cohesion != friction.cohesion, {sand}},
        {"Friction angle",
         of_sand.friction_angle != friction.friction_angle,
         {sand, cam}},
        {"Dilatancy angle",
         of_sand.dilatancy_angle != friction.dilatancy_angle,
         {sand}},
        {"Tensile strength",
         of_sand.tensile_strength != friction.tensile_strength,
         {sand}},
        {"Residual cohesion",
         of_sand.residual_cohesion != friction.residual_cohesion,
         {sand}},
        {"Residual friction angle",
         of_sand.residual_friction != friction.residual_friction,
         {sand}},
        {"Residual dilatancy angle",
         of_sand.residual_dilatancy != friction.residual_dilatancy,
         {sand}},
        {"Softening strain",
         of_sand.softening_strain != friction.softening_strain,
         {sand}},
        {"Shear strength table", of_sand.has_table(), {sand}},
        {"Friction angle holds in", of_cam.holds != cam_clay.holds, {cam}},
        {"Lambda", of_cam.lambda != cam_clay.lambda, {cam}},
        {"Kappa", of_cam.kappa != cam_clay.kappa, {cam}},
        {"Void ratio", of_cam.void_ratio != cam_clay.void_ratio, {cam}},
        {"OCR", of_cam.ocr != cam_clay.ocr, {cam}},
        {"Preconsolidation pressure",
         !tidy(of_cam.preconsolidation).empty(),
         {cam}},
        {"Least pressure",
         of_cam.least_pressure != cam_clay.least_pressure,
         {cam}}};
    }
  } // namespace


  void
  warn_of_unused_of_law(const MaterialParameters &m,
                        std::vector<std::string> &warnings)
  {
    const std::string path = "Materials/" + m.name + "/";
    const auto        warn = [&](const bool         is_set,
                          const std::string &name,
                          const std::string &choice) {
      if (is_set)
        warnings.push_back(path + name + " is not used with " + choice);
    };
    for (const Entry &entry : entries_of_laws(m))
      warn(entry.is_set &&
             std::find(entry.laws.begin(), entry.laws.end(), m.model) ==
               entry.laws.end(),
           entry.name,
           std::string("Model = ") + name_of(m.model));

    const MohrCoulombParameters friction;
    switch (m.model)
      {
        case MaterialModel::linear_elastic:
          break;
        case MaterialModel::von_mises_softening:
          {
            const UndrainedStrengthParameters &strength = m.von_mises.strength;
            const std::string                  choice =
              std::string("Strength from = ") + name_of(strength.from);
            for (const std::string &name : strength.unused())
              warn(true, name, choice);
            warn(strength.from != StrengthFrom::place &&
                   m.von_mises.initial_strength !=
                     VonMisesSofteningParameters().initial_strength,
                 "Initial strength",
                 choice);
            // What is left is often said to be the same.
            warn(m.von_mises.softening_modulus == 0. &&
                   m.von_mises.residual_strength !=
                     VonMisesSofteningParameters().residual_strength &&
                   m.von_mises.residual_strength !=
                     m.von_mises.initial_strength,
                 "Residual strength",
                 "Softening modulus = 0");
            break;
          }
        case MaterialModel::mohr_coulomb:
          {
            const MohrCoulombParameters &p = m.mohr_coulomb;
            warn(p.has_table() && p.cohesion != friction.cohesion,
                 "Cohesion",
                 "Shear strength table");
            warn(p.has_table() && p.friction_angle != friction.friction_angle,
                 "Friction angle",
                 "Shear strength table");
            warn(p.softening_strain > 0. &&
                   p.residual_cohesion == friction.residual_cohesion &&
                   p.residual_friction == friction.residual_friction &&
                   p.residual_dilatancy == friction.residual_dilatancy,
                 "Softening strain",
                 "residual values that are those before softening: Residual "
                 "cohesion, Residual friction angle, Residual dilatancy angle");
            break;
          }
        case MaterialModel::modified_cam_clay:
          {
            const bool is_own = !tidy(m.cam_clay.preconsolidation).empty();
            warn(is_own && m.cam_clay.ocr != ModifiedCamClayParameters().ocr,
                 "OCR",
                 "Preconsolidation pressure");
            warn(is_own && m.von_mises.strength.pop != 0.,
                 "POP",
                 "Preconsolidation pressure");
            break;
          }
      }
  }
} // namespace Waker
