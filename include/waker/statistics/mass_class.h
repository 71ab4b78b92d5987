// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_statistics_mass_class_h
#define waker_statistics_mass_class_h

#include <waker/measures/sliding_masses.h>

#include <vector>

namespace Waker
{
  /// Where a sliding mass came from, seen from the first one (section 7.4 of
  /// Remmerswaal 2023). The thesis's three groups are `side`, `behind_centred`
  /// and `behind_off_centre`.
  enum class MassClass
  {
    initial,
    remnant,          // of soil beside which the first mass sheared off
    side,             // beside the first one, along the slope
    behind_centred,   // behind it, at the same place along the slope
    behind_off_centre // behind it, at another place
  };

  constexpr const char *
  name_of(const MassClass mass_class)
  {
    switch (mass_class)
      {
        case MassClass::initial:
          return "initial";
        case MassClass::remnant:
          return "remnant";
        case MassClass::side:
          return "side";
        case MassClass::behind_centred:
          return "behind, centred";
        case MassClass::behind_off_centre:
          return "behind, off centre";
      }
    return nullptr;
  }

  /// What the classes are told apart by.
  namespace MassClassLimits
  {
    /// Volume of a mass, as share (-) of that of the first, at least: less is a
    /// skin that the first mass has dragged along, not a slide of its own.
    constexpr double volume = 0.05;
    /// Offset of its centre from that of the first mass, in half lengths of the
    /// first one: less is the same place.
    constexpr double offset = 0.5;
  } // namespace MassClassLimits

  /**
   * The class of each mass of a run, the first that fits. Offsets of its centre
   * from that of the first mass, as they lay at t = 0, are in half lengths of
   * the first mass's box: back (away from the slope) in its length along x,
   * sideways in that along z.
   *
   * 1. initial: the first mass.
   * 2. remnant: both offsets, or its volume, are below MassClassLimits.
   * 3. side: its offset sideways is not less than that back.
   * 4. behind_centred: its offset sideways is below the limit; else
   *    behind_off_centre. In 2D all masses are centred.
   */
  std::vector<MassClass>
  classify_masses(const SlidingMasses &sliding);
} // namespace Waker

#endif
