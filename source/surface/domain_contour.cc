// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/surface/boxes/box_union_contour.h>
#include <waker/surface/boxes/box_union_faces.h>
#include <waker/surface/domain_contour.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    /// The support domains, in the first directions of the points' space.
    template <int dim, int spacedim>
    BoxExtents<dim>
    support_domains(const MaterialPoints<spacedim> &points,
                    std::vector<Box<dim>>          &domains)
    {
      const std::size_t n = points.n_points();
      domains.resize(n);
      BoxExtents<dim> extents = BoxExtents<dim>::of_none();
      for (std::size_t p = 0; p < n; ++p)
        {
          for (unsigned int d = 0; d < dim; ++d)
            {
              const double x      = points.position[p][d];
              const double l      = points.half_size[p][d];
              domains[p].lower[d] = x - l;
              domains[p].upper[d] = x + l;
            }
          extents.add(domains[p]);
        }
      return extents;
    }
  } // namespace



  template <int dim>
  struct DomainContour<dim>::WorkSpace
  {
    SurfaceParameters     parameters;
    BoxUnionRules<dim>    rules;
    std::vector<Box<2>>   plane_domains;
    std::vector<Box<dim>> domains;
    BoxUnionContour       contour;
    BoxUnionFaces         faces; // 3D
    Surface               surface;

    BoxUnionContour::Visible              visible;
    std::vector<BoxUnionFaces::Rectangle> rectangles;

    // The rules for domains, in their space.
    template <int plane_dim>
    BoxUnionRules<plane_dim>
    rules_for(const BoxExtents<plane_dim> &all) const
    {
      BoxUnionRules<plane_dim> r;
      r.symmetric    = rules.symmetric;
      r.tolerance    = rules.tolerance;
      r.closed_faces = rules.closed_faces & ((1u << 2 * plane_dim) - 1);
      for (unsigned int d = 0; d < plane_dim; ++d)
        r.minimum_gap[d] = all.n > 0. ? all.smallest[d] : 1.;
      for (unsigned int d = 0; d < plane_dim; ++d)
        {
          r.lower[d] = rules.lower[d];
          r.upper[d] = rules.upper[d];
          r.minimum_gap[d] *= d == 1 ? parameters.minimum_gap_height
                                     : parameters.minimum_gap_width;
        }
      return r;
    }
  };



  template <int dim>
  DomainContour<dim>::DomainContour(const BackgroundGrid<dim> &grid,
                                    const SurfaceParameters   &parameters,
                                    const unsigned int         closed_faces,
                                    const std::array<double, 2 * dim> &setback)
    : work(std::make_unique<WorkSpace>())
  {
    parameters.check();
    work->parameters         = parameters;
    work->rules.symmetric    = parameters.symmetric_filling;
    work->rules.tolerance    = 1e-9 * grid.cell_size();
    work->rules.closed_faces = closed_faces;
    work->rules.lower        = grid.lower_corner();
    work->rules.upper        = grid.upper_corner();
    for (unsigned int d = 0; d < dim; ++d)
      {
        work->rules.lower[d] += setback[2 * d];
        work->rules.upper[d] -= setback[2 * d + 1];
      }
  }



  template <int dim>
  DomainContour<dim>::~DomainContour() = default;



  template <int dim>
  void
  DomainContour<dim>::detect(const Body<dim> &body, Surface &surface)
  {
    std::vector<Box<2>>   &domains = work->plane_domains;
    const BoxExtents<2>    all     = support_domains(body.whole(), domains);
    const BoxUnionRules<2> rules   = work->rules_for(all);
    work->contour.find_visible(domains, rules, all, work->visible);
    work->contour.trace(work->visible, rules, surface);
  }



  template <>
  void
  DomainContour<2>::detect(const Body<2> &body, Facets<2> &facets)
  {
    detect(body, work->surface);
    facets = to_facets(work->surface);
  }



  template <>
  void
  DomainContour<3>::detect(const Body<3> &body, Facets<3> &facets)
  {
    const BoxExtents<3> all = support_domains(body.whole(), work->domains);
    work->faces.find(
      work->domains, work->rules_for(all), all, nullptr, work->rectangles);
    BoxUnionFaces::to_facets(work->rectangles, facets);
  }



  template class DomainContour<2>;
  template class DomainContour<3>;
} // namespace Waker
