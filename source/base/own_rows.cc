// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/own_rows.h>
#include <waker/base/ranks.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <stdexcept>

namespace Waker
{
  std::vector<int>
  OwnRows::places() const
  {
    std::vector<int> places(n_all, -1);
    if (numbers == nullptr)
      std::iota(places.begin(), places.end(), 0);
    else
      for (std::size_t k = 0; k < numbers->size(); ++k)
        places.at((*numbers)[k]) = static_cast<int>(k);
    return places;
  }


  RowsInOrder::RowsInOrder(const OwnRows &own, const std::size_t block)
    : communicator(own.communicator)
    , n_all(own.n_all)
    , begin(0)
    , end(own.n_all)
  {
    const unsigned int n = n_ranks(communicator);
    if (n == 1 && own.numbers == nullptr)
      return;
    const std::size_t n_blocks = (n_all + block - 1) / block;
    const auto        first_of = [=](const std::size_t rank) {
      return std::min(n_all, n_blocks * rank / n * block);
    };
    const auto rank_of = [&](const std::size_t row) {
      if (row >= n_all)
        throw std::logic_error("a row that is none");
      // This one, or what has been rounded off further.
      std::size_t rank = row / block * n / n_blocks;
      while (first_of(rank + 1) <= row)
        ++rank;
      return rank;
    };
    const unsigned int me = Utilities::MPI::this_mpi_process(communicator);
    begin                 = first_of(me);
    end                   = first_of(me + 1);

    const std::vector<std::uint32_t> &rows = *own.numbers;
    n_out.assign(n, 0);
    n_in.assign(n, 0);
    for (const std::uint32_t row : rows)
      ++n_out[rank_of(row)];
    MPI_Alltoall(
      n_out.data(), 1, MPI_INT, n_in.data(), 1, MPI_INT, communicator);
    begin_out                       = begins_of(n_out);
    begin_in                        = begins_of(n_in);
    std::vector<int>           next = begin_out;
    std::vector<std::uint32_t> leaving(rows.size());
    order.resize(rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k)
      {
        const int place = next[rank_of(rows[k])]++;
        order[place]    = k;
        leaving[place]  = rows[k];
      }
    places.resize(std::accumulate(n_in.begin(), n_in.end(), std::size_t(0)));
    MPI_Alltoallv(leaving.data(),
                  n_out.data(),
                  begin_out.data(),
                  MPI_UINT32_T,
                  places.data(),
                  n_in.data(),
                  begin_in.data(),
                  MPI_UINT32_T,
                  communicator);
    std::vector<bool> is_there(end - begin, false);
    for (std::uint32_t &place : places)
      {
        place -= begin;
        is_there[place] = true;
      }
    if (places.size() != end - begin ||
        std::find(is_there.begin(), is_there.end(), false) != is_there.end())
      throw std::logic_error("rows have got lost between the ranks");
  }


  const std::vector<char> &
  RowsInOrder::values(const std::vector<char> &own,
                      const std::size_t        size,
                      std::vector<char>       &buffer) const
  {
    if (n_out.empty())
      return own;
    std::vector<char> leaving(own.size());
    for (std::size_t k = 0; k < order.size(); ++k)
      std::memcpy(&leaving[k * size], &own[order[k] * size], size);
    std::vector<char> come(places.size() * size);
    const MpiBytes    value(size);
    MPI_Alltoallv(leaving.data(),
                  n_out.data(),
                  begin_out.data(),
                  value.type,
                  come.data(),
                  n_in.data(),
                  begin_in.data(),
                  value.type,
                  communicator);
    buffer.resize(come.size());
    for (std::size_t k = 0; k < places.size(); ++k)
      std::memcpy(&buffer[places[k] * size], &come[k * size], size);
    return buffer;
  }
} // namespace Waker
