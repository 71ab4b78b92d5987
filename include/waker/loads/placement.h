// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_placement_h
#define waker_loads_placement_h

#include <waker/loads/traction_parameters.h>
#include <waker/surface/shape/facet.h>

#include <memory>
#include <string>
#include <vector>

namespace Waker
{
  template <int dim>
  class SurfaceFinder;
  template <int dim>
  struct UserSurface;

  /**
   * Where a traction acts: one for each traction, a case of TractionMethod. It
   * says which surface; which part of that, and what acts there, Traction says.
   */
  template <int dim>
  class TractionPlacement
  {
  public:
    virtual ~TractionPlacement() = default;

    /**
     * The surface as the points lie.
     *
     * @param vertices that the material carries; of a user's surface
     * @param finder of what can be found from the points
     * @param path of the traction, for errors
     * @throws UserError if there is no such surface
     */
    virtual const Facets<dim> &
    surface(const std::vector<Point<dim>> &vertices,
            const SurfaceFinder<dim>      &finder,
            const std::string             &path) = 0;

    /// Does the material carry vertices of it?
    virtual bool
    is_carried() const
    {
      return false;
    }

    /// Do points hand the load on to the nodes (eqs. 3.1 and 3.2 of Remmerswaal
    /// 2023), or the facets themselves (eq. 3.4)?
    virtual bool
    on_points() const
    {
      return false;
    }

    /// On points: those of the start, once and for all?
    virtual bool
    is_fixed() const
    {
      return false;
    }
  };


  /// The one place that knows them all.
  /// @param user_surface see read_surfaces(); must outlive the placement
  template <int dim>
  std::unique_ptr<TractionPlacement<dim>>
  make_placement(const TractionParameters &parameters,
                 const UserSurface<dim>   &user_surface);
} // namespace Waker

#endif
