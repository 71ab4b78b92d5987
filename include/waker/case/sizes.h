// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_case_sizes_h
#define waker_case_sizes_h

#include <waker/case/case.h>

#include <cstddef>

namespace Waker
{
  /// What a run will need at most, roughly: to refuse or to warn before.
  struct RunSizes
  {
    double steps     = 0.; // to the end time
    double time_step = 0.; // s
    double computing = 0.; // s, of all ranks, if it goes on to the end time
    double memory    = 0.; // bytes, of each rank, largest at one time
    /// Of these, or more if the case keeps its points for other realisations:
    /// bytes of the arrays of all points.
    double all_points = 0.;
    double snapshots  = 0.; // moments with ParaView files
    double disk       = 0.; // bytes, of ParaView files and statistics
  };

  /// @param n_points, n_nodes of the case
  /// @param n_ranks that compute it
  template <int dim>
  RunSizes
  run_sizes(const Parameters  &parameters,
            const Materials   &materials,
            const std::size_t  n_points,
            const std::size_t  n_nodes,
            const unsigned int n_ranks = 1);

  /// The same of a case.
  template <int dim>
  RunSizes
  run_sizes(const Case<dim> &the_case);

  /**
   * Are they possible? Called when the points are known, before fields on the
   * grid and the gravity step's equations are made.
   *
   * @param n_here ranks that share this machine's memory
   * @throws UserError with the number
   */
  void
  check_run_sizes(const RunSizes    &sizes,
                  const Parameters  &parameters,
                  const unsigned int n_here = 1);
} // namespace Waker

#endif
