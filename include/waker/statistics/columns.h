// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_statistics_columns_h
#define waker_statistics_columns_h

#include <waker/statistics/failure_class.h>
#include <waker/statistics/slides.h>
#include <waker/store/record.h>

#include <cstdint>
#include <string>
#include <vector>

namespace Waker
{
  /// A record with what is derived from it.
  struct AnalysedRecord
  {
    const Record      *record;
    std::vector<Slide> slides;
    FailureClass       failure_class;
  };

  /// A quantity of the store.
  template <typename Argument, typename Number>
  struct Column
  {
    std::string name;
    std::string units; // "1" if it has none
    std::string long_name;
    Number (*value)(const Argument &);
    /// Of a quantity with names for its values (0, 1, ...): these.
    std::string flag_meanings = "";
  };

  /// NaN: the event did not occur.
  extern const std::vector<Column<AnalysedRecord, double>> real_columns;

  /// Of sliding masses; NaN also if they were not watched.
  extern const std::vector<Column<AnalysedRecord, double>> sliding_columns;

  /// -1 if they were not watched.
  extern const std::vector<Column<AnalysedRecord, std::int32_t>>
    sliding_count_columns;

  extern const std::vector<Column<AnalysedRecord, std::int8_t>> flag_columns;

  extern const std::vector<Column<AnalysedRecord, std::int32_t>> count_columns;

  extern const std::vector<Column<AnalysedRecord, std::int64_t>> work_columns;

  extern const std::vector<Column<Slide, double>> slide_columns;

  extern const std::vector<Column<SlidingMass, double>> mass_columns;
} // namespace Waker

#endif
