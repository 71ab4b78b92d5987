// SPDX-License-Identifier: LGPL-2.1-or-later
//
// BlockMotion in space, four points at a time as vectors of the processor: with
// nine directions and six stresses the loops are too long for the compiler to
// make vectors of a loop over the points.
#include <waker/mapping/node_row.h>
#include <waker/mechanics/block_motion.h>

namespace Waker
{
  namespace
  {
    constexpr unsigned int N       = Material::block_size;
    constexpr unsigned int n_fours = N / 4;
    static_assert(N % 4 == 0, "blocks are taken four points at a time");

    /// (i, j) of the stresses xx, yy, zz, xy, xz, yz.
    constexpr unsigned int row_of[6]    = {0, 1, 2, 0, 0, 1};
    constexpr unsigned int column_of[6] = {0, 1, 2, 1, 2, 2};


    Four
    load(const double *const from)
    {
      Four v;
      std::memcpy(&v, from, sizeof(v));
      return v;
    }


    void
    store(const Four v, double *const to)
    {
      std::memcpy(to, &v, sizeof(v));
    }


    /**
     * Kinematics<3> of four points. With the axial vector a of the spin, W x =
     * a x x, the rotation of Hughes and Winget (1980) is
     *   Q = I + f (W + W^2/2),  f = 1 / (1 + |a|^2/4),
     * and (I - W/2)^-1 B (I + W/2)^-1 of a skew B with the axial vector b has
     * the axial vector f (b + a x b / 2).
     */
    struct FourMotions
    {
      /// @param H first gradient of the four, the next ones N numbers on
      FourMotions(const double *const H, const bool objective)
      {
        const Four zero   = {};
        const Four one    = zero + 1.;
        share             = objective ? 1. : 0.;
        const double half = 0.5 * share;
        Four         h[3][3], M[3][3];
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            {
              h[i][j] = load(H + (3 * i + j) * N);
              M[i][j] = half * h[i][j] + (i == j ? one : zero);
            }
        // R = (I + H/2)^-1, by its cofactors.
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            {
              const unsigned int a = (j + 1) % 3, b = (j + 2) % 3;
              const unsigned int c = (i + 1) % 3, d = (i + 2) % 3;
              R[i][j] = M[a][c] * M[b][d] - M[a][d] * M[b][c];
            }
        const Four inverse =
          1. / (M[0][0] * R[0][0] + M[0][1] * R[1][0] + M[0][2] * R[2][0]);
        for (auto &row : R)
          for (Four &entry : row)
            entry *= inverse;
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            G[i][j] = h[i][0] * R[0][j] + h[i][1] * R[1][j] + h[i][2] * R[2][j];
        for (unsigned int i = 0; i < 3; ++i)
          {
            const unsigned int j = (i + 1) % 3, k = (i + 2) % 3;
            a[i] = half * (G[k][j] - G[j][k]);
          }
        square = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
        f      = 1. / (1. + 0.25 * square);
      }

      /// Q s Q^T of symmetric s, in place, by its six components.
      void
      turn(Four (&s)[6]) const
      {
        Four Q[3][3];
        for (unsigned int i = 0; i < 3; ++i)
          {
            const unsigned int j = (i + 1) % 3, k = (i + 2) % 3;
            const Four         sym = 0.5 * a[i] * a[j];
            Q[i][i]                = 1. + f * 0.5 * (a[i] * a[i] - square);
            Q[i][j]                = f * (sym - a[k]);
            Q[j][i]                = f * (sym + a[k]);
          }
        const Four S[3][3] = {{s[0], s[3], s[4]},
                              {s[3], s[1], s[5]},
                              {s[4], s[5], s[2]}};
        Four       T[3][3];
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            T[i][j] = Q[i][0] * S[0][j] + Q[i][1] * S[1][j] + Q[i][2] * S[2][j];
        for (unsigned int c = 0; c < 6; ++c)
          {
            const unsigned int i = row_of[c], j = column_of[c];
            s[c] = T[i][0] * Q[j][0] + T[i][1] * Q[j][1] + T[i][2] * Q[j][2];
          }
      }

      /// The strain that the law sees for dH = e_k e_m, shear taken twice: of
      /// dG = R dH R, and of the commutator Z t - t Z over 2 G.
      void
      strain(const unsigned int k,
             const unsigned int m,
             const Four (&t)[6],
             const double per_two_G,
             Four (&e)[6]) const
      {
        Four dG[3][3];
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            dG[i][j] = R[i][k] * R[m][j];
        Four b[3], z[3];
        for (unsigned int i = 0; i < 3; ++i)
          {
            const unsigned int j = (i + 1) % 3, l = (i + 2) % 3;
            b[i] = dG[l][j] - dG[j][l]; // twice the axial vector
          }
        const Four factor = (0.5 * share * per_two_G) * f;
        for (unsigned int i = 0; i < 3; ++i)
          {
            const unsigned int j = (i + 1) % 3, l = (i + 2) % 3;
            z[i] = factor * (b[i] + 0.5 * (a[j] * b[l] - a[l] * b[j]));
          }
        const Four &xx = t[0], &yy = t[1], &zz = t[2];
        const Four &xy = t[3], &xz = t[4], &yz = t[5];
        e[0] = dG[0][0] + 2. * (z[1] * xz - z[2] * xy);
        e[1] = dG[1][1] + 2. * (z[2] * xy - z[0] * yz);
        e[2] = dG[2][2] + 2. * (z[0] * yz - z[1] * xz);
        e[3] =
          dG[0][1] + dG[1][0] + 2. * (z[2] * (xx - yy) + z[1] * yz - z[0] * xz);
        e[4] =
          dG[0][2] + dG[2][0] + 2. * (z[1] * (zz - xx) + z[0] * xy - z[2] * yz);
        e[5] =
          dG[1][2] + dG[2][1] + 2. * (z[0] * (yy - zz) + z[2] * xz - z[1] * xy);
      }

      double share;
      Four   R[3][3]; // (I + H/2)^-1
      Four   G[3][3]; // of the displacement increment, at mid-step
      Four   a[3];    // axial vector of the spin
      Four   square;  // |a|^2
      Four   f;
    };
  } // namespace


  template <>
  void
  BlockMotion<3>::move(Material::Block &block) const
  {
    for (unsigned int v = 0; v < n_fours; ++v)
      {
        const unsigned int l = 4 * v;
        const FourMotions  motion(&H[0][l], objective_rate);
        Four               stress[6];
        for (unsigned int c = 0; c < 6; ++c)
          stress[c] = load(&block.stress[c][l]);
        motion.turn(stress);
        for (unsigned int c = 0; c < 6; ++c)
          {
            const unsigned int i = row_of[c], j = column_of[c];
            store(stress[c], &block.stress[c][l]);
            store(0.5 * (motion.G[i][j] + motion.G[j][i]),
                  &block.strain_increment[c][l]);
          }
      }
  }


  template <>
  void
  BlockMotion<3>::stress_derivative(const double (*D)[N],
                                    const double (*turned)[N],
                                    const double  shear_modulus,
                                    const double *scale,
                                    double (*A)[9][N]) const
  {
    for (unsigned int v = 0; v < n_fours; ++v)
      {
        const unsigned int l = 4 * v;
        const FourMotions  motion(&H[0][l], objective_rate);
        Four               t[6];
        for (unsigned int c = 0; c < 6; ++c)
          t[c] = load(&turned[c][l]);
        const Four volume = load(scale + l);
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int m = 0; m < 3; ++m)
            {
              Four e[6];
              motion.strain(k, m, t, 0.5 / shear_modulus, e);
              for (Four &entry : e)
                entry *= volume;
              for (unsigned int s = 0; s < 6; ++s)
                {
                  Four sum = load(&D[6 * s][l]) * e[0];
                  for (unsigned int c = 1; c < 6; ++c)
                    sum += load(&D[6 * s + c][l]) * e[c];
                  store(sum, &A[s][3 * k + m][l]);
                }
            }
      }
  }


  template <>
  void
  BlockMotion<3>::full_stress_derivative(const double (*D)[N],
                                         const double (*turned)[N],
                                         const double  shear_modulus,
                                         const double *scale,
                                         double (*A)[9][N]) const
  {
    stress_derivative(D, turned, shear_modulus, scale, A);
  }


  template struct BlockMotion<3>;
} // namespace Waker
