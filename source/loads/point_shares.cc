// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/utilities.h>

#include <waker/loads/facet_clip.h>
#include <waker/loads/point_shares.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    /// Call f(cell number) for the cells at distance `ring` (largest of the
    /// directions) around `centre`, inside the grid.
    template <int dim, typename Function>
    void
    for_each_on_ring(const BackgroundGrid<dim>                 &grid,
                     const typename BackgroundGrid<dim>::Index &centre,
                     const int                                  ring,
                     const Function                            &f)
    {
      const int          width = 2 * ring + 1;
      const unsigned int n     = Utilities::pow(width, dim);
      for (unsigned int k = 0; k < n; ++k)
        {
          auto index   = centre;
          int  rest    = k;
          int  largest = 0;
          bool inside  = true;
          for (unsigned int d = 0; d < dim; ++d)
            {
              const int offset = rest % width - ring;
              rest /= width;
              index[d] += offset;
              largest = std::max(largest, std::abs(offset));
              inside =
                inside && index[d] >= 0 &&
                index[d] < static_cast<int>(grid.n_nodes_per_direction()[d]);
            }
          if (inside && largest == ring)
            f(grid.node(index));
        }
    }
  } // namespace


  template <int dim>
  PointShares<dim>::PointShares(const BackgroundGrid<dim> &grid)
    : grid(&grid)
  {}


  template <int dim>
  void
  PointShares<dim>::sort(const std::vector<Point<dim>> &positions)
  {
    // Cells are numbered by their lower left node.
    points = &positions;
    first.assign(grid->n_nodes() + 1, 0);
    cell.resize(points->size());
    order.resize(points->size());
    for (std::size_t p = 0; p < points->size(); ++p)
      {
        cell[p] = grid->node(grid->cell_index((*points)[p]));
        ++first[cell[p] + 1];
      }
    for (unsigned int c = 0; c < grid->n_nodes(); ++c)
      first[c + 1] += first[c];
    // Fill each cell from its end; then its start is what is left.
    for (std::size_t p = points->size(); p-- > 0;)
      order[--first[cell[p] + 1]] = p;
    for (unsigned int c = 0; c < grid->n_nodes(); ++c)
      first[c] = first[c + 1];
    first[grid->n_nodes()] = points->size();
  }


  template <int dim>
  std::uint32_t
  PointShares<dim>::nearest(const Point<dim> &x, const int n_rings) const
  {
    Assert(!order.empty() || n_rings < std::numeric_limits<int>::max(),
           ExcInternalError());
    auto index   = grid->cell_index(x);
    int  longest = 0;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const int n = grid->n_nodes_per_direction()[d];
        index[d]    = std::min(std::max(index[d], 0), n - 1);
        longest     = std::max(longest, n);
      }

    std::uint32_t best     = none;
    double        distance = -1.; // squared
    for (int ring = 0; ring < std::min(longest, n_rings); ++ring)
      {
        // What is outside this ring's inside is at least so far away.
        const double unseen = (ring - 1) * grid->cell_size();
        if (distance >= 0. && ring > 0 && distance < unseen * unseen)
          break;
        for_each_on_ring<dim>(*grid, index, ring, [&](const unsigned int c) {
          for (std::uint32_t k = first[c]; k < first[c + 1]; ++k)
            {
              const std::uint32_t p = order[k];
              const double        s = ((*points)[p] - x).norm_square();
              if (distance < 0. || s < distance || (s == distance && p < best))
                {
                  distance = s;
                  best     = p;
                }
            }
        });
      }
    return best;
  }


  template <int dim>
  void
  PointShares<dim>::visit_within(
    const Point<dim>                         &x,
    const double                              radius,
    const std::function<void(std::uint32_t)> &visit) const
  {
    using Index = typename BackgroundGrid<dim>::Index;
    Tensor<1, dim> corner;
    for (unsigned int d = 0; d < dim; ++d)
      corner[d] = radius;
    Index low  = grid->cell_index(x - corner);
    Index high = grid->cell_index(x + corner);
    for (unsigned int d = 0; d < dim; ++d)
      {
        const int last = grid->n_nodes_per_direction()[d] - 1;
        low[d]         = std::min(std::max(low[d], 0), last);
        high[d]        = std::min(std::max(high[d], 0), last);
      }
    Index cell = low;
    while (cell[dim - 1] <= high[dim - 1])
      {
        const unsigned int c = grid->node(cell);
        for (std::uint32_t k = first[c]; k < first[c + 1]; ++k)
          if ((*points)[order[k]].distance(x) <= radius)
            visit(order[k]);
        for (unsigned int d = 0; d < dim; ++d)
          {
            if (++cell[d] <= high[d] || d == dim - 1)
              break;
            cell[d] = low[d];
          }
      }
  }


  template <int dim>
  void
  PointShares<dim>::split(const Facet<dim> &facet, const Visitor &visit)
  {
    // The places that are closest to one point form a convex cell. A piece
    // whose vertices all lie in one cell lies in it; another is cut along the
    // bisector of two points.
    const double h         = grid->cell_size();
    const double tolerance = 1e-10 * h * h;
    pending.assign(1, facet);
    while (!pending.empty())
      {
        const Facet<dim> piece = pending.back();
        pending.pop_back();
        const std::uint32_t p   = nearest(piece.centroid());
        const Point<dim>   &x_p = (*points)[p];
        bool                cut = false;
        for (unsigned int k = 0; k < dim && !cut; ++k)
          {
            const Point<dim>   &v   = piece.vertices[k];
            const std::uint32_t q   = nearest(v);
            const Point<dim>   &x_q = (*points)[q];
            if (q == p ||
                (v - x_q).norm_square() >= (v - x_p).norm_square() - tolerance)
              continue;
            // 2 (x_q - x_p) . x = x_q^2 - x_p^2, closer to p below it.
            const Tensor<1, dim> n      = x_q - x_p;
            const double         c      = n * (Tensor<1, dim>(x_p) + 0.5 * n);
            const std::size_t    before = pending.size();
            cut_facet(piece, n, c, pending, pending);
            cut = pending.size() > before + 1;
            if (!cut)
              pending.resize(before);
          }
        if (!cut)
          visit(piece, p);
      }
  }


  template class PointShares<2>;
  template class PointShares<3>;
} // namespace Waker
