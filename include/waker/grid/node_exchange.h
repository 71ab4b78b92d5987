// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_grid_node_exchange_h
#define waker_grid_node_exchange_h

#include <deal.II/base/mpi.h>

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <type_traits>
#include <vector>

namespace Waker
{
  using namespace dealii;

  /**
   * What the ranks of one realisation have to tell each other about the nodes
   * of the background grid. Each node has one owner; a rank has a window of the
   * grid (BackgroundGrid), in which beside its own nodes there are those of
   * others that its points reach. On one rank, which owns all of its nodes,
   * nothing is told, and every function returns at once.
   *
   * All functions are collective: each rank calls them, in the same order.
   */
  class NodeExchange
  {
  public:
    /// One rank, which owns all `n_nodes` nodes.
    explicit NodeExchange(const std::size_t n_nodes);

    /**
     * @param communicator of the realisation
     * @param n_nodes of this rank's window
     * @param owned those of them that are its own, ascending
     * @param number of the window's nodes that others own but this rank's
     *        points reach, in any order
     * @param first_owned number of its first own node, counted over all ranks:
     *        own nodes are numbered in the order of `owned`
     * @param numbers of the foreign nodes, by their owners
     */
    NodeExchange(const MPI_Comm                    communicator,
                 const std::size_t                 n_nodes,
                 const std::vector<unsigned int>  &owned,
                 const std::vector<unsigned int>  &foreign,
                 const std::uint64_t               first_owned,
                 const std::uint64_t               n_all,
                 const std::vector<std::uint64_t> &numbers);

    ~NodeExchange();

    bool
    is_one_rank() const
    {
      return plan == nullptr;
    }

    MPI_Comm
    communicator() const
    {
      return mpi_communicator;
    }

    /// Is the node this rank's own?
    bool
    owns(const std::size_t node) const
    {
      return plan == nullptr || is_owned[node];
    }

    /// An array over the window's nodes, `n_components` numbers a node.
    struct Array
    {
      double      *values;
      unsigned int n_components;
    };

    /// What the ranks have found of their nodes is summed up: to the owners.
    /// At nodes of others it is 0 then.
    void
    add_to_owners(const std::initializer_list<Array> arrays) const;

    /// What the owners have goes to all that reach the nodes.
    void
    send_to_others(const std::initializer_list<Array> arrays) const;

    /// Both: wherever a node is reached, the sum over all ranks.
    void
    sum(const std::initializer_list<Array> arrays) const
    {
      if (plan == nullptr)
        return;
      add_to_owners(arrays);
      send_to_others(arrays);
    }

    /// Nodes of others get 0.
    void
    clear_others(const Array &array) const;

    /// Numbers of each rank become their sums over all ranks; the same bits on
    /// each.
    void
    sum(double *numbers, const unsigned int n) const;

    double
    sum(double number) const
    {
      sum(&number, 1);
      return number;
    }

    /// The largest of the numbers of each rank.
    void
    largest(double *numbers, const unsigned int n) const;

    double
    largest(double number) const
    {
      largest(&number, 1);
      return number;
    }

    /// What all ranks have, rank by rank, as bytes.
    template <typename T>
    std::vector<T>
    all_gather(const std::vector<T> &mine) const
    {
      static_assert(std::is_trivially_copyable<T>::value,
                    "this is copied byte by byte");
      if (plan == nullptr)
        return mine;
      std::vector<T> all;
      gather_values(sizeof(T), mine.data(), mine.size(), [&](std::size_t n) {
        all.resize(n);
        return static_cast<void *>(all.data());
      });
      return all;
    }

    /// Do what may fail on one rank alone: it fails on all of them. The action
    /// must tell the others nothing: who fails would leave them waiting.
    /// @throws NumericalFailure what one of them has thrown
    void
    together(const std::function<void()> &action) const;

    /// Messages and bytes that this rank has sent so far.
    struct Traffic
    {
      std::uint64_t messages   = 0;
      std::uint64_t bytes      = 0;
      std::uint64_t reductions = 0;

      void
      operator+=(const Traffic &other)
      {
        messages += other.messages;
        bytes += other.bytes;
        reductions += other.reductions;
      }
    };

    const Traffic &
    traffic() const
    {
      return sent;
    }

  private:
    struct Plan;

    /// @param make_room for so many values; returns where they go
    void
    gather_values(const std::size_t                           size,
                  const void                                 *mine,
                  const std::size_t                           n_mine,
                  const std::function<void *(std::size_t n)> &make_room) const;

    MPI_Comm                   mpi_communicator;
    std::vector<unsigned char> is_owned; // empty on one rank
    std::unique_ptr<Plan>      plan;     // none on one rank
    mutable Traffic            sent;
  };
} // namespace Waker

#endif
