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
    throw UserError("Time stepping/Scheme",
                    "is \"" + input.time.scheme + "\"",
                    "Newmark or explicit");
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


  template std::unique_ptr<TimeScheme<2>>
  make_time_scheme(const SchemeInput<2> &);
  template std::unique_ptr<TimeScheme<3>>
  make_time_scheme(const SchemeInput<3> &);
} // namespace Waker
