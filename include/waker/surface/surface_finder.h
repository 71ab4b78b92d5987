// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_surface_surface_finder_h
#define waker_surface_surface_finder_h

#include <waker/surface/cell_surface.h>
#include <waker/surface/domain_contour.h>
#include <waker/surface/holes.h>
#include <waker/surface/proximity_field.h>
#include <waker/surface/shape/facet.h>
#include <waker/surface/shape/surface.h>

#include <array>
#include <map>
#include <optional>
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
    /// @param closed_faces bit 2d for the lower, 2d + 1 for the upper face
    ///        in direction d
    /// @param setback how far inside these faces the planes are that close
    ///        them (m), less than a cell: walls
    SurfaceFinder(const BackgroundGrid<dim>        &grid,
                  const SurfaceParameters          &parameters,
                  const ShapeFunctions              functions,
                  const unsigned int                closed_faces,
                  const std::array<double, 2 *dim> &setback = {});

    /// From now on the surfaces are those of this body, whose points must stay.
    void
    reset(const Body<dim> &body);

    /// What has not been found yet will be found in these points, by one rank
    /// alone.
    void
    look_at_whole(const MaterialPoints<dim> &points)
    {
      body.emplace(points);
    }

    /// The section of the surface that Surface/Method asks for, on which a dyke
    /// is measured: the chains' segments, outer chains in the order of
    /// decreasing area, then holes. In 3D that of the body's projection on the
    /// x-y plane, which is a dyke's only if it is prismatic: else it is
    /// measured in sections of facets().
    const Facets<2> &
    section() const
    {
      return section(found_by(parameters.method));
    }

    /// The surface itself. In 2D it is the section; that of a prismatic body is
    /// its section, extruded over the grid's box. What is a hole of a body in
    /// space is not marked: who asks does not need it, and it takes as long as
    /// the surface.
    const Facets<dim> &
    facets() const
    {
      return find(found_by(parameters.method), "Surface/Method").facets;
    }

    /**
     * The facets of a surface, holes marked.
     * @param path of the parameter that asks for it, for errors
     * @throws UserError if the body has no such surface
     */
    const Facets<dim> &
    facets(const FoundSurface which, const std::string &path) const;

    /// The proximity field; empty if no surface is found by it. On several
    /// ranks for one alone, that looks at the whole body.
    const std::vector<double> &
    proximity_field() const;

  private:
    template <int facet_dim>
    struct Found
    {
      bool              is_valid = false, has_holes_marked = false;
      Facets<facet_dim> facets;
    };

    const Facets<2> &
    section(const FoundSurface which) const;

    Found<dim> &
    find(const FoundSurface which, const std::string &path) const;

    BackgroundGrid<dim> const *grid;
    SurfaceParameters          parameters;
    ShapeFunctions             functions;
    std::optional<Body<dim>>   body;

    // What the points imply: work, done when it is first asked for.
    mutable ProximityField<dim> proximity;
    mutable DomainContour<dim>  contour;
    mutable CellSurface<dim>    cells;
    mutable Holes               holes;
    mutable Surface             chains;
    mutable bool                has_field = false;
    // Those asked for so far.
    mutable std::map<FoundSurface, Found<2>>   sections;
    mutable std::map<FoundSurface, Found<dim>> surfaces;
  };
} // namespace Waker

#endif
