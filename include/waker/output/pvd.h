// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_pvd_h
#define waker_output_pvd_h

#include <waker/output/output_files.h>

#include <string>
#include <vector>

namespace Waker
{
  /// One file of a time series.
  struct PvdEntry
  {
    double      time;     // s
    std::string file;     // relative to the output folder
    std::string checksum; // checksum_of_text() of what it holds

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &time &file &checksum;
    }
  };

  /**
   * A time series of .vtu files, "solution/<name>-00012.vtu", and the
   * "<name>.pvd" that ParaView opens. The .pvd is rewritten, as temporary and
   * rename, after each new file: it is whole at any time.
   *
   * Use: write the file next_path(), then add(time).
   */
  class PvdSeries
  {
  public:
    /**
     * @param folder the output folder; "solution/" must exist in it
     */
    PvdSeries(const std::string &folder, const FieldSeries fields);

    /// Path of the next file to be written.
    std::string
    next_path() const;

    /// The file next_path() has been written for this time (s).
    /// @param checksum that its writer returned
    void
    add(const double time, const std::string &checksum);

    /// What a checkpoint stores.
    const std::vector<PvdEntry> &
    entries() const
    {
      return series;
    }

    /// Go on from a checkpoint: files that were written after it are removed
    /// from the .pvd and from the disk.
    /// @return those before it that are missing or no longer what was written:
    ///   they stay as they are
    std::vector<std::string>
    restore(const std::vector<PvdEntry> &entries);

  private:
    std::string
    next_file() const;

    void
    write_pvd() const;

    std::string           folder;
    FieldSeries           fields;
    std::vector<PvdEntry> series;
  };
} // namespace Waker

#endif
