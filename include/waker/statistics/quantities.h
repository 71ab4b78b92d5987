// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_statistics_quantities_h
#define waker_statistics_quantities_h

#include <waker/store/record.h>

#include <string>
#include <vector>

namespace Waker
{
  /// What was measured of realisations, and how it is distributed.
  struct Quantity
  {
    std::string         name; // "ultimate load"
    std::string         unit;
    std::vector<double> values; // of those that have it, ascending

    double
    mean() const;

    /// Of the sample, with n - 1; NaN of less than two.
    double
    standard_deviation() const;

    /// @param p from 0 to 1; linear between the values. NaN without values.
    double
    quantile(const double p) const;
  };

  /**
   * The quantities of the realisations that count which any of them has: the
   * ultimate load (of those whose first load programme was stopped for good)
   * and the load at the end of the others, in the unit of the programme; of the
   * sliding masses their number, relative volume, retrogression, and the width
   * of the crest that has failed (3D).
   */
  std::vector<Quantity>
  quantities(const std::vector<Record> &records);
} // namespace Waker

#endif
