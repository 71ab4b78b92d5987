// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_shared_vector_h
#define waker_mechanics_shared_vector_h

#include <waker/grid/node_exchange.h>
#include <waker/nodes/nodal_vector.h>

#include <cmath>

namespace Waker
{
  /**
   * A vector over a rank's window of the grid that is 0 at the nodes of others:
   * what is a product of vectors is summed over all ranks, everything else is
   * that of NodalVector. What deal.II's SolverCG needs, and no more.
   */
  class SharedVector : public NodalVector
  {
  public:
    /// For a VectorMemory; reinit() comes next.
    SharedVector() = default;

    explicit SharedVector(const NodeExchange &ranks)
      : ranks(&ranks)
    {}

    void
    reinit(const SharedVector &other, const bool leave_as_is = false)
    {
      NodalVector::reinit(other, leave_as_is);
      ranks = other.ranks;
    }

    void
    reinit(const NodalVector &other, const bool leave_as_is = false)
    {
      NodalVector::reinit(other, leave_as_is);
    }

    double
    operator*(const SharedVector &other) const
    {
      return ranks->sum(NodalVector::operator*(other));
    }

    double
    l2_norm() const
    {
      return std::sqrt(*this * *this);
    }

    /// *this += a V; return *this * W
    double
    add_and_dot(const double a, const SharedVector &V, const SharedVector &W)
    {
      return ranks->sum(NodalVector::add_and_dot(a, V, W));
    }

    bool
    all_zero() const
    {
      return ranks->largest(NodalVector::linfty_norm()) == 0.;
    }

    using NodalVector::operator=;

  private:
    const NodeExchange *ranks = nullptr;
  };
} // namespace Waker

#endif
