// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/nodes/wall_gaps.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Waker
{
  namespace
  {
    /// Call f(lower corner) for a cell and those next to it.
    template <int dim, typename Function>
    void
    for_cells_around(const BackgroundGrid<dim>                 &grid,
                     const typename BackgroundGrid<dim>::Index &cell,
                     const Function                            &f)
    {
      unsigned int n_cells = 1;
      for (unsigned int d = 0; d < dim; ++d)
        n_cells *= 3;
      for (unsigned int k = 0; k < n_cells; ++k)
        {
          auto         other  = cell;
          bool         inside = true;
          unsigned int rest   = k;
          for (unsigned int d = 0; d < dim; ++d, rest /= 3)
            {
              other[d] += static_cast<int>(rest % 3) - 1;
              const int n = grid.n_nodes_per_direction()[d];
              inside      = inside && other[d] >= 0 && other[d] < n;
            }
          if (inside)
            f(grid.node(other));
        }
    }


    /// Does the line x + s n meet a box?
    template <int dim>
    bool
    meets(const Tensor<1, dim> &x, // from the centre of the box
          const Tensor<1, dim> &n,
          const Tensor<1, dim> &half_size)
    {
      constexpr double round_off = 1e-9;
      double           low       = std::numeric_limits<double>::lowest(),
             high                = std::numeric_limits<double>::max();
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double half = half_size[d] * (1. + round_off);
          if (std::abs(n[d]) < round_off)
            {
              if (std::abs(x[d]) > half)
                return false;
              continue;
            }
          const double a = (-half - x[d]) / n[d], b = (half - x[d]) / n[d];
          low  = std::max(low, std::min(a, b));
          high = std::min(high, std::max(a, b));
        }
      return low <= high;
    }


    /// Area of a box as seen along n (m^(dim-1)).
    template <int dim>
    double
    area_along(const Tensor<1, dim> &n, const Tensor<1, dim> &half_size)
    {
      double area = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        {
          double face = std::abs(n[d]);
          for (unsigned int e = 0; e < dim; ++e)
            face *= e == d ? 1. : 2. * half_size[e];
          area += face;
        }
      return area;
    }


    template <int dim>
    double
    volume_of_box(const Tensor<1, dim> &half_size)
    {
      double volume = 1.;
      for (unsigned int d = 0; d < dim; ++d)
        volume *= 2. * half_size[d];
      return volume;
    }
  } // namespace


  template <int dim>
  WallGaps<dim>::WallGaps(const BackgroundGrid<dim> &grid)
    : grid(&grid)
  {}


  template <int dim>
  void
  WallGaps<dim>::set_places(std::vector<Point<dim>>     new_positions,
                            std::vector<Tensor<1, dim>> new_normals)
  {
    AssertDimension(new_positions.size(), new_normals.size());
    if (new_positions == positions)
      return;
    positions = std::move(new_positions);
    normals   = std::move(new_normals);
    first.assign(grid->n_nodes() + 1, 0);
    is_near.assign(grid->n_nodes(), 0);
    order.clear();
    std::vector<std::pair<unsigned int, unsigned int>> cells; // and places
    for (unsigned int q = 0; q < positions.size(); ++q)
      if (const auto cell = grid->nearest_cell(positions[q]);
          grid->contains(positions[q]) && grid->has_cell(cell))
        {
          cells.emplace_back(grid->node(cell), q);
          for_cells_around(*grid, cell, [&](const unsigned int other) {
            is_near[other] = 1;
          });
        }
    std::sort(cells.begin(), cells.end());
    for (const auto &[cell, q] : cells)
      {
        ++first[cell + 1];
        order.push_back(q);
      }
    for (unsigned int i = 0; i < grid->n_nodes(); ++i)
      first[i + 1] += first[i];
  }


  template <int dim>
  void
  WallGaps<dim>::find(const MaterialPoints<dim> &points,
                      std::vector<double>       &gaps) const
  {
    gaps.assign(positions.size(), std::numeric_limits<double>::infinity());
    const double furthest_behind = -behind * grid->cell_size();
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const Point<dim> &x    = points.position[p];
        const auto        cell = grid->nearest_cell(x);
        if (!grid->contains(x) || !grid->has_cell(cell))
          continue;
        if (!is_near[grid->node(cell)])
          continue;
        const Tensor<1, dim> &half = points.half_size[p];
        for_cells_around(*grid, cell, [&](const unsigned int other) {
          for (unsigned int k = first[other]; k < first[other + 1]; ++k)
            {
              const unsigned int    q        = order[k];
              const Tensor<1, dim> &n        = normals[q];
              const Tensor<1, dim>  r        = positions[q] - x;
              const double          distance = -(r * n);
              if (distance < furthest_behind || !meets(r, n, half))
                continue;
              const double area = area_along(n, half);
              const double gap  = distance - 0.5 * points.volume[p] / area;
              const double none = touching_share * volume_of_box(half) / area;
              gaps[q] = std::min(gaps[q], gap > none ? gap : std::min(gap, 0.));
            }
        });
      }
  }


  template class WallGaps<2>;
  template class WallGaps<3>;
} // namespace Waker
