// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mapping_stencil_h
#define waker_mapping_stencil_h

#include <deal.II/base/tensor.h>

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

    /// sum_i S_ip u_i
    Tensor<1, 2>
    value(const PointWeights<2> &w, const double *nodal) const
    {
      const double *u = nodal + 2 * w.base;
      Tensor<1, 2>  sum;
      for (unsigned int j = 0; j < 3; ++j, u += row)
        for (unsigned int c = 0; c < 2; ++c)
          sum[c] +=
            w.value[1][j] * (w.value[0][0] * u[c] + w.value[0][1] * u[2 + c] +
                             w.value[0][2] * u[4 + c]);
      return sum;
    }

    /// (grad u)_cd = sum_i u_i,c dS_ip/dx_d
    Tensor<2, 2>
    gradient(const PointWeights<2> &w, const double *nodal) const
    {
      const double *u = nodal + 2 * w.base;
      Tensor<2, 2>  sum;
      for (unsigned int j = 0; j < 3; ++j, u += row)
        for (unsigned int c = 0; c < 2; ++c)
          {
            sum[c][0] += w.value[1][j] * (w.gradient[0][0] * u[c] +
                                          w.gradient[0][1] * u[2 + c] +
                                          w.gradient[0][2] * u[4 + c]);
            sum[c][1] += w.gradient[1][j] *
                         (w.value[0][0] * u[c] + w.value[0][1] * u[2 + c] +
                          w.value[0][2] * u[4 + c]);
          }
      return sum;
    }

    /// nodal_i += S_ip f
    void
    scatter_value(const PointWeights<2> &w,
                  const Tensor<1, 2>    &f,
                  double                *nodal) const
    {
      double *u = nodal + 2 * w.base;
      for (unsigned int j = 0; j < 3; ++j, u += row)
        {
          const double a = w.value[1][j] * f[0];
          const double b = w.value[1][j] * f[1];
          for (unsigned int i = 0; i < 3; ++i)
            {
              u[2 * i] += w.value[0][i] * a;
              u[2 * i + 1] += w.value[0][i] * b;
            }
        }
    }

    /// nodal_i,c += sum_d P_cd dS_ip/dx_d
    void
    scatter_gradient(const PointWeights<2> &w,
                     const Tensor<2, 2>    &P,
                     double                *nodal) const
    {
      double *u = nodal + 2 * w.base;
      for (unsigned int j = 0; j < 3; ++j, u += row)
        {
          const double ax = w.value[1][j] * P[0][0];
          const double bx = w.gradient[1][j] * P[0][1];
          const double ay = w.value[1][j] * P[1][0];
          const double by = w.gradient[1][j] * P[1][1];
          for (unsigned int i = 0; i < 3; ++i)
            {
              u[2 * i] += w.gradient[0][i] * ax + w.value[0][i] * bx;
              u[2 * i + 1] += w.gradient[0][i] * ay + w.value[0][i] * by;
            }
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
