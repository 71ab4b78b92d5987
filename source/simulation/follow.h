// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_simulation_follow_h
#define waker_source_simulation_follow_h

#include <waker/base/errors.h>
#include <waker/simulation/run.h>

namespace Waker
{
  /// The state that the first rank has read. Collective.
  template <int dim>
  void
  share_state(const MPI_Comm communicator, State<dim> &state);

  /// All ranks write to the folder: do they see what the first one has put
  /// there? Collective.
  /// @param directory the first rank's counts
  /// @throws UserError "Output/Directory" on all of them if one does not
  void
  require_shared_folder(const MPI_Comm     communicator,
                        const std::string &directory);

  /// A folder that could be written to when the run began, and now cannot, is
  /// no mistake in the input.
  /// @throws FileError instead of a UserError of the folder; others as they are
  [[noreturn]] void
  throw_of_a_begun_run(const UserError &error, const std::string &directory);

  /// What the ranks after the first do in a run: the first alone has the
  /// folder, and speaks to the user.
  template <int dim>
  RunStatus
  follow(const Parameters        &parameters,
         const RunOptions        &options,
         const MPI_Comm           communicator,
         const InitialSetup<dim> &setup);
} // namespace Waker

#endif
