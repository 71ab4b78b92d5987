// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_ranks_h
#define waker_base_ranks_h

#include <deal.II/base/mpi.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace Waker
{
  using namespace dealii;

  /// So many bytes as MPI counts them: its counts, which are int, are then
  /// those of values, or points, and not of bytes.
  class MpiBytes
  {
  public:
    explicit MpiBytes(const std::size_t n_bytes);

    MpiBytes(const MpiBytes &) = delete;
    MpiBytes &
    operator=(const MpiBytes &) = delete;

    ~MpiBytes();

    MPI_Datatype type;
  };


  /// Of a communicator; one where MPI has not been started.
  unsigned int
  n_ranks(const MPI_Comm communicator);

  /// Those of them that share this machine. Collective.
  unsigned int
  n_ranks_here(const MPI_Comm communicator);

  bool
  is_first_rank(const MPI_Comm communicator);

  /**
   * What one rank does for all of them. A mistake that it finds is one on each.
   * Collective.
   *
   * @throws UserError what the first rank has thrown
   */
  void
  first_rank_does(const MPI_Comm               communicator,
                  const std::function<void()> &action);

  /// The first rank's text. Collective.
  std::string
  shared(const std::string &text, const MPI_Comm communicator);

  /// Where the share of each of several ranks begins, if they have so many; and
  /// the end of the last one.
  std::vector<int>
  begins_of(const std::vector<int> &n);

  /// The first rank's numbers, of which each rank has room for as many.
  /// Collective.
  void
  share(const MPI_Comm communicator, std::vector<double> &numbers);
} // namespace Waker

#endif
