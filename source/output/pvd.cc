// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/output/files.h>
#include <waker/output/output_files.h>
#include <waker/output/pvd.h>

#include <cstdio>
#include <filesystem>

namespace Waker
{
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
  PvdSeries::add(const double time)
  {
    series.push_back({time, next_file()});
    write_pvd();
  }


  void
  PvdSeries::restore(const std::vector<PvdEntry> &entries)
  {
    series = entries;

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
