// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/numbers.h>
#include <waker/statistics/field_columns.h>

#include <algorithm>
#include <cctype>

namespace Waker
{
  namespace
  {
    std::vector<std::string>
    names_in(const std::vector<const std::vector<Record> *> &records)
    {
      std::vector<std::string> names;
      for (const std::vector<Record> *some : records)
        for (const Record &record : *some)
          if (record.random_fields)
            for (const FieldSummary &field : *record.random_fields)
              if (std::find(names.begin(), names.end(), field.name) ==
                  names.end())
                names.push_back(field.name);
      return names;
    }


    std::function<double(const Record &)>
    value_of(const std::string &name, double FieldSummary::*const member)
    {
      return [name, member](const Record &record) {
        if (record.random_fields)
          for (const FieldSummary &field : *record.random_fields)
            if (field.name == name)
              return field.*member;
        return nan;
      };
    }
  } // namespace


  std::vector<FieldColumn>
  field_columns(const std::vector<const std::vector<Record> *> &records)
  {
    std::vector<FieldColumn> columns;
    std::vector<std::string> prefixes;
    for (const std::string &name : names_in(records))
      {
        std::string prefix = "field_" + name;
        for (char &c : prefix)
          if (!std::isalnum(static_cast<unsigned char>(c)))
            c = '_';
        while (std::find(prefixes.begin(), prefixes.end(), prefix) !=
               prefixes.end())
          prefix += "_"; // names that differ in such characters only
        prefixes.push_back(prefix);
        const std::string of = " of the random field " + name;
        columns.push_back({prefix + "_average_score",
                           "1",
                           "normal score of the average" + of,
                           value_of(name, &FieldSummary::average_score)});
        columns.push_back({prefix + "_mean",
                           "1",
                           "mass average, in the property's unit," + of,
                           value_of(name, &FieldSummary::mean)});
        columns.push_back({prefix + "_least",
                           "1",
                           "least value, in the property's unit," + of,
                           value_of(name, &FieldSummary::least)});
      }
    return columns;
  }
} // namespace Waker
