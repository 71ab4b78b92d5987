// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/base/time_function.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Waker
{
  namespace
  {
    const std::string allowed = "a number, an expression of t (s), or a table "
                                "\"t0: y0, t1: y1, ...\" with ascending times";


    double
    to_number(const std::string &text,
              const std::string &whole,
              const std::string &path)
    {
      double value = 0.;
      if (!read_number(text, value))
        throw UserError(path,
                        in_quotes(text) + " in " + in_quotes(whole) +
                          " is no number",
                        allowed + decimals_with_a_point);
      return value;
    }
  } // namespace


  TimeFunction::TimeFunction(const double value)
    : table(1, {0., value})
  {}


  TimeFunction::TimeFunction(const std::string &text, const std::string &path)
  {
    if (tidy(text).empty())
      throw UserError(path, "is empty", allowed);
    // A colon also belongs to "a ? b : c".
    if (text.find(':') != std::string::npos &&
        text.find('?') == std::string::npos)
      {
        for (const std::string &entry : split(text, ','))
          {
            const std::vector<std::string> parts = split(entry, ':');
            if (parts.size() != 2)
              throw UserError(path,
                              in_quotes(entry) + " in " + in_quotes(text) +
                                " is no pair of time and value",
                              allowed + decimals_with_a_point);
            const double t = to_number(parts[0], text, path);
            if (!table.empty() && !(t > table.back().first))
              throw UserError(path,
                              "the time " + parts[0] + " in " +
                                in_quotes(text) +
                                " does not come after the one before",
                              allowed);
            table.emplace_back(t, to_number(parts[1], text, path));
          }
        return;
      }

    const std::string or_a_table = ", or a table \"t0: y0, t1: y1, ...\"";
    std::shared_ptr<const Expression<2>> parsed;
    try
      {
        parsed = std::make_shared<const Expression<2>>(text, path, or_a_table);
      }
    catch (const UserError &)
      {
        // The same, with the variables that are allowed here.
        const NamedExpression of_time(text, path, {"t"}, or_a_table);
        throw;
      }
    if (!parsed->is_uniform())
      throw UserError(path, in_quotes(text) + " depends on the place", allowed);
    const double start = parsed->value(Point<2>(), 0.);
    if (!std::isfinite(start))
      throw UserError(path,
                      in_quotes(text) + " is not finite at t = 0",
                      allowed);
    if (parsed->moves())
      expression = std::move(parsed);
    else
      table.emplace_back(0., start);
  }


  double
  TimeFunction::value(const double t) const
  {
    if (expression)
      return expression->value(Point<2>(), t);
    const auto after = std::upper_bound(
      table.begin(), table.end(), t, [](const double time, const auto &entry) {
        return time < entry.first;
      });
    if (after == table.begin())
      return table.front().second;
    if (after == table.end())
      return table.back().second;
    const auto  &a     = *(after - 1);
    const double share = (t - a.first) / (after->first - a.first);
    return a.second + share * (after->second - a.second);
  }


  bool
  TimeFunction::moves() const
  {
    return expression != nullptr || table.size() > 1;
  }


  double
  TimeFunction::least() const
  {
    if (expression)
      return value(0.);
    return std::min_element(table.begin(),
                            table.end(),
                            [](const auto &a, const auto &b) {
                              return a.second < b.second;
                            })
      ->second;
  }


  double
  TimeFunction::last_change() const
  {
    if (expression)
      return expression->last_change();
    for (std::size_t i = table.size(); i-- > 1;)
      if (table[i].second != table[i - 1].second)
        return table[i].first;
    return LastChange::never;
  }


  double
  TimeFunction::next_corner(const double t) const
  {
    const auto after = std::upper_bound(
      table.begin(), table.end(), t, [](const double time, const auto &entry) {
        return time < entry.first;
      });
    return after == table.end() ? std::numeric_limits<double>::infinity()
                                : after->first;
  }


  double
  TimeFunction::time_of_largest() const
  {
    return table.empty() ? 0.
                         : std::max_element(table.begin(),
                                            table.end(),
                                            [](const auto &a, const auto &b) {
                                              return a.second < b.second;
                                            })
                             ->first;
  }


  bool
  TimeFunction::varies(const double from, const double to) const
  {
    if (expression)
      return expression->varies(Point<2>(), from, to);
    const double start = value(from);
    return value(to) != start ||
           std::any_of(table.begin(), table.end(), [&](const auto &entry) {
             return entry.first > from && entry.first < to &&
                    entry.second != start;
           });
  }
} // namespace Waker
