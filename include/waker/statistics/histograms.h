// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_statistics_histograms_h
#define waker_statistics_histograms_h

#include <waker/statistics/failure_class.h>
#include <waker/statistics/intervals.h>
#include <waker/statistics/slides.h>

#include <cstdint>
#include <vector>

namespace Waker
{
  /// Values in [low, high) by outcome, as all_outcomes().
  struct HistogramBin
  {
    double                     low;
    double                     high;
    std::vector<std::uint64_t> counts;
  };

  struct OutcomeValue
  {
    double  value;
    Outcome outcome;
  };

  constexpr double most_bins = 1e5;

  /**
   * Bins of equal width from 0 (from below, if a value is negative) to the
   * highest value, empty ones included. A value within 1e-9 widths below a
   * bin's end counts as on it. Values that are not finite, numerical failures
   * and what is undecided are left out; no bins if nothing remains.
   *
   * @throws UserError "Histograms" if there would be more than most_bins
   */
  std::vector<HistogramBin>
  histogram(const std::vector<OutcomeValue> &values, const double bin_width);

  /// H_r - h (m); 0 for a dyke that flooded, as in fig. 5.9 of Remmerswaal
  /// (2023).
  std::vector<OutcomeValue>
  residual_heights(const std::vector<Record> &records,
                   const double               water_level);

  /// W_r (m); 0 for a dyke that flooded.
  std::vector<OutcomeValue>
  residual_widths(const std::vector<Record> &records);

  /// W_S1 (m), the width after the first slide, of the realisations that
  /// failed; 0 if that flooded. `slides[i]` are those of `records[i]`.
  std::vector<OutcomeValue>
  widths_after_first_slide(const std::vector<Record>             &records,
                           const std::vector<std::vector<Slide>> &slides);

  /// P(F|S1, W_S1) for low <= W_S1 < high (fig. 5.10).
  struct ResistanceBin
  {
    double     low;
    double     high;
    Proportion flooding;
  };

  std::vector<ResistanceBin>
  residual_resistance(const std::vector<OutcomeValue> &widths_after_first_slide,
                      const double                     bin_width);

  /// Realisations of one class, with or without flooding, among all that
  /// count.
  struct ClassCount
  {
    FailureClass failure_class;
    bool         flooded;
    Proportion   share;
  };

  /// @param base_level as classify()
  /// @return one entry for every class and both values of flooded, but none for
  /// flooding without failure, nor for overflow without flooding.
  std::vector<ClassCount>
  count_classes(const std::vector<Record>             &records,
                const std::vector<std::vector<Slide>> &slides,
                const double                           base_level);
} // namespace Waker

#endif
