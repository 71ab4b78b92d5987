// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/program/parameter_names.h>

#include <algorithm>
#include <map>
#include <set>

namespace Waker
{
  namespace
  {
    constexpr std::size_t longest_name = 100;  // bytes
    constexpr std::size_t most_names   = 1000; // of a list


    /// Is `path` the section `section`/`name` with a name of `names`, or below?
    bool
    is_of_names(const std::string           &path,
                const std::string           &section,
                const std::set<std::string> &names)
    {
      if (path.compare(0, section.size() + 1, section + "/") != 0)
        return false;
      const std::string rest = path.substr(section.size() + 1);
      return names.count(rest.substr(0, rest.find('/'))) != 0;
    }


    /// The command line leaves names out of a list of the file's: their
    /// subsections are not wanted, either.
    void
    drop_unlisted(PrmContents &contents, const PrmEntry &list)
    {
      for (const NamedSection &named : named_sections)
        for (const PrmEntry &entry : contents.entries)
          if (named.section == list.section && named.list == list.name &&
              entry.path() == list.path())
            {
              const auto            names = split(entry.value, ',');
              std::set<std::string> dropped(names.begin(), names.end());
              for (const std::string &name : split(list.value, ','))
                dropped.erase(name);
              const auto unwanted = [&](const std::string &section) {
                return is_of_names(section, named.section, dropped);
              };
              auto &entries  = contents.entries;
              auto &sections = contents.sections;
              entries.erase(std::remove_if(entries.begin(),
                                           entries.end(),
                                           [&](const PrmEntry &other) {
                                             return unwanted(other.section);
                                           }),
                            entries.end());
              sections.erase(std::remove_if(sections.begin(),
                                            sections.end(),
                                            [&](const PrmSection &other) {
                                              return unwanted(other.path);
                                            }),
                             sections.end());
              return;
            }
    }


    /// All sections that the file or the command line says anything about.
    std::set<std::string>
    mentioned_sections(const PrmContents &contents)
    {
      std::set<std::string> result;
      for (const PrmSection &section : contents.sections)
        result.insert(section.path);
      for (const PrmEntry &entry : contents.entries)
        result.insert(entry.section);
      return result;
    }


    /// What is wrong with a name in `named`, or nothing. It must survive all
    /// files: .prm, CSV, the columns of `statistics`, the arrays of VTU.
    std::string
    problem_of_name(const std::string &name, const NamedSection &named)
    {
      const bool is_entry =
        name == named.list ||
        (named.section == "Random fields" && name == "Correlations") ||
        (named.section == "Outflow" && name == "Faces");
      if (name.empty() || is_entry || name.find('/') != std::string::npos)
        return " is no name";
      if (name.size() > longest_name)
        return " has " + std::to_string(name.size()) + " bytes";
      const std::size_t odd = name.find_first_of(";#=\\\"");
      if (odd != std::string::npos)
        return " contains " + in_quotes(name.substr(odd, 1));
      return "";
    }


    /// The list of names of a section.
    std::vector<std::string>
    read_list(const PrmContents           &contents,
              const std::set<std::string> &mentioned,
              const NamedSection          &named)
    {
      for (const PrmEntry &entry : contents.entries)
        if (entry.section == named.section && entry.name == named.list)
          {
            const std::vector<std::string> names = split(entry.value, ',');
            const auto refuse = [&entry](const std::string &what,
                                         const std::string &allowed) {
              throw UserError(entry.where, entry.path() + ": " + what, allowed);
            };
            if (names.size() > most_names)
              refuse("has " + std::to_string(names.size()) + " names",
                     "at most " + std::to_string(most_names));
            // In ParaView's arrays blanks are underscores.
            std::map<std::string, std::string> seen;
            for (const std::string &name : names)
              {
                const std::string problem = problem_of_name(name, named);
                if (!problem.empty())
                  refuse(in_quotes(name) + problem,
                         "names without / ; # = \\ and quotation marks, of at "
                         "most " +
                           std::to_string(longest_name) +
                           " bytes, separated by commas");
                std::string array = name;
                std::replace(array.begin(), array.end(), ' ', '_');
                const auto [other, is_new] = seen.emplace(array, name);
                if (!is_new && other->second == name)
                  refuse(in_quotes(name) + " is listed twice",
                         "each name once");
                if (!is_new)
                  refuse(in_quotes(other->second) + " and " + in_quotes(name) +
                           " would be the same in ParaView files",
                         "names that differ in more than blanks and "
                         "underscores");
              }
            for (const std::string &name : names)
              if (mentioned.count(parameter_path(named.section, name)) == 0)
                refuse("there is no subsection " + in_quotes(name),
                       "a subsection of " + in_quotes(named.section) +
                         " for every name");
            return names;
          }
      return {};
    }
  } // namespace


  void
  override_entries(PrmContents                 &contents,
                   const std::vector<PrmEntry> &overrides)
  {
    std::set<std::string> paths;
    for (const PrmEntry &entry : overrides)
      {
        drop_unlisted(contents, entry);
        paths.insert(entry.path());
      }
    auto &entries = contents.entries;
    entries.erase(std::remove_if(entries.begin(),
                                 entries.end(),
                                 [&](const PrmEntry &entry) {
                                   return paths.count(entry.path()) != 0;
                                 }),
                  entries.end());
    entries.insert(entries.end(), overrides.begin(), overrides.end());
  }


  ParameterNames
  read_names(const PrmContents &contents)
  {
    const std::set<std::string> mentioned = mentioned_sections(contents);
    ParameterNames              names;
    for (const NamedSection &named : named_sections)
      names.*named.names = read_list(contents, mentioned, named);
    return names;
  }
} // namespace Waker
