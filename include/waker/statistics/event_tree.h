// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_statistics_event_tree_h
#define waker_statistics_event_tree_h

#include <waker/statistics/intervals.h>
#include <waker/statistics/slides.h>

#include <cstdint>
#include <vector>

namespace Waker
{
  /// The slides of one realisation, as an event tree sees them: at most the
  /// last one floods.
  struct SlideSequence
  {
    unsigned int n_slides;
    bool         floods;
  };

  /// Of the realisations that count (no numerical failures). One that failed
  /// or flooded without a slide gets one: overflow is a branch of its own of
  /// one slide, so that the tree's P(F) is the count of all floods.
  std::vector<SlideSequence>
  slide_sequences(const std::vector<Record>             &records,
                  const std::vector<std::vector<Slide>> &slides);

  /// Slide S_j of the tree. F_j: flooding directly after it; notF_j: it came,
  /// and the dyke stands; notF_0: the intact dyke.
  struct EventTreeLevel
  {
    std::uint64_t n_reached;  // realisations in notF_{j-1}
    std::uint64_t n_slides;   // of these with S_j
    std::uint64_t n_flooding; // of these with F_j

    double   slide;      // P(S_j | notF_{j-1}); 0 if n_reached = 0
    double   flooding;   // P(F_j | S_j); 0 if n_slides = 0
    double   path;       // P(F_j | notF_0), (4.21)
    double   cumulative; // sum of path up to j, (4.23)
    double   standing;   // P(notF_j | notF_0), product of (4.20)
    Interval interval;   // of the cumulative count, Clopper-Pearson
  };

  /**
   * Flooding by a sequence of separate mechanisms (section 4.4.2 of
   * Remmerswaal 2023), its branches estimated by counting.
   *
   * Fed with whole sequences the tree's sum telescopes to the direct count,
   * floods / realisations, whatever they are: that the next slide depends on
   * the number of slides alone (Markov) costs nothing as long as all
   * realisations start from the same intact dyke. The critical path does cost
   * something.
   */
  struct EventTree
  {
    std::vector<EventTreeLevel> levels; // j = 1, 2, ...

    double     probability; // P(F | notF_0), (4.23)
    Proportion direct;      // floods counted

    /// (4.24): P(F_l|S_l) := 1, so at least `probability`.
    unsigned int length; // l
    double       truncated;
    Proportion   truncated_direct; // the same, counted

    /**
     * (4.25), the shortcut of van der Krogt et al. (2019): no flooding before
     * the critical slide, always flooding at it. Critical is the first slide
     * after which more than half of the dykes flood (the most likely damaged
     * dyke is then lower than the water); the path's probability is the
     * product of P(S_k|notF_{k-1}) up to it, what a stability analysis of
     * each damaged dyke would give. 0 and NaN if there is no such slide.
     */
    unsigned int critical_slide;
    double       critical_path;
  };

  /// @param length l of (4.24), at least 1
  EventTree
  build_event_tree(const std::vector<SlideSequence> &sequences,
                   const unsigned int                length);
} // namespace Waker

#endif
