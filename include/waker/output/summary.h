// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_summary_h
#define waker_output_summary_h

#include <waker/measures/sliding_masses.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace Waker
{
  /// A slide of one slope, as it was when it was seen (see SlopeSlide).
  struct SlideSummary
  {
    double                time  = 0.; // s
    double                area  = 0.; // m^2
    double                share = 0.; // of the profile
    std::optional<double> crest_cut;  // x, m; empty: it left the crest alone
  };

  /// How far a load programme has got.
  struct LoadSummary
  {
    std::string           name;
    std::string           unit; // of the factor
    double                factor   = 0.;
    double                held_for = 0.; // time that it has waited, s
    std::optional<double> stop_time; // s; then the factor is the ultimate load
  };

  /**
   * What came out of a run: summary.json. Its keys are the names of the
   * members; slides and times that did not occur, and numbers that are not
   * finite, are null.
   */
  struct Summary
  {
    static constexpr unsigned int current_schema_version = 1;

    unsigned int schema_version = current_schema_version;

    /// In the words of to_string(Outcome), control/outcome.h.
    std::string outcome;
    /// What keeps the last state from being final (Unrest); summaries of
    /// earlier versions do not say.
    std::optional<bool> still_moving;
    std::optional<bool> loads_change;
    std::optional<bool> at_box;
    /// Why the run ended, in words.
    std::string stop_reason;

    /// By width or height, by loss of width (the thesis's reading) and by
    /// displacement (see FailureRecord), s.
    std::optional<double> initial_failure_time;
    std::optional<double> initial_failure_time_thesis;
    std::optional<double> initial_failure_time_displacement;
    /// The slopes that slid, by displacement: "inner", "outer", "both" or "".
    std::string                 slope;
    std::optional<SlideSummary> inner_slide;
    std::optional<SlideSummary> outer_slide;
    std::optional<double>       flooding_time;
    /// If they were watched.
    std::optional<SlidingMasses> sliding_masses;

    double initial_width   = 0.; // W_i, m
    double residual_width  = 0.; // W at the end, m
    double residual_height = 0.; // H at the end, m
    /// z of these, in space (m).
    std::optional<double> residual_width_z;
    std::optional<double> residual_height_z;
    double                end_time = 0.; // s

    std::uint64_t steps             = 0;
    std::uint64_t newton_iterations = 0;
    std::uint64_t linear_iterations = 0;
    std::uint64_t unconverged_steps = 0;
    /// Of a scheme with long steps (LongSteps): their number, the time that
    /// they took together (s), and how often the dyke moved in between.
    std::optional<std::uint64_t> long_steps;
    std::optional<double>        time_at_rest;
    std::optional<std::uint64_t> motions;
    /// None if there was no case: its gravity step did not converge.
    std::optional<std::uint64_t> particles;
    /// Tractions that at some time had no surface left to load.
    std::uint64_t vanished_tractions = 0;

    /// One for each load programme; earlier versions had none.
    std::vector<LoadSummary> loads;

    double wall_time = 0.; // s

    /// Of the input and the run: what is allowed, but likely not meant.
    std::vector<std::string> warnings;

    /// Parameters::hash
    std::string parameters_hash;

    // Of the program that runs; filled in by the constructor.
    std::string version;
    std::string compiler;
    std::string build_flags;

    Summary();

    /// As temporary file and rename.
    /// @throws as throw_cannot_write() if it cannot be written
    void
    write(const std::string &path) const;

    /// @throws UserError with the path if the file is missing, is not a
    ///         summary, or has a newer schema version
    static Summary
    read(const std::string &path);
  };
} // namespace Waker

#endif
