// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/nodes/wall.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  template <int dim>
  void
  Walls<dim>::reinit(const std::vector<double> &node_mass,
                     const double               t,
                     Tractions                 &tractions)
  {
    AssertDimension(tractions.size(), spots.size());
    carried = &tractions;
    contacts.clear();
    nodes.clear();
    weights.clear();
    for (Wall &wall : walls)
      wall.target = displacement(wall, t); // of the whole wall, here
    for (std::size_t q = 0; q < spots.size(); ++q)
      {
        Spot &spot       = spots[q];
        spot.position    = spot.reference + walls[spot.wall].target;
        const auto begin = nodes.size();
        spot.touches     = find_nodes(spot, node_mass);
        if (spot.touches)
          contacts.push_back({q, begin, nodes.size(), tractions[q]});
        else
          tractions[q] = Tensor<1, dim>();
      }
    for (Wall &wall : walls)
      wall.target = Tensor<1, dim>();
  }


  template <int dim>
  bool
  Walls<dim>::find_nodes(const Spot &spot, const std::vector<double> &node_mass)
  {
    constexpr unsigned int n_corners = 1 << dim;
    if (!grid->contains(spot.position))
      return false;
    auto   cell = grid->cell_index(spot.position);
    double local[dim];
    for (unsigned int d = 0; d < dim; ++d)
      {
        const int last = grid->n_nodes_per_direction()[d] - 2;
        cell[d]        = std::clamp(cell[d], 0, last);
        local[d] =
          (spot.position[d] - grid->origin()[d]) * grid->inverse_cell_size() -
          cell[d];
      }
    const unsigned int base = grid->node(cell);
    unsigned int       corner_node[n_corners];
    double             N[n_corners], share = 0.;
    for (unsigned int c = 0; c < n_corners; ++c)
      {
        corner_node[c] = base;
        N[c]           = 1.;
        for (unsigned int d = 0; d < dim; ++d)
          {
            const bool upper = c >> d & 1;
            corner_node[c] += upper ? grid->stride(d) : 0;
            N[c] *= upper ? local[d] : 1. - local[d];
          }
        share +=
          N[c] * std::min(1., node_mass[corner_node[c]] / full_node_mass);
      }
    if (!(share >= contact_share))
      return false;
    for (unsigned int c = 0; c < n_corners; ++c)
      if (N[c] != 0.)
        {
          if (node_mass[corner_node[c]] >= weak_share * full_node_mass)
            {
              nodes.push_back(corner_node[c]);
              weights.push_back(N[c]);
            }
          else
            hand_inwards(corner_node[c], c, N[c], spot, node_mass);
        }
    return true;
  }


  template <int dim>
  void
  Walls<dim>::hand_inwards(const unsigned int         node,
                           const unsigned int         corner,
                           const double               weight,
                           const Spot                &spot,
                           const std::vector<double> &node_mass)
  {
    // Steps into the cell and along the normal, so that all nodes of a spot
    // lie within two cells of each other.
    double best[2] = {-1., -1.};
    int    step[2] = {0, 0}; // with two nodes in reach, with one
    for (unsigned int way = 1; way < 1 << dim; ++way)
      {
        int          stride  = 0;
        double       along   = 0.;
        unsigned int n       = 0;
        bool         allowed = true;
        for (unsigned int d = 0; d < dim; ++d)
          if (way >> d & 1)
            {
              const int sign = corner >> d & 1 ? -1 : 1;
              stride += sign * static_cast<int>(grid->stride(d));
              along += sign * spot.normal[d];
              allowed = allowed && sign * spot.normal[d] >= 0.;
              ++n;
            }
        if (!allowed)
          continue;
        along /= std::sqrt(n);
        const auto is_strong = [&](const int steps) {
          const long other = static_cast<long>(node) + steps * stride;
          return other >= 0 && other < static_cast<long>(node_mass.size()) &&
                 node_mass[other] >= weak_share * full_node_mass;
        };
        if (!is_strong(1))
          continue;
        for (const unsigned int one : {0u, 1u})
          if (along > best[one] && (one || is_strong(2)))
            {
              best[one] = along;
              step[one] = stride;
            }
      }
    const auto add = [&](const int offset, const double w) {
      nodes.push_back(node + offset);
      weights.push_back(w);
    };
    if (step[0] != 0)
      {
        add(step[0], 2. * weight);
        add(2 * step[0], -weight);
      }
    else
      add(step[1], weight); // or the node itself, if it is alone
  }


  template void
  Walls<2>::reinit(const std::vector<double> &, const double, Tractions &);
  template void
  Walls<3>::reinit(const std::vector<double> &, const double, Tractions &);
} // namespace Waker
