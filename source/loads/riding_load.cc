// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/loads/riding_load.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    /// Place of a point in the arrays, or n_points() if it has left. Nearly
    /// always where it was: only soil that leaves changes the places. Ids are
    /// ascending: points keep their order, and new ones come at the end.
    template <int dim>
    std::size_t
    find_point(const MaterialPoints<dim> &points,
               const std::size_t          guess,
               const std::uint64_t        id)
    {
      const std::size_t n = points.n_points();
      if (guess < n && points.id[guess] == id)
        return guess;
      const auto found =
        std::lower_bound(points.id.begin(), points.id.end(), id);
      return found == points.id.end() || *found != id
               ? n
               : found - points.id.begin();
    }


    template <int dim>
    double
    measure_of(const Facets<dim> &facets)
    {
      double sum = 0.;
      for (const Facet<dim> &facet : facets)
        sum += facet.measure();
      return sum;
    }


    Point<2>
    place_at_start(const Facet<2> &now,
                   const Facet<2> &start,
                   const Point<2> &x)
    {
      const Tensor<1, 2> along  = now.vertices[1] - now.vertices[0];
      const double       square = along.norm_square();
      const double       s =
        square > 0. ? ((x - now.vertices[0]) * along) / square : 0.5;
      return start.vertices[0] + s * (start.vertices[1] - start.vertices[0]);
    }


    Point<3>
    place_at_start(const Facet<3> &now,
                   const Facet<3> &start,
                   const Point<3> &x)
    {
      const Tensor<1, 3> a  = now.vertices[1] - now.vertices[0];
      const Tensor<1, 3> b  = now.vertices[2] - now.vertices[0];
      const Tensor<1, 3> c  = x - now.vertices[0];
      const double       aa = a * a, ab = a * b, bb = b * b;
      const double       det = aa * bb - ab * ab;
      double             s = 1. / 3., t = 1. / 3.;
      if (det > 0.)
        {
          s = (bb * (a * c) - ab * (b * c)) / det;
          t = (aa * (b * c) - ab * (a * c)) / det;
        }
      return start.vertices[0] + s * (start.vertices[1] - start.vertices[0]) +
             t * (start.vertices[2] - start.vertices[0]);
    }
  } // namespace


  template <int dim>
  void
  RidingLoad<dim>::ride_on_points(const Facets<dim>         &part,
                                  const MaterialPoints<dim> &points,
                                  PointShares<dim>          &shares)
  {
    on_points = true;
    measure   = measure_of(part);
    pieces.clear();
    for (const Facet<dim> &facet : part)
      shares.split(facet, [&](const Facet<dim> &piece, const std::uint32_t p) {
        pieces.push_back({piece, p, points.id[p], points.half_size[p]});
      });
  }


  template <int dim>
  void
  RidingLoad<dim>::ride_on_vertices(const Facets<dim> &part)
  {
    on_points    = false;
    has_vertices = true;
    measure      = measure_of(part);
    pieces.clear();
    for (const Facet<dim> &facet : part)
      pieces.push_back({facet, 0, 0, {}});
  }


  template <int dim>
  std::vector<Point<dim>>
  RidingLoad<dim>::start_vertices() const
  {
    std::vector<Point<dim>> vertices;
    if (has_vertices)
      for (const Piece &piece : pieces)
        vertices.insert(vertices.end(),
                        piece.start.vertices.begin(),
                        piece.start.vertices.end());
    return vertices;
  }


  template <int dim>
  void
  RidingLoad<dim>::place(const MaterialPoints<dim>     &points,
                         const std::vector<Point<dim>> &vertices,
                         Facets<dim>                   &facets,
                         std::vector<Placed>           &placed) const
  {
    AssertDimension(vertices.size(), has_vertices ? dim * pieces.size() : 0);
    facets.clear();
    placed.clear();
    for (std::size_t k = 0; k < pieces.size(); ++k)
      {
        const Piece &piece   = pieces[k];
        Facet<dim>   carried = piece.start;
        if (has_vertices)
          {
            std::array<Point<dim>, dim> x;
            for (unsigned int v = 0; v < dim; ++v)
              x[v] = vertices[dim * k + v];
            carried         = make_facet<dim>(x);
            carried.in_hole = piece.start.in_hole;
          }
        if (on_points)
          {
            const std::size_t p = find_point(points, piece.point, piece.id);
            if (p == points.n_points())
              continue;
            // It keeps its place on a domain that may stretch.
            Facet<dim> facet = piece.start;
            for (Point<dim> &x : facet.vertices)
              for (unsigned int d = 0; d < dim; ++d)
                {
                  const double l0 = piece.half_size[d];
                  const double stretch =
                    l0 > 0. ? points.half_size[p][d] / l0 : 1.;
                  x[d] = points.position[p][d] +
                         stretch * (x[d] - points.initial_position[p][d]);
                }
            const bool in_hole = facet.in_hole;
            facet              = make_facet<dim>(facet.vertices);
            facet.in_hole      = in_hole;
            facets.push_back(facet);
          }
        else
          facets.push_back(carried);
        placed.push_back({&piece, carried.measure() * carried.normal});
      }
  }


  template <int dim>
  Point<dim>
  start_place(const Facet<dim> &now,
              const Facet<dim> &start,
              const Point<dim> &x)
  {
    return place_at_start(now, start, x);
  }


  template struct RidingLoad<2>;
  template struct RidingLoad<3>;
  template Point<2>
  start_place<2>(const Facet<2> &, const Facet<2> &, const Point<2> &);
  template Point<3>
  start_place<3>(const Facet<3> &, const Facet<3> &, const Point<3> &);
} // namespace Waker
