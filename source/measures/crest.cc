// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/measures/crest.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    /// Share of a point's size below which two ends are one.
    constexpr double same_end = 1e-3;


    /// Ends of the points' domains along z at t = 0, ascending, each once. In
    /// 2D there is one strip.
    template <int dim>
    std::vector<double>
    ends_along_z(const MaterialPoints<dim> &points)
    {
      std::vector<double> ends = {0., 1.};
      if constexpr (dim == 3)
        {
          ends.clear();
          double least = std::numeric_limits<double>::max();
          for (std::size_t p = 0; p < points.n_points(); ++p)
            {
              const double half = initial_half_size(points, p)[2];
              least             = std::min(least, half);
              for (const double side : {-half, half})
                ends.push_back(points.initial_position[p][2] + side);
            }
          std::sort(ends.begin(), ends.end());
          const auto is_same = [&](const double a, const double b) {
            return b - a <= 2. * least * same_end;
          };
          ends.erase(std::unique(ends.begin(), ends.end(), is_same),
                     ends.end());
        }
      return ends;
    }
  } // namespace


  template <int dim>
  Crest<dim>::Crest(const MaterialPoints<dim>   &points,
                    const int                    direction,
                    const std::optional<double> &edge)
    : sign(direction)
    , ends(ends_along_z(points))
    , strips(ends.size() > 1 ? ends.size() - 1 : 0)
  {
    if (edge)
      given_edge = sign * *edge;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      for_each_strip(points, p, [&](const std::size_t s) {
        strips[s].top = std::max(strips[s].top,
                                 points.initial_position[p][1] +
                                   initial_half_size(points, p)[1]);
      });
    for (std::size_t p = 0; p < points.n_points(); ++p)
      for_each_strip(points, p, [&](const std::size_t s) {
        Strip &strip = strips[s];
        if (!is_crest(points, p, strip))
          return;
        ++strip.n;
        const double half = initial_half_size(points, p)[0];
        strip.front       = std::max(strip.front, front(points, p));
        strip.rear        = std::min(strip.rear, front(points, p) - 2. * half);
      });
  }


  template <int dim>
  template <typename Function>
  void
  Crest<dim>::for_each_strip(const MaterialPoints<dim> &points,
                             const std::size_t          p,
                             const Function            &f) const
  {
    if constexpr (dim == 2)
      f(0);
    else
      {
        // Strips of which the middle lies in the point's domain.
        const double z    = points.initial_position[p][2];
        const double half = initial_half_size(points, p)[2];
        auto         end  = std::upper_bound(ends.begin(),
                                    ends.end(),
                                    z - half * (1. + 2. * same_end));
        for (std::size_t s = end - ends.begin(); s + 1 < ends.size(); ++s)
          {
            const double middle = 0.5 * (ends[s] + ends[s + 1]);
            if (middle > z + half)
              break;
            if (middle > z - half)
              f(s);
          }
      }
  }


  template <int dim>
  bool
  Crest<dim>::is_crest(const MaterialPoints<dim> &points,
                       const std::size_t          p,
                       const Strip               &strip) const
  {
    // Its upper side is less than half its height below the highest one.
    const double half = initial_half_size(points, p)[1];
    return points.initial_position[p][1] + 2. * half > strip.top;
  }


  template <int dim>
  double
  Crest<dim>::front(const MaterialPoints<dim> &points,
                    const std::size_t          p) const
  {
    return sign * points.initial_position[p][0] +
           initial_half_size(points, p)[0];
  }


  template <int dim>
  CrestDamage
  Crest<dim>::damage(const MaterialPoints<dim> &points,
                     const std::vector<bool>   &stable) const
  {
    AssertDimension(stable.size(), points.n_points());
    std::vector<std::size_t> n_stable(strips.size(), 0);
    std::vector<double>      foremost(strips.size());
    for (std::size_t s = 0; s < strips.size(); ++s)
      foremost[s] = strips[s].rear;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      if (stable[p])
        for_each_strip(points, p, [&](const std::size_t s) {
          if (!is_crest(points, p, strips[s]))
            return;
          ++n_stable[s];
          foremost[s] = std::max(foremost[s], front(points, p));
        });

    CrestDamage damage;
    if (dim == 3)
      damage.width = 0.;
    for (std::size_t s = 0; s < strips.size(); ++s)
      if (n_stable[s] < strips[s].n)
        {
          const double edge = given_edge.value_or(strips[s].front);
          damage.retrogression =
            std::max(damage.retrogression, edge - foremost[s]);
          if (dim == 3)
            damage.width += ends[s + 1] - ends[s];
        }
    return damage;
  }


  template <int dim>
  double
  Crest<dim>::lowest_x() const
  {
    double x = std::numeric_limits<double>::max();
    for (const Strip &strip : strips)
      if (strip.n > 0)
        x = std::min(x, sign * (sign > 0. ? strip.rear : strip.front));
    return x;
  }


  template <int dim>
  double
  Crest<dim>::highest_x() const
  {
    double x = std::numeric_limits<double>::lowest();
    for (const Strip &strip : strips)
      if (strip.n > 0)
        x = std::max(x, sign * (sign > 0. ? strip.front : strip.rear));
    return x;
  }


  template class Crest<2>;
  template class Crest<3>;
} // namespace Waker
