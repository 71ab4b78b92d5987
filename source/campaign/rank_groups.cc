// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/campaign/rank_groups.h>

#include <cstdint>
#include <exception>
#include <string>

namespace Waker
{
  RankGroups::RankGroups(const MPI_Comm communicator, const unsigned int size)
    : first_communicator(communicator)
    , n_in_group(size)
  {
    const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int n    = Utilities::MPI::n_mpi_processes(communicator);
    if (size == 0 || n % size != 0)
      throw UserError(
        "Campaign/Ranks per realisation",
        "is " + std::to_string(size) + ", and the campaign is started on " +
          std::to_string(n) + " rank(s)",
        "a number that divides that of the ranks (1 always does): "
        "mpirun -n " +
          std::to_string(size) + ", or a multiple of it");
    n_all_groups  = n / size;
    group_number  = rank / size;
    rank_in_group = rank % size;
    if (size == 1)
      return;
    MPI_Comm_split(communicator, group_number, rank, &group_communicator);
    MPI_Comm_split(communicator,
                   is_first() ? 0 : MPI_UNDEFINED,
                   rank,
                   &first_communicator);
  }


  RankGroups::~RankGroups()
  {
    // See ~IndexCounter().
    if (n_in_group == 1 || std::uncaught_exceptions() > 0)
      return;
    MPI_Comm_free(&group_communicator);
    if (is_first())
      MPI_Comm_free(&first_communicator);
  }


  std::optional<Task>
  RankGroups::share(const std::optional<Task> &task) const
  {
    if (n_in_group == 1)
      return task;
    const Task    none{};
    const Task   &mine       = task ? *task : none;
    std::uint64_t numbers[4] = {task ? 1u : 0u,
                                mine.scenario,
                                mine.realisation,
                                mine.batch};
    MPI_Bcast(numbers, 4, MPI_UINT64_T, 0, group_communicator);
    if (numbers[0] == 0)
      return {};
    return Task{static_cast<unsigned int>(numbers[1]), numbers[2], numbers[3]};
  }
} // namespace Waker
