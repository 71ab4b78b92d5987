// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/choice.h>
#include <waker/base/errors.h>
#include <waker/base/hash.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/output/files.h>
#include <waker/output/output_files.h>
#include <waker/simulation/trial_table.h>

#include <cstdio>
#include <filesystem>
#include <sstream>
#include <vector>

namespace Waker
{
  namespace
  {
    const std::string columns =
      "factor,result,time_s,outcome,reading,slope,attempts";
    const std::string crc = ",crc";


    std::string
    line_of(const double factor, const Trial &trial)
    {
      char numbers[2][40];
      std::snprintf(numbers[0], sizeof numbers[0], "%.17g", factor);
      std::snprintf(numbers[1], sizeof numbers[1], "%.17g", trial.time);
      return std::string(numbers[0]) + "," + to_string(trial.result) + "," +
             numbers[1] + "," + to_string(trial.outcome) + "," +
             (trial.reading ? name_of(*trial.reading) : "") + "," +
             name_of(trial.slope) + "," + std::to_string(trial.attempts);
    }


    /// @return false if it is no line of a trial
    bool
    parse(const std::string &line, double &factor, Trial &trial)
    {
      const std::vector<std::string> parts = split(line, ',');
      double                         attempts;
      if (parts.size() != 7 || !read_number(parts[0], factor) ||
          !read_number(parts[2], trial.time) ||
          !read_number(parts[6], attempts))
        return false;
      bool is_result = false;
      for (const TrialResult result :
           {TrialResult::stable, TrialResult::failed, TrialResult::undecided})
        if (to_string(result) == parts[1])
          {
            trial.result = result;
            is_result    = true;
          }
      const std::optional<Slopes> slope = find_choice<Slopes>(parts[5]);
      trial.reading                     = find_choice<FailureReading>(parts[4]);
      if (!is_result || !outcome_from_string(parts[3], trial.outcome) ||
          (!trial.reading && !parts[4].empty()) || !slope || !(factor > 0.) ||
          !(trial.time >= 0.) || !(trial.time < 1e12) || !(attempts >= 1.) ||
          !(attempts < 1e6))
        return false;
      trial.slope    = *slope;
      trial.attempts = static_cast<unsigned int>(attempts);
      return true;
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
    if (!std::getline(file, line) || line != "# parameters " + key ||
        !std::getline(file, line) || line != columns + crc)
      throw UserError("Output/Directory",
                      path + " belongs to another case or version",
                      "--resume with the parameters it was made with, or "
                      "--overwrite");
    while (std::getline(file, line))
      {
        const std::size_t comma = line.rfind(',');
        const std::string rest  = line.substr(0, comma);
        const bool        good  = comma != std::string::npos &&
                          line.substr(comma + 1) == checksum_of_text(rest, key);
        double factor;
        Trial  trial;
        if (good && parse(rest, factor, trial))
          trials[factor] = trial;
        else
          ++n_dropped;
      }
  }
} // namespace Waker
