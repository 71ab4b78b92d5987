// SPDX-License-Identifier: LGPL-2.1-or-later
#include "dyke.h"

#include <waker/case/parameters.h>
#include <waker/program/parameter_reader.h>

#include <map>
#include <stdexcept>

namespace WakerBenchmarks
{
  namespace
  {
    std::vector<std::string>
    overrides(const unsigned int dim, const Size size, const Motion motion)
    {
      std::vector<std::string> set = {
        motion == Motion::moving ? "Materials/clay/Initial strength=5"
                                 : "Materials/clay/Initial strength=26",
        motion == Motion::moving ? "Materials/clay/Residual strength=1.92"
                                 : "Materials/clay/Residual strength=10",
        "Time stepping/Ramp duration=0.1",
        "Stop rules/On flooding=false",
        "Stop rules/At rest=false"};
      if (dim == 2 && size == Size::large)
        {
          set.push_back("Grid/Cell size=0.0625");
          set.push_back("Time stepping/Time step=0.0025");
        }
      if (dim == 3)
        for (const char *const text :
             {"Dimension=3",
              "Grid/Lower corner=-6, 0, 0",
              "Grid/Upper corner=42, 6, 2",
              "Boundary conditions/Names=base, left side, right side, back "
              "side, front side",
              "Boundary conditions/back side/Region=back",
              "Boundary conditions/back side/Type=roller",
              "Boundary conditions/front side/Region=front",
              "Boundary conditions/front side/Type=roller"})
          set.push_back(text);
      return set;
    }
  } // namespace


  template <int dim>
  const Dyke<dim> &
  dyke(const Size size, const Motion motion)
  {
    static std::map<std::pair<Size, Motion>, Dyke<dim>> dykes;
    const auto [it, is_new] = dykes.try_emplace({size, motion});
    Dyke<dim> &dyke         = it->second;
    if (!is_new)
      return dyke;

    const auto parameters =
      read_parameters(WAKER_SOURCE_DIRECTORY
                      "/parameters/chapter5/dyke_weak.prm",
                      overrides(dim, size, motion));
    dyke.the_case  = std::make_unique<Case<dim>>(*parameters, MPI_COMM_SELF);
    dyke.state     = initial_state(*dyke.the_case);
    dyke.time_step = parameters->time.time_step;

    // Past the ramp; what moves has then reached about 1 m/s.
    const double     duration = motion == Motion::moving ? 0.5 : 0.2;
    Realisation<dim> realisation(*dyke.the_case, dyke.state);
    while (dyke.state.time < duration)
      {
        realisation.look();
        realisation.advance();
      }
    const bool moves = dyke.state.displacement_rate > 0.1;
    if (moves != (motion == Motion::moving))
      throw std::runtime_error("the benchmark's dyke does not do what its "
                               "name says");
    return dyke;
  }


  template <int dim>
  const char *
  label(const Size size)
  {
    return dim == 3 ? "3D/100k" : size == Size::small ? "2D/6k" : "2D/100k";
  }


  void
  count_points(benchmark::State &timer, const std::size_t n_points)
  {
    using Counter = benchmark::Counter;
    // Inverted, the console prints a rate as a time: "0.4us".
    timer.counters["time/point"] =
      Counter(n_points, Counter::kIsIterationInvariantRate | Counter::kInvert);
    timer.counters["points"] = n_points;
  }


  template const Dyke<2> &
  dyke<2>(const Size, const Motion);
  template const Dyke<3> &
  dyke<3>(const Size, const Motion);
  template const char *
  label<2>(const Size);
  template const char *
  label<3>(const Size);
} // namespace WakerBenchmarks
