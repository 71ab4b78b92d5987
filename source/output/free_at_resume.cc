// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/output/free_at_resume.h>

#include <algorithm>

namespace Waker
{
  const std::vector<std::string> &
  sections_free_in_campaigns()
  {
    static const std::vector<std::string> sections = {"Output",
                                                      "Strength reduction",
                                                      "Ranks",
                                                      "Snapshots",
                                                      "Slides",
                                                      "Histograms",
                                                      "Risk"};
    return sections;
  }


  const std::vector<std::string> &
  sections_free_at_resume()
  {
    static const std::vector<std::string> sections = []() {
      std::vector<std::string> list = sections_free_in_campaigns();
      list.insert(list.end(), {"Stop rules", "Campaign", "Sweep"});
      return list;
    }();
    return sections;
  }


  bool
  is_free_at_resume(const std::string &section, const std::string &name)
  {
    const auto &free = sections_free_at_resume();
    return std::find(free.begin(), free.end(), section) != free.end() ||
           (section == "Time stepping" && name == "End time");
  }
} // namespace Waker
