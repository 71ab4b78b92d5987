// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/boundary/water_load.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    // Where the walk along the surface starts: a vertex of the chain.
    std::size_t
    find_toe(const SurfaceChain &chain,
             const bool          water_left,
             const double        cell_size)
    {
      constexpr int     bottom = 2;
      const std::size_t n      = chain.vertices.size();

      // The bottom runs from left to right, the body above it.
      std::size_t toe   = n;
      const auto  outer = [&](const std::size_t a, const std::size_t b) {
        return water_left ? chain.vertices[a][0] < chain.vertices[b][0]
                           : chain.vertices[a][0] > chain.vertices[b][0];
      };
      for (std::size_t k = 0; k < n; ++k)
        if (chain.on_face[k] == bottom)
          {
            const std::size_t end = water_left ? k : (k + 1) % n;
            if (toe == n || outer(end, toe))
              toe = end;
          }
      if (toe < n)
        return toe;

      // The lowest vertex; the detected line of a flat underside scatters.
      double lowest = chain.vertices[0][1];
      for (const Point<2> &x : chain.vertices)
        lowest = std::min(lowest, x[1]);
      const double tolerance = 0.25 * cell_size;
      for (std::size_t k = 0; k < n; ++k)
        if (chain.vertices[k][1] <= lowest + tolerance &&
            (toe == n || outer(k, toe)))
          toe = k;
      return toe;
    }
  } // namespace



  template <int dim>
  WaterLoad<dim>::WaterLoad(const BackgroundGrid<dim> &grid,
                            const WaterParameters     &parameters)
    : grid(&grid)
    , parameters(parameters)
  {
    const auto &n = grid.n_nodes_per_direction();
    plane_force.resize(std::size_t(n[0]) * n[1]);
    is_loaded.assign(plane_force.size(), 0);
  }



  template <int dim>
  double
  WaterLoad<dim>::pressure(const double y) const
  {
    return parameters.unit_weight * std::max(parameters.level - y, 0.);
  }



  template <int dim>
  void
  WaterLoad<dim>::find_wetted_segments(const Surface &surface)
  {
    wetted.clear();
    if (parameters.side == "none" || surface.chains.empty())
      return;

    const SurfaceChain &chain = surface.chains[0];
    const std::size_t   n     = chain.vertices.size();
    const bool          left  = parameters.side == "left";
    const double        level = parameters.level;

    // With the water on the left, up the outer slope is against the chain.
    const auto next = [=](const std::size_t k) {
      return left ? (k + n - 1) % n : (k + 1) % n;
    };
    const auto face = [&](const std::size_t k) {
      return chain.on_face[left ? next(k) : k];
    };

    std::size_t k        = find_toe(chain, left, grid->cell_size());
    std::size_t n_walked = 0;
    const int   wall     = left ? 0 : 1;
    while (face(k) == wall && n_walked++ < n)
      k = next(k);

    for (; n_walked < n && face(k) < 0; ++n_walked, k = next(k))
      {
        const Point<2> &from = chain.vertices[k];
        Point<2>        to   = chain.vertices[next(k)];
        if (from[1] > level)
          break;

        const bool rises_above = to[1] > level;
        if (rises_above)
          {
            const double t = (level - from[1]) / (to[1] - from[1]);
            to             = from + t * (to - from);
            to[1]          = level;
          }

        const Tensor<1, 2> along  = to - from;
        const double       length = along.norm();
        if (length > 1e-9 * grid->cell_size())
          {
            // The body is on the right of the walk if the water is on the left.
            const double side = left ? 1. : -1.;
            Tensor<1, 2> normal;
            normal[0] = -side * along[1] / length;
            normal[1] = side * along[0] / length;
            wetted.push_back({from, to, normal});
          }
        if (rises_above)
          break;
      }
  }



  template <int dim>
  void
  WaterLoad<dim>::integrate_piece(const Point<2>     &a,
                                  const Point<2>     &b,
                                  const Tensor<1, 2> &normal)
  {
    // Position in cells from node 0; the cell is that of the mid-point, which
    // round-off cannot put into a neighbour.
    const double       inverse_h = grid->inverse_cell_size();
    const Tensor<1, 2> along     = b - a;
    std::array<int, 2> cell;
    for (unsigned int d = 0; d < 2; ++d)
      {
        const double x = (0.5 * (a[d] + b[d]) - grid->origin()[d]) * inverse_h;
        const int    last = grid->n_nodes_per_direction()[d] - 2;
        cell[d] = std::min(std::max(static_cast<int>(std::floor(x)), 0), last);
      }
    const unsigned int nx   = grid->stride(1);
    const unsigned int node = cell[1] * nx + cell[0];

    // Bilinear N times linear p is cubic along the piece: two points are exact.
    const double offset = 0.5 / std::sqrt(3.);
    for (const double t : {0.5 - offset, 0.5 + offset})
      {
        const Point<2>     x = a + t * along;
        const Tensor<1, 2> f = -0.5 * along.norm() * pressure(x[1]) * normal;
        const double       u = (x[0] - grid->origin()[0]) * inverse_h - cell[0];
        const double       v = (x[1] - grid->origin()[1]) * inverse_h - cell[1];
        const double       N[4]     = {(1 - u) * (1 - v),
                                       u * (1 - v),
                                       (1 - u) * v,
                                       u * v};
        const unsigned int nodes[4] = {node,
                                       node + 1,
                                       node + nx,
                                       node + nx + 1};
        for (unsigned int i = 0; i < 4; ++i)
          {
            plane_force[nodes[i]] += N[i] * f;
            if (!is_loaded[nodes[i]])
              {
                is_loaded[nodes[i]] = 1;
                loaded_nodes.push_back(nodes[i]);
              }
          }
      }
  }



  template <int dim>
  void
  WaterLoad<dim>::integrate(const LoadedSegment &segment)
  {
    // Cut the segment where it crosses the lines of the lattice.
    const Tensor<1, 2> along = segment.to - segment.from;
    cuts.clear();
    cuts.push_back(0.);
    for (unsigned int d = 0; d < 2; ++d)
      {
        const double a =
          (segment.from[d] - grid->origin()[d]) * grid->inverse_cell_size();
        const double b =
          (segment.to[d] - grid->origin()[d]) * grid->inverse_cell_size();
        const int last = std::ceil(std::max(a, b));
        for (int i = std::floor(std::min(a, b)) + 1; i < last; ++i)
          cuts.push_back((i - a) / (b - a));
      }
    cuts.push_back(1.);
    std::sort(cuts.begin(), cuts.end());

    for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
      if (cuts[k + 1] > cuts[k])
        integrate_piece(segment.from + cuts[k] * along,
                        segment.from + cuts[k + 1] * along,
                        segment.normal);
  }



  template <int dim>
  void
  WaterLoad<dim>::add_nodal_forces(const std::vector<double> &node_mass,
                                   const double               full_node_mass,
                                   NodalVector               &force)
  {
    Assert(node_mass.size() == grid->n_nodes(),
           ExcDimensionMismatch(node_mass.size(), grid->n_nodes()));
    Assert(force.locally_owned_size() == grid->n_dofs(),
           ExcDimensionMismatch(force.locally_owned_size(), grid->n_dofs()));

    loaded_nodes.clear();
    for (const LoadedSegment &segment : wetted)
      integrate(segment);

    // Planes of nodes along z that hold a part of the box, and the integral of
    // their linear function over it.
    constexpr unsigned int z           = dim - 1;
    const unsigned int     first_plane = dim == 3 ? grid->margin : 0;
    const unsigned int     last_plane =
      dim == 3 ? grid->n_nodes_per_direction()[z] - 1 - grid->margin : 0;
    const unsigned int plane_size = plane_force.size();

    double *const                     f       = force.begin();
    const std::array<unsigned int, 2> n_plane = {
      {grid->n_nodes_per_direction()[0], grid->n_nodes_per_direction()[1]}};
    for (unsigned int plane = first_plane; plane <= last_plane; ++plane)
      {
        // At its ends a body reaches half as far along z as inside, and so does
        // the full mass of a node.
        const double share =
          (dim == 3 && (plane == first_plane || plane == last_plane)) ? 0.5
                                                                      : 1.;
        const double length = dim == 3 ? share * grid->cell_size() : 1.;
        const double minimum =
          parameters.minimum_support * share * full_node_mass;
        const double *const mass    = node_mass.data() + plane * plane_size;
        double *const       f_plane = f + dim * plane * plane_size;
        for (const unsigned int node : loaded_nodes)
          {
            const Tensor<1, 2> load = length * plane_force[node];
            if (mass[node] >= minimum)
              {
                f_plane[dim * node] += load[0];
                f_plane[dim * node + 1] += load[1];
                continue;
              }
            find_support<2>(mass, minimum, n_plane, node, support);
            for (const SupportNode<2> &s : support)
              {
                f_plane[dim * s.node] += s.weight * load[0];
                f_plane[dim * s.node + 1] += s.weight * load[1];
              }
          }
      }

    for (const unsigned int node : loaded_nodes)
      {
        plane_force[node] = 0.;
        is_loaded[node]   = 0;
      }
  }



  template <int dim>
  WaterResultant
  WaterLoad<dim>::resultant() const
  {
    WaterResultant sum;
    for (const LoadedSegment &segment : wetted)
      {
        // The pressure is linear from p0 to p1.
        const Tensor<1, 2> along  = segment.to - segment.from;
        const double       length = along.norm();
        const double       p0     = pressure(segment.from[1]);
        const double       p1     = pressure(segment.to[1]);
        const double       total  = 0.5 * length * (p0 + p1);
        sum.force -= total * segment.normal;

        // Integral of x p over the segment.
        Tensor<1, 2> first = total * segment.from;
        first += length * (p0 / 6. + p1 / 3.) * along;
        sum.moment -=
          first[0] * segment.normal[1] - first[1] * segment.normal[0];
      }
    return sum;
  }



  template class WaterLoad<2>;
  template class WaterLoad<3>;
} // namespace Waker
