// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/stencil.h>
#include <waker/mapping/transfer.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    /// Add the mass, momentum and momentum rate of one point.
    inline void
    scatter_point(const PointWeights<2> &w,
                  const Stencil<2>      &stencil,
                  const double           m,
                  const Tensor<1, 2>    &velocity,
                  const Tensor<1, 2>    &acceleration,
                  double                *mass,
                  double                *momentum,
                  double                *rate)
    {
      const NodeRow p =
        NodeRow::outer(w.value[0], Two{m * velocity[0], m * velocity[1]});
      const NodeRow f =
        NodeRow::outer(w.value[0],
                       Two{m * acceleration[0], m * acceleration[1]});
      unsigned int node = w.base;
      for (unsigned int j = 0; j < 3; ++j, node += stencil.row / 2)
        {
          for (unsigned int i = 0; i < 3; ++i)
            mass[node + i] += m * w.value[1][j] * w.value[0][i];
          NodeRow r = NodeRow::load(momentum + 2 * node);
          r.add(w.value[1][j], p);
          r.store(momentum + 2 * node);
          r = NodeRow::load(rate + 2 * node);
          r.add(w.value[1][j], f);
          r.store(rate + 2 * node);
        }
    }


    inline void
    scatter_point(const PointWeights<3> &w,
                  const Stencil<3>      &stencil,
                  const double           m,
                  const Tensor<1, 3>    &velocity,
                  const Tensor<1, 3>    &acceleration,
                  double                *mass,
                  double                *momentum,
                  double                *rate)
    {
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int j = 0; j < 3; ++j)
          {
            const unsigned int node =
              w.base + k * (stencil.plane / 3) + j * (stencil.row / 3);
            const double mj = m * w.value[2][k] * w.value[1][j];
            for (unsigned int i = 0; i < 3; ++i)
              {
                const double       s = mj * w.value[0][i];
                const unsigned int n = node + i;
                mass[n] += s;
                for (unsigned int c = 0; c < 3; ++c)
                  {
                    momentum[3 * n + c] += s * velocity[c];
                    rate[3 * n + c] += s * acceleration[c];
                  }
              }
          }
    }
  } // namespace


  template <int dim>
  void
  to_nodes(const MaterialPoints<dim> &points,
           const Weights<dim>        &weights,
           NodalState                &nodes)
  {
    const Stencil<dim> stencil(weights.background_grid());
    nodes.velocity     = 0.;
    nodes.acceleration = 0.;
    std::fill(nodes.mass.begin(), nodes.mass.end(), 0.);

    double *const mass     = nodes.mass.data();
    double *const momentum = nodes.velocity.begin();
    double *const rate     = nodes.acceleration.begin();
    for (std::size_t p = 0; p < points.n_points(); ++p)
      scatter_point(weights[p],
                    stencil,
                    points.mass[p],
                    points.velocity[p],
                    points.acceleration[p],
                    mass,
                    momentum,
                    rate);
    weights.background_grid().exchange().sum(
      {{mass, 1}, {momentum, dim}, {rate, dim}});

    for (std::size_t i = 0; i < nodes.mass.size(); ++i)
      if (mass[i] > 0.)
        {
          const double inverse = 1. / mass[i];
          for (unsigned int c = 0; c < dim; ++c)
            {
              momentum[dim * i + c] *= inverse;
              rate[dim * i + c] *= inverse;
            }
        }
  }


  template <int dim>
  void
  set_gravity(const double gravity, NodalState &nodes)
  {
    nodes.external_force = 0.;
    double *const force  = nodes.external_force.begin();
    for (std::size_t i = 0; i < nodes.mass.size(); ++i)
      force[dim * i + 1] = -nodes.mass[i] * gravity;
  }


  template <int dim>
  TransferReport
  to_particles(const NodalState    &nodes,
               const Weights<dim>  &weights,
               const double         dt,
               MaterialPoints<dim> &points)
  {
    const Stencil<dim>  stencil(weights.background_grid());
    const double *const increment    = nodes.increment.begin();
    const double *const acceleration = nodes.new_acceleration.begin();
    TransferReport      report;
    double              largest_square = 0.;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const PointWeights<dim> &w  = weights[p];
        const Tensor<1, dim>     du = stencil.value(w, increment);
        const Tensor<1, dim>     a  = stencil.value(w, acceleration);
        report.kinetic_before +=
          0.5 * points.mass[p] * points.velocity[p].norm_square();
        points.position[p] += du;
        points.velocity[p] += (0.5 * dt) * (points.acceleration[p] + a);
        points.acceleration[p] = a;
        report.kinetic_after +=
          0.5 * points.mass[p] * points.velocity[p].norm_square();

        const double square = du.norm_square();
        report.squared_displacement += points.mass[p] * square;
        report.mass += points.mass[p];
        largest_square = std::max(largest_square, square);
      }
    report.largest_displacement = std::sqrt(largest_square);
    return report;
  }


  template void
  to_nodes(const MaterialPoints<2> &, const Weights<2> &, NodalState &);
  template void
  to_nodes(const MaterialPoints<3> &, const Weights<3> &, NodalState &);
  template void
  set_gravity<2>(const double, NodalState &);
  template void
  set_gravity<3>(const double, NodalState &);
  template TransferReport
  to_particles(const NodalState &,
               const Weights<2> &,
               const double,
               MaterialPoints<2> &);
  template TransferReport
  to_particles(const NodalState &,
               const Weights<3> &,
               const double,
               MaterialPoints<3> &);
} // namespace Waker
