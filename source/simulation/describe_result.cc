// SPDX-License-Identifier: LGPL-2.1-or-later
// What came out of a run.
#include <waker/simulation/describe.h>

#include "say.h"
#include <cmath>
#include <cstdio>
#include <sstream>

namespace Waker
{
  std::string
  load_text(const LoadRecord &load, const LoadName &name)
  {
    std::ostringstream text;
    text.precision(4);
    text << name.name << ": " << load.factor;
    if (name.unit != "-")
      text << " " << name.unit;
    if (load.is_stopped())
      text << ", stopped at t = " << load.stop_time << " s";
    if (load.held_for > 0.)
      text << ", held for " << load.held_for << " s";
    return text.str();
  }


  std::string
  geometry_text(const FailureRecord &f)
  {
    char text[160];
    if (!std::isfinite(f.geometry.height))
      std::snprintf(text,
                    sizeof text,
                    "H %.2f m, and no soil is left",
                    f.initial_height);
    else if (std::isnan(f.geometry.width))
      std::snprintf(text,
                    sizeof text,
                    "H %.2f -> %.2f m",
                    f.initial_height,
                    f.geometry.height);
    else
      std::snprintf(text,
                    sizeof text,
                    "W %.2f -> %.2f m, H %.2f -> %.2f m",
                    f.initial_width,
                    f.geometry.width,
                    f.initial_height,
                    f.geometry.height);
    return text;
  }


  template <int dim>
  void
  describe_result(const State<dim>            &state,
                  const std::vector<LoadName> &load_names,
                  const Outcome                outcome,
                  const Unrest                &unrest,
                  const std::string           &reason,
                  const double                 wall_time,
                  const std::uint64_t          steps_done,
                  Log                         &log)
  {
    const FailureRecord &f = state.failure;
    // A run that was resumed at its end has made no step, and all points may
    // have left: then there is no such number.
    const double point_steps =
      static_cast<double>(state.points.n_points()) * steps_done;
    std::string rate;
    if (point_steps > 0.)
      {
        char text[64];
        std::snprintf(text,
                      sizeof text,
                      ", %.3g us per point and step",
                      1e6 * wall_time / point_steps);
        rate = text;
      }
    say(log, "Outcome: %s (%s)", to_string(outcome).c_str(), reason.c_str());
    if (outcome != Outcome::numerical_failure && outcome != Outcome::flooding &&
        !unrest.is_final())
      say(log,
          "  NOT FINAL %s at t = %g s: %s",
          to_string(unrest).c_str(),
          state.time,
          is_decided(outcome) ? "the residual width may change"
                              : "nobody knows whether the dyke stands");
    say(log, "  %s, t = %.3f s", geometry_text(f).c_str(), state.time);
    for (std::size_t i = 0; i < state.loads.size(); ++i)
      log.line("  load " + load_text(state.loads[i], load_names[i]));
    const LongSteps &long_steps = state.long_steps;
    if (long_steps.n + long_steps.motions > 0)
      say(log,
          "  at rest in %llu long steps of %.6g s together, moved %llu time(s) "
          "for %.6g s",
          static_cast<unsigned long long>(long_steps.n),
          long_steps.time,
          static_cast<unsigned long long>(long_steps.motions),
          state.time - long_steps.time);
    say(log,
        "  %llu steps, %llu Newton iterations, %llu unconverged, %.2f s%s",
        static_cast<unsigned long long>(state.step),
        static_cast<unsigned long long>(state.newton_iterations),
        static_cast<unsigned long long>(state.unconverged_steps),
        wall_time,
        rate.c_str());
  }


  void
  describe_traffic(const NodeExchange::Traffic &sent,
                   const unsigned int           n_ranks,
                   const std::uint64_t          n_steps,
                   Log                         &log)
  {
    if (n_ranks == 1 || n_steps == 0)
      return;
    const auto n = static_cast<double>(n_steps);
    say(log,
        "%u ranks; in a step the first one sent %.4g messages with %.4g kB, "
        "and took part in %.4g sums over all",
        n_ranks,
        static_cast<double>(sent.messages) / n,
        1e-3 * static_cast<double>(sent.bytes) / n,
        static_cast<double>(sent.reductions) / n);
  }


  template void
  describe_result(const State<2> &,
                  const std::vector<LoadName> &,
                  const Outcome,
                  const Unrest &,
                  const std::string &,
                  const double,
                  const std::uint64_t,
                  Log &);
  template void
  describe_result(const State<3> &,
                  const std::vector<LoadName> &,
                  const Outcome,
                  const Unrest &,
                  const std::string &,
                  const double,
                  const std::uint64_t,
                  Log &);
} // namespace Waker
