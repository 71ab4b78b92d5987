// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/particles/near_points.h>
#include <waker/surface/boxes/box_union_contour.h>
#include <waker/surface/boxes/box_union_faces.h>
#include <waker/surface/domain_contour.h>

#include <algorithm>
#include <array>

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


    /// Those of all ranks.
    template <int dim>
    BoxExtents<dim>
    of_all(BoxExtents<dim> extents, const NodeExchange &ranks)
    {
      double ends[3 * dim];
      for (unsigned int d = 0; d < dim; ++d)
        {
          ends[d]           = -extents.lower[d];
          ends[dim + d]     = extents.upper[d];
          ends[2 * dim + d] = -extents.smallest[d];
        }
      ranks.largest(ends, 3 * dim);
      for (unsigned int d = 0; d < dim; ++d)
        {
          extents.lower[d]    = -ends[d];
          extents.upper[d]    = ends[dim + d];
          extents.smallest[d] = -ends[2 * dim + d];
        }
      extents.n = ranks.sum(extents.n);
      return extents;
    }


    /// Boxes of each rank become those of all.
    void
    tell_all(const NodeExchange &ranks, std::vector<Box<2>> &boxes)
    {
      std::vector<std::array<double, 4>> told; // m
      for (const Box<2> &box : boxes)
        told.push_back(
          {{box.lower[0], box.lower[1], box.upper[0], box.upper[1]}});
      told = ranks.all_gather(told);
      boxes.clear();
      for (const std::array<double, 4> &x : told)
        boxes.push_back({Point<2>(x[0], x[1]), Point<2>(x[2], x[3])});
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

    // On several ranks.
    BoxUnionContour::Visible              visible;
    MaterialPoints<dim>                   around;
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
    std::vector<Box<2>>      &domains = work->plane_domains;
    const NodeExchange *const ranks =
      body.window() != nullptr ? &body.window()->exchange() : nullptr;
    BoxExtents<2> all = support_domains(body.own(), domains);
    if (ranks != nullptr)
      all = of_all(all, *ranks);
    const BoxUnionRules<2> rules = work->rules_for(all);
    work->contour.find_visible(domains, rules, all, work->visible, ranks);
    if (ranks != nullptr)
      tell_all(*ranks, work->visible.boxes);
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
    const BoxExtents<3> own = support_domains(body.own(), work->domains);
    if (body.window() == nullptr)
      {
        work->faces.find(
          work->domains, work->rules_for(own), own, {}, work->rectangles);
        BoxUnionFaces::to_facets(work->rectangles, facets);
        return;
      }
    const BackgroundGrid<3> &window = *body.window();
    const NodeExchange      &ranks  = window.exchange();
    const BoxExtents<3>      all    = of_all(own, ranks);
    const BoxUnionRules<3>   rules  = work->rules_for(all);
    support_domains(own_and_near(body,
                                 largest_half_size(body.own()) +
                                   BoxUnionFaces::reach(rules, all),
                                 work->around),
                    work->domains);
    BoxUnionFaces::Share share;
    share.has = [&](const Point<3> &x) {
      return window.owns_cell(window.nearest_cell(x));
    };
    share.tell_all = [&](std::vector<double> &numbers) {
      numbers = ranks.all_gather(numbers);
    };
    work->faces.find(work->domains, rules, all, share, work->rectangles);
    work->rectangles = ranks.all_gather(work->rectangles);
    std::stable_sort(work->rectangles.begin(),
                     work->rectangles.end(),
                     [](const auto &a, const auto &b) {
                       return a.block < b.block;
                     });
    BoxUnionFaces::to_facets(work->rectangles, facets);
  }



  template class DomainContour<2>;
  template class DomainContour<3>;
} // namespace Waker
