// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_reliability_snapshots_h
#define waker_reliability_snapshots_h

#include <waker/reliability/campaign.h>
#include <waker/reliability/progress.h>
#include <waker/simulation/run.h>

#include <string>

namespace Waker
{
  /// Gives a run the random properties of realisation `realisation`.
  template <int dim>
  InitialSetup<dim>
  realisation_setup(const Input &input, const std::uint64_t realisation);

  /// The parameters of that run: name and hash say which realisation it is.
  Parameters
  realisation_parameters(const Input &input, const std::uint64_t realisation);

  /**
   * Run the realisations that section "Snapshots" asks for again, with full
   * output, to folder/snapshots/<scenario>-<realisation>. Those that are there
   * already stay. Collective over the communicator.
   *
   * @return false if interrupted
   */
  template <int dim>
  bool
  make_snapshots(const Scenarios                  &scenarios,
                 const std::string                &folder,
                 const std::string                &hash,
                 const Progress                   &progress,
                 const volatile std::sig_atomic_t *interrupt,
                 const MPI_Comm                    communicator);
} // namespace Waker

#endif
