// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/output/files.h>
#include <waker/output/statistics.h>

#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <filesystem>

namespace Waker
{
  using namespace dealii;

  namespace
  {
    constexpr std::size_t buffer_limit = 1 << 16; // bytes


    /// "# 12: Dyke width (m)" -> "Dyke width (m)"; "" for another line.
    std::string
    name_in_header(const std::string &line)
    {
      const std::size_t colon = line.find(": ");
      if (line.compare(0, 2, "# ") != 0 || colon == std::string::npos)
        return "";
      return line.substr(colon + 2);
    }
  } // namespace


  Statistics::Statistics(const std::string &path)
    : path(path)
  {
    if (!path.empty())
      file = std::make_unique<AppendFile>(path, /* empty = */ true);
  }


  Statistics::Statistics(const std::string  &path,
                         const std::uint64_t first_step)
    : path(path)
  {
    if (path.empty())
      return;

    if (std::filesystem::exists(path))
      {
        const std::string old = read_file(path);
        std::string       kept;
        for (std::size_t begin = 0; begin < old.size();)
          {
            const std::size_t end = old.find('\n', begin);
            if (end == std::string::npos)
              break; // cut short by the end of the earlier run
            const std::string line = old.substr(begin, end - begin);
            begin                  = end + 1;
            if (line.compare(0, 1, "#") == 0)
              names.push_back(name_in_header(line));
            else if (std::strtoull(line.c_str(), nullptr, 10) >= first_step)
              continue;
            kept += line;
            kept += '\n';
          }
        // A header alone may be cut short, too: it comes with the first row.
        if (kept.empty() || kept[kept.rfind('\n', kept.size() - 2) + 1] == '#')
          {
            kept.clear();
            names.clear();
          }
        header_written = !names.empty();
        write_file(path, kept);
      }
    file = std::make_unique<AppendFile>(path, /* empty = */ false);
  }


  Statistics::~Statistics()
  {
    // flush() throws, a destructor must not. A row that is not complete is
    // none.
    if (file != nullptr)
      file->write(buffer.substr(0, buffer.rfind('\n') + 1));
  }


  void
  Statistics::write_header()
  {
    std::string header;
    for (std::size_t i = 0; i < names.size(); ++i)
      header += "# " + std::to_string(i + 1) + ": " + names[i] + "\n";
    buffer.insert(0, header);
    header_written = true;
  }


  void
  Statistics::begin_row(const std::uint64_t step)
  {
    column = 0;
    if (names.empty())
      names.push_back("Step");
    char       text[24];
    const auto end = std::to_chars(text, text + sizeof(text), step).ptr;
    buffer.append(text, end);
    ++column;
  }


  void
  Statistics::add(const std::string_view name, const double value)
  {
    if (!header_written)
      {
        AssertThrow(name.find('\n') == std::string_view::npos,
                    ExcMessage("A column's name must be one line"));
        names.emplace_back(name);
      }
    else
      AssertThrow(column < names.size() && names[column] == name,
                  ExcMessage("Column " + std::to_string(column + 1) +
                             " of the statistics is not '" + std::string(name) +
                             "' in every row"));
    ++column;

    char       text[40];
    const auto end = std::to_chars(text,
                                   text + sizeof(text),
                                   value,
                                   std::chars_format::general,
                                   10)
                       .ptr;
    buffer += ' ';
    buffer.append(text, end);
  }


  void
  Statistics::end_row()
  {
    AssertThrow(column == names.size(),
                ExcMessage("A row of the statistics has " +
                           std::to_string(column) + " columns, not " +
                           std::to_string(names.size())));
    buffer += '\n';
    if (!header_written)
      write_header();
    if (file == nullptr)
      buffer.clear();
    else if (buffer.size() > buffer_limit)
      flush();
  }


  void
  Statistics::flush()
  {
    if (file == nullptr)
      return;
    // Whole rows: on a full disk the file ends with the last one that it had.
    const bool good = file->write(buffer);
    buffer.clear();
    if (!good)
      throw_cannot_write(path, errno);
  }
} // namespace Waker
