// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/errors.h>
#include <waker/base/hash.h>
#include <waker/base/read_file.h>
#include <waker/base/text.h>
#include <waker/program/parameter_text.h>
#include <waker/program/prm_scanner.h>

#include <filesystem>
#include <sstream>

namespace Waker
{
  namespace
  {
    void
    set_value(ParameterHandler        &prm,
              const DeclaredParameter &parameter,
              const std::string       &value)
    {
      const std::vector<std::string> sections = split(parameter.section, '/');
      for (const std::string &section : sections)
        prm.enter_subsection(section);
      prm.set(parameter.name, value);
      for (std::size_t i = 0; i < sections.size(); ++i)
        prm.leave_subsection();
    }
  } // namespace


  std::string
  text_of_parameters(ParameterHandler                     &prm,
                     const std::vector<DeclaredParameter> &values)
  {
    for (const DeclaredParameter &parameter : values)
      if (parameter.is_input_file() && !parameter.value.empty())
        {
          // A folder above may have a name that the file could not hold.
          const std::string absolute =
            std::filesystem::absolute(parameter.value)
              .lexically_normal()
              .string();
          if (fits_prm(absolute))
            set_value(prm, parameter, absolute);
        }
    std::ostringstream text;
    prm.print_parameters(text,
                         ParameterHandler::ShortPRM |
                           ParameterHandler::KeepDeclarationOrder);
    for (const DeclaredParameter &parameter : values)
      if (parameter.is_input_file() && !parameter.value.empty())
        set_value(prm, parameter, parameter.value);
    for (const DeclaredParameter &parameter : values)
      if (parameter.is_input_file() && !parameter.value.empty())
        try
          {
            text << "# contents: " << parameter.path() << " = "
                 << hash_of_text(read_input_file(parameter.value)) << "\n";
          }
        catch (const UserError &)
          {
            // Whoever needs the file will say so.
          }
    return text.str();
  }
} // namespace Waker
