// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_nodes_operator_sum_h
#define waker_nodes_operator_sum_h

#include <waker/nodes/operator.h>

namespace Waker
{
  /**
   * A stiffness and a small, symmetric part of it that others bring: walls off
   * the grid, ghost stiffness. The part has vmult_add(dst, src) and
   * add_diagonal(diagonal).
   */
  template <typename Part>
  class OperatorSum : public Operator
  {
  public:
    /// Both must outlive this object.
    OperatorSum(const Operator &stiffness, const Part &part)
      : stiffness(stiffness)
      , part(part)
    {}

    void
    vmult(NodalVector &dst, const NodalVector &src) const override
    {
      stiffness.vmult(dst, src);
      part.vmult_add(dst, src);
    }

    void
    add_diagonal(NodalVector &diagonal) const override
    {
      stiffness.add_diagonal(diagonal);
      part.add_diagonal(diagonal);
    }

    bool
    is_symmetric() const override
    {
      return stiffness.is_symmetric();
    }

  private:
    const Operator &stiffness;
    const Part     &part;
  };
} // namespace Waker

#endif
