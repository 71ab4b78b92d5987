// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/block_motion.h>
#include <waker/mechanics/kinematics.h>

#include <algorithm>

namespace Waker
{
  template <>
  void
  BlockMotion<2>::move(Material::Block &block) const
  {
    const double *const xx = H[0], *const xy = H[1];
    const double *const yx = H[2], *const yy = H[3];
    double *const s_xx  = block.stress[0];
    double *const s_yy  = block.stress[1];
    double *const s_xy  = block.stress[3];
    double *const e_xx  = block.strain_increment[0];
    double *const e_yy  = block.strain_increment[1];
    double *const e_xy  = block.strain_increment[3];
    const double  share = objective_rate ? 1. : 0.;
#pragma GCC ivdep
    for (unsigned int l = 0; l < N; ++l)
      {
        double g_xx = xx[l], g_xy = xy[l], g_yx = yx[l], g_yy = yy[l];
        to_mid_step(share, g_xx, g_xy, g_yx, g_yy);
        turn_in_plane(share * 0.5 * (g_xy - g_yx), s_xx[l], s_yy[l], s_xy[l]);
        e_xx[l] = g_xx;
        e_yy[l] = g_yy;
        e_xy[l] = 0.5 * (g_xy + g_yx);
      }
    for (const unsigned int a : {2, 4, 5})
      std::fill_n(block.strain_increment[a], N, 0.);
  }


  namespace
  {
    /// Of n stresses, the first two xx and yy, the last one xy.
    template <unsigned int n>
    void
    plane_derivative(const BlockMotion<2> &motion,
                     const double (*D)[BlockMotion<2>::N],
                     const double (*turned)[BlockMotion<2>::N],
                     const double  shear_modulus,
                     const double *scale,
                     double (*A)[4][BlockMotion<2>::N])
    {
      constexpr unsigned int N     = BlockMotion<2>::N;
      const auto            &H     = motion.H;
      const double           share = motion.objective_rate ? 1. : 0.;
      const double           half  = 0.5 * share;
      const double *const    s_xx  = turned[0];
      const double *const    s_yy  = turned[1];
      const double *const    s_xy  = turned[3];
#pragma GCC ivdep
      for (unsigned int l = 0; l < N; ++l)
        {
          // R = (I + H/2)^-1; the spin of G = H R.
          const double a = 1. + half * H[0][l], b = half * H[1][l];
          const double c = half * H[2][l], d = 1. + half * H[3][l];
          const double inverse = 1. / (a * d - b * c);
          const double R[2][2] = {{d * inverse, -b * inverse},
                                  {-c * inverse, a * inverse}};
          const double w       = share * 0.5 * (H[1][l] - H[2][l]) * inverse;

          // Z t - t Z = 2 z t_xy, -2 z t_xy, z (t_yy - t_xx) in xx, yy, xy,
          // with z = dw / (1 + w^2/4).
          const double factor =
            share / ((1. + 0.25 * w * w) * 2. * shear_modulus);
          const double r_xx = 2. * s_xy[l] * factor;
          const double r_xy = (s_yy[l] - s_xx[l]) * factor;

          for (unsigned int k = 0; k < 2; ++k)
            for (unsigned int m = 0; m < 2; ++m)
              {
                // dG = R dH R for dH = e_k e_m.
                const double g01   = R[0][k] * R[m][1];
                const double g10   = R[1][k] * R[m][0];
                const double dw    = 0.5 * (g01 - g10);
                const double e_xx  = R[0][k] * R[m][0] + r_xx * dw;
                const double e_yy  = R[1][k] * R[m][1] - r_xx * dw;
                const double gamma = g01 + g10 + 2. * r_xy * dw;
                for (unsigned int s = 0; s < n; ++s)
                  A[s][2 * k + m][l] =
                    scale[l] * (D[n * s][l] * e_xx + D[n * s + 1][l] * e_yy +
                                D[n * s + n - 1][l] * gamma);
              }
        }
    }
  } // namespace


  template <>
  void
  BlockMotion<2>::stress_derivative(const double (*D)[N],
                                    const double (*turned)[N],
                                    const double  shear_modulus,
                                    const double *scale,
                                    double (*A)[4][N]) const
  {
    plane_derivative<3>(*this, D, turned, shear_modulus, scale, A);
  }


  template <>
  void
  BlockMotion<2>::full_stress_derivative(const double (*D)[N],
                                         const double (*turned)[N],
                                         const double  shear_modulus,
                                         const double *scale,
                                         double (*A)[4][N]) const
  {
    plane_derivative<4>(*this, D, turned, shear_modulus, scale, A);
  }


  template struct BlockMotion<2>;
} // namespace Waker
