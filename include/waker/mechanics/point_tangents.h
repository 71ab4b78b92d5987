// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_point_tangents_h
#define waker_mechanics_point_tangents_h

#include <waker/mapping/stencil.h>
#include <waker/mechanics/stress_update.h>

#include <algorithm>
#include <vector>

namespace Waker
{
  /**
   * The derivatives of the points' forces, in the layout of their motion.
   */
  template <int dim>
  class PointTangents
  {
  public:
    virtual ~PointTangents() = default;

    /// Linearise where `stress_update` was last evaluated.
    /// @param diagonal out: of the stiffness
    virtual void
    reinit(const StressUpdate<dim>   &stress_update,
           const MaterialPoints<dim> &points,
           const Weights<dim>        &weights,
           NodalVector               &diagonal) = 0;

    /// f += K u
    virtual void
    vmult_add(const Weights<dim> &weights,
              const double       *u,
              double             *f) const = 0;
  };


  /**
   * In 2D: the loop over blocks of points for a layout, which has
   *   n_in, n_out             how many numbers a point gathers and scatters,
   *   gather(w, p, u, l, in)     in[.][l] from the nodes' u, of point p,
   *   scatter(w, p, out, l, f)   the nodes' f from out[.][l],
   *   add_diagonal(w, p, A, l, f),
   * and A[o][i][l] = d out_o / d in_i of point l between them.
   */
  template <typename Layout>
  class BlockTangents : public PointTangents<2>
  {
  public:
    static constexpr unsigned int N = Material::block_size;

    void
    reinit(const StressUpdate<2>   &stress_update,
           const MaterialPoints<2> &points,
           const Weights<2>        &weights,
           NodalVector             &diagonal) override
    {
      filled = stress_update.point_motion().filled_cells();
      const Layout layout(weights, filled);
      blocks.resize((points.n_points() + N - 1) / N);
      diagonal = 0.;
      // The diagonal goes along, while a block's tangents are at hand.
      for (std::size_t b = 0; b < blocks.size(); ++b)
        {
          auto &A = blocks[b].A;
          stress_update.tangent(
            points, b, &A[0][0][0], Layout::n_out, Layout::n_in);
          const std::size_t n_points =
            std::min<std::size_t>(N, points.n_points() - b * N);
          for (unsigned int l = 0; l < n_points; ++l)
            layout.add_diagonal(
              weights[b * N + l], b * N + l, A, l, diagonal.begin());
        }
    }

    void
    vmult_add(const Weights<2> &weights,
              const double     *u,
              double           *f) const override
    {
      const Layout layout(weights, filled);
      double       in[Layout::n_in][N] = {}, out[Layout::n_out][N];
      for (std::size_t b = 0; b < blocks.size(); ++b)
        {
          const std::size_t n_points =
            std::min<std::size_t>(N, weights.size() - b * N);
          for (unsigned int l = 0; l < n_points; ++l)
            layout.gather(weights[b * N + l], b * N + l, u, l, in);

          const auto &A = blocks[b].A;
          for (unsigned int o = 0; o < Layout::n_out; ++o)
            for (unsigned int l = 0; l < N; ++l)
              {
                double sum = 0.;
                for (unsigned int i = 0; i < Layout::n_in; ++i)
                  sum += A[o][i][l] * in[i][l];
                out[o][l] = sum;
              }

          for (unsigned int l = 0; l < n_points; ++l)
            layout.scatter(weights[b * N + l], b * N + l, out, l, f);
        }
    }

  private:
    struct Block
    {
      double A[Layout::n_out][Layout::n_in][N];
    };

    std::vector<Block>    blocks;
    const FilledCells<2> *filled = nullptr; // of the motion, or none
  };
} // namespace Waker

#endif
