// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Times the parts of a step and whole steps, on one core:
//
//   build/bin/benchmarks --benchmark_filter=2D/6k --benchmark_repetitions=5
//
// "time/point" is the time per material point and call: of the steps, per point
// and step ("0.4us"; seconds in the formats json and csv).
#include <deal.II/base/mpi.h>

#include "dyke.h"

int
main(int argc, char **argv)
{
  using namespace WakerBenchmarks;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  register_weak_dyke();
  register_campaign();
  register_contour();
  register_steps<2>(Size::small);
  register_kernels<2>(Size::small);
  register_steps<2>(Size::large);
  register_kernels<2>(Size::large);
  register_steps<3>(Size::large);
  register_kernels<3>(Size::large);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
