// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_benchmarks_dyke_h
#define waker_benchmarks_dyke_h

#include <waker/simulation/realisation.h>

#include <benchmark/benchmark.h>

/// The dykes that the benchmarks run on.
namespace WakerBenchmarks
{
  using namespace Waker;

  enum class Size
  {
    small, // cells of 0.25 m
    large  // 2D: cells of 0.0625 m; 3D: a slice of 2 m with cells of 0.25 m
  };

  enum class Motion
  {
    moving, // half the strength of the weak dyke: it slides as a whole
    at_rest // twice the strength of the mean dyke: nothing yields
  };

  /// A dyke that has run far enough to move, or to have come to rest.
  template <int dim>
  struct Dyke
  {
    std::unique_ptr<const Case<dim>> the_case;
    State<dim>                       state;
    double                           time_step; // s
  };

  /// Made from parameters/chapter5/dyke_weak.prm when first asked for, and
  /// kept. The time step is twice the wave CFL in all sizes.
  template <int dim>
  const Dyke<dim> &
  dyke(const Size size, const Motion motion);

  /// "2D/6440", for the names of benchmarks.
  template <int dim>
  const char *
  label(const Size size);

  /// Report the time per point and pass through the timed loop.
  void
  count_points(benchmark::State &timer, const std::size_t n_points);

  // Register the benchmarks of this size.
  template <int dim>
  void
  register_kernels(const Size size);

  template <int dim>
  void
  register_steps(const Size size);

  /// The weak dyke as it is, from t = 0 to flooding, without output.
  void
  register_weak_dyke();

  /// The contour of support domains, of growing bodies and of the dyke.
  void
  register_contour();

  /// Realisations of the base case of chapter 5.
  void
  register_campaign();
} // namespace WakerBenchmarks

#endif
