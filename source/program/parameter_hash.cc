// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/hash.h>
#include <waker/base/read_file.h>
#include <waker/campaign/free_parameters.h>
#include <waker/output/output_files.h>
#include <waker/program/parameter_hash.h>

namespace Waker
{
  namespace
  {
    bool
    decides_steps(const DeclaredParameter &parameter)
    {
      return !is_free_at_resume(parameter.section, parameter.name);
    }


    bool
    decides_records(const DeclaredParameter &parameter)
    {
      const auto decides = is_one_of(campaign_parameters_not_free());
      return decides_steps(parameter) || parameter.section == "Stop rules" ||
             parameter.path() == "Time stepping/End time" ||
             (parameter.section == "Campaign" && decides(parameter.name));
    }


    std::string
    contents(const DeclaredParameter &parameter)
    {
      try
        {
          return read_input_file(parameter.value);
        }
      catch (const UserError &error)
        {
          throw UserError(parameter.path(),
                          "'" + parameter.value + "': " + error.problem,
                          error.allowed +
                            "; a relative path begins in the folder in which "
                            "waker is started");
        }
    }


    template <typename Predicate>
    std::string
    hash_of(const std::vector<DeclaredParameter> &parameters,
            const FileContents                    files,
            const Predicate                      &counts)
    {
      std::string text;
      for (const DeclaredParameter &parameter : parameters)
        if (counts(parameter))
          text += parameter.path() + "=" +
                  (files == FileContents::count && parameter.is_input_file() &&
                       !parameter.value.empty()
                     ? "contents " + hash_of_text(contents(parameter))
                     : parameter.value) +
                  "\n";
      return hash_of_text(text);
    }
  } // namespace


  std::string
  hash_of_steps(const std::vector<DeclaredParameter> &parameters,
                const FileContents                    files)
  {
    return hash_of(parameters, files, decides_steps);
  }


  std::string
  hash_of_records(const std::vector<DeclaredParameter> &parameters,
                  const FileContents                    files)
  {
    return hash_of(parameters, files, decides_records);
  }
} // namespace Waker
