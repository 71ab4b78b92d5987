// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <waker/base/ranks.h>
#include <waker/particles/point_exchange.h>
#include <waker/particles/removal.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <type_traits>

namespace Waker
{
  namespace
  {
    /// An array of points as bytes.
    struct Bytes
    {
      std::size_t                        size; // of a value
      char                              *data;
      std::function<char *(std::size_t)> resize; // to n values; the new data
    };


    template <typename T>
    Bytes
    bytes_of(std::vector<T> &array)
    {
      return {sizeof(T),
              reinterpret_cast<char *>(array.data()),
              [&array](const std::size_t n) {
                array.resize(n);
                return reinterpret_cast<char *>(array.data());
              }};
    }


    /// Do points have this array?
    template <int dim>
    std::vector<bool>
    arrays_in_use(const MaterialPoints<dim> &whole)
    {
      std::vector<bool> used;
      MaterialPoints<dim>::for_each_array(whole,
                                          [&](const char *, const auto &array) {
                                            used.push_back(!array.empty());
                                          });
      return used;
    }


    template <int dim>
    std::vector<Bytes>
    bytes_of_points(MaterialPoints<dim> &points, const std::vector<bool> &used)
    {
      std::vector<Bytes> bytes;
      std::size_t        k = 0;
      MaterialPoints<dim>::for_each_array(points,
                                          [&](const char *, auto &array) {
                                            if (used[k++])
                                              bytes.push_back(bytes_of(array));
                                          });
      return bytes;
    }


    std::size_t
    bytes_per_point(const std::vector<Bytes> &arrays)
    {
      return std::accumulate(arrays.begin(),
                             arrays.end(),
                             std::size_t(0),
                             [](const std::size_t sum, const Bytes &array) {
                               return sum + array.size;
                             });
    }
  } // namespace


  template <int dim>
  PointExchange<dim>::PointExchange(const Partition<dim>      &partition,
                                    const MPI_Comm             communicator,
                                    const MaterialPoints<dim> &whole)
    : communicator(communicator)
    , n_whole(0)
  {
    for (const NamedArray &scalar : whole.scalars)
      points.scalars.push_back({scalar.name, {}});
    take_new(partition, whole);
  }


  template <int dim>
  std::size_t
  PointExchange<dim>::send_home(const Partition<dim> &partition)
  {
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator);
    std::vector<unsigned int> to(points.n_points());
    std::vector<int>          n_out(n_ranks, 0), n_in(n_ranks, 0);
    for (std::size_t p = 0; p < to.size(); ++p)
      {
        to[p] = partition.owner(points.position[p]);
        if (to[p] != rank)
          ++n_out[to[p]];
      }
    unsigned long long n_moved =
      std::accumulate(n_out.begin(), n_out.end(), 0ull);
    MPI_Allreduce(
      MPI_IN_PLACE, &n_moved, 1, MPI_UNSIGNED_LONG_LONG, MPI_SUM, communicator);
    ++sent.reductions;
    if (n_moved == 0)
      return 0;
    MPI_Alltoall(
      n_out.data(), 1, MPI_INT, n_in.data(), 1, MPI_INT, communicator);

    std::vector<Bytes> arrays = bytes_of_points(points, used);
    arrays.push_back(bytes_of(places));
    const std::size_t      size      = bytes_per_point(arrays);
    const std::vector<int> begin_out = begins_of(n_out),
                           begin_in  = begins_of(n_in);
    std::vector<char> to_send(size * begin_out.back());
    std::vector<char> received(size * begin_in.back());

    // Of each leaving point all arrays; those that stay close the gaps.
    std::vector<int> next = begin_out;
    std::size_t      n    = 0;
    for (std::size_t p = 0; p < to.size(); ++p)
      {
        if (to[p] != rank)
          {
            char *place = to_send.data() + size * next[to[p]]++;
            for (const Bytes &array : arrays)
              {
                std::memcpy(place, array.data + p * array.size, array.size);
                place += array.size;
              }
          }
        else
          {
            if (n != p)
              for (const Bytes &array : arrays)
                std::memcpy(array.data + n * array.size,
                            array.data + p * array.size,
                            array.size);
            ++n;
          }
      }
    const MpiBytes point(size);
    MPI_Alltoallv(to_send.data(),
                  n_out.data(),
                  begin_out.data(),
                  point.type,
                  received.data(),
                  n_in.data(),
                  begin_in.data(),
                  point.type,
                  communicator);
    sent.reductions += 4; // as these collectives take as long
    sent.bytes += to_send.size();
    for (const int points_out : n_out)
      sent.messages += points_out > 0 ? 1 : 0;
    const std::size_t n_received = begin_in.back();
    for (Bytes &array : arrays)
      array.data = array.resize(n + n_received);
    const char *from = received.data();
    for (std::size_t p = n; p < n + n_received; ++p)
      for (const Bytes &array : arrays)
        {
          std::memcpy(array.data + p * array.size, from, array.size);
          from += array.size;
        }

    unsigned long long n_all = points.n_points();
    MPI_Allreduce(
      MPI_IN_PLACE, &n_all, 1, MPI_UNSIGNED_LONG_LONG, MPI_SUM, communicator);
    if (n_all != n_whole)
      throw std::logic_error("points have got lost between the ranks");
    return n_moved;
  }


  template <int dim>
  void
  PointExchange<dim>::forget(MaterialPoints<dim> &whole)
  {
    MaterialPoints<dim>::for_each_array(
      whole, [&](const char *const name, auto &array) {
        if (std::strcmp(name, "id") != 0)
          std::decay_t<decltype(array)>().swap(array);
      });
  }


  template <int dim>
  void
  PointExchange<dim>::gather(MaterialPoints<dim> &whole,
                             const Names         &changing,
                             const Names         &constant) const
  {
    const auto is_in = [](const Names &names, const std::string &name) {
      return std::find(names.begin(), names.end(), name) != names.end();
    };
    const bool        is_for_a_step = !changing.empty();
    std::vector<bool> wanted;
    auto              flag = used.begin();
    MaterialPoints<dim>::for_each_array(
      whole, [&](const char *const name, auto &array) {
        wanted.push_back(*flag++ && (!is_for_a_step || is_in(changing, name) ||
                                     (array.empty() && is_in(constant, name))));
        if (wanted.back())
          array.resize(n_whole);
      });

    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    // To be read only.
    auto                    &mine = const_cast<MaterialPoints<dim> &>(points);
    const std::vector<Bytes> from = bytes_of_points(mine, wanted);
    const std::vector<Bytes> to   = bytes_of_points(whole, wanted);

    const int        my_n = points.n_points();
    std::vector<int> all_n(n_ranks);
    MPI_Allgather(&my_n, 1, MPI_INT, all_n.data(), 1, MPI_INT, communicator);
    const std::vector<int>     begin = begins_of(all_n);
    std::vector<std::uint32_t> there(begin.back());
    MPI_Allgatherv(places.data(),
                   my_n,
                   MPI_UINT32_T,
                   there.data(),
                   all_n.data(),
                   begin.data(),
                   MPI_UINT32_T,
                   communicator);

    // Array after array: what waits to be put in its place is never much.
    std::vector<char> received;
    for (std::size_t k = 0; k < to.size(); ++k)
      {
        const std::size_t size = to[k].size;
        const MpiBytes    value(size);
        received.resize(size * there.size());
        if (is_for_a_step) // else it is for a campaign's record, or the end
          {
            ++sent.reductions;
            sent.bytes += size * points.n_points();
          }
        MPI_Allgatherv(from[k].data,
                       my_n,
                       value.type,
                       received.data(),
                       all_n.data(),
                       begin.data(),
                       value.type,
                       communicator);
        for (std::size_t p = 0; p < there.size(); ++p)
          std::memcpy(to[k].data + there[p] * size,
                      received.data() + p * size,
                      size);
      }
  }


  template <int dim>
  void
  PointExchange<dim>::gather_places(MaterialPoints<dim> &whole,
                                    const Names         &constant) const
  {
    gather(whole, {"position", "velocity", "half_size", "volume"}, constant);
  }


  template <int dim>
  void
  PointExchange<dim>::gather(MaterialPoints<dim> &whole) const
  {
    gather(whole, {}, {});
  }


  template <int dim>
  void
  PointExchange<dim>::take(const std::string         &name,
                           const MaterialPoints<dim> &whole)
  {
    auto             &body = const_cast<MaterialPoints<dim> &>(whole);
    std::vector<bool> named;
    MaterialPoints<dim>::for_each_array(whole,
                                        [&](const char *one, const auto &) {
                                          named.push_back(used[named.size()] &&
                                                          name == one);
                                        });
    const std::vector<Bytes> from = bytes_of_points(body, named);
    const std::vector<Bytes> to   = bytes_of_points(points, named);
    for (std::size_t k = 0; k < to.size(); ++k)
      for (std::size_t p = 0; p < places.size(); ++p)
        std::memcpy(to[k].data + p * to[k].size,
                    from[k].data + places[p] * to[k].size,
                    to[k].size);
  }


  template <int dim>
  std::vector<std::size_t>
  PointExchange<dim>::remove(const std::vector<std::size_t> &own_list)
  {
    std::vector<std::uint32_t> leaving;
    for (const std::size_t p : own_list)
      leaving.push_back(places[p]);
    std::vector<std::size_t> list;
    for (const std::vector<std::uint32_t> &part :
         Utilities::MPI::all_gather(communicator, leaving))
      list.insert(list.end(), part.begin(), part.end());
    std::sort(list.begin(), list.end());
    remove_points(own_list, points);
    std::size_t n    = 0;
    auto        next = own_list.begin();
    for (std::size_t p = 0; p < places.size(); ++p)
      if (next != own_list.end() && *next == p)
        ++next;
      else
        places[n++] = places[p];
    places.resize(n);
    for (std::uint32_t &place : places)
      place -= std::lower_bound(list.begin(), list.end(), place) - list.begin();
    n_whole -= list.size();
    return list;
  }


  template <int dim>
  void
  PointExchange<dim>::take_new(const Partition<dim>      &partition,
                               const MaterialPoints<dim> &whole)
  {
    const unsigned int rank  = Utilities::MPI::this_mpi_process(communicator);
    const std::size_t  first = places.size();
    for (std::size_t p = n_whole; p < whole.n_points(); ++p)
      if (partition.owner(whole.position[p]) == rank)
        places.push_back(p);
    n_whole                       = whole.n_points();
    used                          = arrays_in_use(whole);
    auto                    &body = const_cast<MaterialPoints<dim> &>(whole);
    const std::vector<Bytes> from = bytes_of_points(body, used);
    std::vector<Bytes>       to   = bytes_of_points(points, used);
    for (std::size_t k = 0; k < to.size(); ++k)
      {
        char *const data = to[k].resize(places.size());
        for (std::size_t p = first; p < places.size(); ++p)
          std::memcpy(data + p * to[k].size,
                      from[k].data + places[p] * to[k].size,
                      to[k].size);
      }
  }


  template <int dim>
  double
  PointExchange<dim>::imbalance() const
  {
    const double n    = static_cast<double>(points.n_points());
    const double most = Utilities::MPI::max(n, communicator);
    return most * Utilities::MPI::n_mpi_processes(communicator) /
           static_cast<double>(std::max<std::size_t>(n_whole, 1));
  }


  template class PointExchange<2>;
  template class PointExchange<3>;
} // namespace Waker
