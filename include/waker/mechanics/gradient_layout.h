// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_gradient_layout_h
#define waker_mechanics_gradient_layout_h

#include <waker/mapping/group_stencil.h>
#include <waker/mapping/stencil.h>
#include <waker/materials/material.h>
#include <waker/mechanics/filled_cells.h>

namespace Waker
{
  /// Row of the stress (c, d) among n_rows: all dim x dim, or those in dim
  /// dimensions of a symmetric one, each there once.
  template <int dim, unsigned int n_rows = dim *(dim + 1) / 2>
  constexpr unsigned int
  stress_row(const unsigned int c, const unsigned int d)
  {
    return n_rows == dim * dim ? dim * c + d
           : c == d            ? c
                               : (dim == 2 ? 2 : c + d + 2);
  }


  /**
   * The layout (see BlockTangents) of motions that are a gradient of u: A
   * gives n_rows stresses times a volume.
   */
  template <unsigned int n_rows>
  struct GradientLayout
  {
    static constexpr unsigned int N     = Material::block_size;
    static constexpr unsigned int n_in  = 4;
    static constexpr unsigned int n_out = n_rows;

    GradientLayout(const Weights<2> &weights, const FilledCells<2> *)
      : stencil(weights.background_grid())
    {}

    void
    gather(const PointWeights<2> &w,
           const std::size_t,
           const double      *u,
           const unsigned int l,
           double (&in)[n_in][N]) const
    {
      const Tensor<2, 2> gradient = stencil.gradient(w, u);
      for (unsigned int c = 0; c < 2; ++c)
        for (unsigned int d = 0; d < 2; ++d)
          in[2 * c + d][l] = gradient[c][d];
    }

    void
    scatter(const PointWeights<2> &w,
            const std::size_t,
            const double (&out)[n_out][N],
            const unsigned int l,
            double            *f) const
    {
      Tensor<2, 2> P;
      for (unsigned int c = 0; c < 2; ++c)
        for (unsigned int d = 0; d < 2; ++d)
          P[c][d] = out[stress_row<2, n_rows>(c, d)][l];
      stencil.scatter_gradient(w, P, f);
    }

    void
    add_diagonal(const PointWeights<2> &w,
                 const std::size_t,
                 const double (&A)[n_out][n_in][N],
                 const unsigned int l,
                 double            *f) const
    {
      // C[c]: what A does to one component alone.
      Tensor<2, 2> C[2];
      for (unsigned int c = 0; c < 2; ++c)
        for (unsigned int d = 0; d < 2; ++d)
          for (unsigned int e = 0; e < 2; ++e)
            C[c][d][e] = A[stress_row<2, n_rows>(c, d)][2 * c + e][l];
      stencil.scatter_quadratic(w, C, f);
    }

    const Stencil<2> stencil;
  };


  /// The same for groups of points (see GroupedTangents).
  template <typename L, unsigned int n_rows>
  struct GroupGradientLayout
  {
    using Lanes  = L;
    using Group  = PointGroup<Lanes>;
    using Number = typename LaneTraits<Lanes>::Number;

    static constexpr unsigned int n_in  = 9;
    static constexpr unsigned int n_out = n_rows;

    GroupGradientLayout(const Weights<3> &weights, const std::array<Lanes, 3> *)
      : stencil(weights.background_grid())
    {}

    void
    gather(const Group &w, const std::size_t, const Number *u, Lanes *in) const
    {
      stencil.gradient(w, u, in);
    }

    void
    scatter(const Group &w,
            const std::size_t,
            const Lanes *out,
            Number      *f) const
    {
      Lanes P[9];
      for (unsigned int c = 0; c < 3; ++c)
        for (unsigned int d = 0; d < 3; ++d)
          P[3 * c + d] = out[stress_row<3, n_rows>(c, d)];
      stencil.scatter(w, P, f);
    }

    void
    add_diagonal(const Group &w,
                 const std::size_t,
                 const Lanes *A,
                 Number      *f) const
    {
      stencil.scatter_of_gradients(
        w,
        GroupCentreWeights<Lanes>({}), // asks for none
        [&](const Lanes *const g, const Lanes *, Lanes *const sum) {
          for (unsigned int c = 0; c < 3; ++c)
            for (unsigned int d = 0; d < 3; ++d)
              {
                const Lanes *const row =
                  A + n_in * stress_row<3, n_rows>(c, d) + 3 * c;
                sum[c] +=
                  g[d] * (row[0] * g[0] + row[1] * g[1] + row[2] * g[2]);
              }
        },
        f);
    }

    const GroupStencil<Lanes> stencil;
  };
} // namespace Waker

#endif
