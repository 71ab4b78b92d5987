// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/surface/boxes/box_union.h>

#include <algorithm>
#include <limits>

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
  BoxExtents<dim>
  BoxExtents<dim>::of_none()
  {
    constexpr double far = std::numeric_limits<double>::max();
    BoxExtents       none;
    for (unsigned int d = 0; d < dim; ++d)
      {
        none.lower[d] = none.smallest[d] = far;
        none.upper[d]                    = -far;
      }
    return none;
  }



  template <int dim>
  BoxExtents<dim>
  extents_of(const std::vector<Box<dim>> &boxes)
  {
    BoxExtents<dim> extents = BoxExtents<dim>::of_none();
    for (const Box<dim> &box : boxes)
      extents.add(box);
    return extents;
  }



  template bool
  cut_at_closed_faces<2>(const BoxUnionRules<2> &, Box<2> &);
  template bool
  cut_at_closed_faces<3>(const BoxUnionRules<3> &, Box<3> &);
  template struct BoxExtents<2>;
  template struct BoxExtents<3>;
  template BoxExtents<2>
  extents_of<2>(const std::vector<Box<2>> &);
  template BoxExtents<3>
  extents_of<3>(const std::vector<Box<3>> &);
} // namespace Waker
