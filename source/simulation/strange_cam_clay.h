// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_simulation_strange_cam_clay_h
#define waker_source_simulation_strange_cam_clay_h

#include <waker/case/case.h>

#include <string>
#include <vector>

namespace Waker
{
  /// What the parameters of modified Cam clay come to.
  void
  warn_of_cam_clay(const MaterialParameters &material,
                   const unsigned int        dim,
                   std::vector<std::string> &warnings);

  /// Points on the dry side, which soften, and points whose stress at the start
  /// has raised their preconsolidation pressure.
  template <int dim>
  void
  warn_of_consolidation(const Case<dim>          &the_case,
                        std::vector<std::string> &warnings);
} // namespace Waker

#endif
