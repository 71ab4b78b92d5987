// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/surface/shape/surface.h>

namespace Waker
{
  double
  SurfaceChain::area() const
  {
    if (vertices.size() < 3)
      return 0.;

    // Relative to the first vertex, so that a body far from the origin loses
    // no digits.
    const Point<2> &origin = vertices[0];
    double          twice  = 0.;
    for (std::size_t k = 1; k + 1 < vertices.size(); ++k)
      {
        const Tensor<1, 2> a = vertices[k] - origin;
        const Tensor<1, 2> b = vertices[k + 1] - origin;
        twice += a[0] * b[1] - a[1] * b[0];
      }
    return 0.5 * twice;
  }
} // namespace Waker
