// SPDX-License-Identifier: LGPL-2.1-or-later
#include "uplift_warnings.h"

#include <waker/base/places.h>
#include <waker/control/load_programme.h>
#include <waker/loads/water_level.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace Waker
{
  namespace
  {
    constexpr double no_uplift = 1e-6; // kPa

    /// Moments of the run that are looked at, and the steps between them in
    /// which the water in the ground follows.
    constexpr unsigned int n_moments = 24, n_steps = 20;


    /**
     * The level of the water outside as high and as soon as it can come: by
     * Water/Rise, and by a load programme that nothing holds or stops. Of a
     * table of a quantity, which no one knows beforehand, by its largest factor
     * at once.
     */
    class HighestWater
    {
    public:
      explicit HighestWater(const Parameters &p)
        : level(p.water)
      {
        for (const LoadProgrammeParameters &programme : p.load_programmes)
          if (programme.drives == LoadTarget::water)
            driven.emplace(programme);
        if (!driven)
          return;
        record = driven->start();
        if (kind() == LoadProgrammeKind::table_of_quantity)
          {
            const TimeFunction table = driven->parameters().read_table();
            record.next =
              std::max(record.factor, table.value(table.time_of_largest()));
          }
      }

      bool
      moves() const
      {
        return level.moves() || driven;
      }

      /// At times (s) that do not descend.
      double
      at(const double t)
      {
        if (driven)
          {
            driven->proceed(t, record);
            level.set_added_rise(record.factor);
          }
        return level.at(t);
      }

      /// Times of its peaks and corners, wherever they lie (s).
      std::vector<double>
      peaks(const Parameters &p) const
      {
        std::vector<double> times = {
          TimeFunction(p.water.rise, "Water/Rise").time_of_largest()};
        if (driven && kind() == LoadProgrammeKind::table_of_time)
          times.push_back(driven->parameters().read_table().time_of_largest());
        if (driven && kind() == LoadProgrammeKind::growth)
          times.push_back(driven->parameters().start_time +
                          driven->parameters().end_of_growth() /
                            driven->parameters().rate);
        return times;
      }

      /// What raises it, as paths of parameters.
      std::string
      name() const
      {
        std::string text = level.moves() ? "Water/Rise" : "";
        if (driven)
          text += (text.empty() ? "" : " and ") +
                  ("Load programmes/" + driven->parameters().name);
        return text;
      }

      /// What may make it lower or later than this; "" if nothing does.
      std::string
      reservation() const
      {
        if (!driven)
          return "";
        if (kind() == LoadProgrammeKind::table_of_quantity)
          return ", if its table comes to its largest factor";
        return driven->parameters().held_by == Watched::nothing &&
                   driven->parameters().stopped_by == Watched::nothing
                 ? ""
                 : ", unless it waits or stops before";
      }

    private:
      LoadProgrammeKind
      kind() const
      {
        return driven->parameters().kind;
      }

      WaterLevel                   level;
      std::optional<LoadProgramme> driven;
      LoadRecord                   record;
    };


    /// The times (s) of these moments, the start first.
    std::vector<double>
    moments_of(const double end, const std::vector<double> &peaks)
    {
      std::vector<double> moments;
      for (unsigned int i = 0; i <= n_moments; ++i)
        moments.push_back(end * i / n_moments);
      for (const double peak : peaks)
        if (peak > 0. && peak < end)
          moments.push_back(peak);
      std::sort(moments.begin(), moments.end());
      return moments;
    }


    /// A run in which the water stands above this (m) is over.
    template <int dim>
    double
    flooding_level(const Case<dim> &the_case)
    {
      double top = std::numeric_limits<double>::infinity();
      if (!the_case.parameters.stop.on_flooding)
        return top;
      top = -top;
      for (const LayerBody &body : the_case.ground.depths().bodies())
        for (const auto &corner : body.corners)
          top = std::max(top, corner[1]);
      return top + 1e-9 * (1. + std::abs(top));
    }


    /// Points that the water lifts at a moment.
    template <int dim>
    struct Uplift
    {
      double      t = 0., level = 0.; // s, m
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
  warn_of_uplift_to_come(const Case<dim>          &the_case,
                         std::vector<std::string> &warnings)
  {
    const Parameters &p = the_case.parameters;
    HighestWater      water(p);
    if (!p.pore_water.anything_follows_water() || !water.moves() ||
        !the_case.ground.knows_stress())
      return;

    const double    flooded = flooding_level(the_case);
    double          level = water.at(0.), before = 0.; // m, s
    PoreWaterRecord outside = the_case.pore_water.start(level);
    Uplift<dim>     first, worst;
    for (const double t : moments_of(p.time.end_time, water.peaks(p)))
      {
        const double dt = (t - before) / n_steps;
        for (unsigned int s = 1; dt > 0. && s <= n_steps; ++s)
          {
            level = water.at(before + s * dt);
            the_case.pore_water.follow(level, dt, outside);
          }
        before = t;
        if (level > flooded)
          break;
        Uplift<dim> now =
          uplift(the_case, the_case.pore_water.heads(outside), t);
        now.level = level;
        if (now.n > 0 && first.n == 0)
          first = now;
        if (now.stress < worst.stress)
          worst = now;
      }
    // What is there at the start, and does not grow, is told elsewhere.
    if (worst.n == 0 || worst.t == 0.)
      return;
    std::ostringstream text;
    text << water.name() << ": ";
    if (first.t > 0.)
      text << "by t = " << first.t << " s, at the level " << first.level
           << " m, the water in the ground has come to carry more than the "
              "soil above weighs; ";
    text << "at t = " << worst.t << " s, at the level " << worst.level << " m, "
         << worst.n << " points are lifted up, most at " << place_text(worst.at)
         << " m, where "
         << p.pore_water.name_of_line_at(worst.at[0], worst.at[1])
         << " makes a pressure of " << worst.pressure
         << " kPa and an effective vertical stress of " << worst.stress
         << " kPa" << water.reservation()
         << ": uplift, and what moves then is no slide alone";
    warnings.push_back(text.str());
  }


  template void
  warn_of_uplift_to_come(const Case<2> &, std::vector<std::string> &);
  template void
  warn_of_uplift_to_come(const Case<3> &, std::vector<std::string> &);
} // namespace Waker
