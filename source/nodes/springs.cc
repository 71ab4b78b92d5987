// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/nodes/springs.h>

#include <cmath>

namespace Waker
{
  template <int dim>
  Springs<dim>::Springs(const Fixities<dim> &fixities,
                        const double         modulus,
                        const double         h)
    : fixities(&fixities)
  {
    for (const auto &penalty : fixities.penalties())
      {
        dofs.push_back(penalty.dof);
        stiffness.push_back(penalty.factor * modulus * std::pow(h, dim - 2));
      }
    targets.resize(dofs.size());
    holds.resize(dofs.size(), 0);
  }


  template <int dim>
  void
  Springs<dim>::begin(const MaterialPoints<dim> &,
                      const NodalState &nodes,
                      const double      t,
                      const double      dt)
  {
    fixities->penalty_increments(t, dt, targets);
    for (std::size_t s = 0; s < dofs.size(); ++s)
      holds[s] = nodes.mass[dofs[s] / dim] > 0.;
  }


  template <int dim>
  double
  Springs<dim>::force(const std::size_t s, const NodalVector &increment) const
  {
    return holds[s] ? stiffness[s] * (increment.begin()[dofs[s]] - targets[s])
                    : 0.;
  }


  template <int dim>
  void
  Springs<dim>::add_force(const NodalVector &increment, NodalVector &internal)
  {
    for (std::size_t s = 0; s < dofs.size(); ++s)
      internal.begin()[dofs[s]] += force(s, increment);
  }


  template <int dim>
  void
  Springs<dim>::vmult_add(NodalVector &dst, const NodalVector &src) const
  {
    for (std::size_t s = 0; s < dofs.size(); ++s)
      dst.begin()[dofs[s]] += stiffness[s] * src.begin()[dofs[s]];
  }


  template <int dim>
  void
  Springs<dim>::add_diagonal(NodalVector &diagonal) const
  {
    for (std::size_t s = 0; s < dofs.size(); ++s)
      diagonal.begin()[dofs[s]] += stiffness[s];
  }


  template <int dim>
  Tensor<1, dim>
  Springs<dim>::accept(const NodalVector &increment, MaterialPoints<dim> &)
  {
    Tensor<1, dim> reaction;
    for (std::size_t s = 0; s < dofs.size(); ++s)
      reaction[dofs[s] % dim] -= force(s, increment);
    return reaction;
  }


  template <int dim>
  ResistanceWork
  Springs<dim>::work(const NodalVector &increment) const
  {
    // Like that of a removed equation: the force at the end, all the way.
    double sum = 0.;
    for (std::size_t s = 0; s < dofs.size(); ++s)
      sum -= force(s, increment) * increment.begin()[dofs[s]];
    return {sum, sum};
  }


  template class Springs<2>;
  template class Springs<3>;
} // namespace Waker
