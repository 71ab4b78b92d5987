// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/hash.h>
#include <waker/output/files.h>
#include <waker/program/parameter_hash.h>

namespace Waker
{
  namespace
  {
    bool
    decides_steps(const DeclaredParameter &parameter)
    {
      for (const char *const section : {"Output",
                                        "Stop rules",
                                        "Strength reduction",
                                        "Campaign",
                                        "Sweep",
                                        "Snapshots",
                                        "Slides",
                                        "Histograms",
                                        "Risk"})
        if (parameter.section == section)
          return false;
      return parameter.path() != "Time stepping/End time";
    }


    bool
    decides_records(const DeclaredParameter &parameter)
    {
      return decides_steps(parameter) || parameter.section == "Stop rules" ||
             parameter.path() == "Time stepping/End time" ||
             parameter.path() == "Campaign/Seed" ||
             parameter.path() == "Campaign/Attempts";
    }


    /// Does it name a file whose contents decide?
    bool
    names_a_file(const DeclaredParameter &parameter)
    {
      return parameter.section.rfind("Random fields/", 0) == 0 &&
             parameter.name == "Measurements" && !parameter.value.empty();
    }


    template <typename Predicate>
    std::string
    hash_of(const std::vector<DeclaredParameter> &parameters,
            const Predicate                      &counts)
    {
      std::string text;
      for (const DeclaredParameter &parameter : parameters)
        if (counts(parameter))
          {
            text += parameter.path() + "=" + parameter.value + "\n";
            if (names_a_file(parameter))
              try
                {
                  text += hash_of_text(read_file(parameter.value)) + "\n";
                }
              catch (const UserError &error)
                {
                  throw UserError(parameter.path(),
                                  "'" + parameter.value + "': " + error.problem,
                                  error.allowed);
                }
          }
      return hash_of_text(text);
    }
  } // namespace


  std::string
  hash_of_steps(const std::vector<DeclaredParameter> &parameters)
  {
    return hash_of(parameters, decides_steps);
  }


  std::string
  hash_of_records(const std::vector<DeclaredParameter> &parameters)
  {
    return hash_of(parameters, decides_records);
  }
} // namespace Waker
