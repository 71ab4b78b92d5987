// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/sizes.h>
#include <waker/base/text.h>
#include <waker/nodes/wall_spots.h>
#include <waker/particles/polygon.h>
#include <waker/particles/sub_cells.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    /// Spots of a wall, at most.
    constexpr double largest_wall = 1e7;


    template <int dim>
    std::vector<Point<dim>>
    read_corners(const std::string &line, const std::string &path)
    {
      const std::string       allowed = dim == 2
                                          ? "corners \"x1, y1; x2, y2; ...\" in m"
                                          : "corners \"x1, y1, z1; ...\" in m";
      std::vector<Point<dim>> corners;
      for (const std::string &corner : split(line, ';'))
        {
          const std::vector<std::string> numbers = split(corner, ',');
          if (numbers.size() != dim)
            throw UserError(path,
                            in_quotes(corner) + " has " +
                              counted(numbers.size(), "number"),
                            allowed + decimals_with_a_point);
          Point<dim> x;
          for (unsigned int d = 0; d < dim; ++d)
            if (!read_number(numbers[d], x[d]))
              throw UserError(path,
                              in_quotes(numbers[d]) + " is no number",
                              allowed);
          corners.push_back(x);
        }
      if (corners.size() < dim)
        throw UserError(path,
                        "has " + std::to_string(corners.size()) + " corners",
                        std::to_string(dim) + " or more");
      return corners;
    }
  } // namespace


  template <>
  std::vector<WallSpot<2>>
  make_wall_spots(const std::string &line,
                  const double       size,
                  const std::string &path)
  {
    const std::vector<Point<2>> corners = read_corners<2>(line, path);
    std::vector<WallSpot<2>>    spots;
    for (std::size_t k = 0; k + 1 < corners.size(); ++k)
      {
        const Tensor<1, 2> edge   = corners[k + 1] - corners[k];
        const double       length = edge.norm();
        if (!(length > 1e-9 * size))
          throw UserError(path,
                          "corner " + std::to_string(k + 2) +
                            " repeats the one before it",
                          "corners that differ");
        const std::uint64_t n =
          checked_count(path,
                        std::ceil(length / size * (1. - 1e-12)),
                        "spots on a wall",
                        largest_wall,
                        "a wall inside the grid, or larger cells");
        for (std::uint64_t i = 0; i < n; ++i)
          spots.push_back({corners[k] + (i + 0.5) / n * edge,
                           Tensor<1, 2>({-edge[1] / length, edge[0] / length}),
                           length / n});
      }
    return spots;
  }


  template <>
  std::vector<WallSpot<3>>
  make_wall_spots(const std::string &line,
                  const double       size,
                  const std::string &path)
  {
    const std::vector<Point<3>> corners = read_corners<3>(line, path);
    // Twice the vector of its area (Newell).
    Tensor<1, 3> normal;
    for (std::size_t k = 0; k < corners.size(); ++k)
      normal +=
        cross_product_3d(corners[k] - corners[0],
                         corners[(k + 1) % corners.size()] - corners[0]);
    const Tensor<1, 3> edge = corners[1] - corners[0];
    if (!(normal.norm() > 1e-9 * size * size && edge.norm() > 1e-9 * size))
      throw UserError(path, "the polygon has no area", "a flat polygon");
    normal /= normal.norm();
    const Tensor<1, 3> e1 = edge / edge.norm();
    const Tensor<1, 3> e2 = cross_product_3d(normal, e1);

    // In its plane, in units of the lattice.
    std::string flat;
    for (const Point<3> &x : corners)
      {
        const Tensor<1, 3> y = x - corners[0];
        if (std::abs(y * normal) > 1e-6 * size)
          throw UserError(path,
                          "corner (" + in_digits(x[0]) + ", " +
                            in_digits(x[1]) + ", " + in_digits(x[2]) + ") is " +
                            in_digits(std::abs(y * normal)) +
                            " m off the plane of the others",
                          "a flat polygon");
        flat += (flat.empty() ? "" : "; ") + in_digits(y * e1 / size) + ", " +
                in_digits(y * e2 / size);
      }
    // Of the box around the polygon; it may be turned.
    double longest = 0.;
    for (const Point<3> &x : corners)
      longest = std::max(longest, (x - corners[0]).norm());
    checked_count(path,
                  4. * (longest / size + 1.) * (longest / size + 1.),
                  "spots on a wall",
                  largest_wall,
                  "a wall inside the grid, or larger cells");
    std::vector<WallSpot<3>> spots;
    for (const SubCellPart &part :
         merge_small_parts(cut_sub_cells(parse_polygon(flat, path)), 0.25))
      spots.push_back(
        {corners[0] + size * (part.centroid[0] * e1 + part.centroid[1] * e2),
         normal,
         part.share * size * size});
    return spots;
  }
} // namespace Waker
