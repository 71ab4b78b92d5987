// SPDX-License-Identifier: LGPL-2.1-or-later
#include "uplift_warnings.h"

#include <waker/base/places.h>
#include <waker/loads/water_level.h>

#include <algorithm>
#include <sstream>

namespace Waker
{
  namespace
  {
    constexpr double no_uplift = 1e-6; // kPa

    /// Moments of the storm that are looked at, and the steps between them in
    /// which the water in the ground follows.
    constexpr unsigned int n_moments = 24, n_steps = 20;


    /// The times (s) of these moments, the start first.
    std::vector<double>
    moments_of(const Parameters &p)
    {
      const double end = p.time.end_time;
      const double peak =
        TimeFunction(p.water.rise, "Water/Rise").time_of_largest();
      std::vector<double> moments;
      for (unsigned int i = 0; i <= n_moments; ++i)
        moments.push_back(end * i / n_moments);
      if (peak > 0. && peak < end)
        moments.push_back(peak);
      std::sort(moments.begin(), moments.end());
      return moments;
    }


    /// Points that the water lifts at a moment.
    template <int dim>
    struct Uplift
    {
      double      t = 0.; // s
      std::size_t n = 0;
      // Where the effective vertical stress is least (kPa).
      double     stress = -no_uplift, pressure = 0.;
      Point<dim> at;
    };


    template <int dim>
    Uplift<dim>
    uplift(const Case<dim> &the_case, const Heads &heads, const double t)
    {
      const MaterialPoints<dim> &points = the_case.initial_points;
      Uplift<dim>                now;
      now.t = t;
      for (std::size_t p = 0; p < points.n_points(); ++p)
        {
          const Point<dim> &x = points.initial_position[p];
          const double      stress =
            the_case.ground.vertical_stress_under(heads,
                                                  x,
                                                  the_case.layers_of_points[p]);
          now.n += stress < -no_uplift ? 1 : 0;
          if (stress < now.stress)
            {
              now.stress   = stress;
              now.at       = x;
              now.pressure = the_case.pore_water.pressure(heads, x);
            }
        }
      return now;
    }
  } // namespace


  template <int dim>
  void
  warn_of_uplift_in_storm(const Case<dim>          &the_case,
                          std::vector<std::string> &warnings)
  {
    const Parameters &p = the_case.parameters;
    const WaterLevel  water(p.water);
    if (!p.pore_water.anything_follows_water() || !water.moves() ||
        !the_case.ground.knows_stress())
      return;

    PoreWaterRecord outside = the_case.pore_water.start(water.at(0.));
    Uplift<dim>     first, worst;
    double          before = 0.; // s
    for (const double t : moments_of(p))
      {
        const double dt = (t - before) / n_steps;
        for (unsigned int s = 1; dt > 0. && s <= n_steps; ++s)
          the_case.pore_water.follow(water.at(before + s * dt), dt, outside);
        before = t;
        const Uplift<dim> now =
          uplift(the_case, the_case.pore_water.heads(outside), t);
        if (now.n > 0 && first.n == 0)
          first = now;
        if (now.stress < worst.stress)
          worst = now;
      }
    // What is there at the start, and does not grow, is told elsewhere.
    if (worst.n == 0 || worst.t == 0.)
      return;
    std::ostringstream text;
    text << "Water/Rise: ";
    if (first.t > 0.)
      text << "by t = " << first.t << " s, at the level " << water.at(first.t)
           << " m, the water in the ground has come to carry more than the "
              "soil above weighs; ";
    text << "at t = " << worst.t << " s, at the level " << water.at(worst.t)
         << " m, " << worst.n << " points are lifted up, most at "
         << place_text(worst.at) << " m, where "
         << p.pore_water.name_of_line_at(worst.at[0], worst.at[1])
         << " makes a pressure of " << worst.pressure
         << " kPa and an effective vertical stress of " << worst.stress
         << " kPa: uplift, and what moves then is no slide alone";
    warnings.push_back(text.str());
  }


  template void
  warn_of_uplift_in_storm(const Case<2> &, std::vector<std::string> &);
  template void
  warn_of_uplift_in_storm(const Case<3> &, std::vector<std::string> &);
} // namespace Waker
