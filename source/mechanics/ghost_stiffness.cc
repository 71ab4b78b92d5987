// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/ghost_stiffness.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    /// A node with less than this share of a full node's mass is hardly
    /// touched. (At a straight edge on the grid it is 1/2, at a corner
    /// 1/2^dim.)
    constexpr double hardly_touched = 0.01;
  } // namespace


  template <int dim>
  GhostStiffness<dim>::GhostStiffness(const BackgroundGrid<dim> &grid,
                                      const Fixities<dim>       &fixities,
                                      const double               stiffness,
                                      const double               full_node_mass)
    : grid(&grid)
    , fixities(&fixities)
    , k(stiffness * std::pow(grid.cell_size(), dim - 2))
    , full_node_mass(full_node_mass)
  {}


  template <int dim>
  void
  GhostStiffness<dim>::begin(const MaterialPoints<dim> &,
                             const NodalState &nodes,
                             const double,
                             const double)
  {
    const std::vector<double> &mass  = nodes.mass;
    const double               limit = hardly_touched * full_node_mass;
    rows.clear();
    for (unsigned int node = 0; node < mass.size(); ++node)
      {
        // Each by one rank, which reaches the nodes beside its own.
        if (mass[node] == 0. || !grid->exchange().owns(node))
          continue;
        const auto index = grid->node_index(node);
        for (unsigned int d = 0; d < dim; ++d)
          {
            if (index[d] == 0 ||
                index[d] + 1 ==
                  static_cast<int>(grid->n_nodes_per_direction()[d]))
              continue;
            const unsigned int stride = grid->stride(d);
            bool               there = true, hardly = false;
            for (const unsigned int i : {node - stride, node, node + stride})
              {
                there  = there && mass[i] > 0.;
                hardly = hardly || mass[i] < limit;
              }
            if (!there || !hardly)
              continue;
            // One that is held is held: only free ones have to follow.
            for (unsigned int c = 0; c < dim; ++c)
              {
                bool free = false, held = false;
                for (const unsigned int i :
                     {node - stride, node, node + stride})
                  if (mass[i] < limit)
                    {
                      const bool removed = fixities->removed()[dim * i + c];
                      free               = free || !removed;
                      held               = held || removed;
                    }
                if (free && !held)
                  rows.push_back({dim * node + c, dim * stride});
              }
          }
      }
  }


  template <int dim>
  void
  GhostStiffness<dim>::vmult_add(NodalVector &dst, const NodalVector &src) const
  {
    const double *const x = src.begin();
    double *const       f = dst.begin();
    for (const Row &row : rows)
      {
        const unsigned int i = row.middle, s = row.distance;
        const double       bend = k * (x[i - s] - 2. * x[i] + x[i + s]);
        f[i - s] += bend;
        f[i] -= 2. * bend;
        f[i + s] += bend;
      }
  }


  template <int dim>
  void
  GhostStiffness<dim>::add_diagonal(NodalVector &diagonal) const
  {
    double *const d = diagonal.begin();
    for (const Row &row : rows)
      {
        d[row.middle - row.distance] += k;
        d[row.middle] += 4. * k;
        d[row.middle + row.distance] += k;
      }
  }


  template <int dim>
  void
  GhostStiffness<dim>::add_entries(MatrixEntries &entries) const
  {
    constexpr unsigned int n             = 3 * dim;
    constexpr double       bend[3]       = {1., -2., 1.};
    double                 matrix[n * n] = {};
    for (const Row &row : rows)
      {
        const unsigned int middle = row.middle / dim, c = row.middle % dim,
                           distance = row.distance / dim;
        const unsigned int nodes[]  = {middle - distance,
                                       middle,
                                       middle + distance};
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            matrix[n * (dim * i + c) + dim * j + c] = k * bend[i] * bend[j];
        entries.add({nodes, 3}, {matrix, n * n});
        std::fill_n(matrix, n * n, 0.);
      }
  }


  template <int dim>
  Tensor<1, dim>
  GhostStiffness<dim>::accept(const NodalVector &, MaterialPoints<dim> &)
  {
    return Tensor<1, dim>(); // each spring's forces are in balance
  }


  template <int dim>
  ResistanceWork
  GhostStiffness<dim>::work(const NodalVector &increment) const
  {
    const double *const u   = increment.begin();
    double              sum = 0.;
    for (const Row &row : rows)
      {
        const unsigned int i = row.middle, s = row.distance;
        const double       bend = u[i - s] - 2. * u[i] + u[i + s];
        sum += k * bend * bend;
      }
    return {0., -sum};
  }


  template class GhostStiffness<2>;
  template class GhostStiffness<3>;
} // namespace Waker
