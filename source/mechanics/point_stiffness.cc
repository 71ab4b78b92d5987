// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/filled_cells.h>
#include <waker/mechanics/point_stiffness.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Waker
{
  namespace
  {
    /// A domain that reaches less than this share of itself into the next cells
    /// does so by round-off.
    constexpr double smallest_part = 1e-8;


    /// What a direction has of a support domain in the first and second cell of
    /// its stencil: the share, the weight of its energy, and means of the
    /// cell's two linear functions.
    struct Part
    {
      double share, weight, mean[2];
    };

    template <int dim>
    std::array<Part, 2>
    parts(const PointWeights<dim> &w, const unsigned int d, const double h)
    {
      // The share is the outer node's slope times h. Its value is the integral
      // of its function, and the middle one's what is left of the share.
      std::array<Part, 2> result;
      for (unsigned int side = 0; side < 2; ++side)
        {
          Part &part = result[side];
          part.share = std::abs(w.gradient[d][2 * side]) * h;
          if (part.share < smallest_part)
            part.share = 0.;
          const double outer =
            part.share > 0. ? w.value[d][2 * side] / part.share : 0.;
          part.mean[side]     = outer;
          part.mean[1 - side] = 1. - outer;
        }
      const double squares =
        std::pow(result[0].share, 2) + std::pow(result[1].share, 2);
      for (Part &part : result)
        part.weight = part.share * part.share / squares;
      return result;
    }
  } // namespace


  template <int dim>
  void
  add_point_stiffness(const StressUpdate<dim>   &stress_update,
                      const MaterialPoints<dim> &points,
                      const Weights<dim>        &weights,
                      MatrixEntries             &entries)
  {
    constexpr unsigned int     n_vertices = 1 << dim, n = dim * n_vertices;
    const BackgroundGrid<dim> &grid   = weights.background_grid();
    const PointMotion<dim>    &motion = stress_update.point_motion();
    const double               h      = grid.cell_size();

    std::vector<IsotropicModuli> moduli;
    stress_update.isotropic_tangents(points, moduli);
    const FilledCells<dim> *const filled = motion.filled_cells();

    std::array<unsigned int, n_vertices> nodes;
    std::vector<double>                  matrix(n * n);
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const PointWeights<dim>             &w = weights[p];
        std::array<std::array<Part, 2>, dim> in_direction;
        for (unsigned int d = 0; d < dim; ++d)
          in_direction[d] = parts(w, d, h);
        const double b = filled != nullptr ? (*filled)[p] : 0.;
        for (unsigned int cell = 0; cell < n_vertices; ++cell)
          {
            std::array<const Part *, dim> part;
            double                        volume = points.volume[p];
            unsigned int                  first  = w.base;
            for (unsigned int d = 0; d < dim; ++d)
              {
                part[d] = &in_direction[d][cell >> d & 1];
                volume *= part[d]->weight;
                first += (cell >> d & 1) * grid.stride(d);
              }
            if (volume == 0.)
              continue;

            std::array<Tensor<1, dim>, n_vertices> g, mean;
            for (unsigned int v = 0; v < n_vertices; ++v)
              {
                nodes[v] = first;
                for (unsigned int d = 0; d < dim; ++d)
                  {
                    nodes[v] += (v >> d & 1) * grid.stride(d);
                    const double slope = (v >> d & 1) ? 1. / h : -1. / h;
                    g[v][d]            = slope;
                    for (unsigned int e = 0; e < dim; ++e)
                      if (e != d)
                        g[v][d] *= part[e]->mean[v >> e & 1];
                    mean[v][d] =
                      g[v][d] + b * (slope / (1 << (dim - 1)) - g[v][d]);
                  }
              }
            const double k = volume * moduli[p].bulk,
                         G = volume * moduli[p].shear;
            for (unsigned int i = 0; i < n_vertices; ++i)
              for (unsigned int j = 0; j < n_vertices; ++j)
                {
                  const double both = G * (g[i] * g[j]);
                  for (unsigned int c = 0; c < dim; ++c)
                    for (unsigned int e = 0; e < dim; ++e)
                      matrix[n * (dim * i + c) + dim * j + e] =
                        k * mean[i][c] * mean[j][e] + G * g[j][c] * g[i][e] -
                        2. / 3. * G * g[i][c] * g[j][e] + (c == e ? both : 0.);
                }
            entries.add({nodes.data(), n_vertices},
                        {matrix.data(), matrix.size()});
          }
      }
  }


  template void
  add_point_stiffness(const StressUpdate<2> &,
                      const MaterialPoints<2> &,
                      const Weights<2> &,
                      MatrixEntries &);
  template void
  add_point_stiffness(const StressUpdate<3> &,
                      const MaterialPoints<3> &,
                      const Weights<3> &,
                      MatrixEntries &);
} // namespace Waker
