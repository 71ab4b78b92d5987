// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/errors.h>
#include <waker/program/declared_parameters.h>
#include <waker/program/parameter_hash.h>
#include <waker/program/parameter_reader.h>
#include <waker/program/parameter_text.h>
#include <waker/program/prm_scanner.h>
#include <waker/program/suggestions.h>
#include <waker/reliability/input.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

namespace Waker
{
  std::string
  ParameterLocations::where(const std::string &path) const
  {
    const auto line = lines.find(path);
    if (line != lines.end())
      return line->second;
    if (known.count(path) != 0)
      return source + " (default of " + path + ")";
    return path;
  }


  UserError
  ParameterLocations::located(const UserError &error) const
  {
    std::string what = error.problem;
    // A file and a line do not say which parameter is meant.
    if (known.count(error.where) != 0 && where(error.where) != error.where)
      what = error.where + ": " + what;
    return UserError(where(error.where), what, error.allowed);
  }


  namespace
  {
    PrmContents
    scan_source(const std::string &source, const std::string &name)
    {
      if (source == "-")
        return scan_prm(std::cin, name);

      std::error_code error;
      if (std::filesystem::is_directory(source, error))
        throw UserError(name,
                        "is a folder",
                        "a .prm file, or - to read standard input");
      errno = 0;
      std::ifstream file(source);
      if (!file)
        throw UserError(name,
                        std::string("cannot be opened: ") +
                          std::strerror(errno != 0 ? errno : ENOENT),
                        "a .prm file, or - to read standard input");
      return scan_prm(file, name);
    }


    /// The overrides replace entries of the file.
    void
    override_entries(std::vector<PrmEntry>       &entries,
                     const std::vector<PrmEntry> &overrides)
    {
      for (const PrmEntry &override_entry : overrides)
        {
          entries.erase(std::remove_if(entries.begin(),
                                       entries.end(),
                                       [&](const PrmEntry &entry) {
                                         return entry.path() ==
                                                override_entry.path();
                                       }),
                        entries.end());
          entries.push_back(override_entry);
        }
    }


    /// Does the file or the command line say anything about this section?
    bool
    is_mentioned(const PrmContents &contents, const std::string &section)
    {
      for (const PrmSection &other : contents.sections)
        if (other.path == section)
          return true;
      for (const PrmEntry &entry : contents.entries)
        if (entry.section == section)
          return true;
      return false;
    }


    /// The list of names at `section`/`list`, each of which must have a
    /// subsection: a forgotten one would silently mean default values.
    std::vector<std::string>
    read_names(const PrmContents &contents,
               const std::string &section,
               const std::string &list)
    {
      for (const PrmEntry &entry : contents.entries)
        if (entry.section == section && entry.name == list)
          {
            const std::vector<std::string> names = split(entry.value, ',');
            const auto refuse = [&entry](const std::string &what,
                                         const std::string &allowed) {
              throw UserError(entry.where, entry.path() + ": " + what, allowed);
            };
            for (const std::string &name : names)
              {
                if (name.empty() || name == list ||
                    name.find('/') != std::string::npos)
                  refuse(in_quotes(name) + " is no name",
                         "names without \"/\", separated by commas");
                if (std::count(names.begin(), names.end(), name) > 1)
                  refuse(in_quotes(name) + " is listed twice",
                         "each name once");
                if (!is_mentioned(contents, parameter_path(section, name)))
                  refuse("there is no subsection " + in_quotes(name),
                         "a subsection of " + in_quotes(section) +
                           " for every name");
              }
            return names;
          }
      return {};
    }


    /// Check an entry and hand it to deal.II, which sets the struct.
    void
    set_entry(ParameterHandler        &prm,
              const PrmEntry          &entry,
              const DeclaredParameter &declaration)
    {
      const auto refuse = [&]() {
        throw UserError(entry.where,
                        entry.path() + ": " + in_quotes(entry.value) +
                          " is not allowed",
                        pattern_in_words(declaration.pattern));
      };
      if (!matches_pattern(entry.value, declaration.pattern))
        refuse();

      const std::vector<std::string> sections = split(entry.section, '/');
      for (const std::string &section : sections)
        prm.enter_subsection(section);
      try
        {
          prm.set(entry.name, normalised(entry.value, declaration.pattern));
        }
      catch (const ExceptionBase &)
        {
          refuse();
        }
      for (std::size_t i = 0; i < sections.size(); ++i)
        prm.leave_subsection();
    }
  } // namespace


  namespace
  {
    std::unique_ptr<Input>
    make_input(const PrmContents &contents, ParameterLocations &map)
    {
      // First the names, then the subsections that they call for.
      ParameterNames names;
      names.materials   = read_names(contents, "Materials", "Names");
      names.layers      = read_names(contents, "Soil profile", "Layers");
      names.conditions  = read_names(contents, "Boundary conditions", "Names");
      names.tractions   = read_names(contents, "Tractions", "Names");
      names.point_loads = read_names(contents, "Point loads", "Names");
      names.walls       = read_names(contents, "Walls", "Names");
      names.inflows     = read_names(contents, "Inflow", "Names");
      names.fields      = read_names(contents, "Random fields", "Names");

      auto             input = std::make_unique<Input>();
      ParameterHandler prm;
      declare_parameters(prm, *input, names);
      const std::vector<DeclaredParameter> declared = declared_parameters(prm);

      for (const PrmSection &section : contents.sections)
        {
          check_section(section, declared);
          map.lines[section.path] = section.where;
        }
      for (const DeclaredParameter &parameter : declared)
        {
          map.known.insert(parameter.path());
          // deal.II writes some defaults in its own way: 1e-04.
          const std::string value =
            normalised(parameter.value, parameter.pattern);
          if (value != parameter.value)
            set_entry(prm,
                      {parameter.section, parameter.name, value, ""},
                      parameter);
        }
      for (const PrmEntry &entry : contents.entries)
        {
          set_entry(prm, entry, find_declared(entry, declared));
          map.lines[entry.path()] = entry.where;
        }

      const std::vector<DeclaredParameter> values = declared_parameters(prm);
      input->simulation.text = text_of_parameters(prm, values);

      try
        {
          input->check();
          input->simulation.hash = hash_of_steps(values);
          input->campaign_hash   = hash_of_records(values);
        }
      catch (const UserError &error)
        {
          throw map.located(error);
        }
      return input;
    }


    PrmContents
    read_contents(const std::string              &source,
                  const std::vector<std::string> &overrides,
                  ParameterLocations             &map)
    {
      map        = ParameterLocations();
      map.source = source == "-"    ? "standard input"
                   : source.empty() ? in_quotes("")
                                    : source;
      const std::vector<PrmEntry> override_list = scan_overrides(overrides);
      PrmContents                 contents = scan_source(source, map.source);
      override_entries(contents.entries, override_list);
      return contents;
    }
  } // namespace


  namespace
  {
    /// Does the last scenario differ from those before in what counts, and in
    /// nothing that all must share?
    void
    check_scenario(const std::vector<std::unique_ptr<Input>> &scenarios,
                   const ParameterLocations                  &map)
    {
      const Input &last = *scenarios.back();
      for (std::size_t s = 0; s + 1 < scenarios.size(); ++s)
        if (scenarios[s]->campaign_hash == last.campaign_hash)
          throw map.located(UserError(
            "Sweep/Parameter",
            "\"" + last.reliability.sweep.parameter +
              "\" makes no difference to the realisations",
            "a parameter that decides what they compute, with values that "
            "differ"));
      if (scenarios[0]->simulation.dimension != last.simulation.dimension ||
          scenarios[0]->reliability.campaign.seed !=
            last.reliability.campaign.seed)
        throw map.located(
          UserError("Sweep/Parameter",
                    "is \"" + last.reliability.sweep.parameter +
                      "\", which all scenarios must share",
                    "a parameter of the simulation or its random fields"));
    }
  } // namespace


  std::vector<std::unique_ptr<Input>>
  read_scenarios(const std::string              &source,
                 const std::vector<std::string> &overrides,
                 ParameterLocations             *locations)
  {
    ParameterLocations  own_locations;
    ParameterLocations &map = locations != nullptr ? *locations : own_locations;
    const PrmContents   contents = read_contents(source, overrides, map);

    std::vector<std::unique_ptr<Input>> scenarios;
    scenarios.push_back(make_input(contents, map));
    const SweepParameters sweep = scenarios[0]->reliability.sweep;
    if (sweep.parameter.empty())
      return scenarios;

    const std::string &path = sweep.parameter;
    if (map.known.count(path) == 0)
      throw map.located(UserError("Sweep/Parameter",
                                  "is \"" + path + "\", which does not exist",
                                  "the path of a parameter, \"Section/Name\"; "
                                  "waker parameters prints them all"));
    if (map.where(path) == "--set " + path)
      throw UserError("--set " + path,
                      "is swept: it has another value in each scenario",
                      "--set \"Sweep/Values=...\"; or, for no sweep, --set "
                      "Sweep/Parameter= --set Sweep/Values=");
    const std::size_t slash = path.rfind('/');
    scenarios.clear();
    for (const std::string &value : sweep.list())
      {
        PrmContents        changed = contents;
        ParameterLocations unused  = map;
        override_entries(
          changed.entries,
          {{slash == std::string::npos ? "" : path.substr(0, slash),
            path.substr(slash == std::string::npos ? 0 : slash + 1),
            value,
            map.where("Sweep/Values")}});
        scenarios.push_back(make_input(changed, unused));
        check_scenario(scenarios, map);
      }
    return scenarios;
  }


  std::unique_ptr<Parameters>
  read_parameters(const std::string              &source,
                  const std::vector<std::string> &overrides,
                  ParameterLocations             *locations)
  {
    ParameterLocations  own_locations;
    ParameterLocations &map = locations != nullptr ? *locations : own_locations;
    const PrmContents   contents = read_contents(source, overrides, map);
    return std::make_unique<Parameters>(
      std::move(make_input(contents, map)->simulation));
  }
} // namespace Waker
