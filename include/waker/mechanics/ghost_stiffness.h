// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_ghost_stiffness_h
#define waker_mechanics_ghost_stiffness_h

#include <waker/nodes/fixities.h>
#include <waker/nodes/resistance.h>

#include <vector>

namespace Waker
{
  /**
   * A node that support domains hardly touch has next to no stiffness; without
   * inertia it moves as it likes, and spoils Newton's method. The ghost
   * stiffness makes it follow its neighbours: it penalises the jump of the
   * gradient of the displacement increment over the faces at such nodes
   * (Coombs 2023), on the uniform grid springs with the energy
   *   1/2 k (u_{i-1} - 2 u_i + u_{i+1})^2,  k = f (K + 4G/3) h^(dim-2),
   * on each three nodes in a row of which one is hardly touched. Fields that
   * are linear cost nothing, and each spring's forces are in balance. f is
   * TimeParameters::ghost_stiffness.
   */
  template <int dim>
  class GhostStiffness : public Resistance<dim>
  {
  public:
    /// @param fixities must outlive this object
    /// @param stiffness f (K + 4G/3), of the stiffest material (kPa)
    /// @param full_node_mass of a node inside the body (Mg)
    GhostStiffness(const BackgroundGrid<dim> &grid,
                   const Fixities<dim>       &fixities,
                   const double               stiffness,
                   const double               full_node_mass);

    typename Resistance<dim>::Role
    role() const override
    {
      return Resistance<dim>::Role::remedy;
    }

    /// Find the nodes that are hardly touched.
    void
    begin(const MaterialPoints<dim> &points,
          const NodalState          &nodes,
          const double               t,
          const double               dt) override;

    /// The force of the springs, which is linear in the increment.
    void
    add_force(const NodalVector &increment, NodalVector &internal) override
    {
      vmult_add(internal, increment);
    }

    void
    vmult_add(NodalVector &dst, const NodalVector &src) const override;

    void
    add_diagonal(NodalVector &diagonal) const override;

    void
    add_entries(MatrixEntries &entries) const override;

    Tensor<1, dim>
    accept(const NodalVector &increment, MaterialPoints<dim> &points) override;

    ResistanceWork
    work(const NodalVector &increment) const override;

  private:
    /// Three dofs in a row: middle - distance, middle, middle + distance.
    struct Row
    {
      unsigned int middle, distance;
    };

    const BackgroundGrid<dim> *grid;
    const Fixities<dim>       *fixities;
    double                     k; // kN/m
    double                     full_node_mass;
    std::vector<Row>           rows;
  };
} // namespace Waker

#endif
