// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/particles/removal.h>

namespace Waker
{
  template <int dim>
  std::vector<std::size_t>
  points_beyond(const Openings<dim>       &openings,
                const MaterialPoints<dim> &points)
  {
    std::vector<std::size_t> list;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      if (openings.is_passed_by(points.position[p]))
        list.push_back(p);
    return list;
  }


  template <int dim>
  void
  remove_points(const std::vector<std::size_t> &list,
                MaterialPoints<dim>            &points)
  {
    if (list.empty())
      return;
    MaterialPoints<dim>::for_each_array(points, [&](const char *, auto &array) {
      if (array.empty())
        return;
      std::size_t kept = list.front();
      for (std::size_t k = 0; k < list.size(); ++k)
        {
          const std::size_t end =
            k + 1 < list.size() ? list[k + 1] : array.size();
          for (std::size_t p = list[k] + 1; p < end; ++p)
            array[kept++] = array[p];
        }
      array.resize(kept);
    });
  }


  template std::vector<std::size_t>
  points_beyond(const Openings<2> &, const MaterialPoints<2> &);
  template std::vector<std::size_t>
  points_beyond(const Openings<3> &, const MaterialPoints<3> &);
  template void
  remove_points(const std::vector<std::size_t> &, MaterialPoints<2> &);
  template void
  remove_points(const std::vector<std::size_t> &, MaterialPoints<3> &);
} // namespace Waker
