// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/surface/surface_finder.h>

namespace Waker
{
  namespace
  {
    Facets<2>
    extrude(const Surface &surface, const BackgroundGrid<2> &)
    {
      return to_facets(surface);
    }


    /// The sides of a body that is prismatic over the grid's box, without its
    /// ends.
    Facets<3>
    extrude(const Surface &surface, const BackgroundGrid<3> &grid)
    {
      const double back  = grid.lower_corner()[2];
      const double front = grid.upper_corner()[2];
      Facets<3>    facets;
      for (const SurfaceChain &chain : surface.chains)
        {
          const std::size_t n       = chain.vertices.size();
          const bool        in_hole = chain.area() < 0.;
          for (std::size_t k = 0; k < n; ++k)
            {
              // The body is on the left seen from the front.
              const Point<2> &a    = chain.vertices[k];
              const Point<2> &b    = chain.vertices[(k + 1) % n];
              const Point<3>  x[4] = {Point<3>(a[0], a[1], back),
                                      Point<3>(b[0], b[1], back),
                                      Point<3>(b[0], b[1], front),
                                      Point<3>(a[0], a[1], front)};
              facets.push_back(
                make_facet<3>({{x[0], x[2], x[1]}}, chain.on_face[k]));
              facets.push_back(
                make_facet<3>({{x[0], x[3], x[2]}}, chain.on_face[k]));
              for (unsigned int i = 1; i <= 2; ++i)
                facets[facets.size() - i].in_hole = in_hole;
            }
        }
      return facets;
    }
  } // namespace


  template <int dim>
  SurfaceFinder<dim>::SurfaceFinder(const BackgroundGrid<dim> &grid,
                                    const SurfaceParameters   &parameters,
                                    const ShapeFunctions       functions,
                                    const unsigned int         closed_faces)
    : grid(&grid)
    , parameters(parameters)
    , functions(functions)
    , proximity(grid, parameters, closed_faces)
    , contour(grid, parameters, closed_faces)
    , cells(grid, closed_faces)
  {}


  template <int dim>
  void
  SurfaceFinder<dim>::reset(const MaterialPoints<dim> &the_points)
  {
    points = &the_points;
    for (bool &has : has_chains)
      has = false;
    for (auto &[which, surface] : found)
      surface.is_valid = false;
    has_field = false;
  }


  template <int dim>
  const Surface &
  SurfaceFinder<dim>::chains() const
  {
    return chains(found_by(parameters.method));
  }


  template <int dim>
  const Surface &
  SurfaceFinder<dim>::chains(const FoundSurface which) const
  {
    Assert(points != nullptr, ExcInternalError());
    const unsigned int i = which == FoundSurface::contour ? 1 : 0;
    if (!has_chains[i])
      {
        if (i == 1)
          contour.detect(*points, found_chains[i]);
        else
          {
            proximity.detect(*points, found_chains[i]);
            has_field = true;
          }
        has_chains[i] = true;
      }
    return found_chains[i];
  }


  template <int dim>
  const Facets<dim> &
  SurfaceFinder<dim>::facets(const FoundSurface which,
                             const std::string &path) const
  {
    Assert(points != nullptr, ExcInternalError());
    Found &surface = found[which];
    if (surface.is_valid)
      return surface.facets;
    switch (which)
      {
        case FoundSurface::surface_nodes:
          cells.find_active(*points, functions, surface.facets);
          break;
        case FoundSurface::volume:
          cells.find_volume(*points, path, surface.facets);
          break;
        case FoundSurface::proximity_field:
        case FoundSurface::contour:
          if (!is_spatial())
            {
              surface.facets = extrude(chains(which), *grid);
              break;
            }
          if (which == FoundSurface::contour)
            contour.detect(*points, surface.facets);
          else
            {
              proximity.detect(*points, surface.facets);
              has_field = true;
            }
          holes.mark(1e-9 * grid->cell_size(), surface.facets);
          break;
      }
    surface.is_valid = true;
    return surface.facets;
  }


  template <int dim>
  const std::vector<double> &
  SurfaceFinder<dim>::proximity_field() const
  {
    static const std::vector<double> none;
    if (parameters.method == SurfaceMethod::proximity_field)
      facets();
    return has_field ? proximity.nodal_values() : none;
  }


  template class SurfaceFinder<2>;
  template class SurfaceFinder<3>;
} // namespace Waker
