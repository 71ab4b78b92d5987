// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/store/record.h>
#include <waker/store/record_json.h>

#include <cmath>
#include <stdexcept>

namespace Waker
{
  namespace
  {
    /// Call f(key, member, plausible range) for each member that is a result,
    /// in the order of the line. One that is new, and that the lines of today
    /// do not have, is a std::optional.
    template <typename Self, typename Function>
    void
    for_each_result(Self &s, const Function &f)
    {
      using namespace Plausible;
      f("scenario", s.scenario, count);
      f("realisation", s.realisation, count);
      f("outcome", s.outcome, any);
      f("stop_reason", s.stop_reason, any);
      f("attempts", s.attempts, count);
      f("unrest", s.unrest, any);
      f("initial_time", s.initial_time, event_time);
      f("initial_time_thesis", s.initial_time_thesis, event_time);
      f("flooding_time", s.flooding_time, event_time);
      f("end_time", s.end_time, duration);
      f("initial_width", s.initial_width, length);
      f("initial_height", s.initial_height, length);
      f("residual_width", s.residual_width, length);
      f("residual_height", s.residual_height, length);
      f("inward", s.inward, any);
      f("outward", s.outward, any);
      f("first_inward", s.first_inward, any);
      f("first_outward", s.first_outward, any);
      f("mean_strength", s.mean_strength, strength);
      f("least_strength", s.least_strength, strength);
      f("steps", s.steps, count);
      f("newton_iterations", s.newton_iterations, count);
      f("linear_iterations", s.linear_iterations, count);
      f("unconverged_steps", s.unconverged_steps, count);
      f("trace", s.trace, any);
      f("inner_slide", s.inner_slide, any);
      f("outer_slide", s.outer_slide, any);
      f("sliding_masses", s.sliding_masses, any);
      f("residual_width_z", s.residual_width_z, length);
      f("residual_height_z", s.residual_height_z, length);
      f("load", s.load, any);
      f("load_stop_time", s.load_stop_time, event_time);
      f("random_fields", s.random_fields, any);
      f("points_beyond_law", s.points_beyond_law, count);
    }


    /// The others: they differ each time, and decide nothing.
    template <typename Self, typename Function>
    void
    for_each_timing(Self &s, const Function &f)
    {
      using namespace Plausible;
      f("wall_time", s.wall_time, duration);
      f("field_time", s.field_time, duration);
      f("ranks", s.ranks, count);
    }
  } // namespace



  bool
  Record::watches_slopes() const
  {
    return !std::isnan(inner_slide.time);
  }


  std::string
  to_json(const Record &record)
  {
    RecordJson::Json json = RecordJson::Json::object();
    const auto       put =
      [&](const char *key, const auto &member, const PlausibleRange &range) {
        RecordJson::put(json, key, range, member);
      };
    for_each_result(record, put);
    for_each_timing(record, put);
    // A message of a library may not be UTF-8: better a mark in it than no
    // record.
    return json.dump(-1,
                     ' ',
                     false,
                     RecordJson::Json::error_handler_t::replace);
  }



  Record
  record_from_json(const std::string &text)
  {
    const auto json = RecordJson::Json::parse(text, nullptr, false);
    if (!json.is_object())
      throw std::runtime_error("not a JSON object");

    Record     record;
    const auto take =
      [&](const char *key, auto &member, const PlausibleRange &range) {
        RecordJson::take(json, key, range, member);
      };
    for_each_result(record, take);
    for_each_timing(record, take);
    return record;
  }



  std::uint64_t
  fingerprint(const Record &record)
  {
    RecordJson::Hash hash;
    for_each_result(record,
                    [&](const char *,
                        const auto &member,
                        const PlausibleRange &) { hash.add(member); });
    return hash.state;
  }
} // namespace Waker
