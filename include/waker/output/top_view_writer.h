// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_top_view_writer_h
#define waker_output_top_view_writer_h

#include <waker/base/own_rows.h>
#include <waker/measures/ground_lines.h>
#include <waker/measures/top_view.h>

#include <string>
#include <vector>

namespace Waker
{
  /**
   * Write the ground as seen from above to a .vtu file: a level square for each
   * one of the view with soil, at its height; in 2D a level line.
   *
   * Fields: height (m), and those of the point that is seen there, as
   * write_particles() lists them.
   *
   * Ranks that share the points write the one file together, each the squares
   * in which its own points are seen. Collective.
   *
   * @param view of all points, the same on all ranks
   * @param points of this rank
   * @param rows which of all points these are
   * @param time of the state (s), stored in the file
   * @return checksum_of_text() of the file, for PvdSeries::add()
   */
  template <int dim>
  std::string
  write_top_view(const TopView<dim>        &view,
                 const MaterialPoints<dim> &points,
                 const OwnRows             &rows,
                 const double               time,
                 const std::string         &path);

  /**
   * Write lines on the ground to a .vtu file, as polylines. Field: kind (0:
   * crest, 1: scarp, 2: moved; see GroundLine).
   *
   * @param time, return value: as above
   */
  std::string
  write_ground_lines(const std::vector<GroundPolyline> &lines,
                     const double                       time,
                     const std::string                 &path);
} // namespace Waker

#endif
