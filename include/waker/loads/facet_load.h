// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_facet_load_h
#define waker_loads_facet_load_h

#include <waker/loads/load_distribution.h>
#include <waker/nodes/nodal_vector.h>
#include <waker/surface/shape/facet.h>

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
   * integrated exactly for tractions that are linear in space: with two Gauss
   * points on a segment (N q is cubic along it), six on a triangle (N q has
   * degree four on it).
   *
   * A node that a support domain has hardly touched would be thrown away by its
   * share: the share of a node with less mass than a minimum goes to supported
   * nodes nearby, with weights that keep resultant and moment
   * (LoadDistribution). A load that fits the internal force by itself, as on
   * the contour of the support domains, needs no minimum.
   *
   * On several ranks each is given all facets, and collects what they do in its
   * window: at its own nodes that is all of it.
   *
   * Work space: made once, used in every step.
   */
  template <int dim>
  class FacetLoad
  {
  public:
    explicit FacetLoad(const LoadNodes<dim> &nodes);

    /// Traction (kPa) on a facet at a place.
    using Traction =
      std::function<Tensor<1, dim>(const Facet<dim> &, const Point<dim> &)>;

    /// Pressure (kPa), against the outward normal, at a place.
    using Pressure = std::function<double(const Point<dim> &)>;

    /// Start anew.
    void
    clear();

    /// Collect the nodal forces of a facet. It must lie inside the grid and its
    /// margin.
    void
    add(const Facet<dim> &facet, const Traction &traction);

    /// The same for a pressure.
    void
    add_pressure(const Facet<dim> &facet, const Pressure &pressure);

    /// Collect a force at a place (kN): F_i = N_i(x) f.
    void
    add(const Point<dim> &x, const Tensor<1, dim> &force);

    /// Plane of nodes, see LoadDistribution.
    using Plane = typename LoadDistribution<dim>::Plane;

    /**
     * Add what was collected to `force` (kN): see LoadDistribution::add().
     *
     * @param node_mass of each node (Mg)
     * @param minimum_mass of a node that carries load (Mg); 0: all do
     *
     * If no node has that mass, nothing is added.
     */
    void
    distribute(const std::vector<double> &node_mass,
               const double               minimum_mass,
               NodalVector               &force,
               const std::vector<Plane>  &planes = {Plane()});

    /// The collected forces (kN), dim per node, before any redistribution.
    const std::vector<double> &
    nodal_forces() const
    {
      return forces;
    }

    /// The nodes that have one, in the order in which they were met.
    const std::vector<unsigned int> &
    nodes() const
    {
      return loaded_nodes;
    }

  private:
    using Index = std::array<int, dim>;

    // Call force_at(x, w) for the force (kN) of the facet's part of measure w
    // around x, for all Gauss points of all pieces.
    template <typename Force>
    void
    integrate(const Facet<dim> &facet, const Force &force_at);

    // The part of a facet within one cell: a segment from a to b (m), or a
    // convex polygon of n corners in cells from the origin.
    template <typename Force>
    void
    integrate_segment(const Point<dim> &a,
                      const Point<dim> &b,
                      const Force      &force_at);
    template <typename Force>
    void
    integrate_polygon(const Point<dim>  *corners,
                      const unsigned int n,
                      const Index       &cell,
                      const Force       &force_at);

    // Add N_i f, for u = x - node 0 of the cell, in cells; the cell is here.
    void
    add_in_cell(const Index          &cell,
                const Point<dim>     &u,
                const Tensor<1, dim> &f);

    // The cell that holds x (in cells from the origin), inside the lattice.
    Index
    cell_of(const Point<dim> &x) const;

    // May a facet reach the nodes that are here?
    bool
    may_meet(const Facet<dim> &facet) const;

    LoadNodes<dim>             lattice;
    LoadDistribution<dim>      distribution;
    std::vector<double>        forces;
    std::vector<unsigned char> is_loaded;
    std::vector<unsigned int>  loaded_nodes;
    std::vector<double>        cuts;
  };
} // namespace Waker

#endif
