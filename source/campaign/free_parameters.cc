// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/campaign/free_parameters.h>

#include <algorithm>

namespace Waker
{
  const std::vector<std::string> &
  campaign_parameters_not_free()
  {
    static const std::vector<std::string> names = {"Seed", "Attempts"};
    return names;
  }


  bool
  is_free_in_campaigns(const std::string &section, const std::string &name)
  {
    const auto has = [](const std::vector<std::string> &list,
                        const std::string              &text) {
      return std::find(list.begin(), list.end(), text) != list.end();
    };
    return has(sections_free_in_campaigns(), section) ||
           (section == "Campaign" &&
            !has(campaign_parameters_not_free(), name));
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
