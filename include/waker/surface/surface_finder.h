// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_surface_surface_finder_h
#define waker_surface_surface_finder_h

#include <waker/surface/cell_surface.h>
#include <waker/surface/domain_contour.h>
#include <waker/surface/holes.h>
#include <waker/surface/proximity_field.h>
#include <waker/surface/shape/facet.h>
#include <waker/surface/shape/surface.h>

#include <map>
#include <string>
#include <vector>

namespace Waker
{
  /// What can be found from the points alone.
  enum class FoundSurface
  {
    proximity_field,
    contour,       // of the support domains
    surface_nodes, // between active and inactive cells
    volume         // of the points in each cell
  };

  constexpr FoundSurface
  found_by(const SurfaceMethod method)
  {
    switch (method)
      {
        case SurfaceMethod::proximity_field:
          return FoundSurface::proximity_field;
        case SurfaceMethod::contour:
          return FoundSurface::contour;
      }
    return FoundSurface::proximity_field;
  }


  /**
   * All surfaces that can be found from the points alone. Each is found when it
   * is first asked for and kept until the points move: water, tractions and
   * observers share them.
   */
  template <int dim>
  class SurfaceFinder
  {
  public:
    SurfaceFinder(const BackgroundGrid<dim> &grid,
                  const SurfaceParameters   &parameters,
                  const ShapeFunctions       functions,
                  const unsigned int         closed_faces);

    /// From now on the surfaces are those of these points, which must stay.
    void
    reset(const MaterialPoints<dim> &points);

    /// Is the surface one in space, with facets that are more than chains?
    bool
    is_spatial() const
    {
      return dim == 3 && !parameters.prismatic;
    }

    /// The chains of the surface that Surface/Method asks for, for water and
    /// observers; in 3D of the body's projection on the x-y plane.
    const Surface &
    chains() const;

    /// The facets of the same surface.
    const Facets<dim> &
    facets() const
    {
      return facets(found_by(parameters.method), "Surface/Method");
    }

    /**
     * The facets of a surface.
     * @param path of the parameter that asks for it, for errors
     * @throws UserError if the body has no such surface
     */
    const Facets<dim> &
    facets(const FoundSurface which, const std::string &path) const;

    /// The proximity field; empty if no surface is found by it.
    const std::vector<double> &
    proximity_field() const;

  private:
    struct Found
    {
      bool        is_valid = false;
      Facets<dim> facets;
    };

    const Surface &
    chains(const FoundSurface which) const;

    BackgroundGrid<dim> const *grid;
    SurfaceParameters          parameters;
    ShapeFunctions             functions;
    const MaterialPoints<dim> *points = nullptr;

    // What the points imply: work, done when it is first asked for.
    mutable ProximityField<dim> proximity;
    mutable DomainContour<dim>  contour;
    mutable CellSurface<dim>    cells;
    mutable Holes               holes;
    // proximity field, contour
    mutable bool                          has_chains[2] = {false, false};
    mutable Surface                       found_chains[2];
    mutable std::map<FoundSurface, Found> found; // those asked for so far
    mutable bool                          has_field = false;
  };
} // namespace Waker

#endif
