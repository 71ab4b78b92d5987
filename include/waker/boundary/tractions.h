// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_boundary_tractions_h
#define waker_boundary_tractions_h

#include <waker/boundary/facet_load.h>
#include <waker/boundary/point_shares.h>
#include <waker/boundary/surface_finder.h>
#include <waker/boundary/traction.h>
#include <waker/boundary/user_surface.h>
#include <waker/nodes/nodal_vector.h>

#include <deque>
#include <string>
#include <vector>

namespace Waker
{
  /// Where the vertices of the user's surfaces are: one list per traction,
  /// empty for those without one. It is part of the state of a run.
  template <int dim>
  using SurfaceVertices = std::vector<std::vector<Point<dim>>>;


  /// The user's surfaces of the tractions, one each; empty where there is none.
  /// @throws UserError, see read_user_surface()
  template <int dim>
  std::vector<UserSurface<dim>>
  read_surfaces(const std::vector<TractionParameters> &tractions,
                const BackgroundGrid<dim>             &grid);


  /**
   * All tractions of a case: where each acts now, and the forces on the nodes
   * that follow (sections 3.3.1 to 3.3.4 of Remmerswaal 2023; the methods are
   * listed in TractionParameters).
   *
   * Work space: made once and used in every step.
   */
  template <int dim>
  class Tractions
  {
  public:
    /// @param surfaces see read_surfaces(); must outlive this object
    Tractions(const BackgroundGrid<dim>             &grid,
              const std::vector<TractionParameters> &parameters,
              const std::vector<UserSurface<dim>>   &surfaces);

    std::size_t
    size() const
    {
      return items.size();
    }

    /// Does any of them change in time while nothing moves?
    bool
    moves() const;

    /**
     * Find the surfaces as the points lie.
     *
     * @param vertices of the user's surfaces
     * @throws UserError if there is no such surface
     */
    void
    find(const MaterialPoints<dim>  &points,
         const SurfaceVertices<dim> &vertices,
         SurfaceFinder<dim>         &finder);

    /**
     * For "fixed points": the points' loads at t = 0, in the points' own
     * scalars "load_<name>_x", ... (kN), which go with them. To be called once,
     * after find().
     */
    void
    fix_point_loads(MaterialPoints<dim> &points);

    /**
     * Add the nodal forces at time t to `force` (kN).
     *
     * @param node_mass of each node (Mg)
     * @param full_node_mass of a node inside the body (Mg)
     */
    void
    add(const double               t,
        const MaterialPoints<dim> &points,
        const std::vector<double> &node_mass,
        const double               full_node_mass,
        NodalVector               &force);

    /// What one traction does, for output; at the time of the last add().
    struct View
    {
      std::string name;
      /// Where it acts; of point loads, the surface that they stand for.
      const Facets<dim> *facets;
      /// Values on the facets (kPa).
      const Traction<dim> *traction;
      const NodalVector   *nodal_force; // kN
      /// Loads of the points (kN); empty unless it is a method of points.
      const std::vector<Tensor<1, dim>> *point_loads;
    };

    View
    view(const std::size_t i) const;

    /// The part of the surfaces that the first look found to be loaded is
    /// empty: a mistake in the input.
    /// @throws UserError "Tractions/<name>/..."
    void
    check_something_is_loaded() const;

  private:
    struct Item
    {
      TractionParameters          parameters;
      Traction<dim>               traction;
      const UserSurface<dim>     *surface;     // or null
      Facets<dim>                 part;        // that may be loaded
      Facets<dim>                 loaded;      // at the time
      std::vector<Tensor<1, dim>> point_loads; // kN
      NodalVector                 force;       // kN
    };

    void
    collect_point_loads(Item &item, const std::size_t n_points);

    const BackgroundGrid<dim> *grid;
    std::deque<Item>           items; // they do not move
    FacetLoad<dim>             load;
    PointShares<dim>           shares;
    Facets<dim>                user_facets;
  };
} // namespace Waker

#endif
