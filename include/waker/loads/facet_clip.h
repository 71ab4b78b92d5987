// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_facet_clip_h
#define waker_loads_facet_clip_h

#include <waker/surface/shape/facet.h>

namespace Waker
{
  /**
   * Cut a facet by the plane n . x = c, exactly: append what lies at n . x <= c
   * to `below` and the rest to `above`, with normal and mark of the facet. A
   * facet in the plane goes below. Up to two triangles on a side in 3D.
   */
  template <int dim>
  void
  cut_facet(const Facet<dim>     &facet,
            const Tensor<1, dim> &n,
            const double          c,
            Facets<dim>          &below,
            Facets<dim>          &above);


  /// The part of the facets at n . x <= c; one that is nowhere above the plane
  /// by more than the tolerance (m) stays whole. `work` is overwritten.
  template <int dim>
  void
  keep_below(const Tensor<1, dim> &n,
             const double          c,
             const double          tolerance,
             Facets<dim>          &facets,
             Facets<dim>          &work);
} // namespace Waker

#endif
