// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_height_map_h
#define waker_particles_height_map_h

#include <waker/base/stl.h>
#include <waker/particles/plan.h>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Waker
{
  /**
   * A height y over each place (x, z) of a rectangle: a surface of triangles
   * that a vertical line meets once. Lengths in m, or in units of a lattice
   * (scaled()).
   */
  class HeightMap
  {
  public:
    /**
     * @param triangles in either orientation; those that do not reach over the
     *        rectangle do not count
     * @param lower, upper corners x, z of the rectangle; vertices within
     *        `round_off` of its edges lie on them
     * @param name of the map, for the error
     * @param path of the parameter, for the error
     * @throws UserError unless the triangles cover the rectangle, once: holes,
     *         overhangs, upright triangles
     */
    HeightMap(const std::vector<StlTriangle> &triangles,
              const std::array<double, 2>    &lower,
              const std::array<double, 2>    &upper,
              const double                    round_off,
              const std::string              &name,
              const std::string              &path);

    /// The height at a place; none outside the rectangle.
    std::optional<double>
    at(const double x, const double z) const;

    /// Least and largest height over the rectangle.
    std::array<double, 2>
    range() const;

    /// The x (m) at which sides of triangles cross the line at z, in no order.
    std::vector<double>
    crossings(const double z) const;

    /// Call f(part, height) for the part of the polygon in each triangle.
    void
    for_each_part(
      const Plan                                             &polygon,
      const std::function<void(const Plan &, const Plane &)> &f) const;

    /// The same surface in other units: (x - origin) * scale.
    HeightMap
    scaled(const std::array<double, 3> &origin, const double scale) const;

  private:
    struct Triangle
    {
      std::array<std::array<double, 2>, 3> corners; // x, z, anticlockwise
      Plane                                height;
    };

    HeightMap() = default;

    void
    fill_bins();

    /// The bin of a coordinate in direction d (0: x, 1: z).
    int
    bin(const unsigned int d, const double x) const;

    std::vector<Triangle>                  triangles;
    std::array<double, 2>                  lower, upper;
    std::array<int, 2>                     n_bins;
    std::vector<std::vector<unsigned int>> bins; // numbers of triangles
  };


  /**
   * Read a height map. A file named *.stl: STL, text or binary. Any other: a
   * table with commas, whose first line names the columns x, z and y (m) in any
   * order; # begins a comment. Its places must be all those of a rectangular,
   * not necessarily uniform grid, each once; between them the height is that of
   * four triangles that meet in the middle of four places, at their mean
   * height.
   *
   * @param lower, upper corners x, z (m) of the rectangle that it must cover
   * @param round_off (m) see HeightMap
   * @param path of the parameter with the name
   * @throws UserError at `path`
   */
  std::shared_ptr<const HeightMap>
  read_height_map(const std::string           &file,
                  const std::array<double, 2> &lower,
                  const std::array<double, 2> &upper,
                  const double                 round_off,
                  const std::string           &path);
} // namespace Waker

#endif
