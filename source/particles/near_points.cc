// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/grid/near_cells.h>
#include <waker/particles/near_points.h>

#include <algorithm>
#include <array>

namespace Waker
{
  namespace
  {
    /// What a rank is told of a point.
    template <int dim>
    struct Told
    {
      std::uint64_t           id;
      std::array<double, dim> position, half_size;
      double                  volume;
    };
  } // namespace


  template <int dim>
  const MaterialPoints<dim> &
  own_and_near(const Body<dim>     &body,
               const double         reach,
               MaterialPoints<dim> &around)
  {
    const MaterialPoints<dim> &own = body.own();
    if (body.window() == nullptr)
      return own;
    const auto tell = [&](const std::size_t p, Told<dim> &told) {
      told.id = own.id[p];
      for (unsigned int d = 0; d < dim; ++d)
        {
          told.position[d]  = own.position[p][d];
          told.half_size[d] = own.half_size.empty() ? 0. : own.half_size[p][d];
        }
      told.volume = own.volume.empty() ? 0. : own.volume[p];
      return true;
    };
    std::vector<Told<dim>> all =
      body.window()->near_cells().template gather<Told<dim>>(own.position,
                                                             reach,
                                                             tell);
    for (std::size_t p = 0; p < own.n_points(); ++p)
      {
        all.emplace_back();
        tell(p, all.back());
      }
    std::sort(all.begin(), all.end(), [](const auto &a, const auto &b) {
      return a.id < b.id;
    });
    const std::size_t n = all.size();
    around.id.resize(n);
    around.position.resize(n);
    around.half_size.resize(n);
    around.volume.resize(n);
    for (std::size_t p = 0; p < n; ++p)
      {
        around.id[p]     = all[p].id;
        around.volume[p] = all[p].volume;
        for (unsigned int d = 0; d < dim; ++d)
          {
            around.position[p][d]  = all[p].position[d];
            around.half_size[p][d] = all[p].half_size[d];
          }
      }
    return around;
  }


  template <int dim>
  double
  largest_half_size(const MaterialPoints<dim> &points)
  {
    double largest = 0.;
    for (const Tensor<1, dim> &l : points.half_size)
      for (unsigned int d = 0; d < dim; ++d)
        largest = std::max(largest, l[d]);
    return largest;
  }


  template const MaterialPoints<2> &
  own_and_near(const Body<2> &, const double, MaterialPoints<2> &);
  template const MaterialPoints<3> &
  own_and_near(const Body<3> &, const double, MaterialPoints<3> &);
  template double
  largest_half_size(const MaterialPoints<2> &);
  template double
  largest_half_size(const MaterialPoints<3> &);
} // namespace Waker
