// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/reliability/input.h>

namespace Waker
{
  void
  ReliabilityParameters::check(const unsigned int dim) const
  {
    fields.check(dim);
    campaign.check();
    sweep.check();
    analysis.check();
    for (const unsigned int number : snapshots.realisations)
      if (number >= campaign.realisations)
        throw UserError("Snapshots/Realisations",
                        "contains " + std::to_string(number),
                        "numbers from 0 to Campaign/Realisations - 1, " +
                          std::to_string(campaign.realisations - 1));
  }
} // namespace Waker
