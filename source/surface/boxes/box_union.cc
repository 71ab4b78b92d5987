// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/surface/boxes/box_union.h>

#include <algorithm>

namespace Waker
{
  template <int dim>
  bool
  cut_at_closed_faces(const BoxUnionRules<dim> &rules, Box<dim> &box)
  {
    for (unsigned int d = 0; d < dim; ++d)
      {
        if (rules.is_closed(2 * d))
          box.lower[d] = std::max(box.lower[d], rules.lower[d]);
        if (rules.is_closed(2 * d + 1))
          box.upper[d] = std::min(box.upper[d], rules.upper[d]);
        if (box.upper[d] - box.lower[d] <= rules.tolerance)
          return false;
      }
    return true;
  }



  template <int dim>
  Tensor<1, dim>
  smallest_extent(const std::vector<Box<dim>> &boxes)
  {
    Tensor<1, dim> smallest;
    for (unsigned int d = 0; d < dim; ++d)
      smallest[d] = boxes.empty() ? 1. : boxes[0].upper[d] - boxes[0].lower[d];
    for (const Box<dim> &box : boxes)
      for (unsigned int d = 0; d < dim; ++d)
        smallest[d] = std::min(smallest[d], box.upper[d] - box.lower[d]);
    return smallest;
  }



  template bool
  cut_at_closed_faces<2>(const BoxUnionRules<2> &, Box<2> &);
  template bool
  cut_at_closed_faces<3>(const BoxUnionRules<3> &, Box<3> &);
  template Tensor<1, 2>
  smallest_extent<2>(const std::vector<Box<2>> &);
  template Tensor<1, 3>
  smallest_extent<3>(const std::vector<Box<3>> &);
} // namespace Waker
