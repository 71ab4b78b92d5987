// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_nodes_operator_h
#define waker_nodes_operator_h

#include <waker/nodes/matrix_entries.h>
#include <waker/nodes/nodal_vector.h>

namespace Waker
{
  /**
   * A linear map on nodal vectors: all that a solver may know of a stiffness.
   */
  class Operator
  {
  public:
    virtual ~Operator() = default;

    /// dst = A src
    virtual void
    vmult(NodalVector &dst, const NodalVector &src) const = 0;

    /// diagonal += diag A
    virtual void
    add_diagonal(NodalVector &diagonal) const = 0;

    /// entries += a matrix near A, symmetric and not negative: what a
    /// preconditioner is made of. By default the diagonal.
    virtual void
    add_entries(MatrixEntries &entries) const
    {
      entries.add_diagonal_of(*this);
    }

    /// Whether A is symmetric: conjugate gradients, or GMRES.
    virtual bool
    is_symmetric() const = 0;
  };
} // namespace Waker

#endif
