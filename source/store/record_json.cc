// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/numbers.h>
#include <waker/store/record_json.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace Waker
{
  namespace RecordJson
  {
    namespace
    {
      void
      check_range(const char           *key,
                  const PlausibleRange &range,
                  const double          value)
      {
        if (value >= range.low && value <= range.high)
          return;
        std::ostringstream problem;
        problem << "is " << value << ", outside of " << range.low << " to "
                << range.high;
        throw_wrong(key, problem.str());
      }


      const Json &
      three_numbers(const Json &json, const char *key)
      {
        if (!json.is_array() || json.size() != 3)
          throw_wrong(key, "does not hold three numbers each");
        return json;
      }
    } // namespace


    void
    throw_wrong(const char *key, const std::string &what)
    {
      throw std::runtime_error(std::string("\"") + key + "\" " + what);
    }


    Json
    json_of(const double value, const PlausibleRange &range)
    {
      return value >= range.low && value <= range.high ? Json(value)
                                                       : Json(nullptr);
    }


    Json
    json_of(const std::uint64_t value, const PlausibleRange &)
    {
      return value;
    }


    Json
    json_of(const unsigned int value, const PlausibleRange &)
    {
      return value;
    }


    Json
    json_of(const bool value, const PlausibleRange &)
    {
      return value;
    }


    Json
    json_of(const std::string &value, const PlausibleRange &)
    {
      return value;
    }


    Json
    json_of(const Outcome outcome, const PlausibleRange &)
    {
      return to_string(outcome);
    }


    Json
    json_of(const Unrest &unrest, const PlausibleRange &)
    {
      return Json::array({unrest.moving, unrest.loads_change, unrest.at_box});
    }


    Json
    json_of(const MovedSoil &soil, const PlausibleRange &)
    {
      return Json::array({json_of(soil.area, Plausible::area),
                          json_of(soil.dx, Plausible::length),
                          json_of(soil.dy, Plausible::length)});
    }


    Json
    json_of(const SlopeSlide &slide, const PlausibleRange &)
    {
      const MovingBody &body = slide.body;
      return Json::array({json_of(slide.time, Plausible::event_time),
                          json_of(body.area, Plausible::area),
                          json_of(body.share, Plausible::share),
                          json_of(body.distance, Plausible::length),
                          json_of(body.crest_cut, Plausible::length)});
    }


    Json
    json_of(const std::vector<TracePoint> &trace, const PlausibleRange &)
    {
      Json json = Json::array();
      for (const TracePoint &point : trace)
        json.push_back(Json::array({json_of(point.time, Plausible::duration),
                                    json_of(point.width, Plausible::length),
                                    json_of(point.height, Plausible::length)}));
      return json;
    }


    void
    read(const Json           &json,
         const char           *key,
         const PlausibleRange &range,
         double               &value)
    {
      if (json.is_null())
        value = nan;
      else if (json.is_number())
        {
          value = json.get<double>();
          check_range(key, range, value);
        }
      else
        throw_wrong(key, "is not a number");
    }


    void
    read(const Json           &json,
         const char           *key,
         const PlausibleRange &range,
         std::uint64_t        &value)
    {
      if (!json.is_number_unsigned())
        throw_wrong(key, "is not a whole number >= 0");
      value = json.get<std::uint64_t>();
      check_range(key, range, static_cast<double>(value));
    }


    void
    read(const Json           &json,
         const char           *key,
         const PlausibleRange &range,
         unsigned int         &value)
    {
      std::uint64_t number = 0;
      read(json, key, range, number);
      if (number > std::numeric_limits<unsigned int>::max())
        throw_wrong(key, "is too large");
      value = static_cast<unsigned int>(number);
    }


    void
    read(const Json &json, const char *key, const PlausibleRange &, bool &value)
    {
      if (!json.is_boolean())
        throw_wrong(key, "is neither true nor false");
      value = json.get<bool>();
    }


    void
    read(const Json &json,
         const char *key,
         const PlausibleRange &,
         std::string &value)
    {
      if (!json.is_string())
        throw_wrong(key, "is not a text");
      value = json.get<std::string>();
    }


    void
    read(const Json           &json,
         const char           *key,
         const PlausibleRange &range,
         Outcome              &outcome)
    {
      std::string name;
      read(json, key, range, name);
      if (!outcome_from_string(name, outcome))
        throw_wrong(key, "is '" + name + "', which is no outcome");
    }


    void
    read(const Json           &json,
         const char           *key,
         const PlausibleRange &range,
         Unrest               &unrest)
    {
      three_numbers(json, key);
      read(json[0], key, range, unrest.moving);
      read(json[1], key, range, unrest.loads_change);
      read(json[2], key, range, unrest.at_box);
    }


    void
    read(const Json &json,
         const char *key,
         const PlausibleRange &,
         MovedSoil &soil)
    {
      three_numbers(json, key);
      read(json[0], key, Plausible::area, soil.area);
      read(json[1], key, Plausible::length, soil.dx);
      read(json[2], key, Plausible::length, soil.dy);
    }


    void
    read(const Json &json,
         const char *key,
         const PlausibleRange &,
         SlopeSlide &slide)
    {
      if (!json.is_array() || json.size() != 5)
        throw_wrong(key, "does not hold five numbers");
      read(json[0], key, Plausible::event_time, slide.time);
      read(json[1], key, Plausible::area, slide.body.area);
      read(json[2], key, Plausible::share, slide.body.share);
      read(json[3], key, Plausible::length, slide.body.distance);
      read(json[4], key, Plausible::length, slide.body.crest_cut);
    }


    void
    read(const Json &json,
         const char *key,
         const PlausibleRange &,
         std::vector<TracePoint> &trace)
    {
      if (!json.is_array())
        throw_wrong(key, "is not a list");
      trace.resize(json.size());
      for (std::size_t i = 0; i < trace.size(); ++i)
        {
          const Json &point = three_numbers(json[i], key);
          read(point[0], key, Plausible::duration, trace[i].time);
          read(point[1], key, Plausible::length, trace[i].width);
          read(point[2], key, Plausible::length, trace[i].height);
        }
    }


    void
    put(Json                 &line,
        const char *const     key,
        const PlausibleRange &range,
        const SlopeSlide     &slide)
    {
      if (!std::isnan(slide.time))
        line.push_back({key, json_of(slide, range)});
    }


    void
    take(const Json           &line,
         const char *const     key,
         const PlausibleRange &range,
         SlopeSlide           &slide)
    {
      const auto found = line.find(key);
      slide            = SlopeSlide();
      if (found != line.end())
        read(*found, key, range, slide);
      else
        slide.time = nan;
    }


    void
    Hash::add(const Unrest &unrest)
    {
      for (const bool value :
           {unrest.moving, unrest.loads_change, unrest.at_box})
        add(value);
    }


    void
    Hash::add(const MovedSoil &soil)
    {
      add(soil.area);
      add(soil.dx);
      add(soil.dy);
    }


    void
    Hash::add(const SlopeSlide &slide)
    {
      if (std::isnan(slide.time))
        return;
      add(slide.time);
      add(slide.body.area);
      add(slide.body.share);
      add(slide.body.distance);
      // All kinds of NaN are one.
      add(std::isnan(slide.body.crest_cut) ? 1e300 : slide.body.crest_cut);
    }


    void
    Hash::add(const std::vector<TracePoint> &trace)
    {
      add(trace.size());
      for (const TracePoint &point : trace)
        {
          add(point.time);
          add(point.width);
          add(point.height);
        }
    }
  } // namespace RecordJson
} // namespace Waker
