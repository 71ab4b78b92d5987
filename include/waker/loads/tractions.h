// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_tractions_h
#define waker_loads_tractions_h

#include <waker/loads/facet_load.h>
#include <waker/loads/placement.h>
#include <waker/loads/riding_load.h>
#include <waker/loads/surface_points.h>
#include <waker/loads/traction.h>
#include <waker/nodes/nodal_vector.h>
#include <waker/surface/surface_finder.h>
#include <waker/surface/user_surface.h>

#include <array>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace Waker
{
  /// Where the vertices that the material carries are, those of the user's
  /// surfaces and of loads that ride: one list per traction, empty for those
  /// without any. It is part of the state of a run.
  template <int dim>
  using SurfaceVertices = std::vector<std::vector<Point<dim>>>;


  /// The user's surfaces of the tractions, one each; empty where there is none.
  /// @throws UserError, see read_user_surface()
  template <int dim>
  std::vector<UserSurface<dim>>
  read_surfaces(const std::vector<TractionParameters> &tractions,
                const BackgroundGrid<dim>             &grid);


  /// What befell a traction during a run: when first (s), negative if never.
  /// Part of the state, so that it is said once.
  struct TractionRecord
  {
    double empty_time = -1.; // no surface is left that it could load
    double left_time  = -1.; // soil that carried it has left the grid
    double lost_time  = -1.; // more than 1 % of it falls on nodes without soil

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &empty_time &left_time &lost_time;
    }
  };


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
    /// @param grid the whole one, in which points are sought
    /// @param window of which the nodes are loaded: on one rank the grid
    /// @param surfaces see read_surfaces(); must outlive this object
    /// @param riding one each, without pieces for those that do not ride, or
    ///        not yet: see ride(); must outlive this object
    Tractions(const BackgroundGrid<dim>             &grid,
              const BackgroundGrid<dim>             &window,
              const std::vector<TractionParameters> &parameters,
              const std::vector<UserSurface<dim>>   &surfaces,
              const std::vector<RidingLoad<dim>>    &riding);

    std::size_t
    size() const
    {
      return items.size();
    }

    /// From now on a traction is this many times its value.
    void
    set_factor(const std::size_t i, const double factor)
    {
      items[i].factor = factor;
    }

    /// Does any of them change in time while nothing moves?
    bool
    moves() const;

    /// The last time at which one of them changes (s): see LastChange.
    double
    last_change() const;

    /// The path of one that changes between two times on the surfaces found
    /// last; empty if none does.
    std::string
    varying(const double from, const double to) const;

    /**
     * Find the surfaces as the points lie.
     *
     * @param points those of this rank
     * @param vertices that the material carries
     * @throws UserError if there is no such surface
     */
    void
    find(const MaterialPoints<dim>  &points,
         const SurfaceVertices<dim> &vertices,
         const SurfaceFinder<dim>   &finder);

    /**
     * Let those that follow the soil ride from now on on the parts that
     * find() has selected (TractionParameters::rides()). To be called once.
     *
     * @param riding what the constructor got
     */
    void
    ride(const MaterialPoints<dim>    &points,
         std::vector<RidingLoad<dim>> &riding);

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
     * @param points those of this rank
     * @param node_mass of each node of the window (Mg)
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
      const NodalVector *nodal_force; // of the whole grid, kN
      /// Loads of this rank's points (kN); null unless it is a method of
      /// points.
      const std::vector<Tensor<1, dim>> *point_loads;
    };

    View
    view(const std::size_t i) const;

    /// On several ranks, for what views show.
    /// @param gather from the window to the whole grid (RankPart)
    void
    complete(const std::function<void(const NodalVector &window,
                                      NodalVector       &all)> &gather);

    /// Traction (kPa) at x on facet k of the view.
    Tensor<1, dim>
    value(const std::size_t i, const std::size_t k, const Point<dim> &x) const;

    /// What acts, and on how much.
    struct Resultant
    {
      Tensor<1, dim> force;   // on the nodes that have mass (kN)
      double         measure; // length or area of the facets (m^(dim-1))
    };

    /// At the time of the last add().
    Resultant
    resultant(const std::size_t i) const;

    /// Note what befell the tractions up to t; at the time of the last add().
    /// @param records one each; made by the first call
    void
    record(const double t, std::vector<TractionRecord> &records) const;

    /// The part of the surfaces that the first look found to be loaded is
    /// empty: a mistake in the input.
    /// @throws UserError "Tractions/<name>/..."
    void
    check_something_is_loaded() const;

  private:
    struct Item
    {
      TractionParameters                      parameters;
      Traction<dim>                           traction;
      const RidingLoad<dim>                  *riding; // if it has pieces
      std::unique_ptr<TractionPlacement<dim>> placement;
      Facets<dim>                             part;        // that may be loaded
      Facets<dim>                             loaded;      // at the time
      std::vector<Tensor<1, dim>>             point_loads; // kN
      NodalVector                             force;       // kN
      NodalVector                             whole_force; // see complete()
      /// Of the facets, if it rides.
      std::vector<typename RidingLoad<dim>::Placed> placed;
      /// Sizes of the nodal forces, and of those on nodes without mass (kN).
      double                  total = 0., lost = 0.;
      std::array<double, dim> on_mass = {}; // of those on nodes with mass (kN)
      double                  factor  = 1.; // of a load programme

      bool
      rides() const
      {
        return !riding->pieces.empty();
      }

      Tensor<1, dim>
      value(const std::size_t k, const Point<dim> &x) const;
    };

    // Has this traction, of fixed points, got its loads?
    bool
    has_fixed_loads(const Item &item, const MaterialPoints<dim> &points) const;

    void
    collect_point_loads(Item &item, const std::size_t n_points);

    void
    add_point_loads(Item &item, const MaterialPoints<dim> &points);

    void
    add_facets(const Item &item);

    /// What becomes of the loads that were collected, and of the item's force.
    void
    add_up(const std::vector<double> &node_mass, Item &item) const;

    const BackgroundGrid<dim> *grid, *window;
    const NodeExchange        *ranks; // of the window
    std::deque<Item>           items; // they do not move
    FacetLoad<dim>             load;
    SurfacePoints<dim>         surface_points;
  };
} // namespace Waker

#endif
