// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Whole steps: map, detect, load, solve, move; everything but output.
#include <waker/program/parameter_reader.h>
#include <waker/simulation/run_to_end.h>

#include "dyke.h"
#include <string>

namespace WakerBenchmarks
{
  namespace
  {
    template <int dim>
    void
    time_steps(benchmark::State &timer, const Size size, const Motion motion)
    {
      const Dyke<dim> &start = dyke<dim>(size, motion);
      State<dim>       state = start.state;
      Realisation<dim> realisation(*start.the_case, state);
      // The first step also makes work arrays.
      realisation.look();
      realisation.advance();

      const std::uint64_t newton = state.newton_iterations;
      const std::uint64_t linear = state.linear_iterations;
      for (auto _ : timer)
        {
          realisation.look();
          realisation.advance();
        }
      const auto mean = benchmark::Counter::kAvgIterations;
      timer.counters["newton"] =
        benchmark::Counter(state.newton_iterations - newton, mean);
      timer.counters["linear"] =
        benchmark::Counter(state.linear_iterations - linear, mean);
      count_points(timer, state.points.n_points());
    }


    void
    time_weak_dyke(benchmark::State &timer)
    {
      const auto parameters =
        read_parameters(WAKER_SOURCE_DIRECTORY
                        "/parameters/chapter5/dyke_weak.prm",
                        {});
      std::uint64_t steps  = 0;
      std::size_t   points = 0;
      for (auto _ : timer)
        {
          // With the grid and the gravity step: what a user waits for.
          const Case<2>  the_case(*parameters, MPI_COMM_SELF);
          State<2>       state = initial_state(the_case);
          Realisation<2> realisation(the_case, state);
          run_to_end(realisation);
          if (!state.failure.flooded())
            timer.SkipWithError("the weak dyke does not flood");
          steps  = state.step;
          points = state.points.n_points();
        }
      timer.counters["steps"] = steps;
      count_points(timer, points * steps);
      timer.counters["points"] = points;
    }
  } // namespace


  template <int dim>
  void
  register_steps(const Size size)
  {
    // The state goes on from step to step: their number is fixed, so that
    // every run times the same ones.
    const unsigned int n_steps = size == Size::small ? 30 : 10;
    for (const Motion motion : {Motion::moving, Motion::at_rest})
      benchmark::RegisterBenchmark((std::string(label<dim>(size)) + "/step, " +
                                    (motion == Motion::moving ? "in motion"
                                                              : "at rest"))
                                     .c_str(),
                                   [size, motion](benchmark::State &timer) {
                                     time_steps<dim>(timer, size, motion);
                                   })
        ->Iterations(n_steps)
        ->Unit(benchmark::kMillisecond);
  }


  void
  register_weak_dyke()
  {
    benchmark::RegisterBenchmark("2D/6k/weak dyke to flooding", time_weak_dyke)
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
  }


  template void
  register_steps<2>(const Size);
  template void
  register_steps<3>(const Size);
} // namespace WakerBenchmarks
