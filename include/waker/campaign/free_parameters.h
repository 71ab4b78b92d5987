// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_free_parameters_h
#define waker_campaign_free_parameters_h

#include <string>
#include <vector>

namespace Waker
{
  /// The sections that decide nothing of a campaign's records, whole: of what
  /// comes after them, and of what only other commands do.
  const std::vector<std::string> &
  sections_free_in_campaigns();

  /// Those of section "Campaign" that decide records.
  const std::vector<std::string> &
  campaign_parameters_not_free();

  /// In words, for messages: what a campaign may be resumed with other values
  /// of.
  std::string
  free_in_campaigns();
} // namespace Waker

#endif
