// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mapping_group_stencil_h
#define waker_mapping_group_stencil_h

#include <waker/mapping/point_groups.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace Waker
{
  /// CentreWeights (mapping/centre_stencil.h) of the points of a group.
  template <typename Lanes>
  struct GroupCentreWeights
  {
    using Number = typename LaneTraits<Lanes>::Number;

    /// @param first share of the first cell, in each direction
    explicit GroupCentreWeights(const std::array<Lanes, 3> &first)
    {
      const Number half = Number(0.5);
      for (unsigned int d = 0; d < 3; ++d)
        {
          value[d][0] = half * first[d];
          value[d][1] = half + Lanes{};
          value[d][2] = half - value[d][0];
        }
    }

    Lanes value[3][3];
  };


  /**
   * Stencil<3> and CentreStencil<3> for a group of points at once. `nodal`
   * arrays hold three numbers per node.
   */
  template <typename Lanes>
  class GroupStencil
  {
  public:
    using Group  = PointGroup<Lanes>;
    using Number = typename LaneTraits<Lanes>::Number;

    explicit GroupStencil(const BackgroundGrid<3> &grid)
      : h(grid.cell_size())
      , row(3 * grid.stride(1))
      , plane(3 * grid.stride(2))
    {}

    /// @param gradient out: grad u, [3 c + d] = du_c/dx_d
    void
    gradient(const Group &w, const Number *nodal, Lanes *gradient) const
    {
      for (unsigned int a = 0; a < 9; ++a)
        gradient[a] = Lanes{};
      for (unsigned int k = 0; k < 3; ++k)
        {
          Lanes s[9] = {}; // sums over this plane, by component and direction
          for (unsigned int j = 0; j < 3; ++j)
            {
              const Number *const u = nodal + 3 * w.base + k * plane + j * row;
              for (unsigned int c = 0; c < 3; ++c)
                {
                  const Lanes v = w.value[0][0] * u[c] +
                                  w.value[0][1] * u[3 + c] +
                                  w.value[0][2] * u[6 + c];
                  const Lanes g = w.gradient[0][0] * u[c] +
                                  w.gradient[0][1] * u[3 + c] +
                                  w.gradient[0][2] * u[6 + c];
                  s[3 * c] += w.value[1][j] * g;
                  s[3 * c + 1] += w.gradient[1][j] * v;
                  s[3 * c + 2] += w.value[1][j] * v;
                }
            }
          for (unsigned int c = 0; c < 3; ++c)
            {
              gradient[3 * c] += w.value[2][k] * s[3 * c];
              gradient[3 * c + 1] += w.value[2][k] * s[3 * c + 1];
              gradient[3 * c + 2] += w.gradient[2][k] * s[3 * c + 2];
            }
        }
    }

    /// sum_i u_i . grad^c S_ip
    Lanes
    mean_dilatation(const Group                     &w,
                    const GroupCentreWeights<Lanes> &c,
                    const Number                    *nodal) const
    {
      Lanes mean = {};
      for (unsigned int k = 0; k < 3; ++k)
        {
          Lanes in_plane = {}, across = {};
          for (unsigned int j = 0; j < 3; ++j)
            {
              const Number *const u = nodal + 3 * w.base + k * plane + j * row;
              const Lanes         x = w.gradient[0][0] * u[0] +
                              w.gradient[0][1] * u[3] + w.gradient[0][2] * u[6];
              const Lanes y = c.value[0][0] * u[1] + c.value[0][1] * u[4] +
                              c.value[0][2] * u[7];
              const Lanes z = c.value[0][0] * u[2] + c.value[0][1] * u[5] +
                              c.value[0][2] * u[8];
              in_plane += c.value[1][j] * x + w.gradient[1][j] * y;
              across += c.value[1][j] * z;
            }
          mean += c.value[2][k] * in_plane + w.gradient[2][k] * across;
        }
      return mean;
    }

    /// nodal_i,c += sum_p sum_d P_cd dS_ip/dx_d
    /// @param P [3 c + d]
    void
    scatter(const Group &w, const Lanes *P, Number *nodal) const
    {
      add(w, P, nullptr, Lanes{}, nodal);
    }

    /// nodal_i += sum_p (P grad S_ip + p grad^c S_ip)
    void
    scatter(const Group                     &w,
            const GroupCentreWeights<Lanes> &c,
            const Lanes                     *P,
            const Lanes                      p,
            Number                          *nodal) const
    {
      add(w, P, &c, p, nodal);
    }

    /// nodal_i,c += sum_p f_c(grad S_ip, grad^c S_ip)
    /// @param f f(gradient, centre gradient, sum): adds to sum[3]
    template <typename Function>
    void
    scatter_of_gradients(const Group                     &w,
                         const GroupCentreWeights<Lanes> &c,
                         const Function                  &f,
                         Number                          *nodal) const
    {
      for (unsigned int k = 0; k < 3; ++k)
        {
          Lanes sums[32] = {};
          for (unsigned int j = 0; j < 3; ++j)
            for (unsigned int i = 0; i < 3; ++i)
              {
                const Lanes g[3] = {
                  w.gradient[0][i] * w.value[1][j] * w.value[2][k],
                  w.value[0][i] * w.gradient[1][j] * w.value[2][k],
                  w.value[0][i] * w.value[1][j] * w.gradient[2][k]};
                const Lanes centre[3] = {
                  w.gradient[0][i] * c.value[1][j] * c.value[2][k],
                  c.value[0][i] * w.gradient[1][j] * c.value[2][k],
                  c.value[0][i] * c.value[1][j] * w.gradient[2][k]};
                f(g, centre, sums + 9 * j + 3 * i);
              }
          add_plane(sums, nodal + 3 * w.base + k * plane);
        }
    }

  private:
    /// @param centre pointer to its weights; nullptr: there is no p
    template <typename Centre>
    void
    add(const Group  &w,
        const Lanes  *P,
        const Centre &centre,
        const Lanes   p,
        Number       *nodal) const
    {
      constexpr bool mean = !std::is_same<Centre, std::nullptr_t>::value;
      for (unsigned int k = 0; k < 3; ++k)
        {
          // The three planes of P, times the weights along z.
          Lanes x[3], y[3], z[3];
          for (unsigned int e = 0; e < 3; ++e)
            {
              x[e] = w.value[2][k] * P[3 * e];
              y[e] = w.value[2][k] * P[3 * e + 1];
              z[e] = w.gradient[2][k] * P[3 * e + 2];
            }
          Lanes       in_plane = {};
          const Lanes across   = w.gradient[2][k] * p;
          if constexpr (mean)
            in_plane = centre->value[2][k] * p;
          Lanes sums[32] = {};
          for (unsigned int j = 0; j < 3; ++j)
            {
              Lanes a[3], b[3];
              for (unsigned int e = 0; e < 3; ++e)
                {
                  a[e] = w.value[1][j] * x[e];
                  b[e] = w.gradient[1][j] * y[e] + w.value[1][j] * z[e];
                }
              Lanes *const sum = sums + 9 * j;
              if constexpr (mean)
                a[0] += centre->value[1][j] * in_plane;
              for (unsigned int i = 0; i < 3; ++i)
                for (unsigned int e = 0; e < 3; ++e)
                  sum[3 * i + e] =
                    w.gradient[0][i] * a[e] + w.value[0][i] * b[e];
              if constexpr (mean)
                {
                  const Lanes along = w.gradient[1][j] * in_plane;
                  const Lanes out   = centre->value[1][j] * across;
                  for (unsigned int i = 0; i < 3; ++i)
                    {
                      sum[3 * i + 1] += centre->value[0][i] * along;
                      sum[3 * i + 2] += centre->value[0][i] * out;
                    }
                }
            }
          add_plane(sums, nodal + 3 * w.base + k * plane);
        }
    }

    /// Add the sums over the lanes of the 27 numbers of a plane of nodes.
    void
    add_plane(const Lanes (&sums)[32], Number *nodal) const
    {
      constexpr unsigned int n_lanes = LaneTraits<Lanes>::n;
      Number                 total[32];
      for (unsigned int v = 0; v < 32; v += n_lanes)
        {
          const Lanes s = sums_over_lanes(sums + v);
          std::memcpy(total + v, &s, sizeof(s));
        }
      for (unsigned int j = 0; j < 3; ++j)
        for (unsigned int a = 0; a < 9; ++a)
          nodal[j * row + a] += total[9 * j + a];
    }

    Number       h;
    unsigned int row;
    unsigned int plane;
  };
} // namespace Waker

#endif
