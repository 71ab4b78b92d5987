// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/loads/following_line.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  LineDelay::LineDelay(const std::string &text, const std::string &path)
  {
    const std::string allowed =
      "a delay (s) of at least 0; or \"x: delay, x: delay, ...\" (m, s), x "
      "ascending";
    const auto check = [&](const double delay) {
      if (!(delay >= 0. && std::isfinite(delay)))
        throw UserError(path, "is " + in_digits(delay) + " s", allowed);
    };
    double number = 0.;
    if (read_number(text, number))
      {
        check(number);
        places = {{{0., number}}};
        return;
      }
    places.clear();
    for (const std::string &item : split(text, ','))
      {
        const std::vector<std::string> parts = split(item, ':');
        std::array<double, 2>          place;
        if (parts.size() != 2 || !read_number(parts[0], place[0]) ||
            !read_number(parts[1], place[1]))
          throw UserError(path,
                          in_quotes(item) + " is no place and delay",
                          allowed);
        check(place[1]);
        if (!places.empty() && !(place[0] > places.back()[0]))
          throw UserError(path,
                          "has x = " + in_digits(place[0]) + " m after x = " +
                            in_digits(places.back()[0]) + " m",
                          allowed);
        places.push_back(place);
      }
    if (places.empty())
      throw UserError(path, "is empty", allowed);
  }


  double
  LineDelay::largest() const
  {
    double largest = 0.;
    for (const auto &place : places)
      largest = std::max(largest, place[1]);
    return largest;
  }


  void
  LineDelay::follow(const double         before,
                    const double         after,
                    const double         dt,
                    std::vector<double> &arrived) const
  {
    for (std::size_t i = 0; i < places.size(); ++i)
      {
        const double T = places[i][1];
        if (!(T > 0.) || !(dt > 0.))
          {
            arrived[i] = after;
            continue;
          }
        // The share that the step lets in, and that of the rise in the step:
        // 1 - (1 - e^-a)/a, which for little a is its series.
        const double a  = dt / T;
        const double in = -std::expm1(-a);
        const double of_rise =
          a < 1e-4 ? a * (0.5 - a * (1. / 6.)) : 1. - in / a;
        arrived[i] += in * (before - arrived[i]) + of_rise * (after - before);
      }
  }


  double
  LineDelay::level_at(const double x, const std::vector<double> &arrived) const
  {
    std::size_t i = 0;
    while (i < places.size() && places[i][0] < x)
      ++i;
    if (i == 0)
      return arrived.front();
    if (i == places.size())
      return arrived.back();
    const double share =
      (x - places[i - 1][0]) / (places[i][0] - places[i - 1][0]);
    return (1. - share) * arrived[i - 1] + share * arrived[i];
  }


  PhreaticLine
  FollowingLine::at(const std::vector<double> &arrived) const
  {
    if (arrived.size() == 1 || !moves())
      return lines.at(arrived.front());
    std::vector<double> corners;
    for (const auto &place : line_delay.all())
      corners.push_back(place[0]);
    for (const PhreaticLine &line : lines.all())
      for (const auto &corner : line.all())
        corners.push_back(corner[0]);
    return PhreaticLine(corners, [&](const double x) {
      return lines.at(line_delay.level_at(x, arrived)).height(x);
    });
  }
} // namespace Waker
