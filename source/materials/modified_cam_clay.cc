// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/modified_cam_clay.h>
#include <waker/materials/mohr_coulomb.h>

#include "cam_clay_return.h"
#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    const double degree = std::acos(-1.) / 180.;


    /// s:s of a deviator's or a stress's entries xx, yy, zz, xy, xz, yz.
    double
    square(const double (&s)[6])
    {
      return s[0] * s[0] + s[1] * s[1] + s[2] * s[2] +
             2. * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]);
    }
  } // namespace


  double
  critical_state_ratio(const double friction_angle, const FrictionHolds holds)
  {
    // A random field may reach down to 0, where there would be no surface.
    const double s = std::max(std::sin(friction_angle * degree), 1e-3);
    switch (holds)
      {
        case FrictionHolds::triaxial_compression:
          return 6. * s / (3. - s);
        case FrictionHolds::plane_strain:
          return std::sqrt(3.) * s;
      }
    AssertThrow(false, ExcInternalError());
    return 0.;
  }


  ModifiedCamClay::ModifiedCamClay(
    const double                         density,
    const Constants                     &c,
    const InitialValue                  &friction_angle,
    const InitialValue                  &preconsolidation,
    const std::vector<MaterialVariable> &coefficients)
    : rho(density)
    , G(c.youngs_modulus / (2. * (1. + c.poissons_ratio)))
    , in_situ_bulk_modulus(c.youngs_modulus /
                           (3. * (1. - 2. * c.poissons_ratio)))
    , compression(c.compression)
    , swelling(c.swelling)
    , least_pressure(c.least_pressure)
    , holds(c.holds)
    , friction_angle(friction_angle)
    , preconsolidation(preconsolidation)
    , initial_coefficients(coefficients)
  {
    Assert(swelling > 0. && compression > swelling && least_pressure > 0.,
           ExcMessage("soil compresses more than it swells"));
  }


  std::vector<MaterialVariable>
  ModifiedCamClay::variables() const
  {
    using Role = MaterialVariable::Role;
    return {
      {"friction angle",
       "degrees",
       friction_angle,
       Role::strength,
       "friction_angle"},
      {"preconsolidation pressure", "kPa", preconsolidation, Role::history},
      {"plastic strain", "-", 0., Role::history}};
  }


  std::optional<std::pair<unsigned int, std::string>>
  ModifiedCamClay::initial_problem(const std::vector<double> &values) const
  {
    if (!(values[0] > 0. && values[0] <= largest_friction_angle))
      return {{0, "above 0, at most 89 (degrees) at every point"}};
    if (!(values[1] >= 0. && values[1] <= 1e6))
      return {{1, "from 0 to 1e6 (kPa) at every point"}};
    return Material::initial_problem(values);
  }


  void
  ModifiedCamClay::divide_strengths(const double factor,
                                    double      *variables) const
  {
    variables[0] = std::atan(std::tan(variables[0] * degree) / factor) / degree;
  }


  void
  ModifiedCamClay::consolidate(const SymmetricTensor<2, 3> &stress,
                               double                      *variables) const
  {
    double      &pc = variables[1];
    const double p  = -trace(stress) / 3.;
    pc              = std::max(pc, least_pressure);
    if (!(p > 0.))
      return;
    const double M        = critical_state_ratio(variables[0], holds);
    const double q_square = 1.5 * (stress * stress - 3. * p * p);
    pc = std::max(pc, std::min(p + q_square / (M * M * p), 2. * p));
  }


  CamClayEnd
  ModifiedCamClay::step(const double (&strain)[6],
                        double (&stress)[6],
                        double (&variables)[3],
                        double (&trial)[6],
                        double &dissipation) const
  {
    const double p        = -(stress[0] + stress[1] + stress[2]) / 3.;
    const double dilation = strain[0] + strain[1] + strain[2];
    for (unsigned int a = 0; a < 6; ++a)
      trial[a] = stress[a] + 2. * G * strain[a] +
                 (a < 3 ? p - 2. / 3. * G * dilation : 0.);
    const double q = std::sqrt(1.5 * square(trial));

    const ExponentialElasticity elasticity(swelling, least_pressure);
    const CamClayReturn         map(elasticity,
                            compression - swelling,
                            G,
                            least_pressure);
    const CamClayEnd            end = map(elasticity.strain(p) - dilation,
                               q,
                               critical_state_ratio(variables[0], holds),
                               variables[1]);
    for (unsigned int a = 0; a < 6; ++a)
      stress[a] = end.shear_left * trial[a] - (a < 3 ? end.pressure : 0.);
    const double shear_strain = (1. - end.shear_left) * q / (3. * G);
    variables[1]              = end.preconsolidation;
    variables[2] += shear_strain;
    dissipation = std::max(0.,
                           end.pressure * end.volume_strain +
                             end.shear_left * q * shear_strain);
    return end;
  }


  double
  ModifiedCamClay::slope(const CamClayEnd &end,
                         const double (&trial)[6],
                         const unsigned int a,
                         const unsigned int b) const
  {
    const double one_a = a < 3 ? 1. : 0., one_b = b < 3 ? 1. : 0.;
    const double K        = end.bulk_modulus;
    double       deviator = -one_a * one_b / 3.;
    if (a == b)
      deviator += a < 3 ? 1. : 0.5;
    double result = K * (1. - end.volume_by_strain) * one_a * one_b +
                    2. * G * end.shear_left * deviator;
    if (end.has_yielded)
      result += 3. * G * K * end.volume_by_shear * one_a * trial[b] +
                trial[a] * (3. * G * end.shear_left_by_shear * trial[b] -
                            end.shear_left_by_strain * one_b);
    return result;
  }


  double
  ModifiedCamClay::update(const SymmetricTensor<2, 3> &strain_increment,
                          SymmetricTensor<2, 3>       &stress,
                          double                      *variables,
                          SymmetricTensor<4, 3>       *tangent) const
  {
    double strain[6], point[6], trial[6], dissipation;
    double own[3] = {variables[0], variables[1], variables[2]};
    for (unsigned int a = 0; a < 6; ++a)
      {
        strain[a] = strain_increment.access_raw_entry(a);
        point[a]  = stress.access_raw_entry(a);
      }
    const CamClayEnd end = step(strain, point, own, trial, dissipation);
    for (unsigned int a = 0; a < 6; ++a)
      stress.access_raw_entry(a) = point[a];
    std::copy_n(own, 3, variables);
    if (tangent != nullptr)
      for (unsigned int a = 0; a < 6; ++a)
        for (unsigned int b = 0; b < 6; ++b)
          tangent->access_raw_entry(6 * a + b) = slope(end, trial, a, b);
    return dissipation;
  }


  void
  ModifiedCamClay::update_block(const unsigned int n_points, Block &block) const
  {
    for (unsigned int l = 0; l < n_points; ++l)
      {
        double strain[6], stress[6], variables[3], trial[6];
        for (unsigned int a = 0; a < 6; ++a)
          {
            strain[a] = block.strain_increment[a][l];
            stress[a] = block.stress[a][l];
          }
        for (unsigned int v = 0; v < 3; ++v)
          variables[v] = block.variables[v][l];
        step(strain, stress, variables, trial, block.dissipation[l]);
        for (unsigned int a = 0; a < 6; ++a)
          block.stress[a][l] = stress[a];
        for (unsigned int v = 0; v < 3; ++v)
          block.variables[v][l] = variables[v];
      }
  }


  void
  ModifiedCamClay::tangent_block(const unsigned int  n_points,
                                 Block              &block,
                                 const unsigned int  n_components,
                                 const unsigned int *components,
                                 double (*tangent)[block_size]) const
  {
    for (unsigned int l = 0; l < n_points; ++l)
      {
        double strain[6], stress[6], variables[3], trial[6], dissipation;
        for (unsigned int a = 0; a < 6; ++a)
          {
            strain[a] = block.strain_increment[a][l];
            stress[a] = block.stress[a][l];
          }
        for (unsigned int v = 0; v < 3; ++v)
          variables[v] = block.variables[v][l];
        const CamClayEnd end =
          step(strain, stress, variables, trial, dissipation);
        for (unsigned int a = 0; a < n_components; ++a)
          for (unsigned int b = 0; b < n_components; ++b)
            tangent[n_components * a + b][l] =
              slope(end, trial, components[a], components[b]);
      }
  }


  void
  ModifiedCamClay::elastic_energy(const Block &block,
                                  double (&energy)[block_size]) const
  {
    const ExponentialElasticity elasticity(swelling, least_pressure);
    const double                per_shear = 0.25 / G;
    for (unsigned int l = 0; l < block_size; ++l)
      {
        double stress[6];
        for (unsigned int a = 0; a < 6; ++a)
          stress[a] = block.stress[a][l];
        const double p = -(stress[0] + stress[1] + stress[2]) / 3.;
        energy[l] =
          elasticity.energy(p) + (square(stress) - 3. * p * p) * per_shear;
      }
  }
} // namespace Waker
