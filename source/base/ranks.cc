// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/ranks.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace Waker
{
  MpiBytes::MpiBytes(const std::size_t n_bytes)
  {
    MPI_Type_contiguous(static_cast<int>(n_bytes), MPI_BYTE, &type);
    MPI_Type_commit(&type);
  }


  MpiBytes::~MpiBytes()
  {
    MPI_Type_free(&type);
  }


  unsigned int
  n_ranks(const MPI_Comm communicator)
  {
    int is_used = 0;
    MPI_Initialized(&is_used);
    return is_used != 0 ? Utilities::MPI::n_mpi_processes(communicator) : 1;
  }


  unsigned int
  n_ranks_here(const MPI_Comm communicator)
  {
    if (n_ranks(communicator) == 1)
      return 1;
    MPI_Comm machine;
    MPI_Comm_split_type(
      communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
    const unsigned int n = Utilities::MPI::n_mpi_processes(machine);
    MPI_Comm_free(&machine);
    return n;
  }


  bool
  is_first_rank(const MPI_Comm communicator)
  {
    return n_ranks(communicator) == 1 ||
           Utilities::MPI::this_mpi_process(communicator) == 0;
  }


  void
  first_rank_does(const MPI_Comm               communicator,
                  const std::function<void()> &action)
  {
    if (n_ranks(communicator) == 1)
      return action();
    std::vector<std::string> mistake;
    if (is_first_rank(communicator))
      try
        {
          action();
        }
      catch (const UserError &error)
        {
          mistake = {error.where, error.problem, error.allowed};
        }
    mistake = Utilities::MPI::broadcast(communicator, mistake);
    if (!mistake.empty())
      throw UserError(mistake[0], mistake[1], mistake[2]);
  }


  std::string
  shared(const std::string &text, const MPI_Comm communicator)
  {
    return n_ranks(communicator) == 1
             ? text
             : Utilities::MPI::broadcast(communicator, text);
  }


  void
  share(const MPI_Comm communicator, std::vector<double> &numbers)
  {
    if (n_ranks(communicator) == 1)
      return;
    constexpr std::size_t most = std::size_t(1) << 30; // MPI counts with int
    for (std::size_t begin = 0; begin < numbers.size(); begin += most)
      MPI_Bcast(numbers.data() + begin,
                static_cast<int>(std::min(most, numbers.size() - begin)),
                MPI_DOUBLE,
                0,
                communicator);
  }


  std::vector<int>
  begins_of(const std::vector<int> &n)
  {
    std::vector<int> begins(n.size() + 1, 0);
    std::partial_sum(n.begin(), n.end(), begins.begin() + 1);
    return begins;
  }
} // namespace Waker
