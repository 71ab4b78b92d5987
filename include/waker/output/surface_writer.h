// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_surface_writer_h
#define waker_output_surface_writer_h

#include <waker/surface/shape/facet.h>

#include <string>
#include <vector>

namespace Waker
{
  struct Liquid;

  /**
   * Write the surface of a body to a .vtu file, one cell per facet (a line in
   * 2D, a triangle in 3D), and the wetted facets as further ones on top of
   * them.
   *
   * Fields: chain (number; -1 on wetted facets, and where the surface is not
   * that of a section), on_face (see Facet; -1 on wetted facets), wetted (0 or
   * 1) and pressure (kPa, of the water; 0 on the surface itself).
   *
   * @param time of the state (s), stored in the file
   * @return checksum_of_text() of the file, for PvdSeries::add()
   */
  template <int dim>
  std::string
  write_surface(const Facets<dim> &surface,
                const Facets<dim> &wetted,
                const Liquid      &water,
                const double       time,
                const std::string &path);
} // namespace Waker

#endif
