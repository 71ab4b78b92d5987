// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_grouped_tangents_h
#define waker_mechanics_grouped_tangents_h

#include <waker/mapping/group_stencil.h>
#include <waker/mechanics/point_tangents.h>

#include <algorithm>
#include <array>
#include <vector>

namespace Waker
{
  /**
   * The derivatives of the points' forces in 3D, group by group of points
   * around a node (mapping/point_groups.h), with numbers as the layout has
   * them. Single precision takes half the time, which is that of the memory,
   * and is enough: what a Krylov method needs of a product is a direction. The
   * residual, which says what has converged, is in double precision.
   *
   * The layout has, as one of BlockTangents,
   *   n_in, n_out              how many numbers a point gathers and scatters,
   *   gather(group, g, u, in)     in[.] from the nodes' u, of group number g,
   *   scatter(group, g, out, f)   the nodes' f from out[.],
   *   add_diagonal(group, g, A, f),
   * and A[n_in o + i] = d out_o / d in_i of the group's points between them.
   */
  template <typename Layout>
  class GroupedTangents : public PointTangents<3>
  {
  public:
    using Lanes                           = typename Layout::Lanes;
    using Number                          = typename LaneTraits<Lanes>::Number;
    static constexpr unsigned int n_lanes = LaneTraits<Lanes>::n;

    void
    reinit(const StressUpdate<3>   &stress_update,
           const MaterialPoints<3> &points,
           const Weights<3>        &weights,
           NodalVector             &diagonal) override
    {
      constexpr unsigned int N = Material::block_size;
      groups.reinit(weights);
      // Twice the room, as a vector takes, would be a third of all memory.
      if (groups.size() > tangents.capacity())
        {
          tangents.clear();
          tangents.shrink_to_fit();
          tangents.reserve(groups.size() + groups.size() / 20);
          n_filled.clear();
        }
      tangents.resize(groups.size());
      n_filled.resize(groups.size(), 0);
      // Lanes without a point are 0, as new ones are.
      for (std::size_t g = 0; g < groups.size(); ++g)
        {
          if (groups[g].n_points < n_filled[g])
            tangents[g] = GroupTangent{};
          n_filled[g] = groups[g].n_points;
        }

      double A[n_entries][N];
      for (std::size_t b = 0; b * N < points.n_points(); ++b)
        {
          stress_update.tangent(
            points, b, &A[0][0], Layout::n_out, Layout::n_in);
          const std::size_t n_points =
            std::min<std::size_t>(N, points.n_points() - b * N);
          for (unsigned int l = 0; l < n_points; ++l)
            {
              Lanes *const to   = tangents[groups.group_of(b * N + l)].A;
              const auto   lane = groups.lane_of(b * N + l);
              for (unsigned int k = 0; k < n_entries; ++k)
                to[k][lane] = A[k][l];
            }
        }

      read_first_shares(stress_update.point_motion().filled_cells(),
                        points.n_points());
      const Layout layout(weights, first_shares.data());
      result.assign(diagonal.locally_owned_size(), Number(0));
      for (std::size_t g = 0; g < groups.size(); ++g)
        layout.add_diagonal(groups[g], g, tangents[g].A, result.data());
      std::copy(result.begin(), result.end(), diagonal.begin());
    }

    void
    vmult_add(const Weights<3> &weights,
              const double     *u,
              double           *f) const override
    {
      const Layout layout(weights, first_shares.data());
      direction.assign(u, u + result.size());
      std::fill(result.begin(), result.end(), Number(0));
      for (std::size_t g = 0; g < groups.size(); ++g)
        {
          Lanes in[Layout::n_in], out[Layout::n_out];
          layout.gather(groups[g], g, direction.data(), in);
          const Lanes *A = tangents[g].A;
          for (unsigned int o = 0; o < Layout::n_out; ++o)
            {
              out[o] = Lanes{};
              for (unsigned int i = 0; i < Layout::n_in; ++i)
                out[o] += *A++ * in[i];
            }
          layout.scatter(groups[g], g, out, result.data());
        }
      for (std::size_t dof = 0; dof < result.size(); ++dof)
        f[dof] += result[dof];
    }

  private:
    static constexpr unsigned int n_entries = Layout::n_out * Layout::n_in;

    struct GroupTangent
    {
      Lanes A[n_entries];
    };

    /// @param filled of the motion, or null
    void
    read_first_shares(const FilledCells<3> *filled, const std::size_t n_points)
    {
      first_shares.clear();
      if (filled == nullptr)
        return;
      first_shares.resize(groups.size());
      for (std::size_t p = 0; p < n_points; ++p)
        for (unsigned int d = 0; d < 3; ++d)
          first_shares[groups.group_of(p)][d][groups.lane_of(p)] =
            filled->first_shares(p)[d];
    }

    PointGroups<Lanes>                groups;
    std::vector<GroupTangent>         tangents;
    std::vector<std::array<Lanes, 3>> first_shares; // none without B-bar
    std::vector<unsigned char>        n_filled; // lanes of each, the first ones
    mutable std::vector<Number>       direction, result; // of a product
  };


  /// The tangents of a motion: group by group in 3D, in the precision that is
  /// asked for; by blocks, and in double precision, in 2D.
  template <int dim, typename Layout, template <typename> class GroupLayout>
  std::unique_ptr<PointTangents<dim>>
  make_layout_tangents(const Precision precision)
  {
    if constexpr (dim == 2)
      return std::make_unique<BlockTangents<Layout>>();
    else
      switch (precision)
        {
          case Precision::single_precision:
            return std::make_unique<
              GroupedTangents<GroupLayout<SingleLanes>>>();
          case Precision::double_precision:
            return std::make_unique<
              GroupedTangents<GroupLayout<DoubleLanes>>>();
        }
    return nullptr;
  }
} // namespace Waker

#endif
