// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/logarithmic_motion.h>
#include <waker/mechanics/point_tangents.h>
#include <waker/mechanics/step_motion.h>

namespace Waker
{
  namespace
  {
    template <int dim>
    std::unique_ptr<PointMotion<dim>>
    make_step_motion(const MappingParameters &parameters, const bool objective)
    {
      if (parameters.volumetric_strain == "B-bar")
        return std::make_unique<MeanDilatationMotion<dim>>(objective);
      return std::make_unique<StepMotion<dim>>(objective);
    }
  } // namespace


  template <int dim>
  std::unique_ptr<PointMotion<dim>>
  make_point_motion(const MappingParameters &parameters)
  {
    if (parameters.strain == "logarithmic")
      return std::make_unique<LogarithmicMotion<dim>>();
    return make_step_motion<dim>(parameters, parameters.objective_rate);
  }


  template <int dim>
  std::unique_ptr<PointMotion<dim>>
  make_small_motion(const MappingParameters &parameters)
  {
    return make_step_motion<dim>(parameters, false);
  }


  template std::unique_ptr<PointMotion<2>>
  make_point_motion(const MappingParameters &);
  template std::unique_ptr<PointMotion<3>>
  make_point_motion(const MappingParameters &);
  template std::unique_ptr<PointMotion<2>>
  make_small_motion(const MappingParameters &);
  template std::unique_ptr<PointMotion<3>>
  make_small_motion(const MappingParameters &);
} // namespace Waker
