// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/index_set.h>
#include <deal.II/base/partitioner.h>

#include <waker/base/errors.h>
#include <waker/base/ranks.h>
#include <waker/grid/node_exchange.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace Waker
{
  /// Who is told what, as deal.II's partitioner finds it out.
  struct NodeExchange::Plan
  {
    /// Nodes of the window that are shared with one rank.
    struct Neighbour
    {
      unsigned int              rank;
      std::vector<unsigned int> nodes; // in the same order on both sides
    };

    std::vector<Neighbour> owners; // of foreign nodes
    std::vector<Neighbour> users;  // of own nodes

    // Work space.
    std::vector<double>      from_owners, from_users;
    std::vector<MPI_Request> requests;
  };


  NodeExchange::NodeExchange(const std::size_t /*n_nodes*/)
    : mpi_communicator(MPI_COMM_SELF)
  {}


  NodeExchange::NodeExchange(const MPI_Comm                    communicator,
                             const std::size_t                 n_nodes,
                             const std::vector<unsigned int>  &owned,
                             const std::vector<unsigned int>  &foreign,
                             const std::uint64_t               first_owned,
                             const std::uint64_t               n_all,
                             const std::vector<std::uint64_t> &numbers)
    : mpi_communicator(communicator)
    , is_owned(n_nodes, 0)
    , plan(std::make_unique<Plan>())
  {
    for (const unsigned int node : owned)
      is_owned[node] = 1;

    // In the order of their numbers the foreign nodes are sorted by owners.
    std::vector<std::size_t> order(foreign.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
      return numbers[a] < numbers[b];
    });
    IndexSet own(n_all), others(n_all);
    own.add_range(first_owned, first_owned + owned.size());
    for (const std::size_t k : order)
      others.add_index(numbers[k]);
    own.compress();
    others.compress();
    const Utilities::MPI::Partitioner partitioner(own, others, communicator);

    std::size_t k = 0;
    for (const auto &[rank, n] : partitioner.ghost_targets())
      {
        plan->owners.push_back({rank, {}});
        for (unsigned int i = 0; i < n; ++i, ++k)
          plan->owners.back().nodes.push_back(foreign[order[k]]);
      }
    // Ranges of own nodes, user after user.
    std::vector<unsigned int> used;
    for (const auto &[begin, end] : partitioner.import_indices())
      for (unsigned int i = begin; i < end; ++i)
        used.push_back(owned[i]);
    auto next = used.begin();
    for (const auto &[rank, n] : partitioner.import_targets())
      {
        plan->users.push_back({rank, {next, next + n}});
        next += n;
      }
  }


  NodeExchange::~NodeExchange() = default;


  namespace
  {
    constexpr int tag = 4711;


    unsigned int
    n_components(const std::initializer_list<NodeExchange::Array> &arrays)
    {
      unsigned int n = 0;
      for (const NodeExchange::Array &array : arrays)
        n += array.n_components;
      return n;
    }


    template <typename Neighbours>
    std::size_t
    n_nodes(const Neighbours &neighbours)
    {
      std::size_t n = 0;
      for (const auto &neighbour : neighbours)
        n += neighbour.nodes.size();
      return n;
    }


    /// Call f(array's entry, buffer's entry) for all that a list of nodes has.
    template <typename Function>
    void
    for_each_entry(const std::vector<unsigned int>                  &nodes,
                   const std::initializer_list<NodeExchange::Array> &arrays,
                   double                                           *buffer,
                   const Function                                   &f)
    {
      for (const NodeExchange::Array &array : arrays)
        for (const unsigned int node : nodes)
          for (unsigned int c = 0; c < array.n_components; ++c)
            f(array.values[std::size_t(array.n_components) * node + c],
              *buffer++);
    }


    /// Send from one list of neighbours to the other: what `pack` leaves in the
    /// buffer of the one arrives in that of the other.
    template <typename Neighbours, typename Pack, typename Unpack>
    void
    exchange(const MPI_Comm            communicator,
             const unsigned int        n,
             const Neighbours         &receivers,
             std::vector<double>      &to_send,
             const Neighbours         &senders,
             std::vector<double>      &to_receive,
             std::vector<MPI_Request> &requests,
             NodeExchange::Traffic    &sent,
             const Pack               &pack,
             const Unpack             &unpack)
    {
      to_send.resize(n * n_nodes(receivers));
      to_receive.resize(n * n_nodes(senders));
      requests.resize(senders.size() + receivers.size());
      auto    request = requests.begin();
      double *buffer  = to_receive.data();
      for (const auto &sender : senders)
        {
          MPI_Irecv(buffer,
                    n * sender.nodes.size(),
                    MPI_DOUBLE,
                    sender.rank,
                    tag,
                    communicator,
                    &*request++);
          buffer += n * sender.nodes.size();
        }
      buffer = to_send.data();
      for (const auto &receiver : receivers)
        {
          pack(receiver.nodes, buffer);
          MPI_Isend(buffer,
                    n * receiver.nodes.size(),
                    MPI_DOUBLE,
                    receiver.rank,
                    tag,
                    communicator,
                    &*request++);
          buffer += n * receiver.nodes.size();
          ++sent.messages;
          sent.bytes += sizeof(double) * n * receiver.nodes.size();
        }
      MPI_Waitall(requests.size(), requests.data(), MPI_STATUSES_IGNORE);
      // In the order of the ranks: sums have the same bits in every run.
      buffer = to_receive.data();
      for (const auto &sender : senders)
        {
          unpack(sender.nodes, buffer);
          buffer += n * sender.nodes.size();
        }
    }
  } // namespace


  void
  NodeExchange::add_to_owners(const std::initializer_list<Array> arrays) const
  {
    if (plan == nullptr)
      return;
    exchange(
      mpi_communicator,
      n_components(arrays),
      plan->owners,
      plan->from_users,
      plan->users,
      plan->from_owners,
      plan->requests,
      sent,
      [&](const std::vector<unsigned int> &nodes, double *const buffer) {
        for_each_entry(nodes, arrays, buffer, [](double &entry, double &there) {
          there = entry;
          entry = 0.;
        });
      },
      [&](const std::vector<unsigned int> &nodes, double *const buffer) {
        for_each_entry(nodes, arrays, buffer, [](double &entry, double &there) {
          entry += there;
        });
      });
  }


  void
  NodeExchange::send_to_others(const std::initializer_list<Array> arrays) const
  {
    if (plan == nullptr)
      return;
    exchange(
      mpi_communicator,
      n_components(arrays),
      plan->users,
      plan->from_owners,
      plan->owners,
      plan->from_users,
      plan->requests,
      sent,
      [&](const std::vector<unsigned int> &nodes, double *const buffer) {
        for_each_entry(nodes, arrays, buffer, [](double &entry, double &there) {
          there = entry;
        });
      },
      [&](const std::vector<unsigned int> &nodes, double *const buffer) {
        for_each_entry(nodes, arrays, buffer, [](double &entry, double &there) {
          entry = there;
        });
      });
  }


  void
  NodeExchange::clear_others(const Array &array) const
  {
    if (plan == nullptr)
      return;
    for (std::size_t node = 0; node < is_owned.size(); ++node)
      if (!is_owned[node])
        std::fill_n(array.values + array.n_components * node,
                    array.n_components,
                    0.);
  }


  void
  NodeExchange::sum(double *const numbers, const unsigned int n) const
  {
    if (plan == nullptr)
      return;
    MPI_Allreduce(
      MPI_IN_PLACE, numbers, n, MPI_DOUBLE, MPI_SUM, mpi_communicator);
    ++sent.reductions;
    sent.bytes += n * sizeof(double);
  }


  void
  NodeExchange::gather_values(
    const std::size_t                           size,
    const void *const                           mine,
    const std::size_t                           n_mine,
    const std::function<void *(std::size_t n)> &make_room) const
  {
    const int        my_n = static_cast<int>(n_mine);
    std::vector<int> n(Utilities::MPI::n_mpi_processes(mpi_communicator));
    MPI_Allgather(&my_n, 1, MPI_INT, n.data(), 1, MPI_INT, mpi_communicator);
    const std::vector<int> begin = begins_of(n);
    const MpiBytes         value(size);
    MPI_Allgatherv(mine,
                   my_n,
                   value.type,
                   make_room(begin.back()),
                   n.data(),
                   begin.data(),
                   value.type,
                   mpi_communicator);
    sent.reductions += 2;
    sent.bytes += n_mine * size;
  }


  void
  NodeExchange::largest(double *const numbers, const unsigned int n) const
  {
    if (plan == nullptr || n == 0)
      return;
    MPI_Allreduce(
      MPI_IN_PLACE, numbers, n, MPI_DOUBLE, MPI_MAX, mpi_communicator);
    ++sent.reductions;
  }


  void
  NodeExchange::together(const std::function<void()> &action) const
  {
    if (plan == nullptr)
      return action();
    std::string problem;
    try
      {
        action();
      }
    catch (const NumericalFailure &failure)
      {
        problem = failure.what();
      }
    if (largest(problem.empty() ? 0. : 1.) == 0.)
      return;
    for (const std::string &text :
         Utilities::MPI::all_gather(mpi_communicator, problem))
      if (!text.empty())
        throw NumericalFailure(text);
  }
} // namespace Waker
