// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_statistics_slides_h
#define waker_statistics_slides_h

#include <waker/store/record.h>

#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  /// Section "Slides".
  struct SlideParameters
  {
    double rate           = 0.1; // m/s: faster is a slide, slower a plateau
    double duration       = 0.5; // s that a plateau lasts at least
    double minimum_change = 0.3; // m of W or H

    void
    add_parameters(dealii::ParameterHandler &prm);
    /// @throws UserError "Slides/..."
    void
    check() const;
  };

  /// A change of W or H that ends in a plateau, or in flooding.
  struct Slide
  {
    double start;  // s
    double end;    // s
    double width;  // W after it, m
    double height; // H after it, m
    bool   floods; // the dyke was lower than the water at its end
  };

  /**
   * The slides of a realisation, from its trace (sections 4.4.2 and 5.2.3 of
   * Remmerswaal 2023), in order of time.
   *
   * A plateau is any time of `duration` in which W and H stay within
   * rate * duration: so that slow on average counts, and a jump of 2 cm in one
   * time step does not end it. What lies between plateaus is movement. A
   * movement is a slide if W or H then differs by minimum_change or more from
   * its value after the previous slide (at first: from the initial one);
   * smaller ones add up until they make a slide together.
   *
   * Three rules keep slides and events of a record consistent:
   * - no slide without initial failure, and at least one with it (a dyke that
   *   only creeps has one, from initial failure to the end);
   * - the last slide of a dyke that floods, and no other, floods. If the dyke
   *   creeps under the water from a plateau, that is a slide of its own;
   * - a movement under way at the end of the run is a slide if large enough.
   */
  std::vector<Slide>
  find_slides(const Record &record, const SlideParameters &parameters);
} // namespace Waker

#endif
