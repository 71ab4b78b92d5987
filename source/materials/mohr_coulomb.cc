// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/mohr_coulomb.h>
#include <waker/materials/principal_stress.h>

#include "mohr_coulomb_return.h"
#include "softening_history.h"
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <sstream>

namespace Waker
{
  namespace
  {
    const double degree = std::acos(-1.) / 180.;


    /// The largest principal stress that cohesion and friction admit (kPa).
    double
    apex(const double cohesion, const double sin_phi, const double cos_phi)
    {
      if (cohesion == 0.)
        return 0.;
      return sin_phi > 0. ? cohesion * cos_phi / sin_phi
                          : std::numeric_limits<double>::infinity();
    }


    /// The plastic strain after a step that begins with `start`: that of the
    /// strength that it leaves, k = start + increment(k). With less strength
    /// there is more of it, so the end is unique unless a point snaps back.
    template <typename Increment>
    double
    plastic_strain_after(const double     start,
                         const double     softening_strain,
                         const Increment &increment)
    {
      const double at_residual = start + increment(softening_strain);
      if (at_residual >= softening_strain)
        return at_residual;
      const auto excess = [&](const double k) {
        return k - start - increment(k);
      };
      std::uintmax_t n_iterations = 60;
      const auto [low, high]      = boost::math::tools::toms748_solve(
        excess,
        start,
        softening_strain,
        excess(start),
        softening_strain - at_residual,
        boost::math::tools::eps_tolerance<double>(51),
        n_iterations);
      return 0.5 * (low + high);
    }
  } // namespace


  MohrCoulomb::MohrCoulomb(const double  density,
                           const double  youngs_modulus,
                           const double  poissons_ratio,
                           const Angles &peak,
                           const double  tensile_strength)
    : MohrCoulomb(density,
                  youngs_modulus,
                  poissons_ratio,
                  peak,
                  tensile_strength,
                  peak,
                  0.)
  {}


  MohrCoulomb::MohrCoulomb(const double            density,
                           const double            youngs_modulus,
                           const double            poissons_ratio,
                           const Angles           &peak,
                           const double            tensile_strength,
                           const Angles           &residual,
                           const double            softening_strain,
                           const SofteningMeasure &measure)
    : LinearElastic(density, youngs_modulus, poissons_ratio)
    , peak(peak)
    , residual(residual)
    , tensile_strength(tensile_strength)
    , softening_strain(measure.is_local() ? softening_strain / measure.own
                                          : softening_strain)
    , measure(measure)
  {
    Assert(tensile_strength >= 0. && softening_strain >= 0.,
           ExcMessage("neither tensile strength nor softening strain is "
                      "negative"));
  }


  std::vector<MaterialVariable>
  MohrCoulomb::variables() const
  {
    using Role                        = MaterialVariable::Role;
    std::vector<MaterialVariable> all = {
      {"cohesion", "kPa", peak.cohesion, Role::strength, "cohesion"},
      {"friction angle",
       "degrees",
       peak.friction_angle,
       Role::strength,
       "friction_angle"},
      {"dilatancy angle",
       "degrees",
       peak.dilatancy_angle,
       Role::dilatancy,
       "dilatancy_angle"}};
    if (softens())
      {
        all.push_back({"residual cohesion",
                       "kPa",
                       residual.cohesion,
                       Role::residual_strength,
                       "",
                       "cohesion"});
        all.push_back({"residual friction angle",
                       "degrees",
                       residual.friction_angle,
                       Role::residual_strength,
                       "",
                       "friction angle"});
        all.push_back({"residual dilatancy angle",
                       "degrees",
                       residual.dilatancy_angle,
                       Role::dilatancy});
      }
    all.push_back({"plastic strain", "-", 0., Role::history});
    if (!measure.is_local())
      append_softening_history(all);
    add_stiffness_ratio(all);
    return all;
  }


  bool
  MohrCoulomb::can_soften(const double *variables) const
  {
    return softens() &&
           variables[number_of_softening_strain()] < softening_strain;
  }


  void
  MohrCoulomb::soften(const double increment, double *variables) const
  {
    grow_softening_strain(increment,
                          variables + number_of_plastic_strain() + 1);
  }


  std::optional<std::pair<unsigned int, std::string>>
  MohrCoulomb::initial_problem(const std::vector<double> &variables) const
  {
    const unsigned int n_sets = softens() ? 2 : 1;
    for (unsigned int s = 0; s < n_sets; ++s)
      {
        const double *const v    = variables.data() + 3 * s;
        const bool          left = s == 1;
        if (!(v[0] >= 0. && std::isfinite(v[0]) &&
              (!left || v[0] <= variables[0])))
          {
            std::ostringstream text;
            text << "a finite number of at least 0 (kPa)";
            if (left)
              text << " and at most the peak value at every point, here "
                   << variables[0] << " kPa";
            return {{3 * s, text.str()}};
          }
        if (!(v[1] >= 0. && v[1] <= largest_friction_angle &&
              (!left || v[1] <= variables[1])))
          {
            std::ostringstream text;
            text << "from 0 to " << largest_friction_angle
                 << " (degrees) at every point";
            if (left)
              text << ", at most the peak value, here " << variables[1];
            return {{3 * s + 1, text.str()}};
          }
        if (!(v[2] >= 0. && v[2] <= v[1]))
          {
            std::ostringstream text;
            text << "from 0 to the " << (left ? "residual " : "")
                 << "friction angle at every point, here " << v[1]
                 << " degrees";
            return {{3 * s + 2, text.str()}};
          }
      }
    if (variables[0] == 0. && variables[1] == 0.)
      return {{0, "above 0 (kPa) where the friction angle is 0"}};
    return Material::initial_problem(variables);
  }


  void
  MohrCoulomb::divide_strengths(const double factor, double *variables) const
  {
    const unsigned int n_sets = softens() ? 2 : 1;
    for (unsigned int s = 0; s < n_sets; ++s)
      {
        double *const v = variables + 3 * s;
        v[0] /= factor;
        v[1] = std::atan(std::tan(v[1] * degree) / factor) / degree;
        v[2] = std::min(v[2], v[1]);
      }
  }


  MohrCoulombStrength
  MohrCoulomb::strength_at(const double         plastic_strain,
                           const double        *v,
                           MohrCoulombStrength *rate) const
  {
    // What softening leaves never exceeds what there is: a random field may
    // give a point less than its residual strength.
    double cohesion = v[0], phi = v[1], psi = v[2];
    double slope[3] = {0., 0., 0.};
    if (softens())
      {
        const double share   = std::min(plastic_strain / softening_strain, 1.);
        const double loss[3] = {std::min(v[3] - v[0], 0.),
                                std::min(v[4] - v[1], 0.),
                                v[5] - v[2]};
        cohesion += share * loss[0];
        phi += share * loss[1];
        psi += share * loss[2];
        if (share < 1.)
          for (unsigned int i = 0; i < 3; ++i)
            slope[i] = loss[i] / softening_strain;
      }
    const bool          is_associated = psi >= phi;
    MohrCoulombStrength s;
    s.cohesion       = cohesion;
    s.sin_phi        = std::sin(phi * degree);
    s.cos_phi        = std::cos(phi * degree);
    s.sin_psi        = is_associated ? s.sin_phi : std::sin(psi * degree);
    const double end = apex(cohesion, s.sin_phi, s.cos_phi);
    s.tension        = std::min(tensile_strength, end);
    if (rate != nullptr)
      {
        const double phi_rate = slope[1] * degree;
        rate->cohesion        = slope[0];
        rate->sin_phi         = s.cos_phi * phi_rate;
        rate->cos_phi         = -s.sin_phi * phi_rate;
        rate->sin_psi         = is_associated
                                  ? rate->sin_phi
                                  : std::cos(psi * degree) * slope[2] * degree;
        rate->tension         = tensile_strength < end || !(s.sin_phi > 0.)
                                  ? 0.
                                  : slope[0] * s.cos_phi / s.sin_phi -
                              cohesion * phi_rate / (s.sin_phi * s.sin_phi);
      }
    return s;
  }


  double
  MohrCoulomb::update(const SymmetricTensor<2, 3> &strain_increment,
                      SymmetricTensor<2, 3>       &stress,
                      double                      *variables,
                      SymmetricTensor<4, 3>       *tangent) const
  {
    return update(strain_increment,
                  strength_at(variables[number_of_softening_strain()],
                              variables),
                  stress,
                  variables,
                  tangent);
  }


  double
  MohrCoulomb::update(const SymmetricTensor<2, 3> &strain_increment,
                      const MohrCoulombStrength   &strength_before,
                      SymmetricTensor<2, 3>       &stress,
                      double                      *variables,
                      SymmetricTensor<4, 3>       *tangent) const
  {
    double      &plastic_strain = variables[number_of_plastic_strain()];
    const double ratio          = stiffness_ratio(variables);
    add_elastic_stress(strain_increment, ratio, stress);
    const PrincipalStress trial = principal_stress(stress);
    if (MohrCoulombReturn::holds(trial.value, strength_before))
      {
        if (tangent != nullptr)
          *tangent = ratio * elastic_tangent;
        return 0.;
      }

    const double            shear = ratio * G;
    const double            lame  = ratio * (K - 2. / 3. * G);
    const MohrCoulombReturn map(shear, lame);
    double                  end = plastic_strain;
    if (softens_in_step())
      end = plastic_strain_after(
        plastic_strain, softening_strain, [&](const double k) {
          const auto at_k = map(trial.value, strength_at(k, variables));
          return MohrCoulombReturn::equivalent(at_k.plastic_strain);
        });
    MohrCoulombStrength strength = strength_before, rate = {};
    if (softens_in_step())
      strength = strength_at(end, variables, &rate);
    const auto result = map(trial.value, strength);
    plastic_strain += MohrCoulombReturn::equivalent(result.plastic_strain);
    stress = with_values(result.stress, trial.direction);

    if (tangent != nullptr)
      {
        double slope[3][3];
        map.slope(result, strength, rate, slope);
        *tangent =
          isotropic_derivative(trial, result.stress, slope, 2. * shear, lame);
      }
    double dissipation = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      dissipation += result.stress[d] * result.plastic_strain[d];
    return dissipation;
  }
} // namespace Waker
