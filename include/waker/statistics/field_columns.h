// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_statistics_field_columns_h
#define waker_statistics_field_columns_h

#include <waker/store/record.h>

#include <functional>
#include <string>
#include <vector>

namespace Waker
{
  /// A quantity of the store that belongs to a random field.
  struct FieldColumn
  {
    std::string                           name; // "field_peat_S_mean"
    std::string                           units;
    std::string                           long_name;
    std::function<double(const Record &)> value; // NaN: not known
  };

  /// Of all random fields that the records name: average_score, mean, least.
  /// What is no letter and no digit in a name becomes "_".
  std::vector<FieldColumn>
  field_columns(const std::vector<const std::vector<Record> *> &records);
} // namespace Waker

#endif
