// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/text.h>
#include <waker/output/parameter_differences.h>

#include <map>
#include <sstream>

namespace Waker
{
  namespace
  {
    const std::string contents_of = "contents of ";


    /// Values by path; "# contents: path = hash" is "contents of path".
    std::map<std::string, std::string>
    values_of(const std::string &text)
    {
      const std::string begin = "subsection ", set = "set ",
                        contents = "# contents: ";
      std::map<std::string, std::string> values;
      std::string                        section;
      std::istringstream                 lines(text);
      for (std::string raw; std::getline(lines, raw);)
        {
          const std::string line   = tidy(raw);
          const std::size_t equals = line.find('=');
          if (line.compare(0, begin.size(), begin) == 0)
            section += line.substr(begin.size()) + "/";
          else if (line == "end" && !section.empty())
            {
              const std::size_t slash =
                section.size() < 2 ? std::string::npos
                                   : section.rfind('/', section.size() - 2);
              section.resize(slash == std::string::npos ? 0 : slash + 1);
            }
          else if (equals == std::string::npos)
            continue;
          else if (line.compare(0, set.size(), set) == 0)
            values[section +
                   tidy(line.substr(set.size(), equals - set.size()))] =
              tidy(line.substr(equals + 1));
          else if (line.compare(0, contents.size(), contents) == 0)
            values[contents_of + tidy(line.substr(contents.size(),
                                                  equals - contents.size()))] =
              tidy(line.substr(equals + 1));
        }
      return values;
    }


    std::string
    shown(const std::map<std::string, std::string> &values,
          const std::string                        &path)
    {
      const auto found = values.find(path);
      if (found == values.end())
        return "none";
      const std::size_t longest = 40;
      if (found->second.empty())
        return "empty";
      return found->second.size() <= longest
               ? found->second
               : found->second.substr(0, longest) + "...";
    }
  } // namespace


  std::string
  parameter_differences(const std::string                              &there,
                        const std::string                              &here,
                        const std::function<bool(const std::string &,
                                                 const std::string &)> &is_free)
  {
    const auto old_values = values_of(there), new_values = values_of(here);
    auto       all = old_values;
    all.insert(new_values.begin(), new_values.end());

    constexpr unsigned int n_shown = 3;
    unsigned int           n       = 0;
    std::string            text;
    for (const auto &entry : all)
      {
        const std::string &path     = entry.first;
        const auto         is_equal = [&]() {
          const auto a = old_values.find(path), b = new_values.find(path);
          return a != old_values.end() && b != new_values.end() &&
                 a->second == b->second;
        };
        // "contents of" a file counts as its parameter.
        const std::string name  = path.rfind(contents_of, 0) == 0
                                    ? path.substr(contents_of.size())
                                    : path;
        const std::size_t slash = name.rfind('/');
        const bool        free =
          slash == std::string::npos
                   ? is_free("", name)
                   : is_free(name.substr(0, slash), name.substr(slash + 1));
        if (free || is_equal())
          continue;
        if (++n > n_shown)
          continue;
        text += (text.empty() ? "" : ", ") + path + " (" +
                shown(old_values, path) + " there, " + shown(new_values, path) +
                " here)";
      }
    if (n > n_shown)
      text += ", and " + std::to_string(n - n_shown) + " more";
    return text;
  }
} // namespace Waker
