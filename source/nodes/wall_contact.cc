// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/nodes/wall.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace Waker
{
  template <int dim>
  void
  Walls<dim>::reinit(const MaterialPoints<dim> &points,
                     const std::vector<double> &node_mass,
                     const double               t,
                     Tractions                 &tractions)
  {
    AssertDimension(tractions.size(), spots.size());
    carried = &tractions;
    slides  = false;
    contacts.clear();
    nodes.clear();
    weights.clear();
    for (Wall &wall : walls)
      wall.target = displacement(wall, t); // of the whole wall, here
    for (Spot &spot : spots)
      spot.position = spot.reference + walls[spot.wall].target;
    for (Wall &wall : walls)
      wall.target = Tensor<1, dim>();
    find_gaps(points);
    for (std::size_t q = 0; q < spots.size(); ++q)
      {
        Spot      &spot  = spots[q];
        const auto begin = nodes.size();
        if (!grid->owns_cell(grid->nearest_cell(spot.position)) ||
            !find_nodes(spot, node_mass, tractions[q]))
          {
            spot.touches = false;
            tractions[q] = Tensor<1, dim>();
            continue;
          }
        const bool carries = tractions[q] * spot.normal > 0.;
        spot.touches       = carries || spot.gap <= 0.;
        Contact contact{q,
                        begin,
                        nodes.size(),
                        {spot.normal,
                         tractions[q],
                         carries ? 0. : std::max(0., spot.gap)},
                        Tensor<1, dim>(),
                        Tensor<2, dim>()};
        contact.derivative =
          walls[spot.wall].law.derivative(contact.start, Tensor<1, dim>());
        contacts.push_back(contact);
      }
    share_contacts(tractions);
  }


  template <int dim>
  void
  Walls<dim>::share_contacts(Tractions &tractions)
  {
    if (ranks->is_one_rank())
      return;
    std::vector<double> all;
    for (std::size_t q = 0; q < spots.size(); ++q)
      {
        all.push_back(spots[q].touches ? 1. : 0.);
        for (unsigned int d = 0; d < dim; ++d)
          all.push_back(tractions[q][d]);
      }
    ranks->sum(all.data(), all.size());
    for (std::size_t q = 0; q < spots.size(); ++q)
      {
        const double *const of_spot = &all[(1 + dim) * q];
        spots[q].touches            = of_spot[0] > 0.;
        for (unsigned int d = 0; d < dim; ++d)
          tractions[q][d] = of_spot[1 + d];
      }
  }


  template <int dim>
  void
  Walls<dim>::find_gaps(const MaterialPoints<dim> &points)
  {
    if (one_sided.empty())
      return;
    std::vector<Point<dim>>     positions;
    std::vector<Tensor<1, dim>> normals;
    for (const std::size_t q : one_sided)
      {
        positions.push_back(spots[q].position);
        normals.push_back(spots[q].normal);
      }
    wall_gaps.set_places(std::move(positions), std::move(normals));
    wall_gaps.find(points, gaps);
    // The smallest of what the ranks have found.
    for (double &gap : gaps)
      gap = -gap;
    ranks->largest(gaps.data(), gaps.size());
    for (double &gap : gaps)
      gap = -gap;
    for (std::size_t k = 0; k < one_sided.size(); ++k)
      spots[one_sided[k]].gap = gaps[k];
  }


  template <int dim>
  void
  Walls<dim>::check_start() const
  {
    // Cut sub-cells reach through by a tenth of a domain.
    const double deepest = -0.2 * grid->cell_size();
    for (const std::size_t q : one_sided)
      if (spots[q].gap < deepest)
        {
          std::ostringstream problem;
          problem << "the wall has soil behind it, " << -spots[q].gap
                  << " m at (";
          for (unsigned int d = 0; d < dim; ++d)
            problem << (d == 0 ? "" : ", ") << spots[q].position[d];
          problem << ") m";
          throw UserError("Walls/" + wall_names[spots[q].wall] + "/Line",
                          problem.str(),
                          "a frictional wall with all soil near it on its "
                          "left, or in space on the side from which its "
                          "corners run anticlockwise");
        }
  }


  template <int dim>
  std::vector<unsigned int>
  Walls<dim>::idle() const
  {
    std::vector<unsigned char> is_touched(walls.size(), 0);
    for (const Spot &spot : spots)
      if (spot.touches)
        is_touched[spot.wall] = 1;
    std::vector<unsigned int> result;
    for (unsigned int w = 0; w < walls.size(); ++w)
      if (!is_touched[w])
        result.push_back(w);
    return result;
  }


  template <int dim>
  bool
  Walls<dim>::has_soil(const Spot           &spot,
                       const double          share,
                       const Tensor<1, dim> &traction) const
  {
    if (walls[spot.wall].law.type != WallType::frictional)
      return share >= contact_share;
    const bool carries = traction * spot.normal > 0.;
    return spot.gap < (carries ? lost : reach) * grid->cell_size();
  }


  template <int dim>
  bool
  Walls<dim>::find_nodes(const Spot                &spot,
                         const std::vector<double> &node_mass,
                         const Tensor<1, dim>      &traction)
  {
    constexpr unsigned int n_corners       = 1 << dim;
    constexpr double       smallest_weight = 1e-14; // round-off
    if (!grid->contains(spot.position))
      return false;
    const auto cell = grid->nearest_cell(spot.position);
    double     local[dim];
    for (unsigned int d = 0; d < dim; ++d)
      local[d] = (spot.position[d] - grid->lattice_origin()[d]) *
                   grid->inverse_cell_size() -
                 (cell[d] + grid->offset()[d]);
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
    if (!has_soil(spot, share, traction))
      return false;
    const std::size_t begin = nodes.size();
    for (unsigned int c = 0; c < n_corners; ++c)
      if (N[c] > smallest_weight)
        {
          if (node_mass[corner_node[c]] >= weak_share * full_node_mass)
            {
              nodes.push_back(corner_node[c]);
              weights.push_back(N[c]);
            }
          else
            hand_inwards(corner_node[c], c, N[c], spot, node_mass);
        }
    if (walls[spot.wall].law.type != WallType::frictional)
      return true;
    // Soil that is further off may have no nodes here yet.
    for (std::size_t k = begin; k < nodes.size(); ++k)
      if (node_mass[nodes[k]] < weak_share * full_node_mass)
        {
          nodes.resize(begin);
          weights.resize(begin);
          return false;
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


  // The class is instantiated in wall.cc, of which these are a part.
  template void
  Walls<2>::reinit(const MaterialPoints<2> &,
                   const std::vector<double> &,
                   const double,
                   Tractions &);
  template void
  Walls<3>::reinit(const MaterialPoints<3> &,
                   const std::vector<double> &,
                   const double,
                   Tractions &);
  template void
  Walls<2>::check_start() const;
  template void
  Walls<3>::check_start() const;
  template std::vector<unsigned int>
  Walls<2>::idle() const;
  template std::vector<unsigned int>
  Walls<3>::idle() const;
} // namespace Waker
