// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_statistics_csv_table_h
#define waker_statistics_csv_table_h

#include <waker/statistics/estimates.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <type_traits>
#include <utility>

namespace Waker
{
  /// Lines of comma separated cells.
  class CsvTable
  {
  public:
    explicit CsvTable(const std::string &titles)
      : text(titles)
    {}

    CsvTable &
    row()
    {
      text += '\n';
      is_first = true;
      return *this;
    }

    CsvTable &
    cell(const std::string &value)
    {
      if (!is_first)
        text += ',';
      is_first = false;
      if (value.find_first_of(",\"\n") == std::string::npos)
        text += value;
      else
        {
          text += '"';
          for (const char c : value)
            text += c == '"' ? std::string("\"\"") : std::string(1, c);
          text += '"';
        }
      return *this;
    }

    CsvTable &
    cell(const double value)
    {
      if (!std::isfinite(value)) // no reader takes it for a number
        return cell(std::string("nan"));
      char buffer[40];
      std::snprintf(buffer, sizeof buffer, "%.12g", value);
      return cell(std::string(buffer));
    }

    template <typename Integer,
              typename = std::enable_if_t<std::is_integral<Integer>::value>>
    CsvTable &
    cell(const Integer value)
    {
      return cell(std::to_string(value));
    }

    /// P, low, high, kind, of a Proportion or a BoundedProbability
    template <typename Probability,
              typename = decltype(std::declval<Probability>().high)>
    CsvTable &
    cells(const Probability &p)
    {
      cell(p.estimate).cell(p.low).cell(p.high);
      return cell(to_string(kind_of(p.estimate)));
    }

    CsvTable &
    cells(const Estimate &e)
    {
      return cells(e.initial).cells(e.flooding).cells(e.flooding_given);
    }

    std::string
    finish() const
    {
      return text + '\n';
    }

  private:
    std::string text;
    bool        is_first = true;
  };


  /// Titles of a probability, its interval, and what the estimate says.
  inline std::string
  titles_of(const std::string &name)
  {
    return "," + name + "," + name + "_low," + name + "_high," + name + "_kind";
  }
} // namespace Waker

#endif
