// SPDX-License-Identifier: LGPL-2.1-or-later
#include "run_watcher.h"

#include <waker/simulation/describe.h>

#include <cmath>
#include <cstdio>

namespace Waker
{
  namespace
  {
    /// Say in the log what has just happened to the dyke.
    void
    report_events(const FailureRecord &before,
                  const FailureRecord &now,
                  Log                 &log)
    {
      char text[200];
      for (const bool inner : {true, false})
        {
          const SlopeSlide &slide = inner ? now.inner_slide : now.outer_slide;
          if (slide.time < 0. ||
              (inner ? before.inner_slide : before.outer_slide).time >= 0.)
            continue;
          char cut[60] = "leaves the crest alone";
          if (!std::isnan(slide.body.crest_cut))
            std::snprintf(cut,
                          sizeof cut,
                          "cuts the crest at x = %.2f m",
                          slide.body.crest_cut);
          std::snprintf(text,
                        sizeof text,
                        "t = %.3f s: slide of the %s slope (%.1f m^2, %.0f %% "
                        "of the profile; %s)",
                        slide.time,
                        name_of(inner ? Slopes::inner : Slopes::outer),
                        slide.body.area,
                        100. * slide.body.share,
                        cut);
          log.line(text);
        }
      if (now.initial_time >= 0. && before.initial_time < 0.)
        {
          std::snprintf(text,
                        sizeof text,
                        "t = %.3f s: initial failure (%s)",
                        now.initial_time,
                        geometry_text(now).c_str());
          log.line(text);
        }
      if (now.flooded() && !before.flooded())
        {
          std::snprintf(text,
                        sizeof text,
                        "t = %.3f s: flooding (%s)",
                        now.flooding_time,
                        geometry_text(now).c_str());
          log.line(text);
        }
    }


    /// What broke loose, for the log.
    template <int dim>
    std::string
    sliding_text(const std::size_t k, const SlidingMasses &sliding)
    {
      const SlidingMass &mass = sliding.masses[k];
      char               text[200];
      char               along_z[60] = "";
      if (dim == 3)
        std::snprintf(along_z,
                      sizeof along_z,
                      ", z from %.2f to %.2f m",
                      mass.lower[2],
                      mass.upper[2]);
      std::snprintf(text,
                    sizeof text,
                    "t = %.3f s: sliding mass %zu (%.3g m^%d, %.1f %% of the "
                    "body; x from %.2f to %.2f m%s)",
                    mass.time,
                    k + 1,
                    mass.volume,
                    dim,
                    100. * mass.volume / sliding.whole_volume,
                    mass.lower[0],
                    mass.upper[0],
                    along_z);
      return text;
    }


    /// Warn of what has just happened to the tractions: it is in the summary,
    /// too.
    void
    report_tractions(const std::vector<TractionParameters> &parameters,
                     const std::vector<TractionRecord>     &before,
                     const std::vector<TractionRecord>     &now,
                     Log                                   &log)
    {
      for (std::size_t i = 0; i < now.size(); ++i)
        {
          const TractionRecord was =
            i < before.size() ? before[i] : TractionRecord();
          const auto say = [&](const double       earlier,
                               const double       time,
                               const std::string &what) {
            if (time < 0. || earlier >= 0.)
              return;
            char text[64];
            std::snprintf(text, sizeof text, "t = %.3f s: traction ", time);
            log.warning(text + parameters[i].name + " " + what);
          };
          say(
            was.empty_time,
            now[i].empty_time,
            "loads nothing: no part of the surface is left in it; see Follows");
          say(was.left_time,
              now[i].left_time,
              "has lost a part: soil that carried it has left the grid");
          say(was.lost_time,
              now[i].lost_time,
              "loses more than 1 % of its load, on nodes without soil; see "
              "Minimum support");
        }
    }


    /// Say in the log which loads have just been stopped, and how far they got.
    void
    report_loads(const std::vector<LoadProgrammeParameters> &parameters,
                 const std::vector<LoadRecord>              &before,
                 const std::vector<LoadRecord>              &now,
                 Log                                        &log)
    {
      for (std::size_t i = 0; i < now.size(); ++i)
        if (now[i].is_stopped() && !before[i].is_stopped())
          log.line("load " + load_text(now[i],
                                       {parameters[i].name,
                                        facts_of(parameters[i].drives).unit}));
    }
  } // namespace


  template <int dim>
  RunWatcher<dim>::RunWatcher(const Parameters &parameters,
                              const bool        resumed,
                              const State<dim> &state,
                              Realisation<dim> &realisation,
                              Recorder<dim>    &recorder,
                              Log              &log)
    : parameters(parameters)
    , state(state)
    , realisation(realisation)
    , recorder(recorder)
    , log(log)
    , failure(state.failure)
    , n_sliding_masses(state.sliding.masses.size())
    , tractions(state.tractions)
    , loads(state.loads)
    , is_new(!resumed)
    , unconverged(state.unconverged_steps)
    , long_steps(state.long_steps)
  {}


  template <int dim>
  void
  RunWatcher<dim>::looked(const StopReason /*stop*/, const bool /*last*/)
  {
    report_events(failure, state.failure, log);
    report_tractions(parameters.tractions, tractions, state.tractions, log);
    for (std::size_t k = n_sliding_masses; k < state.sliding.masses.size(); ++k)
      log.line(sliding_text<dim>(k, state.sliding));
    report_loads(parameters.load_programmes, loads, state.loads, log);
    failure          = state.failure;
    n_sliding_masses = state.sliding.masses.size();
    tractions        = state.tractions;
    loads            = state.loads;
    if (is_new)
      recorder.record(realisation.view());
    is_new = true;
  }


  template <int dim>
  Wanted
  RunWatcher<dim>::wants(const StopReason stop, const bool last)
  {
    return is_new ? recorder.wants(state.time, stop != StopReason::none, last)
                  : Wanted();
  }


  template <int dim>
  void
  RunWatcher<dim>::write_files()
  {
    recorder.write_files(realisation.view(), realisation.own());
  }


  template <int dim>
  void
  RunWatcher<dim>::write_checkpoint()
  {
    recorder.checkpoint(state, realisation.own());
  }


  template <int dim>
  void
  RunWatcher<dim>::advanced()
  {
    if (!held && realisation.view().report.held_domains > 0)
      {
        held = true;
        log.line("t = " + std::to_string(state.time) +
                 " s: from now on stretched support domains are held "
                 "at the size of a cell (" +
                 std::to_string(realisation.view().report.held_domains) +
                 " points)");
      }
    if (!levels_failed && realisation.view().report.strong_failures > 0)
      {
        levels_failed = true;
        log.line(
          "t = " + std::to_string(state.time) +
          " s: multigrid could not be set up for a static step: "
          "conjugate gradients go on with the diagonal, which takes more "
          "iterations to the same result (said once)");
      }
    if (state.long_steps.motions > long_steps.motions)
      log.line("t = " + std::to_string(state.time - state.last_dt) +
               " s: no balance nearby, from now on it moves");
    if (state.long_steps.last && !long_steps.last && long_steps.motions > 0)
      log.line("t = " + std::to_string(state.time - state.last_dt) +
               " s: at rest, long steps");
    long_steps = state.long_steps;
    if (state.unconverged_steps > unconverged)
      {
        log.line(
          "t = " + std::to_string(state.time) +
          " s: " + std::to_string(state.unconverged_steps - unconverged) +
          " unconverged attempt(s), dt = " + std::to_string(state.last_dt) +
          " s");
        unconverged = state.unconverged_steps;
      }
    if (log.progress_due())
      {
        char text[160];
        std::snprintf(text,
                      sizeof text,
                      "t = %.2f of at most %g s, %s",
                      state.time,
                      parameters.time.end_time,
                      geometry_text(state.failure).c_str());
        log.progress(state.time / parameters.time.end_time, text);
      }
  }


  template class RunWatcher<2>;
  template class RunWatcher<3>;
} // namespace Waker
