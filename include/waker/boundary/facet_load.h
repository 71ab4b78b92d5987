// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_boundary_facet_load_h
#define waker_boundary_facet_load_h

#include <waker/boundary/facet.h>
#include <waker/boundary/nodal_support.h>
#include <waker/grid/background_grid.h>
#include <waker/nodes/nodal_vector.h>

#include <functional>
#include <vector>

namespace Waker
{
  /**
   * From tractions on facets to forces on nodes: F_i = sum over the facets of
   * the integral of N_i q (eq. 3.4 of Remmerswaal 2023), with linear functions
   * N_i also under GIMP: a surface has no width to average over.
   *
   * Facets are cut where they cross the faces of the cells, and every piece is
   * integrated exactly for tractions that are linear in space.
   *
   * A node that a support domain has hardly touched would be thrown away by its
   * share: the share of a node with less mass than a minimum goes to supported
   * nodes nearby, with weights that keep resultant and moment
   * (boundary/nodal_support.h). A load that fits the internal force by itself,
   * as on the contour of the support domains, needs no minimum.
   *
   * Work space: made once, used in every step.
   */
  template <int dim>
  class FacetLoad
  {
  public:
    explicit FacetLoad(const BackgroundGrid<dim> &grid);

    /// Traction (kPa) on a facet at a place.
    using Traction =
      std::function<Tensor<1, dim>(const Facet<dim> &, const Point<dim> &)>;

    /// Start anew.
    void
    clear();

    /// Collect the nodal forces of a facet. It must lie inside the grid and its
    /// margin.
    void
    add(const Facet<dim> &facet, const Traction &traction);

    /// Collect a force at a place (kN): F_i = N_i(x) f.
    void
    add(const Point<dim> &x, const Tensor<1, dim> &force);

    /**
     * Add what was collected to `force` (kN).
     *
     * @param node_mass of each node (Mg)
     * @param minimum_mass of a node that carries load (Mg); 0: all do
     */
    void
    distribute(const std::vector<double> &node_mass,
               const double               minimum_mass,
               NodalVector               &force) const;

    /// The collected forces (kN), dim per node, before any redistribution.
    const std::vector<double> &
    nodal_forces() const
    {
      return forces;
    }

  private:
    void
    add_to_node(const unsigned int node, const Tensor<1, dim> &f);

    const BackgroundGrid<dim> *grid;
    std::vector<double>        forces;
    std::vector<unsigned char> is_loaded;
    std::vector<unsigned int>  loaded_nodes;
  };
} // namespace Waker

#endif
