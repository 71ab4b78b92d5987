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
  std::vector<std::size_t>
  RidingLoad<dim>::find_points(const NodeExchange        &ranks,
                               const MaterialPoints<dim> &points) const
  {
    std::vector<std::size_t> places(pieces.size());
    if (ranks.is_one_rank())
      {
        for (std::size_t k = 0; k < pieces.size(); ++k)
          places[k] = find_point(points, pieces[k].point, pieces[k].id);
        return places;
      }
    // Of several ranks each has its points in some order.
    std::vector<std::uint64_t> ids(pieces.size());
    for (std::size_t k = 0; k < pieces.size(); ++k)
      ids[k] = pieces[k].id;
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    std::vector<std::size_t> place_of_id(ids.size(), points.n_points());
    const auto               number = [&](const std::uint64_t id) {
      return std::lower_bound(ids.begin(), ids.end(), id) - ids.begin();
    };
    for (std::size_t p = 0; p < points.n_points() && !ids.empty(); ++p)
      if (const std::uint64_t id = points.id[p];
          id >= ids.front() && id <= ids.back())
        if (const std::size_t i = number(id); ids[i] == id)
          place_of_id[i] = p;
    for (std::size_t k = 0; k < pieces.size(); ++k)
      places[k] = place_of_id[number(pieces[k].id)];
    return places;
  }


  template <int dim>
  std::vector<typename RidingLoad<dim>::Vertices>
  RidingLoad<dim>::ride_with_points(const NodeExchange        &ranks,
                                    const MaterialPoints<dim> &points) const
  {
    std::vector<Vertices>          placed;
    const std::vector<std::size_t> places = find_points(ranks, points);
    for (std::size_t k = 0; k < pieces.size(); ++k)
      {
        const std::size_t p = places[k];
        if (p == points.n_points())
          continue;
        // It keeps its place on a domain that may stretch.
        const Piece &piece = pieces[k];
        placed.push_back({k, {}});
        for (unsigned int v = 0; v < dim; ++v)
          for (unsigned int d = 0; d < dim; ++d)
            {
              const double l0      = piece.half_size[d];
              const double stretch = l0 > 0. ? points.half_size[p][d] / l0 : 1.;
              placed.back().x[v][d] = points.position[p][d] +
                                      stretch * (piece.start.vertices[v][d] -
                                                 points.initial_position[p][d]);
            }
      }
    if (ranks.is_one_rank())
      return placed;
    placed = ranks.all_gather(placed);
    std::sort(placed.begin(), placed.end(), [](const auto &a, const auto &b) {
      return a.piece < b.piece;
    });
    return placed;
  }


  template <int dim>
  void
  RidingLoad<dim>::place(const NodeExchange            &ranks,
                         const MaterialPoints<dim>     &points,
                         const std::vector<Point<dim>> &vertices,
                         Facets<dim>                   &facets,
                         std::vector<Placed>           &placed) const
  {
    AssertDimension(vertices.size(), has_vertices ? dim * pieces.size() : 0);
    facets.clear();
    placed.clear();
    const auto carried = [&](const std::size_t k) {
      if (!has_vertices)
        return pieces[k].start;
      std::array<Point<dim>, dim> x;
      for (unsigned int v = 0; v < dim; ++v)
        x[v] = vertices[dim * k + v];
      Facet<dim> facet = make_facet<dim>(x);
      facet.in_hole    = pieces[k].start.in_hole;
      return facet;
    };
    const auto add = [&](const std::size_t k, const Facet<dim> &facet) {
      facets.push_back(facet);
      const Facet<dim> there = carried(k);
      placed.push_back({&pieces[k], there.measure() * there.normal});
    };
    if (!on_points)
      {
        for (std::size_t k = 0; k < pieces.size(); ++k)
          add(k, carried(k));
        return;
      }
    for (const Vertices &now : ride_with_points(ranks, points))
      {
        std::array<Point<dim>, dim> x;
        for (unsigned int v = 0; v < dim; ++v)
          for (unsigned int d = 0; d < dim; ++d)
            x[v][d] = now.x[v][d];
        Facet<dim> facet = make_facet<dim>(x);
        facet.in_hole    = pieces[now.piece].start.in_hole;
        add(now.piece, facet);
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
