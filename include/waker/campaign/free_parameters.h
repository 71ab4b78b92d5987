// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_free_parameters_h
#define waker_campaign_free_parameters_h

#include <waker/output/free_at_resume.h>

#include <string>
#include <vector>

namespace Waker
{
  /// Those of section "Campaign" that decide records.
  const std::vector<std::string> &
  campaign_parameters_not_free();

  /// May a campaign be resumed with another value of this parameter?
  bool
  is_free_in_campaigns(const std::string &section, const std::string &name);

  /// In words, for messages: what a campaign may be resumed with other values
  /// of.
  std::string
  free_in_campaigns();
} // namespace Waker

#endif
