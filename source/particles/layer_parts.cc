// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/particles/layer_parts.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace Waker
{
  template <int dim>
  double
  to_lattice(const BackgroundGrid<dim> &grid,
             const unsigned int         d,
             const unsigned int         points_per_direction,
             const double               x)
  {
    const double lower = grid.lower_corner()[d];
    const double scale = points_per_direction * grid.inverse_cell_size();
    const double n     = std::round((grid.upper_corner()[d] - lower) * scale);
    const double X     = std::clamp((x - lower) * scale, 0., n);
    const double line  = std::round(X);
    const double tolerance =
      1e-11 + 1e-15 * scale * std::max(std::abs(x), std::abs(lower));
    return std::abs(X - line) < tolerance ? line : X;
  }


  template <int dim>
  Polygon
  corners_in_lattice(const BackgroundGrid<dim> &grid,
                     const LayerBody           &body,
                     const unsigned int         points_per_direction)
  {
    Polygon corners = body.corners;
    for (auto &corner : corners)
      for (unsigned int d = 0; d < 2; ++d)
        corner[d] = to_lattice(grid, d, points_per_direction, corner[d]);
    return corners;
  }


  namespace
  {
    /// The body of a layer in units of the sub-cells.
    LayerBody
    in_lattice(const BackgroundGrid<3> &grid,
               const LayerBody         &body,
               const unsigned int       n)
    {
      const double scale  = n * grid.inverse_cell_size();
      const auto   scaled = [&](const std::shared_ptr<const HeightMap> &map) {
        std::shared_ptr<const HeightMap> result;
        const Point<3>                  &x = grid.lower_corner();
        if (map != nullptr)
          result = std::make_shared<const HeightMap>(
            map->scaled({{x[0], x[1], x[2]}}, scale));
        return result;
      };
      LayerBody result;
      result.corners = corners_in_lattice(grid, body, n);
      result.begin   = to_lattice(grid, 2, n, body.begin);
      result.end     = to_lattice(grid, 2, n, body.end);
      result.top     = scaled(body.top);
      result.bottom  = scaled(body.bottom);
      return result;
    }
  } // namespace


  template <int dim>
  std::vector<LatticePart<dim>>
  all_parts(const BackgroundGrid<dim> &grid,
            const LayerBody           &body,
            const unsigned int         n)
  {
    if constexpr (dim == 3)
      if (!body.is_prism())
        return cut_body(in_lattice(grid, body, n));
    const std::vector<SubCellPart> plane =
      cut_sub_cells(corners_in_lattice(grid, body, n));
    if constexpr (dim == 2)
      return plane;
    else
      {
        std::vector<LatticePart<dim>> parts;
        for (const IntervalPart &slice :
             cut_intervals(to_lattice(grid, 2, n, body.begin),
                           to_lattice(grid, 2, n, body.end),
                           /*minimum_share=*/0.))
          for (const SubCellPart &part : plane)
            parts.push_back(
              {{{part.index[0], part.index[1], slice.index}},
               part.share * slice.share,
               {{part.centroid[0], part.centroid[1], slice.centroid}}});
        return parts;
      }
  }


  template double
  to_lattice(const BackgroundGrid<2> &,
             const unsigned int,
             const unsigned int,
             const double);
  template double
  to_lattice(const BackgroundGrid<3> &,
             const unsigned int,
             const unsigned int,
             const double);
  template Polygon
  corners_in_lattice(const BackgroundGrid<2> &,
                     const LayerBody &,
                     const unsigned int);
  template Polygon
  corners_in_lattice(const BackgroundGrid<3> &,
                     const LayerBody &,
                     const unsigned int);
  template std::vector<LatticePart<2>>
  all_parts(const BackgroundGrid<2> &, const LayerBody &, const unsigned int);
  template std::vector<LatticePart<3>>
  all_parts(const BackgroundGrid<3> &, const LayerBody &, const unsigned int);
} // namespace Waker
