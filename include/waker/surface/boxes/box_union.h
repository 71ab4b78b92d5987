// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_surface_boxes_box_union_h
#define waker_surface_boxes_box_union_h

#include <deal.II/base/point.h>

#include <algorithm>
#include <vector>

namespace Waker
{
  using namespace dealii;

  /// A rectangle (2D) or box (3D) along the axes.
  template <int dim>
  struct Box
  {
    Point<dim> lower; // m
    Point<dim> upper; // m
  };

  /**
   * What is taken as inside, besides the boxes, and where the body ends.
   *
   * Beyond a closed face everything counts as body: gaps between the boxes and
   * the face are gaps like others. The contour is cut at the face.
   */
  template <int dim>
  struct BoxUnionRules
  {
    /// Gaps of at most this extent are filled, per direction (m); 0: none.
    Tensor<1, dim> minimum_gap;
    /// 2D: fill alike from the left and from the right. In 3D it is always so.
    bool symmetric = false;
    /// Coordinates closer to each other than this are one (m).
    double tolerance = 1e-10;

    /// The closed faces, bit 2d: the lower, 2d + 1: the upper face in direction
    /// d, and where they are (m).
    unsigned int closed_faces = 0;
    Point<dim>   lower;
    Point<dim>   upper;

    /// Skip the inside of the body. The result is the same
    /// (PlaneCoverage, BlockCoverage).
    bool restricted = true;

    bool
    is_closed(const unsigned int face) const
    {
      return closed_faces >> face & 1u;
    }
  };

  /// Cut a box at the closed faces. False if nothing is left of it.
  template <int dim>
  bool
  cut_at_closed_faces(const BoxUnionRules<dim> &rules, Box<dim> &box);

  /// What all boxes have in common, also those that others have.
  template <int dim>
  struct BoxExtents
  {
    Point<dim>     lower, upper; // of all together (m)
    Tensor<1, dim> smallest;     // of a box in each direction (m)
    double         n = 0.;

    /// Before the first box is added.
    static BoxExtents
    of_none();

    void
    add(const Box<dim> &box)
    {
      for (unsigned int d = 0; d < dim; ++d)
        {
          lower[d]    = std::min(lower[d], box.lower[d]);
          upper[d]    = std::max(upper[d], box.upper[d]);
          smallest[d] = std::min(smallest[d], box.upper[d] - box.lower[d]);
        }
      n += 1.;
    }
  };

  /// Those of these boxes.
  template <int dim>
  BoxExtents<dim>
  extents_of(const std::vector<Box<dim>> &boxes);
} // namespace Waker

#endif
