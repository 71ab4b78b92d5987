// SPDX-License-Identifier: LGPL-2.1-or-later
// How the random fields of a record become JSON and come back.
#include <waker/store/record_json.h>

#include <cmath>

namespace Waker
{
  namespace RecordJson
  {
    Json
    json_of(const std::vector<FieldSummary> &fields, const PlausibleRange &)
    {
      Json json = Json::array();
      for (const FieldSummary &field : fields)
        json.push_back(
          Json::array({field.name,
                       json_of(field.average_score, Plausible::any),
                       json_of(field.mean, Plausible::strength),
                       json_of(field.least, Plausible::strength)}));
      return json;
    }


    void
    read(const Json &json,
         const char *key,
         const PlausibleRange &,
         std::vector<FieldSummary> &fields)
    {
      if (!json.is_array())
        throw_wrong(key, "is not a list");
      fields.clear();
      for (const Json &one : json)
        {
          if (!one.is_array() || one.size() != 4)
            throw_wrong(key, "does not hold a name and three numbers each");
          FieldSummary field;
          read(one[0], key, Plausible::any, field.name);
          read(one[1], key, Plausible::any, field.average_score);
          read(one[2], key, Plausible::strength, field.mean);
          read(one[3], key, Plausible::strength, field.least);
          fields.push_back(field);
        }
    }


    void
    Hash::add(const std::vector<FieldSummary> &fields)
    {
      add(fields.size());
      for (const FieldSummary &field : fields)
        {
          add(field.name);
          // All kinds of NaN are one.
          for (const double value :
               {field.average_score, field.mean, field.least})
            add(std::isnan(value) ? 1e300 : value);
        }
    }
  } // namespace RecordJson
} // namespace Waker
