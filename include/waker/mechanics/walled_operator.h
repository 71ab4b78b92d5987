// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_walled_operator_h
#define waker_mechanics_walled_operator_h

#include <waker/boundary/wall.h>
#include <waker/nodes/operator.h>

namespace Waker
{
  /// A stiffness and that of walls off the grid.
  template <int dim>
  class WalledOperator : public Operator
  {
  public:
    /// Both must outlive this object.
    WalledOperator(const Operator &stiffness, const Walls<dim> &walls)
      : stiffness(stiffness)
      , walls(walls)
    {}

    void
    vmult(NodalVector &dst, const NodalVector &src) const override
    {
      stiffness.vmult(dst, src);
      walls.vmult_add(dst, src);
    }

    void
    add_diagonal(NodalVector &diagonal) const override
    {
      stiffness.add_diagonal(diagonal);
      walls.add_diagonal(diagonal);
    }

    bool
    is_symmetric() const override
    {
      return stiffness.is_symmetric();
    }

  private:
    const Operator   &stiffness;
    const Walls<dim> &walls;
  };
} // namespace Waker

#endif
