// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/text.h>
#include <waker/materials/principal_stress.h>
#include <waker/materials/shear_strength_table.h>

#include "envelope_return.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace Waker
{
  namespace
  {
    const double degree = std::acos(-1.) / 180.;


    /// The surfaces of a point whose strengths are `factor` times the table's.
    std::vector<MohrCoulombStrength>
    surfaces(const std::vector<ShearStrengthTable::Line> &lines,
             const double                                 factor,
             const double                                 sin_psi,
             const double                                 tensile_strength)
    {
      std::vector<MohrCoulombStrength> list;
      for (const ShearStrengthTable::Line &line : lines)
        {
          const double        slope = factor * line.tan_phi;
          MohrCoulombStrength s;
          s.cohesion = factor * line.cohesion;
          s.cos_phi  = 1. / std::sqrt(1. + slope * slope);
          s.sin_phi  = slope * s.cos_phi;
          s.sin_psi  = std::min(sin_psi, s.sin_phi);
          // The first line ends it.
          s.tension =
            std::min(tensile_strength,
                     slope > 0. ? s.cohesion / slope
                                : std::numeric_limits<double>::infinity());
          list.push_back(s);
        }
      return list;
    }
  } // namespace


  ShearStrengthTable::ShearStrengthTable(const double density,
                                         const double youngs_modulus,
                                         const double poissons_ratio,
                                         const std::vector<Line> &lines,
                                         const double dilatancy_angle,
                                         const double tensile_strength)
    : LinearElastic(density, youngs_modulus, poissons_ratio)
    , lines(lines)
    , sin_psi(std::sin(dilatancy_angle * degree))
    , tensile_strength(tensile_strength)
  {
    Assert(!lines.empty(), ExcMessage("an envelope without lines"));
  }


  std::vector<MaterialVariable>
  ShearStrengthTable::variables() const
  {
    using Role                         = MaterialVariable::Role;
    std::vector<MaterialVariable> list = {
      {"strength factor", "-", 1., Role::strength},
      {"plastic strain", "-", 0., Role::history}};
    add_stiffness_ratio(list);
    return list;
  }


  std::optional<std::pair<unsigned int, std::string>>
  ShearStrengthTable::initial_problem(const std::vector<double> &values) const
  {
    if (!(values[0] > 0. && std::isfinite(values[0])))
      return {{0, "a finite number above 0 at every point"}};
    return Material::initial_problem(values);
  }


  double
  ShearStrengthTable::update(const SymmetricTensor<2, 3> &strain_increment,
                             SymmetricTensor<2, 3>       &stress,
                             double                      *variables,
                             SymmetricTensor<4, 3>       *tangent) const
  {
    const double ratio = stiffness_ratio(variables);
    add_elastic_stress(strain_increment, ratio, stress);
    const PrincipalStress trial = principal_stress(stress);
    const auto            strength =
      surfaces(lines, variables[0], sin_psi, tensile_strength);
    if (EnvelopeReturn::holds(trial.value, strength))
      {
        if (tangent != nullptr)
          *tangent = ratio * elastic_tangent;
        return 0.;
      }

    const double         shear = ratio * G;
    const double         lame  = ratio * (K - 2. / 3. * G);
    const EnvelopeReturn map(shear, lame, strength);
    const auto           result = map(trial.value);
    variables[1] += MohrCoulombReturn::equivalent(result.plastic_strain);
    stress = with_values(result.stress, trial.direction);
    if (tangent != nullptr)
      {
        double slope[3][3];
        map.slope(result, slope);
        *tangent =
          isotropic_derivative(trial, result.stress, slope, 2. * shear, lame);
      }
    double dissipation = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      dissipation += result.stress[d] * result.plastic_strain[d];
    return dissipation;
  }


  std::vector<ShearStrengthTable::Entry>
  shear_strength_entries(const std::string &text, const std::string &path)
  {
    const auto refuse = [&](const std::string &problem) {
      throw UserError(path,
                      problem,
                      "2 to " +
                        std::to_string(ShearStrengthTable::most_entries) +
                        " pairs, \"stress: strength, ...\" (kPa), stresses "
                        "ascending from 0, strengths that grow, by less and "
                        "less");
    };
    // Of slopes: what digits of a file round.
    constexpr double                       round_off = 1e-9;
    std::vector<ShearStrengthTable::Entry> list;
    double                                 last = 1e3; // slope
    for (const std::string &entry : split(text, ','))
      {
        const std::vector<std::string> pair = split(entry, ':');
        double                         stress, strength;
        if (pair.size() != 2 || !read_number(pair[0], stress) ||
            !read_number(pair[1], strength) || !std::isfinite(stress) ||
            !std::isfinite(strength) || !(strength >= 0.))
          refuse("has the entry " + in_quotes(entry));
        if (list.empty() && stress != 0.)
          refuse("begins at the stress " + pair[0] + " kPa");
        if (!list.empty())
          {
            const auto &[before, there] = list.back();
            if (!(stress > before))
              refuse("has the stress " + pair[0] + " kPa after " +
                     in_digits(before) + " kPa");
            const double slope = (strength - there) / (stress - before);
            if (!(slope >= 0.))
              refuse("falls towards the stress " + pair[0] + " kPa");
            if (list.size() == 1 && !(slope < last))
              refuse("is too steep below the stress " + pair[0] + " kPa");
            if (!(slope <= last * (1. + round_off) + round_off))
              refuse("is steeper below the stress " + pair[0] +
                     " kPa than before: no convex law has it");
            last = slope;
          }
        list.emplace_back(stress, strength);
      }
    if (list.size() < 2 || list.size() > ShearStrengthTable::most_entries)
      refuse("has " + counted(list.size(), "pair"));
    if (list[0].second == 0. && list[1].second == 0.)
      refuse("begins with no strength");
    return list;
  }


  std::vector<ShearStrengthTable::Line>
  lines_through(const std::vector<ShearStrengthTable::Entry> &entries)
  {
    std::vector<ShearStrengthTable::Line> lines;
    for (std::size_t i = 1; i < entries.size(); ++i)
      {
        const auto &[low, at_low]   = entries[i - 1];
        const auto &[high, at_high] = entries[i];
        const double slope          = (at_high - at_low) / (high - low);
        // Entries on one line make one.
        if (lines.empty() ||
            std::abs(slope - lines.back().tan_phi) > 1e-9 * (1. + slope))
          lines.push_back({at_low - slope * low, slope});
      }
    return lines;
  }
} // namespace Waker
