// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/surface/surface_finder.h>

namespace Waker
{
  namespace
  {
    const Facets<2> &
    extruded(const Facets<2> &section, const BackgroundGrid<2> &)
    {
      return section;
    }


    /// Over the whole box.
    Facets<3>
    extruded(const Facets<2> &section, const BackgroundGrid<3> &grid)
    {
      return extrude(section, grid.lower_corner()[2], grid.upper_corner()[2]);
    }
  } // namespace


  template <int dim>
  SurfaceFinder<dim>::SurfaceFinder(const BackgroundGrid<dim> &grid,
                                    const SurfaceParameters   &parameters,
                                    const ShapeFunctions       functions,
                                    const unsigned int         closed_faces,
                                    const std::array<double, 2 * dim> &setback)
    : grid(&grid)
    , parameters(parameters)
    , functions(functions)
    , proximity(grid, parameters, closed_faces, setback)
    , contour(grid, parameters, closed_faces, setback)
    , cells(grid, closed_faces)
  {}


  template <int dim>
  void
  SurfaceFinder<dim>::reset(const Body<dim> &the_body)
  {
    body.emplace(the_body);
    for (auto &[which, section] : sections)
      section.is_valid = false;
    for (auto &[which, surface] : surfaces)
      surface.is_valid = false;
    has_field = false;
  }


  template <int dim>
  const Facets<2> &
  SurfaceFinder<dim>::section(const FoundSurface which) const
  {
    Assert(body, ExcInternalError());
    Found<2> &section = sections[which];
    if (section.is_valid)
      return section.facets;
    if (which == FoundSurface::contour)
      contour.detect(*body, chains);
    else
      {
        proximity.detect(*body, chains);
        has_field = true;
      }
    to_facets(chains, section.facets);
    section.is_valid = true;
    return section.facets;
  }


  template <int dim>
  const Facets<dim> &
  SurfaceFinder<dim>::facets(const FoundSurface which,
                             const std::string &path) const
  {
    Found<dim> &surface = find(which, path);
    if (!surface.has_holes_marked)
      holes.mark(1e-9 * grid->cell_size(), surface.facets);
    surface.has_holes_marked = true;
    return surface.facets;
  }


  template <int dim>
  typename SurfaceFinder<dim>::template Found<dim> &
  SurfaceFinder<dim>::find(const FoundSurface which,
                           const std::string &path) const
  {
    Assert(body, ExcInternalError());
    Found<dim> &surface = surfaces[which];
    if (surface.is_valid)
      return surface;
    surface.has_holes_marked = true; // where they are known, or nobody asks
    switch (which)
      {
        case FoundSurface::surface_nodes:
          cells.find_active(*body, functions, surface.facets);
          break;
        case FoundSurface::volume:
          cells.find_volume(*body, path, surface.facets);
          break;
        case FoundSurface::proximity_field:
        case FoundSurface::contour:
          if (parameters.is_of_section(dim))
            {
              surface.facets = extruded(section(which), *grid);
              break;
            }
          if (which == FoundSurface::contour)
            contour.detect(*body, surface.facets);
          else
            {
              proximity.detect(*body, surface.facets);
              has_field = true;
            }
          surface.has_holes_marked = false;
          break;
      }
    surface.is_valid = true;
    return surface;
  }


  template <int dim>
  const std::vector<double> &
  SurfaceFinder<dim>::proximity_field() const
  {
    static const std::vector<double> none;
    if (parameters.method == SurfaceMethod::proximity_field)
      facets();
    return has_field ? proximity.nodal_values(*body) : none;
  }


  template class SurfaceFinder<2>;
  template class SurfaceFinder<3>;
} // namespace Waker
