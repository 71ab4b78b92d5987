// SPDX-License-Identifier: LGPL-2.1-or-later
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
  }
} // namespace Waker
