// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_nodes_springs_h
#define waker_nodes_springs_h

#include <waker/nodes/fixities.h>
#include <waker/nodes/resistance.h>

#include <vector>

namespace Waker
{
  /**
   * Springs that hold dofs, the penalty form of a support: the force on the
   * body is -k (u - g), g the prescribed increment (see FixityParameters). They
   * keep no force from step to step.
   */
  template <int dim>
  class Springs : public Resistance<dim>
  {
  public:
    /// @param fixities must outlive this object
    /// @param modulus the stiffest K + 4G/3 (kPa)
    /// @param h size of a cell (m)
    Springs(const Fixities<dim> &fixities,
            const double         modulus,
            const double         h);

    /// Are there none, on any rank?
    bool
    empty() const
    {
      return !fixities->has_penalties();
    }

    typename Resistance<dim>::Role
    role() const override
    {
      return Resistance<dim>::Role::support;
    }

    void
    begin(const MaterialPoints<dim> &points,
          const NodalState          &nodes,
          const double               t,
          const double               dt) override;

    void
    add_force(const NodalVector &increment, NodalVector &internal) override;

    void
    vmult_add(NodalVector &dst, const NodalVector &src) const override;

    void
    add_diagonal(NodalVector &diagonal) const override;

    Tensor<1, dim>
    accept(const NodalVector &increment, MaterialPoints<dim> &points) override;

    ResistanceWork
    work(const NodalVector &increment) const override;

  private:
    /// k (u - g) of spring s; 0 where there is no soil (kN).
    double
    force(const std::size_t s, const NodalVector &increment) const;

    const Fixities<dim>       *fixities;
    std::vector<unsigned int>  dofs;
    std::vector<double>        stiffness; // k, kN/m
    std::vector<double>        targets;   // g, m
    std::vector<unsigned char> holds;     // is there soil?
  };
} // namespace Waker

#endif
