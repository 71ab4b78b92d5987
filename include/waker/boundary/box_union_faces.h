// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_boundary_box_union_faces_h
#define waker_boundary_box_union_faces_h

#include <waker/boundary/box_union.h>
#include <waker/boundary/box_union_coordinates.h>
#include <waker/boundary/box_union_coverage.h>
#include <waker/boundary/facet.h>

#include <vector>

namespace Waker
{
  class BoxUnionFaces
  {
  public:
    void
    find(const std::vector<Box<3>> &boxes,
         const BoxUnionRules<3>    &rules,
         Facets<3>                 &facets);
  };
} // namespace Waker

#endif
