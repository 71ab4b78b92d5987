// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/campaign/schedule.h>

#include <algorithm>
#include <exception>

namespace Waker
{
  using namespace dealii;

  Schedule::Schedule(const unsigned int  n_scenarios,
                     const std::uint64_t first,
                     const std::uint64_t last,
                     const std::uint64_t batch)
    : n_scenarios(n_scenarios)
    , first(first)
    , last(last)
    , batch(batch)
  {
    Assert(first <= last && batch > 0, ExcInternalError());
  }


  Task
  Schedule::task(const std::uint64_t number) const
  {
    // Batches are counted from realisation 0, and the first and last one that
    // are wanted may be parts: skip the part before.
    const std::uint64_t whole     = first / batch; // batch of the first
    const std::uint64_t head_end  = std::min((whole + 1) * batch, last);
    const std::uint64_t head_size = (head_end - first) * n_scenarios;
    if (number < head_size)
      {
        const std::uint64_t length = head_end - first;
        return {static_cast<unsigned int>(number / length),
                first + number % length,
                whole};
      }
    const std::uint64_t rest   = number - head_size;
    const std::uint64_t block  = rest / (batch * n_scenarios);
    const std::uint64_t begin  = head_end + block * batch;
    const std::uint64_t length = std::min(batch, last - begin);
    const std::uint64_t inside = rest - block * batch * n_scenarios;
    return {static_cast<unsigned int>(inside / length),
            begin + inside % length,
            begin / batch};
  }


  IndexCounter::IndexCounter(const MPI_Comm communicator)
  {
    MPI_Comm_split_type(
      communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node_communicator);
    int rank;
    MPI_Comm_rank(node_communicator, &rank);

    // Number the nodes by their first ranks.
    MPI_Comm leaders = MPI_COMM_NULL;
    MPI_Comm_split(communicator, rank == 0 ? 0 : MPI_UNDEFINED, 0, &leaders);
    int position[2] = {0, 1};
    if (rank == 0)
      {
        MPI_Comm_rank(leaders, &position[0]);
        MPI_Comm_size(leaders, &position[1]);
        MPI_Comm_free(&leaders);
      }
    MPI_Bcast(position, 2, MPI_INT, 0, node_communicator);
    node    = position[0];
    n_nodes = position[1];

    MPI_Win_allocate_shared(rank == 0 ? sizeof(std::uint64_t) : 0,
                            sizeof(std::uint64_t),
                            MPI_INFO_NULL,
                            node_communicator,
                            &counter,
                            &window);
    if (rank == 0)
      *counter = 0;
    MPI_Barrier(node_communicator);
    MPI_Win_lock_all(0, window);
  }


  IndexCounter::~IndexCounter()
  {
    // An exception is on its way on this rank only: the others do not come to
    // the collective calls below, and the program is about to end them all.
    if (std::uncaught_exceptions() > 0)
      return;
    MPI_Win_unlock_all(window);
    MPI_Win_free(&window);
    MPI_Comm_free(&node_communicator);
  }


  std::uint64_t
  IndexCounter::next()
  {
    const std::uint64_t one = 1;
    std::uint64_t       drawn;
    MPI_Fetch_and_op(&one, &drawn, MPI_UINT64_T, 0, 0, MPI_SUM, window);
    MPI_Win_flush(0, window);
    return node + n_nodes * drawn;
  }
} // namespace Waker
