// SPDX-License-Identifier: LGPL-2.1-or-later
// The planes that hold a stress, for 16 points at a time.
#include "mohr_coulomb_lanes.h"
#include "mohr_coulomb_planes.h"
#include <cmath>

namespace Waker
{
  using namespace MohrCoulombPlanes;


  inline void
  MohrCoulombLanes::keep(const unsigned int l,
                         const bool         take,
                         const Three       &s,
                         const Three       &e)
  {
    value[0][l]  = take ? s.x : value[0][l];
    value[1][l]  = take ? s.y : value[1][l];
    value[2][l]  = take ? s.z : value[2][l];
    strain[0][l] = take ? e.x : strain[0][l];
    strain[1][l] = take ? e.y : strain[1][l];
    strain[2][l] = take ? e.z : strain[2][l];
    open[l]      = take ? 0. : open[l];
  }


  inline void
  MohrCoulombLanes::keep_slope(const unsigned int l,
                               const bool         take,
                               const Three       &x,
                               const Three       &y,
                               const Three       &z)
  {
    slope[0][0][l] = take ? x.x : slope[0][0][l];
    slope[0][1][l] = take ? x.y : slope[0][1][l];
    slope[0][2][l] = take ? x.z : slope[0][2][l];
    slope[1][0][l] = take ? y.x : slope[1][0][l];
    slope[1][1][l] = take ? y.y : slope[1][1][l];
    slope[1][2][l] = take ? y.z : slope[1][2][l];
    slope[2][0][l] = take ? z.x : slope[2][0][l];
    slope[2][1][l] = take ? z.y : slope[2][1][l];
    slope[2][2][l] = take ? z.z : slope[2][2][l];
  }


  void
  MohrCoulombLanes::begin(const bool with_slope)
  {
    for (unsigned int l = 0; l < n; ++l)
      {
        const Three t = {trial[0][l], trial[1][l], trial[2][l]};
        // Not a number is not held, by no plane.
        const bool holds =
          (along<0>(sin_phi[l], t) <= offset[l]) & (t.x <= tension[l]);
        yields[l] = open[l] = holds ? 0. : 1.;
        tolerance[l] =
          1e-11 * (std::abs(t.x) + std::abs(t.z) + 2. * strength[l].cohesion);
      }
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int l = 0; l < n; ++l)
        {
          value[i][l]  = trial[i][l];
          strain[i][l] = 0.;
        }
    if (with_slope)
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          for (unsigned int l = 0; l < n; ++l)
            slope[i][j][l] = i == j ? 1. : 0.;
  }


  bool
  MohrCoulombLanes::any_open() const
  {
    bool any = false;
    for (unsigned int l = 0; l < n; ++l)
      any = any | (open[l] != 0.);
    return any;
  }


  template <bool with_slope, unsigned int p>
  void
  MohrCoulombLanes::try_plane()
  {
#pragma GCC ivdep
    for (unsigned int l = 0; l < n; ++l)
      {
        const Three  t     = {trial[0][l], trial[1][l], trial[2][l]};
        const double phi   = sin_phi[l];
        const Three  S     = stress_of_flow<p>(sin_psi[l], two_G[l], lame[l]);
        const double per_A = 1. / along<p>(phi, S);
        const double excess =
          along<p>(phi, t) - offset_of<p>(offset[l], tension[l]);
        const double m    = excess * per_A;
        const Three  s    = {t.x - m * S.x, t.y - m * S.y, t.z - m * S.z};
        const bool   take = (open[l] != 0.) &
                          (m * two_G[l] >= -2. * tolerance[l]) &
                          is_held(s, phi, offset[l], tension[l], tolerance[l]);
        const Three g = across<p>(sin_psi[l]);
        keep(l, take, s, {m * g.x, m * g.y, m * g.z});
        if constexpr (with_slope)
          {
            const Three N = across<p>(phi);
            const Three a = {per_A * N.x, per_A * N.y, per_A * N.z};
            keep_slope(l,
                       take,
                       {1. - S.x * a.x, -S.x * a.y, -S.x * a.z},
                       {-S.y * a.x, 1. - S.y * a.y, -S.y * a.z},
                       {-S.z * a.x, -S.z * a.y, 1. - S.z * a.z});
          }
      }
  }


  template <bool with_slope, unsigned int p, unsigned int q>
  void
  MohrCoulombLanes::try_edge()
  {
#pragma GCC ivdep
    for (unsigned int l = 0; l < n; ++l)
      {
        const Three  t   = {trial[0][l], trial[1][l], trial[2][l]};
        const double phi = sin_phi[l];
        const Three  S   = stress_of_flow<p>(sin_psi[l], two_G[l], lame[l]);
        const Three  T   = stress_of_flow<q>(sin_psi[l], two_G[l], lame[l]);
        const double pp = along<p>(phi, S), pq = along<p>(phi, T);
        const double qp = along<q>(phi, S), qq = along<q>(phi, T);
        const double per_det = 1. / (pp * qq - pq * qp);
        const double of_p =
          along<p>(phi, t) - offset_of<p>(offset[l], tension[l]);
        const double of_q =
          along<q>(phi, t) - offset_of<q>(offset[l], tension[l]);
        const double m     = (qq * of_p - pq * of_q) * per_det;
        const double k     = (pp * of_q - qp * of_p) * per_det;
        const Three  s     = {t.x - m * S.x - k * T.x,
                              t.y - m * S.y - k * T.y,
                              t.z - m * S.z - k * T.z};
        const double least = -2. * tolerance[l];
        const bool   take  = (open[l] != 0.) & (m * two_G[l] >= least) &
                          (k * two_G[l] >= least) &
                          is_held(s, phi, offset[l], tension[l], tolerance[l]);
        const Three g = across<p>(sin_psi[l]), h = across<q>(sin_psi[l]);
        keep(l,
             take,
             s,
             {m * g.x + k * h.x, m * g.y + k * h.y, m * g.z + k * h.z});
        if constexpr (with_slope)
          {
            // The derivatives of both multipliers by the trial values.
            const Three N = across<p>(phi), M = across<q>(phi);
            const Three a = {(qq * N.x - pq * M.x) * per_det,
                             (qq * N.y - pq * M.y) * per_det,
                             (qq * N.z - pq * M.z) * per_det};
            const Three b = {(pp * M.x - qp * N.x) * per_det,
                             (pp * M.y - qp * N.y) * per_det,
                             (pp * M.z - qp * N.z) * per_det};
            keep_slope(l,
                       take,
                       {1. - S.x * a.x - T.x * b.x,
                        -S.x * a.y - T.x * b.y,
                        -S.x * a.z - T.x * b.z},
                       {-S.y * a.x - T.y * b.x,
                        1. - S.y * a.y - T.y * b.y,
                        -S.y * a.z - T.y * b.z},
                       {-S.z * a.x - T.z * b.x,
                        -S.z * a.y - T.z * b.y,
                        1. - S.z * a.z - T.z * b.z});
          }
      }
  }


  template <bool with_slope, unsigned int p, unsigned int q, unsigned int r>
  void
  MohrCoulombLanes::try_corner()
  {
#pragma GCC ivdep
    for (unsigned int l = 0; l < n; ++l)
      {
        const Three  t   = {trial[0][l], trial[1][l], trial[2][l]};
        const double phi = sin_phi[l], psi = sin_psi[l];
        const Three  S = stress_of_flow<p>(psi, two_G[l], lame[l]);
        const Three  T = stress_of_flow<q>(psi, two_G[l], lame[l]);
        const Three  U = stress_of_flow<r>(psi, two_G[l], lame[l]);
        // Columns of the planes' equations, and their right-hand side.
        const Three a = {along<p>(phi, S), along<q>(phi, S), along<r>(phi, S)};
        const Three b = {along<p>(phi, T), along<q>(phi, T), along<r>(phi, T)};
        const Three c = {along<p>(phi, U), along<q>(phi, U), along<r>(phi, U)};
        const Three x = {along<p>(phi, t) - offset_of<p>(offset[l], tension[l]),
                         along<q>(phi, t) - offset_of<q>(offset[l], tension[l]),
                         along<r>(phi, t) -
                           offset_of<r>(offset[l], tension[l])};
        const Three bc       = cross(b, c);
        const Three ax       = cross(a, x);
        const double per_det = 1. / dot(a, bc);
        const double m       = dot(x, bc) * per_det;
        const double k       = dot(ax, c) * per_det;
        const double j       = -dot(ax, b) * per_det;
        const Three  s       = {t.x - m * S.x - k * T.x - j * U.x,
                                t.y - m * S.y - k * T.y - j * U.y,
                                t.z - m * S.z - k * T.z - j * U.z};
        const double least   = -2. * tolerance[l];
        const bool   take    = (open[l] != 0.) & (m * two_G[l] >= least) &
                          (k * two_G[l] >= least) & (j * two_G[l] >= least) &
                          is_held(s, phi, offset[l], tension[l], tolerance[l]);
        const Three g = across<p>(psi), h = across<q>(psi), i = across<r>(psi);
        keep(l,
             take,
             s,
             {m * g.x + k * h.x + j * i.x,
              m * g.y + k * h.y + j * i.y,
              m * g.z + k * h.z + j * i.z});
        // A corner stays where it is.
        if constexpr (with_slope)
          keep_slope(l, take, {0., 0., 0.}, {0., 0., 0.}, {0., 0., 0.});
      }
  }


  template <bool with_slope>
  void
  MohrCoulombLanes::try_all()
  {
    // In the order of MohrCoulombReturn.
    try_plane<with_slope, 0>();
    if (any_open())
      try_plane<with_slope, 3>();
    if (any_open())
      try_edge<with_slope, 0, 1>();
    if (any_open())
      try_edge<with_slope, 0, 2>();
    if (any_open())
      try_edge<with_slope, 0, 3>();
    if (any_open())
      try_edge<with_slope, 3, 4>();
    if (any_open())
      try_corner<with_slope, 3, 4, 5>();
    if (any_open())
      try_corner<with_slope, 0, 1, 3>();
    if (any_open())
      try_corner<with_slope, 0, 2, 3>();
    if (any_open())
      try_corner<with_slope, 0, 3, 4>();
  }


  void
  MohrCoulombLanes::return_open_points(const bool with_slope)
  {
    for (unsigned int l = 0; l < n; ++l)
      if (open[l] != 0.)
        {
          const MohrCoulombReturn map(0.5 * two_G[l], lame[l]);
          const auto              result =
            map({{trial[0][l], trial[1][l], trial[2][l]}}, strength[l]);
          double own_slope[3][3];
          if (with_slope)
            map.slope(result, strength[l], MohrCoulombStrength{}, own_slope);
          for (unsigned int i = 0; i < 3; ++i)
            {
              value[i][l]  = result.stress[i];
              strain[i][l] = result.plastic_strain[i];
              for (unsigned int j = 0; with_slope && j < 3; ++j)
                slope[i][j][l] = own_slope[i][j];
            }
        }
  }


  void
  MohrCoulombLanes::find_return(const bool with_slope)
  {
    find_principal_stresses();
    begin(with_slope);
    if (any_open())
      with_slope ? try_all<true>() : try_all<false>();
    if (any_open())
      return_open_points(with_slope);
  }
} // namespace Waker
