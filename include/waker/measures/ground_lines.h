// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_measures_ground_lines_h
#define waker_measures_ground_lines_h

#include <deal.II/base/point.h>

#include <waker/measures/top_view.h>

#include <vector>

namespace Waker
{
  /// Lines on the ground that a picture of a slide needs. The numbers are those
  /// in files.
  enum class GroundLine
  {
    /// Where the ground comes to lie deeper than ground_step() below the
    /// highest soil at t = 0: how far the crest reaches.
    crest = 0,
    /// Where the ground drops by more than ground_step() between two
    /// neighbouring squares of the top view: steeper than 68 degrees.
    scarp = 1,
    /// Around soil that has moved, |u|, by more than ground_step().
    moved = 2
  };

  /// 1.25 cells (m). No whole number of halves: the steps of a slope made of
  /// points lie there, and round-off would decide.
  template <int dim>
  double
  ground_step(const BackgroundGrid<dim> &grid)
  {
    return 1.25 * grid.cell_size();
  }


  /// A polyline on the ground. Closed ones end where they begin.
  struct GroundPolyline
  {
    GroundLine            kind;
    std::vector<Point<3>> vertices; // m
  };

  /// The drops: along the sides of squares with soil, on the upper one.
  std::vector<GroundPolyline>
  scarp_lines(const TopView<3> &view, const double step);

  /**
   * Where a number of each square falls below a threshold, by linear
   * interpolation between their middles; lines lie on the higher of the two,
   * and end at the raster's border.
   *
   * @param values one a square; what is compared is value >= threshold, so
   *        squares without soil need one, too
   */
  std::vector<GroundPolyline>
  contour_lines(const TopView<3>          &view,
                const std::vector<double> &values,
                const double               threshold,
                const GroundLine           kind);

  /// Height to which soil reaches (m).
  template <int dim>
  double
  crest_height(const MaterialPoints<dim> &points);

  /// All lines of a moment.
  /// @param crest crest_height() at t = 0
  std::vector<GroundPolyline>
  ground_lines(const TopView<3>        &view,
               const MaterialPoints<3> &points,
               const double             crest,
               const double             step);
} // namespace Waker

#endif
