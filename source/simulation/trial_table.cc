// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/hash.h>
#include <waker/base/text.h>
#include <waker/output/files.h>
#include <waker/output/output_files.h>
#include <waker/simulation/trial_table.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <vector>

namespace Waker
{
  namespace
  {
    const std::string columns = "factor,failed,time_s,outcome";
    const std::string crc     = ",crc"; // not of earlier versions


    std::string
    line_of(const double factor, const Trial &trial)
    {
      char numbers[80];
      std::snprintf(numbers,
                    sizeof numbers,
                    "%.17g,%d,%.10g,",
                    factor,
                    trial.failed ? 1 : 0,
                    trial.time);
      return numbers + trial.outcome;
    }


    bool
    read_number(const std::string &text, double &value)
    {
      char *end = nullptr;
      value     = std::strtod(text.c_str(), &end);
      return !text.empty() && *end == '\0' && std::isfinite(value);
    }


    /// @return false if it is no line of a trial
    bool
    parse(const std::string &line, double &factor, Trial &trial)
    {
      const std::vector<std::string> parts = split(line, ',');
      if (parts.size() != 4 || !read_number(parts[0], factor) ||
          !read_number(parts[2], trial.time) ||
          (parts[1] != "0" && parts[1] != "1"))
        return false;
      trial.failed  = parts[1] == "1";
      trial.outcome = parts[3];
      return factor > 0. && trial.time >= 0. && trial.time < 1e12;
    }
  } // namespace


  TrialTable::TrialTable(const std::string &folder,
                         const std::string &key,
                         const bool         resume)
    : path(file_path(folder, OutputFile::strength_table))
    , key(key)
  {
    if (resume && std::filesystem::exists(path))
      read();
  }


  const Trial *
  TrialTable::find(const double factor) const
  {
    const auto it = trials.find(factor);
    return it != trials.end() ? &it->second : nullptr;
  }


  void
  TrialTable::add(const double factor, const Trial &trial)
  {
    trials[factor] = trial;
    write();
  }


  void
  TrialTable::write() const
  {
    std::string text = "# parameters " + key + "\n" + columns + crc + "\n";
    for (const auto &[factor, trial] : trials)
      {
        const std::string line = line_of(factor, trial);
        text += line + "," + checksum_of_text(line, key) + "\n";
      }
    write_file(path, text, /* to_disk = */ true);
  }


  void
  TrialTable::read()
  {
    std::istringstream file(read_file(path));
    std::string        line;
    if (std::getline(file, line) && line != "# parameters " + key)
      throw UserError("Output/Directory",
                      path + " belongs to another case",
                      "--resume with the parameters it was made with, or "
                      "--overwrite");
    std::getline(file, line);
    const bool is_plain = line == columns;
    while (std::getline(file, line))
      {
        const std::size_t comma = line.rfind(',');
        const std::string rest  = is_plain ? line : line.substr(0, comma);
        const bool        good =
          is_plain || (comma != std::string::npos &&
                       line.substr(comma + 1) == checksum_of_text(rest, key));
        double factor;
        Trial  trial;
        if (good && parse(rest, factor, trial))
          trials[factor] = trial;
        else
          ++n_dropped;
      }
  }
} // namespace Waker
