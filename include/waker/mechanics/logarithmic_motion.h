// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_logarithmic_motion_h
#define waker_mechanics_logarithmic_motion_h

#include <waker/mechanics/logarithmic_strain.h>
#include <waker/mechanics/point_motion.h>

#include <vector>

namespace Waker
{
  /**
   * Logarithmic strain (mechanics/logarithmic_strain.h). It needs no state of
   * its own: the elastic strain is that of the Kirchhoff stress, stress times
   * V/V0, where V0 is mass over density. The force is that in the deformed
   * place, sum_p V0_p P_p grad S_ip with LogarithmicStep::first_piola(), and
   * volumes (and the deformation, if it is kept) are updated.
   */
  template <int dim>
  class LogarithmicMotion : public PointMotion<dim>
  {
  public:
    void
    start(const MaterialPoints<dim> &points, const Weights<dim> &) override;

    void
    gather(const Material            &material,
           const MaterialPoints<dim> &points,
           const Weights<dim>        &weights,
           const PointRange          &range,
           const double              *increment) override;

    void
    trial(const MaterialPoints<dim> &points,
          const PointRange          &range,
          Material::Block           &block) const override;

    void
    scatter(const Material            &material,
            const MaterialPoints<dim> &points,
            const Weights<dim>        &weights,
            const PointRange          &range,
            const Material::Block     &block,
            double                    *force) const override;

    void
    add_force_of_stress(const MaterialPoints<dim> &points,
                        const Weights<dim>        &weights,
                        NodalVector               &force) const override;

    void
    commit(const Material        &material,
           const PointRange      &range,
           const Material::Block &block,
           MaterialPoints<dim>   &points,
           StressReport          &report) const override;

    bool
    derivative_needs_stress() const override
    {
      return true;
    }

    void
    derivative(const Material            &material,
               const MaterialPoints<dim> &points,
               const PointRange          &range,
               Material::Block           &trial,
               const Material::Block     *end,
               double                    *A) const override;

    std::unique_ptr<PointTangents<dim>>
    make_tangents(const Precision precision) const override;

  private:
    std::vector<Tensor<2, dim>>       gradients; // of the increment
    std::vector<LogarithmicStep<dim>> steps;
  };
} // namespace Waker

#endif
