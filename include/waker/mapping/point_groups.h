// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mapping_point_groups_h
#define waker_mapping_point_groups_h

#include <waker/mapping/lanes.h>
#include <waker/mapping/weights.h>

#include <cstdint>
#include <vector>

namespace Waker
{
  /// Points whose stencils are the same nodes: their weights, one point per
  /// lane. A lane without a point has zeros.
  template <typename Lanes>
  struct PointGroup
  {
    unsigned int base;     // lower left node of the stencil
    unsigned int n_points; // the first lanes
    Lanes        value[3][3];
    Lanes        gradient[3][3]; // 1/m
  };


  /**
   * The points of a body in 3D, grouped by the nodes of their stencils: with 2
   * x 2 x 2 points a cell eight points lie around a node and share all 27. What
   * is done group by group loads and stores nodal values once for all of them.
   *
   * The points' own order is left as it is; within a node they are in it.
   */
  template <typename Lanes>
  class PointGroups
  {
  public:
    /// Group the points as the weights have them.
    void
    reinit(const Weights<3> &weights);

    std::size_t
    size() const
    {
      return groups.size();
    }

    const PointGroup<Lanes> &
    operator[](const std::size_t g) const
    {
      return groups[g];
    }

    std::size_t
    group_of(const std::size_t p) const
    {
      return places[p] / n_lanes;
    }

    unsigned int
    lane_of(const std::size_t p) const
    {
      return places[p] % n_lanes;
    }

  private:
    static constexpr unsigned int n_lanes = LaneTraits<Lanes>::n;

    std::vector<PointGroup<Lanes>> groups;
    std::vector<std::uint32_t> places; // n_lanes group + lane, of each point
    std::vector<std::uint32_t> next_place; // by base node
  };
} // namespace Waker

#endif
