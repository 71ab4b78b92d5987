// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/ranks.h>
#include <waker/base/sizes.h>
#include <waker/case/sizes.h>
#include <waker/mechanics/time_scheme.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// More steps than this take years, and their statistics terabytes.
    constexpr double most_steps = 1e9;
    /// The list of the files is written again with each of them.
    constexpr double most_snapshots = 1e5;


    /// Do steps of the scheme, of those with long steps these, factorise a
    /// matrix?
    bool
    factorises(const TimeParameters &time)
    {
      return !scheme_traits(time).has_inertia ||
             scheme_traits(time).has_long_steps;
    }


    /// Bytes of the largest thing that is solved at once.
    template <int dim>
    double
    solver_memory(const Parameters &parameters,
                  const double      n_points,
                  const double      n_nodes)
    {
      const bool gravity = parameters.gravity.initial_stress;
      const bool direct  = factorises(parameters.time);
      if (!gravity && !scheme_traits(parameters.time).is_implicit)
        return 0.;
      if (dim == 3 || !(gravity || direct))
        return 8. * 60. * dim * n_nodes; // basis of the Krylov space
      // Of a factor of a plane grid's matrix: some 10 n log2(n) entries of
      // 12 bytes; the gravity step's blocks of 25 neighbours before.
      const double n_soil = // nodes that have equations
        1.2 * n_points / std::pow(parameters.points.points_per_direction, dim);
      const double n = dim * std::min(n_nodes, n_soil);
      return 12. * 10. * n * std::log2(n + 2.) * (direct ? 2. : 1.) +
             25. * 32. * n_nodes;
    }
  } // namespace


  template <int dim>
  RunSizes
  run_sizes(const Parameters  &parameters,
            const Materials   &materials,
            const std::size_t  n_points,
            const std::size_t  n_nodes,
            const unsigned int n_ranks)
  {
    const TimeParameters   &time   = parameters.time;
    const OutputParameters &output = parameters.output;
    RunSizes                sizes;
    sizes.time_step =
      first_time_step(time, materials, parameters.grid.cell_size);
    // While all rests; nobody knows how long it will move.
    const double step =
      scheme_traits(time).has_long_steps ? time.longest_step : sizes.time_step;
    sizes.steps = std::ceil(time.end_time / step * (1. - 1e-12));

    // Microseconds per point and step: see doc/verification/performance.md. A
    // quasi-static step factorises a matrix in each iteration; the contour of
    // boxes in space, where they no longer lie in rows, costs more than all
    // else.
    // In 3D it is that with B-bar.
    const bool b_bar =
      parameters.mapping.volumetric_strain != VolumetricStrain::standard;
    double                   per_step = factorises(time) ? 30.
                                        : dim == 2       ? (b_bar ? 0.64 : 0.4)
                                                         : 2.;
    const SurfaceParameters &surface  = parameters.surface;
    if (dim == 3 && !surface.prismatic &&
        surface.method == SurfaceMethod::contour)
      per_step += 20.;
    sizes.computing = 1e-6 * per_step * n_points * sizes.steps;

    // Its arrays, weights and tangent; at the start each rank has the arrays of
    // all points, and those of its own beside them.
    const double of_arrays = 8. * (4 + 7 * dim + 2 * 6 + 8);
    const double of_tangent =
      scheme_traits(time).is_implicit || parameters.gravity.initial_stress
        ? 8. * (dim * (dim + 1) / 2 + 1) * (dim * dim + 1)
        : 0.;
    const double per_point = of_arrays + 8. * 6 * dim + of_tangent;
    const double per_node  = 8. * (2 + 20 * dim);
    sizes.all_points       = of_arrays * n_points;
    const double at_start  = n_ranks > 1 ? sizes.all_points : 0.;
    // What flows in comes to a copy of the whole body first.
    const double kept = parameters.inflows.empty() ? 0. : at_start;
    sizes.memory =
      std::max(at_start + sizes.all_points / n_ranks,
               kept + (per_point * n_points +
                       solver_memory<dim>(parameters, n_points, n_nodes)) /
                        n_ranks) +
      per_node * n_nodes * (n_ranks > 1 ? 1. + 1. / n_ranks : 1.);

    sizes.snapshots =
      output.interval > 0.
        ? std::min(sizes.steps, std::floor(time.end_time / output.interval)) +
            1.
        : 2.;
    const double per_snapshot =
      (output.particles ? 200. * n_points : 0.) +
      (output.grid ? 150. * n_nodes : 0.) +
      (output.surface ? 100. * std::pow(double(n_nodes), 0.5) : 0.);
    sizes.disk = per_snapshot * sizes.snapshots + 600. * sizes.steps;
    return sizes;
  }


  template <int dim>
  RunSizes
  run_sizes(const Case<dim> &the_case)
  {
    return run_sizes<dim>(the_case.parameters,
                          the_case.materials,
                          the_case.initial_points.n_points(),
                          the_case.grid.n_nodes(),
                          n_ranks(the_case.grid.communicator()));
  }


  void
  check_run_sizes(const RunSizes    &sizes,
                  const Parameters  &parameters,
                  const unsigned int n_here)
  {
    const bool chosen = scheme_traits(parameters.time).is_implicit;
    checked_count(chosen ? "Time stepping/Time step" : "Time stepping/End time",
                  sizes.steps,
                  "steps to the end time",
                  most_steps,
                  chosen ? "a longer time step, or an earlier end time"
                         : "an earlier end time");
    checked_count("Output/Interval",
                  sizes.snapshots,
                  "moments with files",
                  most_snapshots,
                  "a longer interval");
    std::ostringstream what;
    what << "is " << parameters.grid.cell_size << " m";
    if (n_here > 1)
      what << ", on " << n_here << " ranks of this machine";
    require_memory("Grid/Cell size",
                   what.str(),
                   n_here * sizes.memory,
                   "larger cells, a smaller box, or fewer material points");
  }


  template RunSizes
  run_sizes<2>(const Parameters &,
               const Materials &,
               const std::size_t,
               const std::size_t,
               const unsigned int);
  template RunSizes
  run_sizes<3>(const Parameters &,
               const Materials &,
               const std::size_t,
               const std::size_t,
               const unsigned int);
  template RunSizes
  run_sizes(const Case<2> &);
  template RunSizes
  run_sizes(const Case<3> &);
} // namespace Waker
