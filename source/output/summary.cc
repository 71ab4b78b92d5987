// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/version.h>
#include <waker/output/files.h>
#include <waker/output/summary.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace Waker
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    template <typename Value>
    Json
    to_json(const std::optional<Value> &value)
    {
      return value ? Json(*value) : Json(nullptr);
    }


    template <typename Value>
    void
    from_json(const Json &json, std::optional<Value> &value)
    {
      if (json.is_null())
        value.reset();
      else
        value = json.get<Value>();
    }


    /// Members that earlier versions did not write.
    template <typename Member>
    constexpr bool is_new = std::is_same_v<Member, std::optional<bool>>;


    void
    from_json(const Json &json, double &value)
    {
      value = json.is_null() ? nan : json.get<double>();
    }


    void
    from_json(const Json &json, std::string &value)
    {
      value = json.get<std::string>();
    }


    void
    from_json(const Json &json, std::vector<std::string> &value)
    {
      value = json.get<std::vector<std::string>>();
    }


    template <typename Integer>
    void
    from_json(const Json &json, Integer &value)
    {
      value = json.get<Integer>();
    }


    Json
    to_json(const double value)
    {
      return std::isfinite(value) ? Json(value) : Json(nullptr);
    }


    template <typename Other>
    Json
    to_json(const Other &value)
    {
      return Json(value);
    }


    Json
    to_json(const std::optional<SlideSummary> &slide)
    {
      if (!slide)
        return nullptr;
      return {{"time", to_json(slide->time)},
              {"area", to_json(slide->area)},
              {"share", to_json(slide->share)},
              {"crest_cut", to_json(slide->crest_cut)}};
    }


    void
    from_json(const Json &json, std::optional<SlideSummary> &slide)
    {
      slide.reset();
      if (json.is_null())
        return;
      slide.emplace();
      from_json(json.at("time"), slide->time);
      from_json(json.at("area"), slide->area);
      from_json(json.at("share"), slide->share);
      from_json(json.at("crest_cut"), slide->crest_cut);
    }


    Json
    to_json(const std::optional<SlidingMasses> &sliding)
    {
      if (!sliding)
        return nullptr;
      const auto object_of = [](const auto &numbers) {
        Json json = Json::object();
        numbers.for_each_number(numbers,
                                [&](const char *const name,
                                    const double      number,
                                    SlidingQuantity) {
                                  json[name] = to_json(number);
                                });
        return json;
      };
      Json json = object_of(*sliding);
      json["relative_failure_volume"] =
        to_json(sliding->relative_failure_volume());
      json["masses"] = Json::array();
      for (const SlidingMass &mass : sliding->masses)
        json["masses"].push_back(object_of(mass));
      return json;
    }


    Json
    to_json(const std::vector<LoadSummary> &loads)
    {
      Json list = Json::array();
      for (const LoadSummary &load : loads)
        list.push_back({{"name", load.name},
                        {"unit", load.unit},
                        {"factor", to_json(load.factor)},
                        {"held_for", to_json(load.held_for)},
                        {"stop_time", to_json(load.stop_time)}});
      return list;
    }


    void
    from_json(const Json &json, std::optional<SlidingMasses> &sliding)
    {
      sliding.reset();
      if (json.is_null())
        return;
      const auto read = [](const Json &object, auto &numbers) {
        numbers.for_each_number(numbers,
                                [&](const char *const name,
                                    double           &number,
                                    SlidingQuantity) {
                                  from_json(object.at(name), number);
                                });
      };
      sliding.emplace();
      read(json, *sliding);
      for (const Json &object : json.at("masses"))
        read(object, sliding->masses.emplace_back());
    }


    void
    from_json(const Json &json, std::vector<LoadSummary> &loads)
    {
      loads.clear();
      for (const Json &one : json)
        {
          LoadSummary load;
          from_json(one.at("name"), load.name);
          from_json(one.at("unit"), load.unit);
          from_json(one.at("factor"), load.factor);
          from_json(one.at("held_for"), load.held_for);
          from_json(one.at("stop_time"), load.stop_time);
          loads.push_back(load);
        }
    }


    /// Call f(key, member) for each member that older summaries do not have.
    template <typename Self, typename Function>
    void
    for_each_later_member(Self &s, const Function &f)
    {
      f("initial_failure_time_displacement",
        s.initial_failure_time_displacement);
      f("slope", s.slope);
      f("inner_slide", s.inner_slide);
      f("outer_slide", s.outer_slide);
      f("sliding_masses", s.sliding_masses);
      f("residual_width_z", s.residual_width_z);
      f("residual_height_z", s.residual_height_z);
      f("loads", s.loads);
      f("long_steps", s.long_steps);
      f("time_at_rest", s.time_at_rest);
      f("motions", s.motions);
    }


    /// Call f(key, member) for each of the others, in the order of the file.
    template <typename Self, typename Function>
    void
    for_each_member(Self &s, const Function &f)
    {
      f("schema_version", s.schema_version);
      f("outcome", s.outcome);
      f("stop_reason", s.stop_reason);
      f("still_moving", s.still_moving);
      f("loads_change", s.loads_change);
      f("at_box", s.at_box);
      f("initial_failure_time", s.initial_failure_time);
      f("initial_failure_time_thesis", s.initial_failure_time_thesis);
      f("flooding_time", s.flooding_time);
      f("initial_width", s.initial_width);
      f("residual_width", s.residual_width);
      f("residual_height", s.residual_height);
      f("end_time", s.end_time);
      f("steps", s.steps);
      f("newton_iterations", s.newton_iterations);
      f("linear_iterations", s.linear_iterations);
      f("unconverged_steps", s.unconverged_steps);
      f("particles", s.particles);
      f("vanished_tractions", s.vanished_tractions);
      f("wall_time", s.wall_time);
      f("warnings", s.warnings);
      f("parameters_hash", s.parameters_hash);
      f("version", s.version);
      f("compiler", s.compiler);
      f("build_flags", s.build_flags);
    }
  } // namespace


  Summary::Summary()
    : version(WAKER_VERSION)
#ifdef __clang__
    , compiler("clang " __clang_version__)
#else
    , compiler("g++ " __VERSION__)
#endif
    , build_flags(WAKER_BUILD_TYPE ", native " WAKER_NATIVE)
  {}


  void
  Summary::write(const std::string &path) const
  {
    Json       json = Json::object();
    const auto put  = [&](const char *const key, const auto &member) {
      json[key] = to_json(member);
    };
    for_each_member(*this, put);
    for_each_later_member(*this, put);
    write_file(path, json.dump(2) + "\n");
  }


  Summary
  Summary::read(const std::string &path)
  {
    Summary summary;
    try
      {
        const Json json    = Json::parse(read_file(path));
        const auto version = json.at("schema_version").get<unsigned int>();
        if (version > current_schema_version)
          throw UserError(path,
                          "has schema version " + std::to_string(version),
                          "versions up to " +
                            std::to_string(current_schema_version));
        for_each_member(summary, [&](const char *const key, auto &member) {
          const bool is_later = std::string(key) == "warnings";
          if (!(is_later || is_new<std::decay_t<decltype(member)>>) ||
              json.contains(key))
            from_json(json.at(key), member);
        });
        for_each_later_member(summary,
                              [&](const char *const key, auto &member) {
                                if (json.contains(key))
                                  from_json(json.at(key), member);
                              });
      }
    catch (const nlohmann::json::exception &e)
      {
        throw UserError(path,
                        std::string("is not a summary: ") + e.what(),
                        "a summary.json written by Waker");
      }
    return summary;
  }
} // namespace Waker
