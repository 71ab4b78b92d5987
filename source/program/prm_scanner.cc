// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/program/prm_scanner.h>

#include <istream>
#include <map>
#include <set>

namespace Waker
{
  std::string
  parameter_path(const std::string &section, const std::string &name)
  {
    return section.empty() ? name : section + "/" + name;
  }


  std::string
  PrmEntry::path() const
  {
    return parameter_path(section, name);
  }


  namespace
  {
    const std::string grammar =
      "\"subsection NAME\", \"set NAME = VALUE\", \"end\" or \"# comment\"";

    constexpr std::size_t most_levels = 10;


    bool
    starts_with_word(const std::string &line,
                     const std::string &word,
                     const std::string &capitals)
    {
      const std::string first = line.substr(0, line.find(' '));
      return first == word || first == capitals;
    }


    /// Keeps the sections that are open and what has been seen.
    class Scanner
    {
    public:
      explicit Scanner(const std::string &source)
        : source(source)
      {}

      void
      read_line(const std::string &line, const unsigned int number)
      {
        if (line.empty())
          return;
        where = source + ":" + std::to_string(number);
        if (!is_plain_text(line))
          throw UserError(where,
                          "cannot read " + in_quotes(line),
                          grammar + ", in UTF-8 (the file may be saved in "
                                    "another encoding, or be no text)");
        if (starts_with_word(line, "subsection", "SUBSECTION"))
          open_section(tidy(line.substr(10)));
        else if (starts_with_word(line, "set", "SET"))
          read_entry(tidy(line.substr(3)));
        else if (line == "end" || line == "END")
          close_section();
        else if (starts_with_word(line, "include", "INCLUDE"))
          throw UserError(where,
                          "a file cannot include another: " + in_quotes(line),
                          "a complete file; \"--set Section/Name=value\" "
                          "changes single values");
        else
          throw UserError(where, "cannot read " + in_quotes(line), grammar);
      }

      PrmContents
      finish()
      {
        if (!open.empty())
          throw UserError(open.back().where,
                          "subsection " + in_quotes(open.back().path) +
                            " is not closed",
                          "an \"end\" for every \"subsection\"");
        return contents;
      }

    private:
      void
      open_section(const std::string &name)
      {
        if (name.empty() || name.find('/') != std::string::npos)
          throw UserError(where,
                          "subsection " + in_quotes(name) + " is no name",
                          "a name without \"/\"");
        // Paths grow with the depth: a limit, or thousands of levels take
        // time and memory with the square of their number.
        if (open.size() >= most_levels)
          throw UserError(where,
                          "subsection " + in_quotes(name) + " lies " +
                            std::to_string(open.size()) + " subsections deep",
                          "at most two levels of subsections; is an \"end\" "
                          "missing?");
        const std::string path =
          parameter_path(open.empty() ? "" : open.back().path, name);
        remember("section " + path, "subsection " + in_quotes(path));
        open.push_back({path, where});
        contents.sections.push_back(open.back());
      }

      void
      close_section()
      {
        if (open.empty())
          throw UserError(where,
                          "\"end\" without a subsection",
                          "one \"end\" for every \"subsection\"");
        open.pop_back();
      }

      void
      read_entry(const std::string &text)
      {
        const std::size_t equals = text.find('=');
        PrmEntry          entry;
        entry.section = open.empty() ? "" : open.back().path;
        entry.name    = tidy(text.substr(0, equals));
        entry.where   = where;
        if (equals == std::string::npos || entry.name.empty())
          throw UserError(where,
                          "cannot read " + in_quotes("set " + text),
                          "\"set NAME = VALUE\"");
        entry.value = tidy(text.substr(equals + 1));
        remember("entry " + entry.path(), in_quotes(entry.path()));
        contents.entries.push_back(entry);
      }

      /// A name that is given twice would win silently in deal.II.
      void
      remember(const std::string &key, const std::string &description)
      {
        const auto found = seen.emplace(key, where);
        if (!found.second)
          throw UserError(where,
                          description + " appears twice, first at " +
                            found.first->second,
                          "each subsection and each name once");
      }

      const std::string                  source;
      std::string                        where; // the line at hand
      std::vector<PrmSection>            open;
      std::map<std::string, std::string> seen;
      PrmContents                        contents;
    };
  } // namespace


  PrmContents
  scan_prm(std::istream &input, const std::string &source)
  {
    Scanner      scanner(source);
    std::string  physical_line, line;
    unsigned int number = 0, first_number = 1;
    while (std::getline(input, physical_line))
      {
        ++number;
        if (number == 1)
          physical_line = without_byte_order_mark(physical_line);

        // The line number of an entry is that of its first line.
        if (line.empty())
          first_number = number;
        line += " " + tidy(physical_line.substr(0, physical_line.find('#')));
        if (line.back() == '\\')
          line.pop_back();
        else
          {
            scanner.read_line(tidy(line), first_number);
            line.clear();
          }
      }
    scanner.read_line(tidy(line), first_number);
    return scanner.finish();
  }


  bool
  fits_prm(const std::string &value)
  {
    return is_plain_text(value) && tidy(value) == value &&
           value.find('#') == std::string::npos &&
           (value.empty() || value.back() != '\\');
  }


  namespace
  {
    /// Only the command line can give a value that the language of the file
    /// cannot: its parameters.prm would say something else.
    void
    check_representable(const PrmEntry &entry)
    {
      const std::string allowed =
        "text in UTF-8 that a .prm file can hold: no \"#\", which begins a "
        "comment there, no control characters, no \"\\\" at the end";
      if (!is_plain_text(entry.section) || !is_plain_text(entry.name) ||
          !is_plain_text(entry.value))
        throw UserError(entry.where,
                        in_quotes(entry.value) + " is no plain text",
                        allowed);
      if (!fits_prm(entry.value))
        throw UserError(entry.where,
                        in_quotes(entry.value) +
                          " cannot be written to parameters.prm",
                        allowed);
    }
  } // namespace


  std::vector<PrmEntry>
  scan_overrides(const std::vector<std::string> &overrides)
  {
    std::vector<PrmEntry> entries;
    std::set<std::string> paths;
    for (const std::string &text : overrides)
      {
        const std::size_t        equals = text.find('=');
        std::vector<std::string> names  = split(text.substr(0, equals), '/');
        const bool named = !names.empty() && !names.back().empty();
        if (equals == std::string::npos || !named)
          throw UserError("--set " + tidy(text),
                          "cannot read " + in_quotes(text),
                          "--set \"Section/Name=value\"");
        PrmEntry entry;
        entry.name  = names.back();
        entry.value = tidy(text.substr(equals + 1));
        names.pop_back();
        for (const std::string &name : names)
          entry.section = parameter_path(entry.section, name);
        entry.where = "--set " + entry.path();
        if (!paths.insert(entry.path()).second)
          throw UserError(entry.where,
                          in_quotes(entry.path()) + " is given twice",
                          "each name once on the command line");
        check_representable(entry);
        entries.push_back(entry);
      }
    return entries;
  }
} // namespace Waker
