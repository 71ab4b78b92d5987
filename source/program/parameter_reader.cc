// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/errors.h>
#include <waker/base/read_file.h>
#include <waker/campaign/input.h>
#include <waker/case/cross_section.h>
#include <waker/program/declared_parameters.h>
#include <waker/program/magnitudes.h>
#include <waker/program/parameter_hash.h>
#include <waker/program/parameter_names.h>
#include <waker/program/parameter_reader.h>
#include <waker/program/parameter_text.h>
#include <waker/program/prm_scanner.h>
#include <waker/program/suggestions.h>

#include "section_folder.h"
#include <algorithm>
#include <cstdint>
#include <filesystem>
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
    std::string place = where(error.where);
    // Of a section it may be what the command line sets.
    if (known.count(error.where) == 0)
      for (auto line = lines.lower_bound(error.where + "/");
           line != lines.end() &&
           line->first.compare(0, error.where.size() + 1, error.where + "/") ==
             0;
           ++line)
        if (line->second == "--set " + line->first)
          place += ", with " + line->second;
    return UserError(place, what, error.allowed);
  }


  namespace
  {
    constexpr std::size_t longest_value = 1000000; // bytes


    PrmContents
    scan_source(const std::string &source, const std::string &name)
    {
      const std::string allowed = "a .prm file, or - to read standard input";
      const auto        scan    = [&name](const std::string &text) {
        std::istringstream stream(text);
        return scan_prm(stream, name);
      };
      if (source == "-")
        return scan(read_input(std::cin, name));

      std::error_code error;
      if (std::filesystem::is_directory(source, error))
        throw UserError(name, "is a folder", allowed);
      std::string text;
      try
        {
          text = read_input_file(source);
        }
      catch (const UserError &problem)
        {
          throw UserError(name,
                          problem.problem,
                          problem.allowed + ": " + allowed);
        }
      return scan(text);
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
                        allowed_instead(entry.value, declaration.pattern));
      };
      if (entry.value.size() > longest_value)
        throw UserError(entry.where,
                        entry.path() + ": has " +
                          std::to_string(entry.value.size()) + " characters",
                        "at most " + std::to_string(longest_value));
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
    /// @param is_whole it is to be computed, not to be completed by a sweep
    std::unique_ptr<Input>
    make_input(const PrmContents  &contents,
               ParameterLocations &map,
               const FileContents  files,
               const bool          is_whole = true)
    {
      // First the names, then the subsections that they call for.
      const ParameterNames names = read_names(contents);

      auto             input = std::make_unique<Input>();
      ParameterHandler prm;
      declare_parameters(prm, *input, names);
      const DeclaredIndex declared(declared_parameters(prm));

      for (const PrmSection &section : contents.sections)
        {
          check_section(section, declared);
          map.lines[section.path] = section.where;
        }
      for (const DeclaredParameter &parameter : declared.all())
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

      if (!is_whole)
        return input;
      const std::vector<DeclaredParameter> values = declared_parameters(prm);
      input->simulation.text = text_of_parameters(prm, values);

      try
        {
          input->prepare_materials();
          input->check();
          check_magnitudes(values); // after what knows better
          take_cross_section(input->simulation);
          input->simulation.hash = hash_of_steps(values, files);
          input->campaign_hash   = hash_of_records(values, files);
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
      override_entries(contents, override_list);
      return contents;
    }
  } // namespace


  namespace
  {
    bool
    has_sweep(const PrmContents &contents)
    {
      return std::any_of(contents.entries.begin(),
                         contents.entries.end(),
                         [](const PrmEntry &entry) {
                           return entry.path() == "Sweep/Parameter" &&
                                  !entry.value.empty();
                         });
    }


    /// @throws UserError if it cannot differ between the scenarios
    void
    check_swept(const std::string &path, const ParameterLocations &map)
    {
      if (map.known.count(path) == 0)
        throw map.located(
          UserError("Sweep/Parameter",
                    "is \"" + path + "\", which does not exist",
                    "the path of a parameter, \"Section/Name\"; "
                    "waker parameters prints them all"));
      // What all scenarios share.
      const std::string section = path.substr(0, path.find('/'));
      for (const std::string shared :
           {"Dimension", "Output", "Campaign", "Sweep"})
        if (section == shared)
          throw map.located(
            UserError("Sweep/Parameter",
                      "is \"" + path + "\", which cannot be swept",
                      "a parameter of the simulation or its random fields"));
      if (map.where(path) == "--set " + path)
        throw UserError("--set " + path,
                        "is swept: it has another value in each scenario",
                        "--set \"Sweep/Values=...\"; or, for no sweep, --set "
                        "Sweep/Parameter= --set Sweep/Values=");
    }


    /// "dyke.prm:12 (Sweep/Values)"
    std::string
    place_of_values(const ParameterLocations &map)
    {
      const std::string name  = "Sweep/Values";
      const std::string place = map.where(name);
      return place.find(name) != std::string::npos ? place
                                                   : place + " (" + name + ")";
    }


    /// Does the last scenario differ from those before in what counts?
    void
    check_scenario(const std::vector<std::unique_ptr<Input>> &scenarios,
                   const ParameterLocations                  &map)
    {
      const Input &last = *scenarios.back();
      if (last.simulation.dimension != scenarios[0]->simulation.dimension)
        throw map.located(
          UserError("Sweep/Parameter",
                    "\"" + last.reliability.sweep.parameter +
                      "\" makes some scenarios plane and others not",
                    "scenarios of one dimension: two campaigns"));
      for (std::size_t s = 0; s + 1 < scenarios.size(); ++s)
        if (scenarios[s]->campaign_hash == last.campaign_hash)
          throw map.located(UserError(
            "Sweep/Parameter",
            "\"" + last.reliability.sweep.parameter +
              "\" makes no difference to the realisations",
            "a parameter that decides what they compute, with values that "
            "differ"));
    }
  } // namespace


  std::vector<std::unique_ptr<Input>>
  read_scenarios(const std::string              &source,
                 const std::vector<std::string> &overrides,
                 ParameterLocations             *locations,
                 const FileContents              files)
  {
    ParameterLocations  own_locations;
    ParameterLocations &map = locations != nullptr ? *locations : own_locations;
    PrmContents         contents = read_contents(source, overrides, map);
    name_folder_of_section(contents);

    std::vector<std::unique_ptr<Input>> scenarios;
    if (!has_sweep(contents))
      {
        scenarios.push_back(make_input(contents, map, files));
        return scenarios;
      }

    const SweepParameters sweep =
      make_input(contents, map, files, false)->reliability.sweep;
    try
      {
        sweep.check();
      }
    catch (const UserError &error)
      {
        throw map.located(error);
      }
    const std::string &path = sweep.parameter;
    check_swept(path, map);
    // Whoever finds a value of it wrong, now or later, means one of these.
    const std::string place = place_of_values(map);
    map.lines[path]         = place;
    const std::size_t slash = path.rfind('/');
    for (const std::string &value : sweep.list())
      {
        PrmContents        changed = contents;
        ParameterLocations unused  = map;
        override_entries(
          changed,
          {{slash == std::string::npos ? "" : path.substr(0, slash),
            path.substr(slash == std::string::npos ? 0 : slash + 1),
            value,
            place}});
        try
          {
            scenarios.push_back(make_input(changed, unused, files));
          }
        catch (const UserError &error)
          {
            // Where the scenarios before were good only the value can be wrong.
            if (scenarios.empty() || error.where == place)
              throw;
            throw UserError(place,
                            path + " = " + value + ": " + error.where + ": " +
                              error.problem,
                            error.allowed);
          }
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
    PrmContents         contents = read_contents(source, overrides, map);
    name_folder_of_section(contents);
    return std::make_unique<Parameters>(
      std::move(make_input(contents, map, FileContents::count)->simulation));
  }
} // namespace Waker
