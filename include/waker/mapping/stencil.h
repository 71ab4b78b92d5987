// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mapping_stencil_h
#define waker_mapping_stencil_h

#include <deal.II/base/tensor.h>

#include <waker/mapping/node_row.h>
#include <waker/mapping/weights.h>

#include <array>

namespace Waker
{
  /**
   * The four inner loops of the material point method, over the 3^dim nodes
   * of one point, with sums factorised by direction. Everything that is hot
   * goes through them. `nodal` arrays hold dim numbers per node.
   */
  template <int dim>
  struct Stencil;

  template <>
  struct Stencil<2>
  {
    explicit Stencil(const BackgroundGrid<2> &grid)
      : row(2 * grid.stride(1))
    {}

    // The three nodes of a row are six numbers side by side (NodeRow): sums
    // over rows come first.

    /// sum_i S_ip u_i
    Tensor<1, 2>
    value(const PointWeights<2> &w, const double *nodal) const
    {
      const double *u = nodal + 2 * w.base;
      NodeRow       s = NodeRow::zero();
      for (unsigned int j = 0; j < 3; ++j, u += row)
        s.add(w.value[1][j], NodeRow::load(u));
      const Two    sum = s.sum(w.value[0]);
      Tensor<1, 2> result;
      result[0] = sum[0];
      result[1] = sum[1];
      return result;
    }

    /// (grad u)_cd = sum_i u_i,c dS_ip/dx_d
    Tensor<2, 2>
    gradient(const PointWeights<2> &w, const double *nodal) const
    {
      const double *u = nodal + 2 * w.base;
      NodeRow       s = NodeRow::zero(), t = NodeRow::zero();
      for (unsigned int j = 0; j < 3; ++j, u += row)
        {
          const NodeRow r = NodeRow::load(u);
          s.add(w.value[1][j], r);
          t.add(w.gradient[1][j], r);
        }
      const Two    dx = s.sum(w.gradient[0]);
      const Two    dy = t.sum(w.value[0]);
      Tensor<2, 2> result;
      for (unsigned int c = 0; c < 2; ++c)
        {
          result[c][0] = dx[c];
          result[c][1] = dy[c];
        }
      return result;
    }

    /// nodal_i += S_ip f
    void
    scatter_value(const PointWeights<2> &w,
                  const Tensor<1, 2>    &f,
                  double                *nodal) const
    {
      const NodeRow s = NodeRow::outer(w.value[0], Two{f[0], f[1]});
      double       *u = nodal + 2 * w.base;
      for (unsigned int j = 0; j < 3; ++j, u += row)
        {
          NodeRow r = NodeRow::load(u);
          r.add(w.value[1][j], s);
          r.store(u);
        }
    }

    /// nodal_i,c += sum_d P_cd dS_ip/dx_d
    void
    scatter_gradient(const PointWeights<2> &w,
                     const Tensor<2, 2>    &P,
                     double                *nodal) const
    {
      const NodeRow s = NodeRow::outer(w.gradient[0], Two{P[0][0], P[1][0]});
      const NodeRow t = NodeRow::outer(w.value[0], Two{P[0][1], P[1][1]});
      double       *u = nodal + 2 * w.base;
      for (unsigned int j = 0; j < 3; ++j, u += row)
        {
          NodeRow r = NodeRow::load(u);
          r.add(w.value[1][j], s);
          r.add(w.gradient[1][j], t);
          r.store(u);
        }
    }

    /// nodal_i,c += grad S_ip . C_c grad S_ip: what a stiffness has on its
    /// diagonal.
    void
    scatter_quadratic(const PointWeights<2> &w,
                      const Tensor<2, 2> (&C)[2],
                      double *nodal) const
    {
      double gg[3], gv[3], vv[3];
      for (unsigned int i = 0; i < 3; ++i)
        {
          const double g = w.gradient[0][i], v = w.value[0][i];
          gg[i] = g * g;
          gv[i] = g * v;
          vv[i] = v * v;
        }
      const NodeRow s = NodeRow::outer(gg, Two{C[0][0][0], C[1][0][0]});
      const NodeRow t =
        NodeRow::outer(gv,
                       Two{C[0][0][1] + C[0][1][0], C[1][0][1] + C[1][1][0]});
      const NodeRow q = NodeRow::outer(vv, Two{C[0][1][1], C[1][1][1]});
      double       *u = nodal + 2 * w.base;
      for (unsigned int j = 0; j < 3; ++j, u += row)
        {
          const double v = w.value[1][j], g = w.gradient[1][j];
          NodeRow      r = NodeRow::load(u);
          r.add(v * v, s);
          r.add(v * g, t);
          r.add(g * g, q);
          r.store(u);
        }
    }

    /// f(node, S_ip, grad S_ip) for each of the nodes.
    template <typename Function>
    void
    for_each_node(const PointWeights<2> &w, const Function &f) const
    {
      for (unsigned int j = 0; j < 3; ++j)
        for (unsigned int i = 0; i < 3; ++i)
          {
            Tensor<1, 2> gradient;
            gradient[0] = w.gradient[0][i] * w.value[1][j];
            gradient[1] = w.value[0][i] * w.gradient[1][j];
            f(w.base + j * (row / 2) + i,
              w.value[0][i] * w.value[1][j],
              gradient);
          }
    }

    unsigned int row; // numbers between neighbouring rows
  };


  template <>
  struct Stencil<3>
  {
    explicit Stencil(const BackgroundGrid<3> &grid)
      : row(3 * grid.stride(1))
      , plane(3 * grid.stride(2))
    {}

    Tensor<1, 3>
    value(const PointWeights<3> &w, const double *nodal) const
    {
      Tensor<1, 3> sum;
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int j = 0; j < 3; ++j)
          {
            const double *u = nodal + 3 * w.base + k * plane + j * row;
            const double  s = w.value[2][k] * w.value[1][j];
            for (unsigned int c = 0; c < 3; ++c)
              sum[c] += s * (w.value[0][0] * u[c] + w.value[0][1] * u[3 + c] +
                             w.value[0][2] * u[6 + c]);
          }
      return sum;
    }

    Tensor<2, 3>
    gradient(const PointWeights<3> &w, const double *nodal) const
    {
      Tensor<2, 3> sum;
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int j = 0; j < 3; ++j)
          {
            const double *u  = nodal + 3 * w.base + k * plane + j * row;
            const double  sx = w.value[2][k] * w.value[1][j];
            const double  sy = w.value[2][k] * w.gradient[1][j];
            const double  sz = w.gradient[2][k] * w.value[1][j];
            for (unsigned int c = 0; c < 3; ++c)
              {
                const double v = w.value[0][0] * u[c] +
                                 w.value[0][1] * u[3 + c] +
                                 w.value[0][2] * u[6 + c];
                sum[c][0] +=
                  sx * (w.gradient[0][0] * u[c] + w.gradient[0][1] * u[3 + c] +
                        w.gradient[0][2] * u[6 + c]);
                sum[c][1] += sy * v;
                sum[c][2] += sz * v;
              }
          }
      return sum;
    }

    void
    scatter_value(const PointWeights<3> &w,
                  const Tensor<1, 3>    &f,
                  double                *nodal) const
    {
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int j = 0; j < 3; ++j)
          {
            double      *u = nodal + 3 * w.base + k * plane + j * row;
            const double s = w.value[2][k] * w.value[1][j];
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int c = 0; c < 3; ++c)
                u[3 * i + c] += s * w.value[0][i] * f[c];
          }
    }

    void
    scatter_gradient(const PointWeights<3> &w,
                     const Tensor<2, 3>    &P,
                     double                *nodal) const
    {
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int j = 0; j < 3; ++j)
          {
            double      *u  = nodal + 3 * w.base + k * plane + j * row;
            const double sx = w.value[2][k] * w.value[1][j];
            const double sy = w.value[2][k] * w.gradient[1][j];
            const double sz = w.gradient[2][k] * w.value[1][j];
            double       a[3], b[3];
            for (unsigned int c = 0; c < 3; ++c)
              {
                a[c] = sx * P[c][0];
                b[c] = sy * P[c][1] + sz * P[c][2];
              }
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int c = 0; c < 3; ++c)
                u[3 * i + c] += w.gradient[0][i] * a[c] + w.value[0][i] * b[c];
          }
    }

    template <typename Function>
    void
    for_each_node(const PointWeights<3> &w, const Function &f) const
    {
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int j = 0; j < 3; ++j)
          for (unsigned int i = 0; i < 3; ++i)
            {
              Tensor<1, 3> gradient;
              gradient[0] = w.gradient[0][i] * w.value[1][j] * w.value[2][k];
              gradient[1] = w.value[0][i] * w.gradient[1][j] * w.value[2][k];
              gradient[2] = w.value[0][i] * w.value[1][j] * w.gradient[2][k];
              f(w.base + k * (plane / 3) + j * (row / 3) + i,
                w.value[0][i] * w.value[1][j] * w.value[2][k],
                gradient);
            }
    }

    unsigned int row;
    unsigned int plane;
  };
} // namespace Waker

#endif
