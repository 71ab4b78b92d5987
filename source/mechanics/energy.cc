// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/energy.h>
#include <waker/mechanics/time_scheme.h>

namespace Waker
{
  template <int dim>
  double
  kinetic_energy(const MaterialPoints<dim> &points)
  {
    double sum = 0.;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      sum += points.mass[p] * points.velocity[p].norm_square();
    return 0.5 * sum;
  }


  template <int dim>
  double
  kinetic_energy(const std::vector<double> &mass, const NodalVector &velocity)
  {
    const double *const v   = velocity.begin();
    double              sum = 0.;
    for (std::size_t i = 0; i < mass.size(); ++i)
      for (unsigned int c = 0; c < dim; ++c)
        sum += mass[i] * v[dim * i + c] * v[dim * i + c];
    return 0.5 * sum;
  }


  template <int dim>
  Tensor<1, dim>
  momentum(const MaterialPoints<dim> &points)
  {
    Tensor<1, dim> sum;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      sum += points.mass[p] * points.velocity[p];
    return sum;
  }


  template <int dim>
  EnergyAccount &
  EnergyAccount::operator+=(const StepReport<dim> &step)
  {
    kinetic = step.kinetic_energy;
    elastic = step.elastic_energy;
    dissipation += step.dissipation;
    friction += step.friction;
    ramp_work += step.ramp_work;
    mapping_loss += step.mapping_loss;
    gravity_work += step.gravity_work;
    load_work += step.load_work;
    support_work += step.support_work;
    return *this;
  }


  template EnergyAccount &
  EnergyAccount::operator+=(const StepReport<2> &);
  template EnergyAccount &
  EnergyAccount::operator+=(const StepReport<3> &);
  template double
  kinetic_energy(const MaterialPoints<2> &);
  template double
  kinetic_energy(const MaterialPoints<3> &);
  template double
  kinetic_energy<2>(const std::vector<double> &, const NodalVector &);
  template double
  kinetic_energy<3>(const std::vector<double> &, const NodalVector &);
  template Tensor<1, 2>
  momentum(const MaterialPoints<2> &);
  template Tensor<1, 3>
  momentum(const MaterialPoints<3> &);
} // namespace Waker
