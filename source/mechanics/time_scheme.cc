// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/mechanics/time_scheme.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  template <int dim>
  std::unique_ptr<TimeScheme<dim>>
  make_time_scheme(const SchemeInput<dim> &input)
  {
    if (input.time.scheme == "Newmark")
      return make_newmark(input);
    if (input.time.scheme == "explicit")
      return make_explicit(input);
    if (input.time.scheme == "quasi-static")
      return make_quasi_static(input);
    throw UserError("Time stepping/Scheme",
                    "is \"" + input.time.scheme + "\"",
                    "Newmark, explicit or quasi-static");
  }


  template <int dim>
  void
  add_spring_reaction(const Springs             &springs,
                      const std::vector<double> &targets,
                      const NodalState          &nodes,
                      StepReport<dim>           &report)
  {
    const double *const u = nodes.increment.begin();
    for (std::size_t k = 0; k < springs.dofs.size(); ++k)
      {
        const unsigned int dof = springs.dofs[k];
        if (nodes.mass[dof / dim] == 0.)
          continue;
        const double force = -springs.stiffness[k] * (u[dof] - targets[k]);
        report.reaction[dof % dim] += force;
        report.support_work += force * u[dof];
      }
  }


  double
  displacement_rate(const double square, const double mass, const double dt)
  {
    return mass > 0. ? std::sqrt(square / mass) / dt : 0.;
  }


  double
  residual_ramp(const double t, const double duration)
  {
    return duration > 0. ? std::min(1., t / duration) : 1.;
  }


  double
  wave_speed(const Materials &materials)
  {
    double fastest = 0.;
    for (const auto &m : materials)
      fastest = std::max(fastest,
                         (m->bulk_modulus() + 4. / 3. * m->shear_modulus()) /
                           m->density());
    return std::sqrt(fastest);
  }


  double
  stiffest_modulus(const Materials &materials)
  {
    double stiffest = 0.;
    for (const auto &m : materials)
      stiffest =
        std::max(stiffest, m->bulk_modulus() + 4. / 3. * m->shear_modulus());
    return stiffest;
  }


  template void
  add_spring_reaction(const Springs &,
                      const std::vector<double> &,
                      const NodalState &,
                      StepReport<2> &);
  template void
  add_spring_reaction(const Springs &,
                      const std::vector<double> &,
                      const NodalState &,
                      StepReport<3> &);
  template std::unique_ptr<TimeScheme<2>>
  make_time_scheme(const SchemeInput<2> &);
  template std::unique_ptr<TimeScheme<3>>
  make_time_scheme(const SchemeInput<3> &);
} // namespace Waker
