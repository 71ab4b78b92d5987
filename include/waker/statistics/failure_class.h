// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_statistics_failure_class_h
#define waker_statistics_failure_class_h

#include <waker/statistics/slides.h>

#include <string>

namespace Waker
{
  /// How a dyke failed (fig. 5.2 of Remmerswaal 2023); whether it flooded is
  /// in the record. The numbers are those of the store: new ones come last.
  enum class FailureClass
  {
    none,
    initial_only,
    retrogressive,
    horizontal,
    outer,
    settled,
    overflow
  };

  /// Number of classes.
  constexpr unsigned int n_failure_classes = 7;

  /// "none", "initial only", ...
  std::string
  to_string(const FailureClass failure_class);

  /// What the classes are told apart by.
  namespace FailureClassLimits
  {
    /// Share (-) of W that is left, at least, of a horizontal slide when H has
    /// lost half of what it loses. Retrogressive slides eat up the width first
    /// and take the height with the last of it; a body that moves as a whole
    /// keeps its width. This limit decides; the others only keep out slides
    /// that cannot be translations.
    constexpr double kept_width = 0.7;
    /// Fall / travel (-) of the moved soil in a horizontal slide, at most. A
    /// dyke that sinks as a block (fig. 5.2a) falls by a third of its travel or
    /// more; slides of the base case that run out have 0.16 to 0.19.
    constexpr double fall = 0.2;
    /// Moved soil in a horizontal slide, as share (-) of W_i H_i, at least:
    /// the block that carries the width, not only the slope beside it. Single
    /// slides of the base case have 0.95 to 0.97, floods 1.3 to 1.4.
    constexpr double moved_area = 1.;
  } // namespace FailureClassLimits

  /**
   * The class of a realisation; the first that fits:
   *
   * 1. overflow: flooded by water that rose over it before any initial failure;
   *    none: no initial failure.
   * 2. outer (fig. 5.2e): the outer slope has slid, by displacement, and the
   *    inner one has not; if both have, more soil has moved outwards than
   *    inwards (by area) one second after initial failure, or at the end if
   *    none has moved by 0.5 m yet; else it slid first. Records of version 0.1
   *    do not know the slides by displacement: there areas decide, and if no
   *    soil has moved at all, a width that has grown means outwards.
   * 3. settled: no slope has slid and no soil has moved by 0.5 m; only the
   *    detected width or height says that it failed.
   * 4. horizontal (fig. 5.2d, 5.5f): the body is translated inwards. By the
   *    end the moved soil has an area of W_i H_i at least (H from the base
   *    of the soil profile), has travelled much further than it fell, and the
   * last slide has left the width as it was while the height was lost
   *    (FailureClassLimits). It may have begun with a rotational slide.
   * 5. retrogressive (fig. 5.2c): two slides or more.
   * 6. initial only (fig. 5.2a, b): one slide. With flooding this is the deep
   *    slide that floods directly.
   *
   * A slide that only its displacement shows is an initial one, or an outer one
   * if no other slope has slid.
   *
   * A realisation that failed numerically is judged by what it did until then.
   *
   * @param slides find_slides() of the same record
   * @param base_level of the soil profile, m: H_i is measured from there
   */
  FailureClass
  classify(const Record             &record,
           const std::vector<Slide> &slides,
           const double              base_level);
} // namespace Waker

#endif
