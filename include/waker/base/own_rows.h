// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_own_rows_h
#define waker_base_own_rows_h

#include <deal.II/base/mpi.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace Waker
{
  using namespace dealii;

  /// Which rows of a table (points of a body, say) a rank has, where ranks
  /// share the table: each row is on one of them.
  struct OwnRows
  {
    /// All of them, in their order, on a rank that is alone.
    explicit OwnRows(const std::size_t n_all)
      : n_all(n_all)
    {}

    /// @param numbers of the own rows among all of them, in the order in which
    ///        the rank has them: kept by reference
    OwnRows(const MPI_Comm                    communicator,
            const std::size_t                 n_all,
            const std::vector<std::uint32_t> &numbers)
      : communicator(communicator)
      , n_all(n_all)
      , numbers(&numbers)
    {}

    /// The own ones of a value that is known of all rows.
    template <typename T>
    std::vector<T>
    of(const std::vector<T> &all) const
    {
      if (numbers == nullptr)
        return all;
      std::vector<T> own;
      own.reserve(numbers->size());
      for (const std::uint32_t row : *numbers)
        own.push_back(all.at(row));
      return own;
    }

    /// Of each row its place among the own ones, or -1.
    std::vector<int>
    places() const;

    MPI_Comm                          communicator = MPI_COMM_SELF;
    std::size_t                       n_all;
    const std::vector<std::uint32_t> *numbers = nullptr; // null: all of them
  };


  /**
   * Rows that ranks share, put in their order: each rank gets a range of them,
   * as long as the others', which follows that of the rank before. What a file
   * needs that all ranks write together.
   */
  class RowsInOrder
  {
  public:
    /**
     * Collective.
     *
     * @param block ranges begin at multiples of so many rows
     * @throws std::logic_error if the own rows of all ranks are not all rows: a
     *         bug
     */
    RowsInOrder(const OwnRows &own, const std::size_t block);

    /**
     * The values of the rows in this rank's range. Collective.
     *
     * @param own of the own rows, `size` bytes each
     * @param buffer where the result is, unless it is `own` itself
     */
    const std::vector<char> &
    values(const std::vector<char> &own,
           const std::size_t        size,
           std::vector<char>       &buffer) const;

    const MPI_Comm    communicator;
    const std::size_t n_all;
    /// This rank's range, without its end.
    std::size_t begin, end;

  private:
    std::vector<std::uint32_t> order;  // of own rows, as they are sent
    std::vector<std::uint32_t> places; // in the range, of those received
    std::vector<int>           n_out, n_in, begin_out, begin_in; // of ranks
  };
} // namespace Waker

#endif
