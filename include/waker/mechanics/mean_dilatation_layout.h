// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_mean_dilatation_layout_h
#define waker_mechanics_mean_dilatation_layout_h

#include <waker/mapping/centre_stencil.h>
#include <waker/mapping/group_stencil.h>
#include <waker/materials/material.h>
#include <waker/mechanics/filled_cells.h>
#include <waker/mechanics/gradient_layout.h>

namespace Waker
{
  /**
   * The gradient of u and the correction d of its dilatation where B-bar acts
   * fully; V stress, of which each component in the plane is there once, and
   * V b p. The shares b of B-bar are in the derivatives.
   */
  struct MeanDilatationLayout
  {
    static constexpr unsigned int N          = Material::block_size;
    static constexpr unsigned int n_stresses = 3;
    static constexpr unsigned int n_in       = 5;
    static constexpr unsigned int n_out      = n_stresses + 1;

    MeanDilatationLayout(const Weights<2>     &weights,
                         const FilledCells<2> *filled)
      : stencil(weights.background_grid())
      , filled(filled)
    {}

    CentreWeights<2>
    centre(const std::size_t p) const
    {
      return CentreWeights<2>(filled->first_shares(p));
    }

    void
    gather(const PointWeights<2> &w,
           const std::size_t      p,
           const double          *u,
           const unsigned int     l,
           double (&in)[n_in][N]) const
    {
      double       H[2][2];
      const double mean = stencil.gradient(w, centre(p), u, H);
      double       tr   = 0.;
      for (unsigned int c = 0; c < 2; ++c)
        {
          tr += H[c][c];
          for (unsigned int d = 0; d < 2; ++d)
            in[2 * c + d][l] = H[c][d];
        }
      in[4][l] = (mean - tr) / 3.;
    }

    void
    scatter(const PointWeights<2> &w,
            const std::size_t      p,
            const double (&out)[n_out][N],
            const unsigned int l,
            double            *f) const
    {
      const double pressure = out[n_stresses][l];
      Tensor<2, 2> P;
      for (unsigned int c = 0; c < 2; ++c)
        for (unsigned int d = 0; d < 2; ++d)
          P[c][d] = out[stress_row<2>(c, d)][l] - (c == d ? pressure : 0.);
      stencil.scatter(w, centre(p), P, pressure, f);
    }

    void
    add_diagonal(const PointWeights<2> &w,
                 const std::size_t      p,
                 const double (&A)[n_out][n_in][N],
                 const unsigned int l,
                 double            *f) const
    {
      // The component c of one node moves by 1: the gradient is g in row c,
      // and 3 d the difference q of the two dilatations.
      double M[2][2][2], r[2][2];
      for (unsigned int c = 0; c < 2; ++c)
        for (unsigned int e = 0; e < 2; ++e)
          {
            for (unsigned int k = 0; k < 2; ++k)
              M[c][e][k] = A[stress_row<2>(c, e)][2 * c + k][l];
            r[c][e] =
              A[stress_row<2>(c, e)][4][l] / 3. + A[n_stresses][2 * c + e][l];
          }
      const double pressure = A[n_stresses][4][l] / 3.;
      stencil.for_each_node(w,
                            this->centre(p),
                            [&](const unsigned int  node,
                                const Tensor<1, 2> &g,
                                const Tensor<1, 2> &centre) {
                              for (unsigned int c = 0; c < 2; ++c)
                                {
                                  const double q   = centre[c] - g[c];
                                  double       sum = q * q * pressure;
                                  for (unsigned int e = 0; e < 2; ++e)
                                    {
                                      sum += q * r[c][e] * g[e];
                                      for (unsigned int k = 0; k < 2; ++k)
                                        sum += g[e] * M[c][e][k] * g[k];
                                    }
                                  f[2 * node + c] += sum;
                                }
                            });
    }

    const CentreStencil<2> stencil;
    const FilledCells<2>  *filled;
  };


  /// The same for groups of points (see GroupedTangents).
  template <typename L>
  struct GroupMeanDilatationLayout
  {
    using Lanes  = L;
    using Group  = PointGroup<Lanes>;
    using Number = typename LaneTraits<Lanes>::Number;

    static constexpr Number third = Number(1) / 3;

    static constexpr unsigned int n_in  = 10;
    static constexpr unsigned int n_out = 7;

    /// @param first_shares of the points of each group
    GroupMeanDilatationLayout(const Weights<3>           &weights,
                              const std::array<Lanes, 3> *first_shares)
      : stencil(weights.background_grid())
      , first_shares(first_shares)
    {}

    GroupCentreWeights<Lanes>
    centre(const std::size_t group) const
    {
      return GroupCentreWeights<Lanes>(first_shares[group]);
    }

    void
    gather(const Group      &w,
           const std::size_t group,
           const Number     *u,
           Lanes            *in) const
    {
      stencil.gradient(w, u, in);
      const Lanes tr = in[0] + in[4] + in[8];
      in[9] = (stencil.mean_dilatation(w, centre(group), u) - tr) * third;
    }

    void
    scatter(const Group      &w,
            const std::size_t group,
            const Lanes      *out,
            Number           *f) const
    {
      Lanes P[9];
      for (unsigned int c = 0; c < 3; ++c)
        for (unsigned int d = 0; d < 3; ++d)
          P[3 * c + d] = out[stress_row<3>(c, d)];
      for (unsigned int c = 0; c < 3; ++c)
        P[4 * c] -= out[6];
      stencil.scatter(w, centre(group), P, out[6], f);
    }

    void
    add_diagonal(const Group      &w,
                 const std::size_t group,
                 const Lanes      *A,
                 Number           *f) const
    {
      // As MeanDilatationLayout.
      Lanes r[3][3];
      for (unsigned int c = 0; c < 3; ++c)
        for (unsigned int e = 0; e < 3; ++e)
          r[c][e] =
            A[n_in * stress_row<3>(c, e) + 9] * third + A[n_in * 6 + 3 * c + e];
      const Lanes pressure = A[n_in * 6 + 9] * third;
      stencil.scatter_of_gradients(
        w,
        this->centre(group),
        [&](const Lanes *const g, const Lanes *const centre, Lanes *const sum) {
          for (unsigned int c = 0; c < 3; ++c)
            {
              const Lanes q     = centre[c] - g[c];
              Lanes       total = q * q * pressure;
              for (unsigned int e = 0; e < 3; ++e)
                {
                  const Lanes *const row =
                    A + n_in * stress_row<3>(c, e) + 3 * c;
                  total += g[e] * (q * r[c][e] + row[0] * g[0] + row[1] * g[1] +
                                   row[2] * g[2]);
                }
              sum[c] += total;
            }
        },
        f);
    }

    const GroupStencil<Lanes>         stencil;
    const std::array<Lanes, 3> *const first_shares;
  };
} // namespace Waker

#endif
