// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_case_cross_section_h
#define waker_case_cross_section_h

#include <waker/case/parameters.h>

namespace Waker
{
  /**
   * If a cross-section is asked for: turn the parameters of a case in space,
   * which have been checked, into those of its section, a case in plane strain.
   * What lies along z is left away: the third direction, the faces across it
   * with their conditions and openings, and layers and boxes that the section
   * does not meet: that is what begins above its z or ends at it or below.
   * `in_space` keeps the case, for its random fields.
   *
   * @throws UserError "Cross-section": not in the box; beside the load of a
   * load programme; something that has no section: height maps, initial
   * stresses and velocities, walls, inflows, point loads, tractions
   */
  void
  take_cross_section(Parameters &parameters);
} // namespace Waker

#endif
