// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/program/suggestions.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace Waker
{
  namespace
  {
    /// Levenshtein's distance, capitals ignored.
    std::size_t
    edit_distance(const std::string &a, const std::string &b)
    {
      std::vector<std::size_t> row(b.size() + 1);
      std::iota(row.begin(), row.end(), 0);
      for (std::size_t i = 0; i < a.size(); ++i)
        {
          std::size_t diagonal = row[0];
          row[0]               = i + 1;
          for (std::size_t j = 0; j < b.size(); ++j)
            {
              const bool same =
                std::tolower(static_cast<unsigned char>(a[i])) ==
                std::tolower(static_cast<unsigned char>(b[j]));
              const std::size_t replaced = diagonal + (same ? 0 : 1);
              diagonal                   = row[j + 1];
              row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
            }
        }
      return row.back();
    }


    std::string
    joined(const std::vector<std::string> &names)
    {
      std::string result;
      for (const std::string &name : names)
        result += (result.empty() ? "" : ", ") + name;
      return result;
    }


    /// Names of the entries and of the sections directly below `section`.
    void
    children(const std::string        &section,
             const DeclaredIndex      &declared,
             std::vector<std::string> &entries,
             std::vector<std::string> &subsections)
    {
      const std::string prefix = section.empty() ? "" : section + "/";
      for (const DeclaredParameter &parameter : declared.all())
        if (parameter.section == section)
          entries.push_back(parameter.name);
        else if (parameter.section.rfind(prefix, 0) == 0)
          {
            const std::string rest = parameter.section.substr(prefix.size());
            const std::string name = rest.substr(0, rest.find('/'));
            if (std::find(subsections.begin(), subsections.end(), name) ==
                subsections.end())
              subsections.push_back(name);
          }
    }


    std::string
    parent(const std::string &path)
    {
      const std::size_t slash = path.rfind('/');
      return slash == std::string::npos ? "" : path.substr(0, slash);
    }


    std::string
    in_section(const std::string &section)
    {
      return section.empty() ? "at the top level" : "in " + in_quotes(section);
    }
  } // namespace


  std::string
  nearest_name(const std::string              &name,
               const std::vector<std::string> &candidates)
  {
    std::string best;
    if (name.size() > 100) // none of ours
      return best;
    std::size_t least = std::max<std::size_t>(2, name.size() / 3) + 1;
    for (const std::string &candidate : candidates)
      {
        const std::size_t distance = edit_distance(name, candidate);
        if (distance < least)
          {
            least = distance;
            best  = candidate;
          }
      }
    return best;
  }


  std::string
  did_you_mean(const std::string &name)
  {
    return name.empty() ? "" : "did you mean " + in_quotes(name) + "? ";
  }


  void
  check_section(const PrmSection &section, const DeclaredIndex &declared)
  {
    if (declared.has_section(section.path))
      return;

    const std::string above = parent(section.path);
    const std::string name =
      section.path.substr(above.empty() ? 0 : above.size() + 1);
    std::vector<std::string> entries, subsections;
    children(above, declared, entries, subsections);
    std::string allowed = did_you_mean(nearest_name(name, subsections));
    const auto  named   = std::find_if(named_sections.begin(),
                                    named_sections.end(),
                                    [&](const NamedSection &candidate) {
                                      return candidate.section == above;
                                    });
    if (named != named_sections.end())
      allowed += "names that " + in_quotes(above + "/" + named->list) +
                 " lists: " +
                 (subsections.empty() ? "none so far" : joined(subsections));
    else
      allowed += subsections.empty() ? in_quotes(above) + " has no subsections"
                                     : joined(subsections);
    throw UserError(section.where,
                    "unknown section " + in_quotes(name) + " " +
                      in_section(above),
                    allowed);
  }


  const DeclaredParameter &
  find_declared(const PrmEntry &entry, const DeclaredIndex &declared)
  {
    const DeclaredParameter *const found = declared.find(entry.path());
    if (found != nullptr && found->name == entry.name)
      return *found;

    // On the command line the section may be wrong as well.
    std::string section;
    for (const std::string &name : split(entry.section, '/'))
      {
        section = parameter_path(section, name);
        check_section({section, entry.where}, declared);
      }

    std::vector<std::string> entries, subsections;
    children(entry.section, declared, entries, subsections);
    std::string best = nearest_name(entry.name, entries);
    for (const DeclaredParameter &parameter : declared.all())
      if (best.empty() && parameter.name == entry.name)
        best = parameter.path();
    // "Water.Level" stands for a path; names that are no more like it do not.
    if (best.empty() && entry.section.empty())
      {
        std::vector<std::string> paths;
        for (const DeclaredParameter &parameter : declared.all())
          if (parameter.path().size() + 2 >= entry.name.size() &&
              entry.name.size() + 2 >= parameter.path().size())
            paths.push_back(parameter.path());
        best = nearest_name(entry.name, paths);
      }
    throw UserError(entry.where,
                    "unknown name " + in_quotes(entry.name) + " " +
                      in_section(entry.section),
                    did_you_mean(best) + joined(entries));
  }
} // namespace Waker
