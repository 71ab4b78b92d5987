// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/campaign/free_parameters.h>

namespace Waker
{
  const std::vector<std::string> &
  sections_free_in_campaigns()
  {
    static const std::vector<std::string> sections = {"Output",
                                                      "Strength reduction",
                                                      "Snapshots",
                                                      "Slides",
                                                      "Histograms",
                                                      "Risk"};
    return sections;
  }


  const std::vector<std::string> &
  campaign_parameters_not_free()
  {
    static const std::vector<std::string> names = {"Seed", "Attempts"};
    return names;
  }


  std::string
  free_in_campaigns()
  {
    std::string text;
    for (const std::string &section : sections_free_in_campaigns())
      text += section + ", ";
    text += "and of Campaign all but ";
    const std::vector<std::string> &names = campaign_parameters_not_free();
    for (std::size_t i = 0; i < names.size(); ++i)
      text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    return text;
  }
} // namespace Waker
