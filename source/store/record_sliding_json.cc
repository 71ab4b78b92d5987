// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/store/record_json.h>

#include <cmath>

// Slides as columns: their numbers under one key each, in order of time. So a
// number that later versions add is a key more, and a line stays short.

namespace Waker
{
  namespace RecordJson
  {
    namespace
    {
      constexpr char masses_key[] = "masses";


      const PlausibleRange &
      range_of(const SlidingQuantity quantity)
      {
        switch (quantity)
          {
            case SlidingQuantity::time:
              return Plausible::duration;
            case SlidingQuantity::length:
              return Plausible::length;
            case SlidingQuantity::volume:
              return Plausible::area;
            case SlidingQuantity::direction:
              return Plausible::direction;
          }
        return Plausible::any;
      }


      const Json &
      member(const Json &json, const char *key, const char *name)
      {
        if (!json.is_object() || !json.contains(name))
          throw_wrong(key, std::string("has no \"") + name + "\"");
        return json.at(name);
      }
    } // namespace


    Json
    json_of(const SlidingMasses &sliding, const PlausibleRange &)
    {
      Json json = Json::object();
      SlidingMasses::for_each_number(sliding,
                                     [&](const char           *name,
                                         const double          number,
                                         const SlidingQuantity quantity) {
                                       json[name] =
                                         json_of(number, range_of(quantity));
                                     });
      Json              columns = Json::object();
      const SlidingMass none; // lists also if there is no mass
      SlidingMass::for_each_number(
        none, [&](const char *name, const double, SlidingQuantity) {
          columns[name] = Json::array();
        });
      for (const SlidingMass &mass : sliding.masses)
        SlidingMass::for_each_number(mass,
                                     [&](const char           *name,
                                         const double          number,
                                         const SlidingQuantity quantity) {
                                       columns[name].push_back(
                                         json_of(number, range_of(quantity)));
                                     });
      json[masses_key] = std::move(columns);
      return json;
    }


    void
    read(const Json &json,
         const char *key,
         const PlausibleRange &,
         SlidingMasses &sliding)
    {
      SlidingMasses::for_each_number(
        sliding,
        [&](const char *name, double &number, const SlidingQuantity quantity) {
          read(member(json, key, name), key, range_of(quantity), number);
        });
      const Json &columns = member(json, key, masses_key);
      const Json &times   = member(columns, key, "time");
      if (!times.is_array())
        throw_wrong(key, "has masses that are no lists");
      sliding.masses.assign(times.size(), SlidingMass());
      for (std::size_t k = 0; k < times.size(); ++k)
        SlidingMass::for_each_number(
          sliding.masses[k],
          [&](const char           *name,
              double               &number,
              const SlidingQuantity quantity) {
            const Json &column = member(columns, key, name);
            if (!column.is_array() || column.size() != times.size())
              throw_wrong(key, "has lists of different lengths");
            read(column[k], key, range_of(quantity), number);
          });
    }


    void
    Hash::add(const SlidingMasses &sliding)
    {
      // All kinds of NaN are one.
      const auto add_number =
        [&](const char *, const double number, SlidingQuantity) {
          add(std::isnan(number) ? 1e300 : number);
        };
      SlidingMasses::for_each_number(sliding, add_number);
      add(sliding.masses.size());
      for (const SlidingMass &mass : sliding.masses)
        SlidingMass::for_each_number(mass, add_number);
    }
  } // namespace RecordJson
} // namespace Waker
