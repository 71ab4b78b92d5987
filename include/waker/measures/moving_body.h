// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_measures_moving_body_h
#define waker_measures_moving_body_h

#include <waker/base/numbers.h>
#include <waker/grid/background_grid.h>
#include <waker/particles/body.h>

#include <type_traits>


namespace Waker
{
  /// A connected body of soil that has moved away from the rest.
  struct MovingBody
  {
    /// Volume over its length along z (m^2): in 2D the volume per metre.
    double area = 0.;
    /// Of the area of the whole profile (-).
    double share = 0.;
    /// How much further than the rest of the soil it has moved, on average (m).
    double distance = 0.;
    /// x where it is cut off from what remains of the crest (m); NaN if it
    /// does not reach the crest. If nothing of the crest remains, its far end.
    double crest_cut = nan;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &area &share &distance &crest_cut;
    }
  };

  /**
   * The largest connected body that has moved along x in one direction: of the
   * exact two-means split (two_means()) of the displacements |u| since t = 0,
   * by volume, the upper cluster. Soil that has moved in the other direction
   * counts as at rest, so slides of two slopes do not hide each other; what has
   * moved further than five times `distance` counts as five times, so a few
   * points that fly off do not hide a slide. Connected are cells of the grid
   * that share a face and in which points of the cluster lay at t = 0.
   *
   * The crest is the soil that lay within a cell of the highest point.
   *
   * @param direction +1: towards positive x, -1: towards negative x
   * @param distance (m), least_share (-): a body that has moved less, or is
   *        smaller, need not be found
   * @return a body with area 0 if there is none
   */
  template <int dim>
  MovingBody
  largest_moving_body(const std::common_type_t<Body<dim>> &body,
                      const BackgroundGrid<dim>           &grid,
                      const int                            direction,
                      const double                         distance,
                      const double                         least_share);
} // namespace Waker

#endif
