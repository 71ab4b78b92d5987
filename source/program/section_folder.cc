// SPDX-License-Identifier: LGPL-2.1-or-later
#include "section_folder.h"

#include <waker/base/expression_pattern.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/output/parameters.h>

namespace Waker
{
  void
  name_folder_of_section(PrmContents &contents)
  {
    const std::string section = "Cross-section", folder = "Output/Directory";
    std::string       end;
    PrmEntry directory{"Output", "Directory", OutputParameters().directory, ""};
    PrmEntry *given = nullptr;
    for (PrmEntry &entry : contents.entries)
      {
        const bool is_here = entry.where == "--set " + entry.path();
        if (is_here && entry.path() == section)
          {
            // In the digits of a number: 4.50 is 4.5.
            if (const auto z = plain_number(entry.value))
              end = "-section-" + in_digits(*z);
          }
        else if (is_here && entry.path() == "Sweep/Parameter" &&
                 tidy(entry.value) == section)
          end = "-sections";
        else if (entry.path() == folder)
          given = &entry;
      }
    if (given != nullptr)
      directory = *given;
    if (end.empty() || directory.where == "--set " + folder)
      return;
    std::string &name = directory.value;
    while (name.size() > 1 && name.back() == '/')
      name.pop_back();
    if (name.empty())
      return;
    name += end;
    if (given != nullptr)
      *given = directory;
    else
      contents.entries.push_back(
        {directory.section, directory.name, name, "--set " + section});
  }
} // namespace Waker
