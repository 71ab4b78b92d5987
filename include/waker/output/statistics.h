// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_statistics_h
#define waker_output_statistics_h

#include <waker/output/files.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace Waker
{
  /**
   * The text file `statistics`: one row a step, columns named in a header
   *
   *     # 1: Step
   *     # 2: Time (s)
   *
   * that numpy.loadtxt and gnuplot skip. The first row fixes the columns.
   *
   * Rows are collected in memory: call flush() before a checkpoint is written,
   * so that every row before the checkpoint's step is in the file. The
   * destructor flushes too.
   */
  class Statistics
  {
  public:
    /// A new file. An empty path makes an object that writes nothing.
    /// @throws as throw_cannot_write() if it cannot be written
    explicit Statistics(const std::string &path);

    /// Go on with the file of a resumed run: rows of steps >= first_step, a
    /// last line that was cut short, and lines that are no row are removed.
    /// There should be a row of each step before: see damage().
    /// @throws UserError "Output/Directory" if its header names other columns
    /// than its rows have
    Statistics(const std::string &path, const std::uint64_t first_step);

    ~Statistics();

    Statistics(const Statistics &) = delete;
    Statistics &
    operator=(const Statistics &) = delete;

    /// Begin the row of this step: its number is the first column, "Step".
    void
    begin_row(const std::uint64_t step);

    /// @param name with the unit: "Dyke width (m)". The same names in the same
    ///        order in every row; throws (ExcMessage) where they differ.
    void
    add(const std::string_view name, const double value);

    /// The row is complete. Throws (ExcMessage) if it has fewer columns than
    /// the first.
    void
    end_row();

    /// Hand the rows over to the operating system.
    /// @throws as throw_cannot_write() if they cannot be written
    void
    flush();

    /// A line for the user about rows that are missing in the file of a
    /// resumed run, or empty.
    const std::string &
    damage() const
    {
      return damage_text;
    }

    /// Names of the columns; empty before the first row.
    const std::vector<std::string> &
    columns() const
    {
      return names;
    }

  private:
    void
    write_header();

    std::string                 path;
    std::unique_ptr<AppendFile> file;  // none: nothing is written
    std::vector<std::string>    names; // of the columns
    bool                        header_written = false;
    bool                        is_resumed     = false; // names: of the file
    std::string                 damage_text;
    unsigned int                column = 0; // next one of this row
    std::string                 buffer;
  };
} // namespace Waker

#endif
