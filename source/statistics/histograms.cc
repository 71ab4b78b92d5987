// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/base/sizes.h>
#include <waker/statistics/estimates.h>
#include <waker/statistics/histograms.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Waker
{
  namespace
  {
    bool
    floods(const Record &record)
    {
      return record.flooding_time >= 0.;
    }
  } // namespace


  std::vector<HistogramBin>
  histogram(const std::vector<OutcomeValue> &values, const double bin_width)
  {
    Assert(bin_width > 0., dealii::ExcInternalError());
    // Not of input only: of what stands in journals, too.
    double lowest = 0., highest = 0.;
    for (const OutcomeValue &v : values)
      if (std::isfinite(v.value))
        {
          lowest  = std::min(lowest, v.value);
          highest = std::max(highest, v.value);
        }
    checked_count("Histograms",
                  (highest - lowest) / bin_width,
                  "bins",
                  most_bins,
                  "wider bins");
    const auto bin_of = [bin_width](const double value) {
      return static_cast<std::int64_t>(std::floor(value / bin_width + 1e-9));
    };
    const auto is_left_out = [](const OutcomeValue &v) {
      return !std::isfinite(v.value) || !is_decided(v.outcome);
    };

    std::int64_t first = 0, last = -1;
    for (const OutcomeValue &v : values)
      if (!is_left_out(v))
        {
          first = std::min(first, bin_of(v.value));
          last  = std::max(last, bin_of(v.value));
        }

    const std::vector<std::uint64_t> none(all_outcomes().size(), 0);
    std::vector<HistogramBin>        bins;
    for (std::int64_t i = first; i <= last; ++i)
      bins.push_back({i * bin_width, (i + 1) * bin_width, none});
    for (const OutcomeValue &v : values)
      if (!is_left_out(v))
        ++bins[bin_of(v.value) - first]
            .counts[static_cast<unsigned int>(v.outcome)];
    return bins;
  }


  std::vector<OutcomeValue>
  residual_heights(const std::vector<Record> &records, const double water_level)
  {
    std::vector<OutcomeValue> values;
    values.reserve(records.size());
    for (const Record &record : records)
      values.push_back(
        {floods(record) ? 0. : record.residual_height - water_level,
         record.outcome});
    return values;
  }


  std::vector<OutcomeValue>
  residual_widths(const std::vector<Record> &records)
  {
    std::vector<OutcomeValue> values;
    values.reserve(records.size());
    for (const Record &record : records)
      values.push_back(
        {floods(record) ? 0. : record.residual_width, record.outcome});
    return values;
  }


  std::vector<OutcomeValue>
  widths_after_first_slide(const std::vector<Record>             &records,
                           const std::vector<std::vector<Slide>> &slides)
  {
    AssertDimension(records.size(), slides.size());
    std::vector<OutcomeValue> values;
    for (std::size_t i = 0; i < records.size(); ++i)
      if (!slides[i].empty())
        values.push_back(
          {slides[i].front().floods ? 0. : slides[i].front().width,
           records[i].outcome});
    return values;
  }


  std::vector<ResistanceBin>
  residual_resistance(const std::vector<OutcomeValue> &widths,
                      const double                     bin_width)
  {
    std::vector<ResistanceBin> result;
    for (const HistogramBin &bin : histogram(widths, bin_width))
      {
        const std::uint64_t n_flooding =
          bin.counts[static_cast<unsigned int>(Outcome::flooding)];
        const std::uint64_t n = std::accumulate(bin.counts.begin(),
                                                bin.counts.end(),
                                                std::uint64_t(0));
        result.push_back({bin.low, bin.high, proportion(n_flooding, n)});
      }
    return result;
  }


  std::vector<ClassCount>
  count_classes(const std::vector<Record>             &records,
                const std::vector<std::vector<Slide>> &slides,
                const double                           base_level)
  {
    AssertDimension(records.size(), slides.size());
    std::uint64_t n                               = 0;
    std::uint64_t counts_of[n_failure_classes][2] = {};
    for (std::size_t i = 0; i < records.size(); ++i)
      if (counts(records[i]))
        {
          ++n;
          const FailureClass c = classify(records[i], slides[i], base_level);
          ++counts_of[static_cast<unsigned int>(c)][floods(records[i])];
        }

    std::vector<ClassCount> result;
    for (unsigned int c = 0; c < n_failure_classes; ++c)
      for (const bool flooded : {false, true})
        {
          const auto failure_class = static_cast<FailureClass>(c);
          // none of none floods, all overflow does
          if ((failure_class != FailureClass::none || !flooded) &&
              (failure_class != FailureClass::overflow || flooded))
            result.push_back(
              {failure_class, flooded, proportion(counts_of[c][flooded], n)});
        }
    return result;
  }
} // namespace Waker
