// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/surface/boxes/box_union_contour.h>
#include <waker/surface/boxes/box_union_faces.h>
#include <waker/surface/domain_contour.h>

#include <algorithm>
#include <limits>

namespace Waker
{
  namespace
  {
    /// The support domains, in the first directions of the points' space.
    /// @return their smallest extents (m), as of smallest_extent()
    template <int dim, int spacedim>
    Tensor<1, dim>
    support_domains(const MaterialPoints<spacedim> &points,
                    std::vector<Box<dim>>          &domains)
    {
      const std::size_t n = points.n_points();
      domains.resize(n);
      Tensor<1, dim> smallest;
      for (unsigned int d = 0; d < dim; ++d)
        smallest[d] = n == 0 ? 1. : std::numeric_limits<double>::max();
      for (std::size_t p = 0; p < n; ++p)
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double x      = points.position[p][d];
            const double l      = points.half_size[p][d];
            const double lower  = x - l;
            const double upper  = x + l;
            domains[p].lower[d] = lower;
            domains[p].upper[d] = upper;
            smallest[d]         = std::min(smallest[d], upper - lower);
          }
      return smallest;
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

    // The rules for domains of these smallest extents, in their space.
    template <int plane_dim>
    BoxUnionRules<plane_dim>
    rules_for(const Tensor<1, plane_dim> &smallest) const
    {
      BoxUnionRules<plane_dim> r;
      r.symmetric    = rules.symmetric;
      r.tolerance    = rules.tolerance;
      r.closed_faces = rules.closed_faces & ((1u << 2 * plane_dim) - 1);
      r.minimum_gap  = smallest;
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
  DomainContour<dim>::detect(const MaterialPoints<dim> &points,
                             Surface                   &surface)
  {
    const Tensor<1, 2> smallest = support_domains(points, work->plane_domains);
    work->contour.trace(work->plane_domains,
                        work->rules_for(smallest),
                        surface);
  }



  template <>
  void
  DomainContour<2>::detect(const MaterialPoints<2> &points, Facets<2> &facets)
  {
    detect(points, work->surface);
    facets = to_facets(work->surface);
  }



  template <>
  void
  DomainContour<3>::detect(const MaterialPoints<3> &points, Facets<3> &facets)
  {
    const Tensor<1, 3> smallest = support_domains(points, work->domains);
    work->faces.find(work->domains, work->rules_for(smallest), facets);
  }



  template class DomainContour<2>;
  template class DomainContour<3>;
} // namespace Waker
