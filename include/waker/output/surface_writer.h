// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_surface_writer_h
#define waker_output_surface_writer_h

#include <waker/surface/shape/facet.h>

#include <string>
#include <vector>

namespace Waker
{
  struct Liquid;
  struct LoadedSegment;
  struct Surface;

  /**
   * Write the detected surface to a .vtu file, one line cell per segment, and
   * the wetted segments as further lines on top of them.
   *
   * Fields: chain (number; -1 on wetted lines), on_face (see SurfaceChain; -1
   * on wetted lines), wetted (0 or 1) and pressure (kPa, of the water; 0 on
   * chains).
   *
   * @param time of the state (s), stored in the file
   * @return checksum_of_text() of the file, for PvdSeries::add()
   */
  std::string
  write_surface(const Surface                    &surface,
                const std::vector<LoadedSegment> &wetted_segments,
                const Liquid                     &water,
                const double                      time,
                const std::string                &path);

  /// The same for a surface of facets: lines or triangles, without the field
  /// chain.
  template <int dim>
  std::string
  write_surface(const Facets<dim> &surface,
                const Facets<dim> &wetted,
                const Liquid      &water,
                const double       time,
                const std::string &path);
} // namespace Waker

#endif
