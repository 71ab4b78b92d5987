// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/boundary/box_union_faces.h>
namespace Waker{
void BoxUnionFaces::find(const std::vector<Box<3>> &, const BoxUnionRules<3> &, Facets<3> &facets){facets.clear();}
}
