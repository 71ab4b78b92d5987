// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/hash.h>
#include <waker/base/read_file.h>
#include <waker/output/files.h>
#include <waker/output/output_files.h>
#include <waker/output/pvd.h>

#include <cstdio>
#include <filesystem>

namespace Waker
{
  namespace
  {
    bool
    is_whole(const std::string &path, const std::string &checksum)
    {
      try
        {
          return checksum_of_text(read_file(path)) == checksum;
        }
      catch (const UserError &)
        {
          return false;
        }
    }
  } // namespace


  PvdSeries::PvdSeries(const std::string &folder, const FieldSeries fields)
    : folder(folder)
    , fields(fields)
  {}


  std::string
  PvdSeries::next_file() const
  {
    return frame_name(fields, series.size());
  }


  std::string
  PvdSeries::next_path() const
  {
    return join_path(folder, next_file());
  }


  void
  PvdSeries::add(const double time, const std::string &checksum)
  {
    series.push_back({time, next_file(), checksum});
    write_pvd();
  }


  std::vector<std::string>
  PvdSeries::restore(const std::vector<PvdEntry> &entries)
  {
    series = entries;
    std::vector<std::string> damaged;
    for (const PvdEntry &entry : series)
      if (!is_whole(join_path(folder, entry.file), entry.checksum))
        damaged.push_back(entry.file);

    // Files are numbered without gaps: those the checkpoint does not know
    // begin at the next number.
    std::error_code ignored;
    for (std::size_t number = series.size();; ++number)
      {
        const std::string path = join_path(folder, frame_name(fields, number));
        std::filesystem::remove(path + ".tmp", ignored);
        if (!std::filesystem::remove(path, ignored))
          break;
      }

    if (!series.empty())
      write_pvd();
    else
      std::filesystem::remove(join_path(folder, series_name(fields) + ".pvd"),
                              ignored);
    return damaged;
  }


  void
  PvdSeries::write_pvd() const
  {
    std::string text = "<?xml version=\"1.0\"?>\n"
                       "<VTKFile type=\"Collection\" version=\"0.1\" "
                       "byte_order=\"LittleEndian\">\n"
                       "<Collection>\n";
    for (const PvdEntry &entry : series)
      {
        char time[32];
        std::snprintf(time, sizeof(time), "%.10g", entry.time);
        text += "<DataSet timestep=\"" + std::string(time) +
                "\" group=\"\" part=\"0\" file=\"" + entry.file + "\"/>\n";
      }
    text += "</Collection>\n</VTKFile>\n";
    write_file(join_path(folder, series_name(fields) + ".pvd"), text);
  }
} // namespace Waker
