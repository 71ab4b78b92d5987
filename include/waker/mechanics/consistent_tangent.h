// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_consistent_tangent_h
#define waker_mechanics_consistent_tangent_h

#include <waker/mechanics/stress_update.h>
#include <waker/nodes/operator.h>

namespace Waker
{
  /**
   * The derivative of the internal force as StressUpdate computes it, applied
   * point by point without a matrix: with it, Newton converges quadratically.
   * The objective rate makes it slightly unsymmetric; so does an unsymmetric
   * law with logarithmic strain.
   */
  template <int dim>
  class ConsistentTangent : public Operator
  {
  public:
    /// @param weights must outlive this object
    ConsistentTangent(const Weights<dim> &weights,
                      const Precision precision = Precision::single_precision);
    ~ConsistentTangent();

    /// Linearise where `stress_update` was last evaluated: of the same motion
    /// each time.
    void
    reinit(const StressUpdate<dim>   &stress_update,
           const MaterialPoints<dim> &points);

    void
    vmult(NodalVector &dst, const NodalVector &src) const override;

    void
    add_diagonal(NodalVector &diagonal) const override;

    bool
    is_symmetric() const override
    {
      return false;
    }

    const Weights<dim> &
    point_weights() const
    {
      return *weights;
    }

  private:
    const Weights<dim>                 *weights;
    Precision                           precision;
    std::unique_ptr<PointTangents<dim>> tangents;
    NodalVector                         diagonal;
  };
} // namespace Waker

#endif
