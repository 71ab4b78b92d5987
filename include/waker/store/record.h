// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_store_record_h
#define waker_store_record_h

#include <waker/control/outcome.h>
#include <waker/measures/failure_record.h>
#include <waker/measures/moved_soil.h>
#include <waker/measures/sliding_masses.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace Waker
{
  /// Geometry at a moment: what slides are found in.
  struct TracePoint
  {
    double time;   // s
    double width;  // W, m
    double height; // H, m
  };

  /// A random field of a realisation at t = 0.
  struct FieldSummary
  {
    std::string name;
    /// Normal score of its average, as a random variable; NaN: it has none.
    double average_score;
    double mean; // by mass, of the property's unit
    double least;
  };

  /**
   * What a campaign keeps of one realisation: one line of JSON in a journal.
   * Times are -1 if the event did not occur. Members that the lines of earlier
   * versions lack are std::optional (see record_json.h); the slides by
   * displacement, which those of version 0.1 lack, then have the time NaN.
   */
  struct Record : FailureEvents
  {
    unsigned int  scenario    = 0; // of the sweep; 0 without one
    std::uint64_t realisation = 0;
    Outcome       outcome     = Outcome::stable;
    std::string   stop_reason;  // in words; of a numerical failure: what failed
    unsigned int  attempts = 1; // 2 and more: repeated with a smaller step

    /// What keeps the end from being final. Not known of numerical failures,
    /// nor of lines of Waker 0.1.
    std::optional<Unrest> unrest;

    double end_time        = 0.; // s
    double initial_width   = 0.; // W_i, m
    double initial_height  = 0.; // H_i, m
    double residual_width  = 0.; // W_r, at the end, m
    double residual_height = 0.; // H_r, m
    /// z of the narrowest and of the lowest section then, in space (m).
    std::optional<double> residual_width_z;
    std::optional<double> residual_height_z;

    /// At the end; inner side is where the water is not (positive x if the
    /// water stands on the left).
    MovedSoil inward, outward;
    /// One second after S1, or at the end if that comes first.
    MovedSoil first_inward, first_outward;

    double mean_strength  = 0.; // mass average of the first random field
    double least_strength = 0.;
    /// Of all random fields, in their order; empty if there is one alone,
    /// without an average of its own.
    std::optional<std::vector<FieldSummary>> random_fields;
    /// Points at t = 0 to which the draw gives what their law would refuse, as
    /// a dilatancy angle above the friction angle, which counts as the most
    /// that the law takes.
    std::optional<std::uint64_t> points_beyond_law;

    std::uint64_t steps             = 0;
    std::uint64_t newton_iterations = 0;
    std::uint64_t linear_iterations = 0;
    std::uint64_t unconverged_steps = 0;
    double        wall_time         = 0.; // s
    double        field_time        = 0.; // of which for the fields, s
    /// That have computed it together, if there were several.
    std::optional<unsigned int> ranks;

    /// If they were watched.
    std::optional<SlidingMasses> sliding_masses;

    /// Of the first load programme, if there is one: its factor at the end, in
    /// its unit, and when it was stopped for good (s; -1: never): then it is
    /// the ultimate load.
    std::optional<double> load;
    std::optional<double> load_stop_time;

    /// Only if the dyke failed: the geometry whenever it changes by more than
    /// 0.02 m, with the last moment before the change, the first and the last.
    std::vector<TracePoint> trace;

    /// Was the reading by displacement made? Not by version 0.1.
    bool
    watches_slopes() const;
  };

  /// One line of JSON without its end. Numbers come back with the same bits;
  /// all that is not finite comes back as NaN.
  std::string
  to_json(const Record &record);

  /**
   * Of the values of to_json(); unknown ones are passed over.
   *
   * @throws std::runtime_error with what is wrong: not JSON, a value missing,
   *         of another kind, or outside of what is possible
   */
  Record
  record_from_json(const std::string &text);

  /// A hash of all but the times that the computer took: two readings of one
  /// realisation are the same result if it is equal.
  std::uint64_t
  fingerprint(const Record &record);
} // namespace Waker

#endif
