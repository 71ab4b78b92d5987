// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_ghost_stiffness_h
#define waker_mechanics_ghost_stiffness_h

#include <waker/nodes/fixities.h>
#include <waker/nodes/nodal_vector.h>

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
  class GhostStiffness
  {
  public:
    /// @param fixities must outlive this object
    /// @param stiffness f (K + 4G/3), of the stiffest material (kPa)
    GhostStiffness(const BackgroundGrid<dim> &grid,
                   const Fixities<dim>       &fixities,
                   const double               stiffness);

    /// Find the nodes that are hardly touched.
    /// @param full_node_mass of a node inside the body (Mg)
    void
    reinit(const std::vector<double> &mass, const double full_node_mass);

    /// force += the force of the springs at displacement increments u, which
    /// is linear in them.
    void
    vmult_add(NodalVector &force, const NodalVector &u) const;

    /// diagonal += its own.
    void
    add_diagonal(NodalVector &diagonal) const;

  private:
    /// Three dofs in a row: middle - distance, middle, middle + distance.
    struct Row
    {
      unsigned int middle, distance;
    };

    const BackgroundGrid<dim> *grid;
    const Fixities<dim>       *fixities;
    double                     k; // kN/m
    std::vector<Row>           rows;
  };
} // namespace Waker

#endif
