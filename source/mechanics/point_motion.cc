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
      switch (parameters.volumetric_strain)
        {
          case VolumetricStrain::standard:
            return std::make_unique<StepMotion<dim>>(objective);
          case VolumetricStrain::b_bar:
            return std::make_unique<MeanDilatationMotion<dim>>(objective);
          case VolumetricStrain::b_bar_everywhere:
            return std::make_unique<MeanDilatationMotion<dim>>(objective,
                                                               BBarCells::all);
        }
      AssertThrow(false, ExcInternalError());
      return nullptr;
    }
  } // namespace


  template <int dim>
  std::unique_ptr<PointMotion<dim>>
  make_point_motion(const MappingParameters &parameters)
  {
    switch (parameters.strain)
      {
        case StrainMeasure::step:
          return make_step_motion<dim>(parameters, parameters.objective_rate);
        case StrainMeasure::logarithmic:
          return std::make_unique<LogarithmicMotion<dim>>();
      }
    AssertThrow(false, ExcInternalError());
    return nullptr;
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
