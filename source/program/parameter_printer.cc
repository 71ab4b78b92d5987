// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/errors.h>
#include <waker/campaign/input.h>
#include <waker/program/declared_parameters.h>
#include <waker/program/parameter_printer.h>
#include <waker/program/prm_scanner.h>

#include <algorithm>
#include <ostream>

namespace Waker
{
  namespace
  {
    /// Characters that mean something in a Markdown table.
    std::string
    escaped(const std::string &text)
    {
      std::string result;
      for (const char c : text)
        {
          if (c == '|' || c == '*' || c == '<' || c == '_')
            result += '\\';
          result += c;
        }
      return result;
    }


    void
    print_markdown(std::ostream &output, const ParameterHandler &prm)
    {
      output << "# Parameters\n\n"
                "Made by `waker parameters --format markdown`; do not edit.\n\n"
                "Units: m, s, kPa, Mg, kN/m^3. `--set \"Section/Name=value\"` "
                "overrides a value of the file.\n"
                "Replace `<name>` by a name that the list above it holds.\n";
      std::string section = "-"; // of the table at hand
      for (const DeclaredParameter &parameter : declared_parameters(prm))
        {
          if (parameter.section != section)
            {
              section = parameter.section;
              output << "\n## "
                     << (section.empty() ? "Top level" : escaped(section))
                     << "\n\n| name | default | allowed | meaning |\n"
                        "|---|---|---|---|\n";
            }
          output << "| " << escaped(parameter.name) << " | "
                 << (parameter.default_value.empty()
                       ? "(empty)"
                       : escaped(parameter.default_value))
                 << " | " << escaped(pattern_in_words(parameter.pattern))
                 << " | " << escaped(parameter.documentation) << " |\n";
        }
    }


    std::string
    indent(const std::size_t depth)
    {
      return std::string(2 * depth, ' ');
    }


    /// `text` as comment lines of at most 78 characters.
    void
    print_comment(std::ostream      &output,
                  const std::string &text,
                  const std::size_t  depth)
    {
      std::string line = indent(depth) + "#";
      for (const std::string &word : split(text, ' '))
        {
          if (line.size() + 1 + word.size() > 78)
            {
              output << line << '\n';
              line = indent(depth) + "#";
            }
          line += " " + word;
        }
      output << line << '\n';
    }


    /// Unlike deal.II's, it says what is allowed.
    void
    print_prm(std::ostream &output, const ParameterHandler &prm)
    {
      std::vector<std::string> open; // sections
      for (const DeclaredParameter &parameter : declared_parameters(prm))
        {
          const std::vector<std::string> sections =
            split(parameter.section, '/');
          while (open.size() > sections.size() ||
                 !std::equal(open.begin(), open.end(), sections.begin()))
            {
              open.pop_back();
              output << indent(open.size()) << "end\n";
            }
          while (open.size() < sections.size())
            {
              output << '\n'
                     << indent(open.size()) << "subsection "
                     << sections[open.size()] << '\n';
              open.push_back(sections[open.size()]);
            }
          print_comment(output, parameter.documentation, open.size());
          print_comment(output,
                        "Allowed: " + pattern_in_words(parameter.pattern) + ".",
                        open.size());
          output << indent(open.size()) << "set " << parameter.name << " = "
                 << parameter.value << '\n';
        }
      for (; !open.empty(); open.pop_back())
        output << indent(open.size() - 1) << "end\n";
    }
  } // namespace


  void
  print_parameters(std::ostream &output, const ParameterFormat format)
  {
    Input            input;
    ParameterHandler prm;
    ParameterNames   names;
    for (const NamedSection &named : named_sections)
      names.*named.names = {"<name>"};
    declare_parameters(prm, input, names);

    const auto style = ParameterHandler::KeepDeclarationOrder;
    switch (format)
      {
        case ParameterFormat::prm:
          print_prm(output, prm);
          break;
        case ParameterFormat::json:
          prm.print_parameters(output, ParameterHandler::JSON | style);
          break;
        case ParameterFormat::xml:
          prm.print_parameters(output, ParameterHandler::XML | style);
          break;
        case ParameterFormat::markdown:
          print_markdown(output, prm);
          break;
      }
  }
} // namespace Waker
