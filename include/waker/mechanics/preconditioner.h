// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_preconditioner_h
#define waker_mechanics_preconditioner_h

#include <waker/nodes/operator.h>

namespace Waker
{
  /**
   * Something near the inverse of an operator that takes time to set up:
   * symmetric and positive, whatever the operator is.
   */
  class Preconditioner
  {
  public:
    virtual ~Preconditioner() = default;

    /**
     * Set it up, from Operator::add_entries(); collective.
     * @return is it of use? Else it must not be applied; the same on all ranks
     */
    virtual bool
    reinit(const Operator &A) = 0;

    /// Give the memory back.
    virtual void
    clear() = 0;

    /// dst = M^-1 src; on several ranks at the own nodes, 0 elsewhere.
    virtual void
    vmult(NodalVector &dst, const NodalVector &src) const = 0;
  };
} // namespace Waker

#endif
