// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/ranks.h>
#include <waker/base/sizes.h>
#include <waker/base/version.h>
#include <waker/case/sizes.h>
#include <waker/mechanics/time_scheme.h>
#include <waker/simulation/describe.h>
#include <waker/simulation/plausibility.h>

#include "say.h"
#include "stress_lines.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>

namespace Waker
{
  namespace
  {
    template <typename... Arguments>
    void
    warn(Log &log, const char *format, const Arguments... arguments)
    {
      char text[512];
      std::snprintf(text, sizeof text, format, arguments..., 0);
      log.warning(text);
    }


    /// "weight on 0.5 m, growth of 0.5 m/s, held by ..."
    std::string
    programme_text(const LoadProgrammeParameters &p)
    {
      const LoadTargetFacts facts = facts_of(p.drives);
      std::ostringstream    text;
      text << name_of(p.drives);
      if (*facts.section != '\0')
        text << " " << p.load;
      if (p.drives == LoadTarget::weight)
        text << " of " << p.weight.unit_weight << " kN/m^3 on "
             << p.weight.area() << (p.weight.from.size() == 1 ? " m" : " m^2");
      text << ", " << name_of(p.kind);
      const auto limit =
        [&](const char *const verb, const Watched watched, const double above) {
          if (watched != Watched::nothing)
            text << ", " << verb << " by a " << name_of(watched) << " above "
                 << above << " " << facts_of(watched).unit;
        };
      if (p.kind == LoadProgrammeKind::growth)
        {
          text << " of " << p.rate << " " << facts.unit << "/s";
          limit("held", p.held_by, p.hold_above);
        }
      limit("stopped", p.stopped_by, p.stop_above);
      return text.str();
    }


    /// ", undrained shear strength 8.3 to 25 kPa, ...": of what varies with the
    /// place, as it is at the start.
    template <int dim>
    std::string
    ranges(const MaterialPoints<dim> &points,
           const unsigned int         number,
           const Material            &material)
    {
      std::ostringstream text;
      text.precision(4);
      for (const MaterialVariable &variable : material.variables())
        {
          if (!variable.initial_value.varies())
            continue;
          const auto &values =
            points.scalars[points.find_scalar(variable.name)].values;
          double least = std::numeric_limits<double>::max(), largest = -least;
          for (std::size_t p = 0; p < points.n_points(); ++p)
            if (points.material[p] == number)
              {
                least   = std::min(least, values[p]);
                largest = std::max(largest, values[p]);
              }
          if (least <= largest)
            text << ", " << variable.name << " " << least << " to " << largest
                 << (variable.unit == "-" ? "" : " " + variable.unit);
        }
      return text.str();
    }

    /// What softens it, if that is not itself alone.
    std::string
    surroundings(const MaterialParameters &material)
    {
      std::ostringstream text;
      if (material.regularisation == Regularisation::nonlocal &&
          material.softens())
        text << ", nonlocal over " << material.nonlocal.length << " m";
      return text.str();
    }
  } // namespace


  template <int dim>
  void
  describe_case(const Case<dim> &the_case, Log &log)
  {
    const Parameters          &p      = the_case.parameters;
    const MaterialPoints<dim> &points = the_case.initial_points;
    const double               h      = the_case.grid.cell_size();

    say(
      log, "Waker %s: %s, %dD", WAKER_VERSION, p.output.directory.c_str(), dim);
    say(log,
        "  grid      %u cells of %g m, %u nodes (margin included)",
        the_case.grid.n_cells(),
        h,
        the_case.grid.n_nodes());
    const double mass =
      std::accumulate(points.mass.begin(), points.mass.end(), 0.);
    const double volume =
      std::accumulate(points.volume.begin(), points.volume.end(), 0.);
    // With whole domains the soil may have another volume than was drawn.
    const double       drawn = profile_volume(the_case.grid, p.layers);
    std::ostringstream profile;
    if (p.inflows.empty() && std::abs(volume - drawn) > 1e-6 * drawn)
      profile << " (the profile has " << drawn << ")";
    if (points.n_points() > 0)
      say(log,
          "  points    %zu, %g m^%d%s, %g Mg, %.3g per full cell",
          points.n_points(),
          volume,
          dim,
          profile.str().c_str(),
          mass,
          points.n_points() * std::pow(h, dim) / volume);
    else
      log.line("  points    none");
    for (unsigned int m = 0; m < p.materials.size(); ++m)
      say(log,
          "  material  %s: %s%s%s",
          p.materials[m].name.c_str(),
          name_of(p.materials[m].model),
          surroundings(p.materials[m]).c_str(),
          m < the_case.materials.size()
            ? ranges(points, m, *the_case.materials[m]).c_str()
            : "");

    const double      c      = wave_speed(the_case.materials);
    const double      dt     = first_time_step(p.time, the_case.materials, h);
    const char *const scheme = name_of(p.time.scheme);
    if (const auto cfl = chosen_courant_number(p.time, the_case.materials, h))
      say(log,
          "  time      %s, dt = %g s%s: %.2g times the wave CFL "
          "(c_p = %.3g m/s)",
          scheme,
          dt,
          scheme_traits(p.time).has_long_steps ? " in motion" : "",
          *cfl,
          c);
    else if (!scheme_traits(p.time).has_inertia)
      say(log,
          "  time      %s, %.3g load steps of %g s",
          scheme,
          std::ceil(p.time.end_time / dt * (1. - 1e-12)),
          dt);
    else
      say(
        log, "  time      %s, dt about %.2g s (c_p = %.3g m/s)", scheme, dt, c);
    for (std::size_t i = 0; i < p.tractions.size(); ++i)
      {
        const TractionParameters &traction = p.tractions[i];
        const auto               &initial  = the_case.initial_tractions[i];
        std::ostringstream        force;
        force.precision(4);
        for (unsigned int d = 0; d < dim; ++d)
          force << (d > 0 ? ", " : "") << initial.force[d];
        const bool rides = traction.goes_with_soil();
        say(log,
            "  traction  %s: %s on %s, at first (%s) kN on %.4g %s, %s",
            traction.name.c_str(),
            name_of(traction.kind),
            name_of(traction.method),
            force.str().c_str(),
            initial.measure,
            dim == 2 ? "m" : "m^2",
            rides ? "goes with the soil" : "stays in space");
      }
    for (const LoadProgrammeParameters &load : p.load_programmes)
      log.line("  load      " + load.name + ": " + programme_text(load));
    if (p.water.stands() && !the_case.water_touches)
      warn(log,
           "Water/Level: the water touches no soil at the start, at %g m: it "
           "does not stand above the foreland, and W at that level is the "
           "width of all soil there, not the dyke's",
           p.water.level);
    if (!p.water.stands() && !std::isnan(p.water.level) &&
        std::isnan(the_case.measuring_level))
      warn(log,
           "Water/Level: no soil at %g m: the width is not measured",
           p.water.level);
    if (the_case.last_load_change == LastChange::unknown)
      say(log,
          "  loads     change with an expression of t, perhaps to the end: "
          "the run goes on to %g s (see Stop rules/Loads constant from)",
          p.time.end_time);
    else if (the_case.last_load_change > p.time.end_time)
      warn(log,
           "Time stepping/End time: loads change until t = %g s, after the end "
           "time %g s",
           the_case.last_load_change,
           p.time.end_time);
    else if (the_case.last_load_change > 0.)
      say(log, "  loads     change until t = %g s", the_case.last_load_change);
    if (p.initial_stress.is_gravity_step() &&
        !the_case.gravity_report.residuals.empty())
      {
        const GravityReport &report = the_case.gravity_report;
        const std::string    iterations =
          dim == 2
               ? ""
               : ", " + std::to_string(report.linear_iterations) +
                " iterations, " + std::to_string(report.strong_iterations) +
                " of them with multigrid";
        say(log,
            "  gravity   in-situ stress after %zu solve(s), residual %.1e%s",
            report.residuals.size() - 1,
            report.residuals.back(),
            iterations.c_str());
      }
    for (const std::string &line : stress_lines(the_case))
      log.line(line);
    const RunSizes sizes = run_sizes(the_case);
    log.line(
      std::string("  effort    ") +
      (scheme_traits(p.time).has_long_steps ? "at least " : "up to ") +
      count_text(sizes.steps) + " steps: about " +
      rough_duration_text(sizes.computing) +
      " of computing, several times that where soil flows, " +
      bytes_text(sizes.memory) + " of memory" +
      (n_ranks(the_case.grid.communicator()) > 1 ? " on each rank" : "") +
      ", " + bytes_text(sizes.disk) + " of files");
    for (const std::string &text : strange_things(the_case))
      log.warning(text);
  }


  BalanceWatcher
  initial_stress_progress(const InitialStressParameters &parameters, Log &log)
  {
    return [n = parameters.steps, &log](const BalanceReport &report) {
      if (log.progress_due())
        log.progress(report.share,
                     "initial stress: load step " +
                       std::to_string(report.steps + 1) + " of at least " +
                       std::to_string(n));
    };
  }


  template void
  describe_case(const Case<2> &, Log &);
  template void
  describe_case(const Case<3> &, Log &);
} // namespace Waker
