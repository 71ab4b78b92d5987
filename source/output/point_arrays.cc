// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/ranks.h>
#include <waker/output/point_arrays.h>

#include "joint_file.h"
#include <cstring>
#include <stdexcept>

namespace Waker
{
  template <int dim>
  std::vector<std::uint64_t>
  array_sizes(const MaterialPoints<dim> &own, const OwnRows &rows)
  {
    std::vector<std::uint64_t> sizes;
    MaterialPoints<dim>::for_each_array(own,
                                        [&](const char *, const auto &array) {
                                          sizes.push_back(
                                            array.empty() ? 0 : rows.n_all);
                                        });
    if (n_ranks(rows.communicator) > 1)
      MPI_Allreduce(MPI_IN_PLACE,
                    sizes.data(),
                    static_cast<int>(sizes.size()),
                    MPI_UINT64_T,
                    MPI_MAX,
                    rows.communicator);
    return sizes;
  }


  template <int dim>
  std::uint64_t
  n_bytes_of_arrays(const MaterialPoints<dim>        &points,
                    const std::vector<std::uint64_t> &sizes)
  {
    std::uint64_t n_bytes = 0;
    auto          size    = sizes.begin();
    MaterialPoints<dim>::for_each_array(points,
                                        [&](const char *, const auto &array) {
                                          n_bytes += *size++ * sizeof(array[0]);
                                        });
    return n_bytes;
  }


  template <int dim>
  void
  add_arrays(const MaterialPoints<dim>        &own,
             const OwnRows                    &rows,
             const std::vector<std::uint64_t> &sizes,
             JointFile                        &file)
  {
    const RowsInOrder order(rows, 1);
    auto              size = sizes.begin();
    std::vector<char> buffer;
    MaterialPoints<dim>::for_each_array(
      own, [&](const char *, const auto &array) {
        if (*size++ == 0)
          return;
        const char *const begin = reinterpret_cast<const char *>(array.data());
        const std::vector<char>  mine(begin,
                                     begin + array.size() * sizeof(array[0]));
        const std::vector<char> &part =
          order.values(mine, sizeof(array[0]), buffer);
        file.add_part(std::string(part.begin(), part.end()));
      });
  }


  template <int dim>
  void
  append_arrays(const MaterialPoints<dim> &points, std::string &bytes)
  {
    MaterialPoints<dim>::for_each_array(
      points, [&](const char *, const auto &array) {
        bytes.append(reinterpret_cast<const char *>(array.data()),
                     array.size() * sizeof(array[0]));
      });
  }


  template <int dim>
  void
  read_arrays(const std::string_view bytes, MaterialPoints<dim> &points)
  {
    std::size_t at = 0;
    MaterialPoints<dim>::for_each_array(points, [&](const char *, auto &array) {
      const std::size_t n = array.size() * sizeof(array[0]);
      if (n > bytes.size() - at)
        throw std::runtime_error("points without their values");
      if (n > 0)
        std::memcpy(static_cast<void *>(array.data()), bytes.data() + at, n);
      at += n;
    });
    if (at != bytes.size())
      throw std::runtime_error("values of other points");
  }


  template std::vector<std::uint64_t>
  array_sizes(const MaterialPoints<2> &, const OwnRows &);
  template std::uint64_t
  n_bytes_of_arrays(const MaterialPoints<2> &,
                    const std::vector<std::uint64_t> &);
  template void
  add_arrays(const MaterialPoints<2> &,
             const OwnRows &,
             const std::vector<std::uint64_t> &,
             JointFile &);
  template void
  append_arrays(const MaterialPoints<2> &, std::string &);
  template void
  read_arrays(const std::string_view, MaterialPoints<2> &);
  template std::vector<std::uint64_t>
  array_sizes(const MaterialPoints<3> &, const OwnRows &);
  template std::uint64_t
  n_bytes_of_arrays(const MaterialPoints<3> &,
                    const std::vector<std::uint64_t> &);
  template void
  add_arrays(const MaterialPoints<3> &,
             const OwnRows &,
             const std::vector<std::uint64_t> &,
             JointFile &);
  template void
  append_arrays(const MaterialPoints<3> &, std::string &);
  template void
  read_arrays(const std::string_view, MaterialPoints<3> &);
} // namespace Waker
