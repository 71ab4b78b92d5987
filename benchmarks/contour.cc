// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The contour of support domains: of square bodies and of long ones as they
// grow, and of the dyke in motion. "surface" is the number of domains at the
// surface, "swept" how many the slab method has visited, "coverage" the time in
// seconds that it took to find out which. Over a whole run of the weak dyke:
// what detection, load and all of a step take on average (s), and the shares of
// the first two, with the proximity field and with the contour.
#include <waker/loads/wet_section.h>
#include <waker/program/parameter_reader.h>
#include <waker/surface/boxes/box_union_contour.h>
#include <waker/surface/domain_contour.h>
#include <waker/surface/surface_finder.h>

#include "dyke.h"
#include <ctime>
#include <random>
#include <string>

namespace WakerBenchmarks
{
  namespace
  {
    /// n_x x n_y domains of 0.125 m, sheared and shaken by 2 % of their size.
    std::vector<Box<2>>
    body(const unsigned int n_x, const unsigned int n_y)
    {
      const double        size = 0.125;
      std::mt19937_64     engine(1);
      std::vector<Box<2>> boxes;
      const auto          noise = [&]() {
        return 0.02 * size *
               (static_cast<double>(engine() >> 10) * 0x1p-53 - 1.);
      };
      for (unsigned int j = 0; j < n_y; ++j)
        for (unsigned int i = 0; i < n_x; ++i)
          {
            Box<2> box;
            box.lower =
              Point<2>((i + 0.3 * j) * size + noise(), j * size + noise());
            box.upper = Point<2>(box.lower[0] + size, box.lower[1] + size);
            boxes.push_back(box);
          }
      return boxes;
    }


    void
    time_body(benchmark::State          &timer,
              const std::vector<Box<2>> &boxes,
              const unsigned int         n_surface,
              const bool                 restricted)
    {
      BoxUnionRules<2> rules;
      rules.minimum_gap[0] = rules.minimum_gap[1] = 0.0625;
      rules.restricted                            = restricted;
      BoxUnionContour contour;
      PlaneCoverage   coverage;
      Surface         surface;
      std::size_t     n_found = 0;

      std::vector<unsigned int> numbers;

      std::size_t repetitions = 0;
      for (auto _ : timer)
        {
          contour.trace(boxes, rules, surface);
          ++repetitions;
        }
      const std::clock_t start = std::clock();
      for (std::size_t r = 0; restricted && r < repetitions; ++r)
        {
          coverage.reinit(boxes, rules);
          coverage.find_open(numbers);
          n_found += numbers.size();
        }
      const double in_coverage =
        static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
      benchmark::DoNotOptimize(n_found);

      count_points(timer, boxes.size());
      timer.counters["points"]   = boxes.size();
      timer.counters["surface"]  = n_surface;
      timer.counters["swept"]    = contour.n_swept();
      timer.counters["coverage"] = in_coverage / repetitions;
    }


    void
    register_body(const std::string &name,
                  const unsigned int n_x,
                  const unsigned int n_y,
                  const bool         restricted)
    {
      benchmark::RegisterBenchmark(
        ("contour/" + name + "/" + std::to_string(n_x * n_y)).c_str(),
        [=](benchmark::State &timer) {
          const unsigned int n_surface = 2 * (n_x + n_y) - 4;
          time_body(timer, body(n_x, n_y), n_surface, restricted);
        })
        ->Unit(benchmark::kMillisecond);
    }


    // CPU time of this thread (s).
    double
    cpu_time()
    {
      timespec time;
      clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
      return time.tv_sec + 1e-9 * time.tv_nsec;
    }


    // Detection and load, done once more beside each step of the weak dyke,
    // until it floods; and the steps.
    void
    time_shares(benchmark::State &timer, const std::string &method)
    {
      const auto parameters =
        read_parameters(WAKER_SOURCE_DIRECTORY
                        "/parameters/chapter5/dyke_weak.prm",
                        {"Surface/Method=" + method});
      const Case<2>    the_case(*parameters, MPI_COMM_SELF);
      SurfaceFinder<2> surfaces(the_case.grid,
                                parameters->surface,
                                ShapeFunctions::gimp,
                                the_case.fixities.closed_faces());
      WetSection<2>    water(the_case.grid, parameters->water.side);
      NodalState       nodes(the_case.grid);

      double        detection = 0., load = 0., steps = 0.;
      std::uint64_t n_steps = 0;
      for (auto _ : timer)
        {
          State<2>       state = initial_state(the_case);
          Realisation<2> realisation(the_case, state);
          while (true)
            {
              const double start   = cpu_time();
              const bool   goes_on = realisation.look() == StopReason::none;
              const double seen    = cpu_time();
              if (!goes_on)
                break;
              surfaces.reset(state.points);
              surfaces.section();
              const double  detected = cpu_time();
              const Liquid &liquid   = realisation.view().scene.water.now();
              water.find(surfaces, liquid.level);
              water.add_nodal_forces(liquid,
                                     realisation.view().scene.nodes.mass,
                                     parameters->water.minimum_support *
                                       the_case.full_node_mass,
                                     nodes.external_force);
              benchmark::DoNotOptimize(water.resultant(liquid));
              const double loaded = cpu_time();
              realisation.advance();
              steps += seen - start + cpu_time() - loaded;
              detection += detected - seen;
              load += loaded - detected;
              ++n_steps;
            }
          if (!state.failure.flooded())
            timer.SkipWithError("the weak dyke does not flood");
        }
      timer.counters["steps"]           = n_steps;
      timer.counters["step"]            = steps / n_steps;
      timer.counters["detection"]       = detection / n_steps;
      timer.counters["load"]            = load / n_steps;
      timer.counters["detection share"] = detection / steps;
      timer.counters["load share"]      = load / steps;
    }
  } // namespace



  void
  register_contour()
  {
    for (const unsigned int n : {25, 50, 100, 200, 316, 447, 632})
      register_body("square", n, n, true);
    for (const unsigned int n : {25, 100, 400, 1600, 6400, 12800})
      register_body("long", n, 32, true);
    for (const unsigned int n : {25, 100, 316})
      register_body("square, all domains", n, n, false);

    for (const Size size : {Size::small, Size::large})
      benchmark::RegisterBenchmark(
        (std::string("contour/dyke/") + label<2>(size)).c_str(),
        [size](benchmark::State &timer) {
          const Dyke<2> &dyke = WakerBenchmarks::dyke<2>(size, Motion::moving);
          const Case<2> &the_case = *dyke.the_case;
          DomainContour<2> contour(the_case.grid,
                                   SurfaceParameters(),
                                   the_case.fixities.closed_faces());
          Surface          surface;
          for (auto _ : timer)
            contour.detect(dyke.state.points, surface);
          count_points(timer, dyke.state.points.n_points());
        })
        ->Unit(benchmark::kMillisecond);

    for (const char *const method : {"proximity field", "contour"})
      benchmark::RegisterBenchmark(
        (std::string("contour/weak dyke to flooding/") + method).c_str(),
        [method](benchmark::State &timer) { time_shares(timer, method); })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
} // namespace WakerBenchmarks
