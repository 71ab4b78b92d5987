// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_step_motion_h
#define waker_mechanics_step_motion_h

#include <waker/mechanics/block_motion.h>
#include <waker/mechanics/filled_cells.h>
#include <waker/mechanics/point_motion.h>

#include <vector>

namespace Waker
{
  /**
   * The strain increment of each step, from the gradient of the displacement
   * increments (eqs. 2.28, 2.33 of Remmerswaal 2023; mechanics/kinematics.h):
   * at mid-step, with the stress turned with the body, or plain. Volumes stay.
   *   internal force = sum_p V_p stress_p grad S_ip.
   */
  template <int dim>
  class StepMotion : public PointMotion<dim>
  {
  public:
    /// @param objective at mid-step, else plain
    explicit StepMotion(const bool objective)
      : objective(objective)
    {}

    void
    start(const MaterialPoints<dim> &points, const Weights<dim> &) override
    {
      gradients.resize(points.n_points());
    }

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

    void
    derivative(const Material            &material,
               const MaterialPoints<dim> &points,
               const PointRange          &range,
               Material::Block           &trial,
               const Material::Block     *end,
               double                    *A) const override;

    std::unique_ptr<PointTangents<dim>>
    make_tangents(const Precision precision) const override;

  protected:
    /// The gradients of a range, point last; unused entries are zero.
    void
    load_gradients(const PointRange &range, BlockMotion<dim> &motion) const;

    bool                        objective;
    std::vector<Tensor<2, dim>> gradients; // of the increment
  };


  /**
   * B-bar (Hughes 1980): the dilatation of the step is that of the cells'
   * centres, averaged over the support domain (mapping/centre_stencil.h), so
   * that nearly incompressible soil does not lock:
   *   H-bar = H + d I,  d = b (mean dilatation - tr H) / 3,
   * in three dimensions, also in plane strain, where the zz strain d is not
   * zero; b is 1 in cells full of soil (FilledCells). The force is conjugate to
   * that,
   *   sum_p V_p ((stress_p - b p I) grad S_ip + b p grad^c S_ip),
   * with p = tr stress_p / 3.
   */
  template <int dim>
  class MeanDilatationMotion : public StepMotion<dim>
  {
  public:
    explicit MeanDilatationMotion(const bool      objective,
                                  const BBarCells cells = BBarCells::filled)
      : StepMotion<dim>(objective)
      , cells(cells)
      , shares(cells)
    {}

    void
    start(const MaterialPoints<dim> &points,
          const Weights<dim>        &weights) override
    {
      StepMotion<dim>::start(points, weights);
      corrections.resize(points.n_points());
      shares.reinit(points, weights);
    }

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

    void
    derivative(const Material            &material,
               const MaterialPoints<dim> &points,
               const PointRange          &range,
               Material::Block           &trial,
               const Material::Block     *end,
               double                    *A) const override;

    std::unique_ptr<PointTangents<dim>>
    make_tangents(const Precision precision) const override;

    bool
    has_mean_dilatation() const override
    {
      return true;
    }

    BBarCells
    b_bar_cells() const override
    {
      return cells;
    }

    const FilledCells<dim> *
    filled_cells() const override
    {
      return &shares;
    }

  private:
    BBarCells cells;
    std::vector<double>
                     corrections; // d; `gradients` are H-bar in dim dimensions
    FilledCells<dim> shares;      // b
  };
} // namespace Waker

#endif
