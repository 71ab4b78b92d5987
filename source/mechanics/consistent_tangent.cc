// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/consistent_tangent.h>
#include <waker/mechanics/point_tangents.h>

namespace Waker
{
  template <int dim>
  ConsistentTangent<dim>::ConsistentTangent(const Weights<dim> &weights,
                                            const Precision     precision)
    : weights(&weights)
    , precision(precision)
    , diagonal(weights.background_grid().n_dofs())
  {}


  template <int dim>
  ConsistentTangent<dim>::~ConsistentTangent() = default;


  template <int dim>
  void
  ConsistentTangent<dim>::reinit(const StressUpdate<dim>   &stress_update,
                                 const MaterialPoints<dim> &points)
  {
    if (!tangents)
      tangents = stress_update.point_motion().make_tangents(precision);
    tangents->reinit(stress_update, points, *weights, diagonal);
  }


  template <int dim>
  void
  ConsistentTangent<dim>::vmult(NodalVector &dst, const NodalVector &src) const
  {
    dst = 0.;
    tangents->vmult_add(*weights, src.begin(), dst.begin());
  }


  template <int dim>
  void
  ConsistentTangent<dim>::add_diagonal(NodalVector &result) const
  {
    result += diagonal;
  }


  template class ConsistentTangent<2>;
  template class ConsistentTangent<3>;
} // namespace Waker
