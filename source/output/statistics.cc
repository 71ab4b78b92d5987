// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/base/errors.h>
#include <waker/base/text.h>
#include <waker/output/files.h>
#include <waker/output/statistics.h>

#include <cerrno>
#include <charconv>
#include <filesystem>

namespace Waker
{
  using namespace dealii;

  namespace
  {
    constexpr std::size_t buffer_limit = 1 << 16; // bytes


    /// "# 12: Dyke width (m)" -> "Dyke width (m)", if it is column 12; "" for
    /// another line.
    std::string
    name_in_header(const std::string &line, const std::size_t column)
    {
      const std::string begin = "# " + std::to_string(column) + ": ";
      return line.compare(0, begin.size(), begin) == 0
               ? line.substr(begin.size())
               : "";
    }


    /// How many numbers a line consists of; 0 if of something else, too.
    std::size_t
    n_numbers(const std::string &line)
    {
      std::size_t n = 0;
      for (const char *at = line.data(), *end = at + line.size();; ++at)
        {
          double     number;
          const auto result = std::from_chars(at, end, number);
          // What is too large or small for a number is one in the file.
          if (result.ptr == at || (result.ptr != end && *result.ptr != ' '))
            return 0;
          ++n;
          at = result.ptr;
          if (at == end)
            return n;
        }
    }


    /// What is in the file of an earlier run.
    struct OldRows
    {
      std::vector<std::string> names;
      std::string              header; // lines as they are
      bool                     is_header_good = true;

      std::string   rows;        // before the first new step, those that fit
      std::uint64_t n_rows  = 0; // of them
      std::uint64_t n_other = 0; // lines that do not fit
      /// The first step without a row.
      std::uint64_t first_missing = 0;
    };


    OldRows
    read_old_rows(const std::string &text, const std::uint64_t first_step)
    {
      OldRows       old;
      std::uint64_t next = 0; // the least step that may come
      for (std::size_t begin = 0; begin < text.size();)
        {
          const std::size_t end = text.find('\n', begin);
          if (end == std::string::npos)
            break; // cut short by the end of the earlier run
          const std::string line = text.substr(begin, end - begin);
          begin                  = end + 1;
          if (line.compare(0, 1, "#") == 0)
            {
              old.names.push_back(name_in_header(line, old.names.size() + 1));
              old.header += line + '\n';
              old.is_header_good =
                old.is_header_good && !old.names.back().empty();
              continue;
            }
          std::uint64_t step = 0;
          const auto    read =
            std::from_chars(line.data(), line.data() + line.size(), step);
          const bool has_step =
            read.ec == std::errc() && read.ptr != line.data() + line.size();
          if (has_step && step >= first_step)
            continue;
          if (!has_step || step < next || old.names.empty() ||
              n_numbers(line) != old.names.size())
            {
              ++old.n_other;
              continue;
            }
          if (old.first_missing == step)
            ++old.first_missing;
          next = step + 1;
          ++old.n_rows;
          old.rows += line;
          old.rows += '\n';
        }
      return old;
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

    const bool    is_there = std::filesystem::exists(path);
    const OldRows old =
      is_there ? read_old_rows(read_file(path), first_step) : OldRows();
    // Where nothing fits it, the header must be wrong.
    if ((old.n_rows > 0 && !old.is_header_good) ||
        (old.n_rows == 0 && old.n_other > 0))
      throw UserError("Output/Directory",
                      "the header of '" + path +
                        "' is damaged: it does not name the columns below it",
                      "the file as the run has written it; or --resume without "
                      "it, which loses the rows of before; or --overwrite");
    if (old.n_rows < first_step)
      damage_text = std::to_string(first_step - old.n_rows) + " of " +
                    counted(first_step, "row") +
                    " of before the checkpoint "
                    "are missing or damaged in " +
                    path +
                    ", and stay so (--overwrite computes all again): the first "
                    "is that of step " +
                    std::to_string(old.first_missing);
    // A header alone may be cut short, too: it comes with the first row.
    if (old.n_rows > 0)
      names = old.names;
    header_written = !names.empty();
    is_resumed     = header_written;
    if (is_there)
      write_file(path, old.n_rows > 0 ? old.header + old.rows : "");
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
    else if (is_resumed && !(column < names.size() && names[column] == name))
      throw UserError("Output/Directory",
                      "'" + path + "' does not name its column " +
                        std::to_string(column + 1) + " \"" + std::string(name) +
                        "\", as this run does",
                      "the file as the run has written it; or --resume without "
                      "it, which loses the rows of before; or --overwrite");
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
