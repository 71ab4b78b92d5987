// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_schedule_h
#define waker_campaign_schedule_h

#include <deal.II/base/mpi.h>

#include <cstdint>
#include <vector>

namespace Waker
{
  struct Task
  {
    unsigned int  scenario;
    std::uint64_t realisation;
    std::uint64_t batch; // of the realisation
  };


  /**
   * In which order the realisations of a campaign are computed: batch by batch,
   * in each batch scenario by scenario, so that all scenarios grow alike.
   */
  class Schedule
  {
  public:
    /// Realisations first <= i < last of each scenario.
    Schedule(const unsigned int  n_scenarios,
             const std::uint64_t first,
             const std::uint64_t last,
             const std::uint64_t batch);

    /// Number of tasks.
    std::uint64_t
    size() const
    {
      return n_scenarios * (last - first);
    }

    /// 0 <= number < size()
    Task
    task(const std::uint64_t number) const;

  private:
    std::uint64_t n_scenarios, first, last, batch;
  };


  /**
   * Deals out 0, 1, 2, ... to the ranks of a communicator, each number once,
   * to whoever asks next. A counter in memory per node, which ranks add to with
   * one-sided MPI, so that no rank is spent on serving the others; between
   * nodes the numbers are dealt in turn (node k of m gets k, k + m, ...).
   * Collective: construction and destruction.
   */
  class IndexCounter
  {
  public:
    explicit IndexCounter(const MPI_Comm communicator);
    ~IndexCounter();
    IndexCounter(const IndexCounter &) = delete;
    IndexCounter &
    operator=(const IndexCounter &) = delete;

    std::uint64_t
    next();

  private:
    MPI_Comm       node_communicator = MPI_COMM_NULL;
    MPI_Win        window            = MPI_WIN_NULL;
    std::uint64_t *counter           = nullptr; // on the node's first rank
    std::uint64_t  node              = 0;
    std::uint64_t  n_nodes           = 1;
  };
} // namespace Waker

#endif
