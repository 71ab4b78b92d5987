// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The contour of support domains: of square bodies and of long ones as they
// grow, and of the dyke in motion. "surface" is the number of domains at the
// surface, "swept" how many the slab method has visited, "coverage" the time in
// seconds that it took to find out which.
#include <waker/boundary/box_union_contour.h>
#include <waker/boundary/domain_contour.h>

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
      BoxUnionContour  contour;
      BlockCoverage<2> coverage;
      Surface          surface;
      std::size_t      n_found = 0;

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
          for (const Box<2> &box : boxes)
            n_found += coverage.touches_open_block(box);
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
  }
} // namespace WakerBenchmarks
