// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mapping_centre_stencil_h
#define waker_mapping_centre_stencil_h

#include <waker/mapping/stencil.h>

#include <array>

namespace Waker
{
  /**
   * The gradients of the nodes' functions at the centres of the cells,
   * averaged over a point's support domain: with the values at a cell's centre
   * instead of those on the way, in each direction
   *   S^c = (a, 1, 1 - a) / 2,
   * a the share of the domain's first cell; the derivative with respect to x is
   * S'(x) S^c(y) [S^c(z)], and so on. They sum up to nothing, and give a linear
   * field its gradient, whatever a is (numerics: B-bar with GIMP; the Q1
   * element's mean dilatation is that of its centre). It is that of the cells
   * in which B-bar acts (FilledCells).
   */
  template <int dim>
  struct CentreWeights
  {
    /// @param first a, in each direction
    explicit CentreWeights(const std::array<double, dim> &first)
    {
      for (unsigned int d = 0; d < dim; ++d)
        {
          value[d][0] = 0.5 * first[d];
          value[d][1] = 0.5;
          value[d][2] = 0.5 - value[d][0];
        }
    }

    /// Of the whole domain: the shares are in the slopes.
    static std::array<double, dim>
    shares(const PointWeights<dim> &w, const double h)
    {
      std::array<double, dim> first;
      for (unsigned int d = 0; d < dim; ++d)
        first[d] = -w.gradient[d][0] * h;
      return first;
    }

    double value[dim][3];
  };


  /**
   * The gradient and the mean dilatation sum_i u_i . grad^c S_ip of a point
   * together, and the forces of both.
   */
  template <int dim>
  struct CentreStencil;

  template <>
  struct CentreStencil<2> : private Stencil<2>
  {
    explicit CentreStencil(const BackgroundGrid<2> &grid)
      : Stencil<2>(grid)
      , h(grid.cell_size())
    {}

    double
    cell_size() const
    {
      return h;
    }

    /// @param gradient out: grad u
    /// @return the mean dilatation
    double
    gradient(const PointWeights<2>  &w,
             const CentreWeights<2> &c,
             const double           *nodal,
             double (&gradient)[2][2]) const
    {
      const double *u = nodal + 2 * w.base;
      NodeRow s = NodeRow::zero(), t = NodeRow::zero(), m = NodeRow::zero();
      for (unsigned int j = 0; j < 3; ++j, u += row)
        {
          const NodeRow r = NodeRow::load(u);
          s.add(w.value[1][j], r);
          t.add(w.gradient[1][j], r);
          m.add(c.value[1][j], r);
        }
      const Two dx = s.sum(w.gradient[0]);
      const Two dy = t.sum(w.value[0]);
      for (unsigned int k = 0; k < 2; ++k)
        {
          gradient[k][0] = dx[k];
          gradient[k][1] = dy[k];
        }
      return m.sum(w.gradient[0])[0] + t.sum(c.value[0])[1];
    }

    /// nodal_i += P grad S_ip + p grad^c S_ip
    void
    scatter(const PointWeights<2>  &w,
            const CentreWeights<2> &c,
            const Tensor<2, 2>     &P,
            const double            p,
            double                 *nodal) const
    {
      const NodeRow s = NodeRow::outer(w.gradient[0], Two{P[0][0], P[1][0]});
      NodeRow       t = NodeRow::outer(w.value[0], Two{P[0][1], P[1][1]});
      t.add(1., NodeRow::outer(c.value[0], Two{0., p}));
      const NodeRow m = NodeRow::outer(w.gradient[0], Two{p, 0.});
      double       *u = nodal + 2 * w.base;
      for (unsigned int j = 0; j < 3; ++j, u += row)
        {
          NodeRow r = NodeRow::load(u);
          r.add(w.value[1][j], s);
          r.add(w.gradient[1][j], t);
          r.add(c.value[1][j], m);
          r.store(u);
        }
    }

    /// f(node, grad S_ip, grad^c S_ip) for each of the nodes.
    template <typename Function>
    void
    for_each_node(const PointWeights<2>  &w,
                  const CentreWeights<2> &c,
                  const Function         &f) const
    {
      for (unsigned int j = 0; j < 3; ++j)
        for (unsigned int i = 0; i < 3; ++i)
          {
            Tensor<1, 2> at_point, at_centre;
            at_point[0]  = w.gradient[0][i] * w.value[1][j];
            at_point[1]  = w.value[0][i] * w.gradient[1][j];
            at_centre[0] = w.gradient[0][i] * c.value[1][j];
            at_centre[1] = c.value[0][i] * w.gradient[1][j];
            f(w.base + j * (row / 2) + i, at_point, at_centre);
          }
    }

  private:
    double h;
  };


  template <>
  struct CentreStencil<3> : private Stencil<3>
  {
    explicit CentreStencil(const BackgroundGrid<3> &grid)
      : Stencil<3>(grid)
      , h(grid.cell_size())
    {}

    double
    cell_size() const
    {
      return h;
    }

    double
    gradient(const PointWeights<3>  &w,
             const CentreWeights<3> &c,
             const double           *nodal,
             double (&gradient)[3][3]) const
    {
      double mean = 0.;
      for (auto &component : gradient)
        for (double &entry : component)
          entry = 0.;
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int j = 0; j < 3; ++j)
          {
            const double *u         = nodal + 3 * w.base + k * plane + j * row;
            const double  weight[3] = {w.value[2][k] * w.value[1][j],
                                       w.value[2][k] * w.gradient[1][j],
                                       w.gradient[2][k] * w.value[1][j]};
            double        slope[3];
            for (unsigned int a = 0; a < 3; ++a)
              {
                const double v = w.value[0][0] * u[a] +
                                 w.value[0][1] * u[3 + a] +
                                 w.value[0][2] * u[6 + a];
                slope[a] = w.gradient[0][0] * u[a] +
                           w.gradient[0][1] * u[3 + a] +
                           w.gradient[0][2] * u[6 + a];
                gradient[a][0] += weight[0] * slope[a];
                gradient[a][1] += weight[1] * v;
                gradient[a][2] += weight[2] * v;
              }
            double v[3];
            for (unsigned int a = 1; a < 3; ++a)
              v[a] = c.value[0][0] * u[a] + c.value[0][1] * u[3 + a] +
                     c.value[0][2] * u[6 + a];
            mean += c.value[2][k] *
                      (c.value[1][j] * slope[0] + w.gradient[1][j] * v[1]) +
                    w.gradient[2][k] * c.value[1][j] * v[2];
          }
      return mean;
    }

    void
    scatter(const PointWeights<3>  &w,
            const CentreWeights<3> &c,
            const Tensor<2, 3>     &P,
            const double            p,
            double                 *nodal) const
    {
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int j = 0; j < 3; ++j)
          {
            double      *u  = nodal + 3 * w.base + k * plane + j * row;
            const double sx = w.value[2][k] * w.value[1][j];
            const double sy = w.value[2][k] * w.gradient[1][j];
            const double sz = w.gradient[2][k] * w.value[1][j];
            double       a[3], b[3];
            for (unsigned int e = 0; e < 3; ++e)
              {
                a[e] = sx * P[e][0];
                b[e] = sy * P[e][1] + sz * P[e][2];
              }
            a[0] += p * c.value[2][k] * c.value[1][j];
            const double y = p * c.value[2][k] * w.gradient[1][j];
            const double z = p * w.gradient[2][k] * c.value[1][j];
            for (unsigned int i = 0; i < 3; ++i)
              {
                for (unsigned int e = 0; e < 3; ++e)
                  u[3 * i + e] +=
                    w.gradient[0][i] * a[e] + w.value[0][i] * b[e];
                u[3 * i + 1] += c.value[0][i] * y;
                u[3 * i + 2] += c.value[0][i] * z;
              }
          }
    }

    template <typename Function>
    void
    for_each_node(const PointWeights<3>  &w,
                  const CentreWeights<3> &c,
                  const Function         &f) const
    {
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int j = 0; j < 3; ++j)
          for (unsigned int i = 0; i < 3; ++i)
            {
              Tensor<1, 3> at_point, at_centre;
              at_point[0]  = w.gradient[0][i] * w.value[1][j] * w.value[2][k];
              at_point[1]  = w.value[0][i] * w.gradient[1][j] * w.value[2][k];
              at_point[2]  = w.value[0][i] * w.value[1][j] * w.gradient[2][k];
              at_centre[0] = w.gradient[0][i] * c.value[1][j] * c.value[2][k];
              at_centre[1] = c.value[0][i] * w.gradient[1][j] * c.value[2][k];
              at_centre[2] = c.value[0][i] * c.value[1][j] * w.gradient[2][k];
              f(w.base + k * (plane / 3) + j * (row / 3) + i,
                at_point,
                at_centre);
            }
    }

  private:
    double h;
  };
} // namespace Waker

#endif
