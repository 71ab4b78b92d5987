// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/reliability/record.h>

#include <array>
#include <boost/functional/hash.hpp>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace Waker
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    const std::array<std::string, 4> outcome_names = {
      {"stable", "initial failure", "flooding", "numerical failure"}};


    [[noreturn]] void
    throw_wrong(const char *key, const std::string &what)
    {
      throw std::runtime_error(std::string("\"") + key + "\" " + what);
    }


    Json
    json_of(const double value)
    {
      return std::isfinite(value) ? Json(value) : Json(nullptr);
    }


    Json
    json_of(const std::uint64_t value)
    {
      return value;
    }


    Json
    json_of(const unsigned int value)
    {
      return value;
    }


    Json
    json_of(const std::string &value)
    {
      return value;
    }


    Json
    json_of(const Outcome outcome)
    {
      return to_string(outcome);
    }


    Json
    json_of(const MovedSoil &soil)
    {
      return Json::array(
        {json_of(soil.area), json_of(soil.dx), json_of(soil.dy)});
    }


    Json
    json_of(const std::vector<TracePoint> &trace)
    {
      Json json = Json::array();
      for (const TracePoint &point : trace)
        json.push_back(Json::array(
          {json_of(point.time), json_of(point.width), json_of(point.height)}));
      return json;
    }


    void
    read(const Json &json, const char *key, double &value)
    {
      if (json.is_null())
        value = std::numeric_limits<double>::quiet_NaN();
      else if (json.is_number())
        value = json.get<double>();
      else
        throw_wrong(key, "is not a number");
    }


    void
    read(const Json &json, const char *key, std::uint64_t &value)
    {
      if (!json.is_number_unsigned())
        throw_wrong(key, "is not a whole number >= 0");
      value = json.get<std::uint64_t>();
    }


    void
    read(const Json &json, const char *key, unsigned int &value)
    {
      std::uint64_t number = 0;
      read(json, key, number);
      if (number > std::numeric_limits<unsigned int>::max())
        throw_wrong(key, "is too large");
      value = static_cast<unsigned int>(number);
    }


    void
    read(const Json &json, const char *key, std::string &value)
    {
      if (!json.is_string())
        throw_wrong(key, "is not a text");
      value = json.get<std::string>();
    }


    void
    read(const Json &json, const char *key, Outcome &outcome)
    {
      std::string name;
      read(json, key, name);
      for (std::size_t i = 0; i < outcome_names.size(); ++i)
        if (name == outcome_names[i])
          {
            outcome = static_cast<Outcome>(i);
            return;
          }
      throw_wrong(key, "is '" + name + "', which is no outcome");
    }


    const Json &
    three_numbers(const Json &json, const char *key)
    {
      if (!json.is_array() || json.size() != 3)
        throw_wrong(key, "does not hold three numbers each");
      return json;
    }


    void
    read(const Json &json, const char *key, MovedSoil &soil)
    {
      three_numbers(json, key);
      read(json[0], key, soil.area);
      read(json[1], key, soil.dx);
      read(json[2], key, soil.dy);
    }


    void
    read(const Json &json, const char *key, std::vector<TracePoint> &trace)
    {
      if (!json.is_array())
        throw_wrong(key, "is not a list");
      trace.resize(json.size());
      for (std::size_t i = 0; i < trace.size(); ++i)
        {
          const Json &point = three_numbers(json[i], key);
          read(point[0], key, trace[i].time);
          read(point[1], key, trace[i].width);
          read(point[2], key, trace[i].height);
        }
    }


    /// Call f(key, member) for each member that is a result, in the order of
    /// the line.
    template <typename Self, typename Function>
    void
    for_each_result(Self &s, const Function &f)
    {
      f("scenario", s.scenario);
      f("realisation", s.realisation);
      f("outcome", s.outcome);
      f("stop_reason", s.stop_reason);
      f("attempts", s.attempts);
      f("initial_time", s.initial_time);
      f("initial_time_thesis", s.initial_time_thesis);
      f("flooding_time", s.flooding_time);
      f("end_time", s.end_time);
      f("initial_width", s.initial_width);
      f("initial_height", s.initial_height);
      f("residual_width", s.residual_width);
      f("residual_height", s.residual_height);
      f("inward", s.inward);
      f("outward", s.outward);
      f("first_inward", s.first_inward);
      f("first_outward", s.first_outward);
      f("mean_strength", s.mean_strength);
      f("least_strength", s.least_strength);
      f("steps", s.steps);
      f("newton_iterations", s.newton_iterations);
      f("linear_iterations", s.linear_iterations);
      f("unconverged_steps", s.unconverged_steps);
      f("trace", s.trace);
    }


    /// The others: they differ each time.
    template <typename Self, typename Function>
    void
    for_each_timing(Self &s, const Function &f)
    {
      f("wall_time", s.wall_time);
      f("field_time", s.field_time);
    }


    class Hash
    {
    public:
      template <typename Value>
      void
      add(const Value &value)
      {
        boost::hash_combine(state, value);
      }

      void
      add(const MovedSoil &soil)
      {
        add(soil.area);
        add(soil.dx);
        add(soil.dy);
      }

      void
      add(const std::vector<TracePoint> &trace)
      {
        add(trace.size());
        for (const TracePoint &point : trace)
          {
            add(point.time);
            add(point.width);
            add(point.height);
          }
      }

      std::size_t state = 0;
    };
  } // namespace



  std::string
  to_string(const Outcome outcome)
  {
    return outcome_names.at(static_cast<std::size_t>(outcome));
  }



  std::string
  to_json(const Record &record)
  {
    Json       json = Json::object();
    const auto put  = [&](const char *key, const auto &member) {
      json.push_back({key, json_of(member)});
    };
    for_each_result(record, put);
    for_each_timing(record, put);
    // A message of a library may not be UTF-8: better a mark in it than no
    // record.
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  }



  Record
  record_from_json(const std::string &text)
  {
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object())
      throw std::runtime_error("not a JSON object");

    Record     record;
    const auto take = [&](const char *key, auto &member) {
      const auto found = json.find(key);
      if (found == json.end())
        throw_wrong(key, "is missing");
      read(*found, key, member);
    };
    for_each_result(record, take);
    for_each_timing(record, take);
    return record;
  }



  std::uint64_t
  fingerprint(const Record &record)
  {
    Hash hash;
    for_each_result(record, [&](const char *, const auto &member) {
      hash.add(member);
    });
    return hash.state;
  }
} // namespace Waker
