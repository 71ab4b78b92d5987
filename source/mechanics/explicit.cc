// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/stencil.h>
#include <waker/mechanics/displacement_rate.h>
#include <waker/mechanics/energy.h>
#include <waker/mechanics/held_soil.h>
#include <waker/mechanics/time_scheme.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Waker
{
  namespace
  {
    template <int dim>
    class Explicit : public TimeScheme<dim>
    {
    public:
      explicit Explicit(const SchemeInput<dim> &in)
        : in(in)
        , held(in)
        , stretched(in.grid.n_dofs())
      {}

      double
      time_step(const MaterialPoints<dim> &points) const override
      {
        double largest = 0.;
        for (const Tensor<1, dim> &v : points.velocity)
          largest = std::max(largest, v.norm_square());
        return in.time.courant_number * in.grid.cell_size() /
               (wave_speed(in.materials) +
                std::sqrt(in.grid.exchange().largest(largest)));
      }

      StepReport<dim>
      solve(const MaterialPoints<dim> &points,
            const double               t,
            const double               dt,
            NodalState                &nodes) override;

      void
      to_points(const double         t,
                const double         dt,
                NodalState          &nodes,
                MaterialPoints<dim> &points,
                StepReport<dim>     &report) override;

    private:
      /// Let the supports act on the accelerations of the free motion.
      void
      hold(const double dt, NodalState &nodes);

      const SchemeInput<dim> in;
      HeldSoil<dim>          held;
      NodalVector            stretched; // increments that strain the points, m
      std::vector<double>    removed_increments;
    };


    template <int dim>
    void
    Explicit<dim>::hold(const double dt, NodalState &nodes)
    {
      // A spring as stiff as a penalty would need far smaller steps: taken
      // implicitly, with the diagonal of its stiffness, it needs none.
      NodalVector force, stiffness, way = nodes.velocity;
      force.reinit(way);
      stiffness.reinit(way);
      way *= dt;
      for (Resistance<dim> *const support : held.supports)
        {
          support->add_force(way, force);
          support->add_diagonal(stiffness);
        }
      in.grid.exchange().sum({{force.begin(), dim}, {stiffness.begin(), dim}});
      double *const new_a = nodes.new_acceleration.begin();
      for (std::size_t dof = 0; dof < in.grid.n_dofs(); ++dof)
        {
          const double mass = nodes.mass[dof / dim];
          const double k    = stiffness.begin()[dof];
          if (mass > 0. && k > 0.)
            new_a[dof] =
              (mass * new_a[dof] - force.begin()[dof]) / (mass + k * dt * dt);
        }
    }


    template <int dim>
    StepReport<dim>
    Explicit<dim>::solve(const MaterialPoints<dim> &points,
                         const double               t,
                         const double               dt,
                         NodalState                &nodes)
    {
      in.find_motion(t, dt, removed_increments);
      held.soil.begin(points, nodes, t, dt);
      for (Resistance<dim> *const support : held.supports)
        support->begin(points, nodes, t, dt);
      nodes.internal_force = 0.;
      held.soil.add_start_force(nodes.internal_force);
      const NodeExchange &ranks = in.grid.exchange();
      ranks.sum({{nodes.internal_force.begin(), dim}});

      const double        ramp = residual_ramp(t + dt, in.time.ramp_duration);
      const double *const internal = nodes.internal_force.begin();
      const double *const external = nodes.external_force.begin();
      double *const       v        = nodes.velocity.begin();
      double *const       new_v    = nodes.new_velocity.begin();
      double *const       new_a    = nodes.new_acceleration.begin();
      double *const       u        = nodes.increment.begin();

      const auto &removed = in.fixities.removed_list();
      for (std::size_t k = 0; k < removed.size(); ++k)
        v[removed[k]] = removed_increments[k] / dt;

      for (std::size_t i = 0; i < nodes.mass.size(); ++i)
        for (unsigned int c = 0; c < dim; ++c)
          {
            const std::size_t dof = dim * i + c;
            new_a[dof] =
              nodes.mass[i] > 0.
                ? ramp * (external[dof] - internal[dof]) / nodes.mass[i]
                : 0.;
          }
      if (!held.supports.empty())
        hold(dt, nodes);
      for (const unsigned int dof : removed)
        new_a[dof] = 0.;

      double square = 0.;
      for (std::size_t dof = 0; dof < in.grid.n_dofs(); ++dof)
        {
          new_v[dof] = v[dof] + dt * new_a[dof];
          u[dof]     = dt * new_v[dof];
          square += new_v[dof] * new_v[dof];
        }
      // Nothing is solved: it only has to be a motion.
      StepReport<dim> report;
      report.converged = std::isfinite(ranks.sum(square));
      report.residuals = {
        report.converged ? 0. : std::numeric_limits<double>::infinity()};
      return report;
    }


    template <int dim>
    void
    Explicit<dim>::to_points(const double,
                             const double         dt,
                             NodalState          &nodes,
                             MaterialPoints<dim> &points,
                             StepReport<dim>     &report)
    {
      const Weights<dim> &weights = in.weights;
      const Stencil<dim>  stencil(in.grid);
      const double *const new_a  = nodes.new_acceleration.begin();
      const double *const u      = nodes.increment.begin();
      stretched                  = 0.;
      double *const star         = stretched.begin();
      double        displacement = 0., mass = 0.;
      for (std::size_t p = 0; p < points.n_points(); ++p)
        {
          const Tensor<1, dim> a  = stencil.value(weights[p], new_a);
          const Tensor<1, dim> du = stencil.value(weights[p], u);
          points.velocity[p] += dt * a;
          points.position[p] += du;
          points.acceleration[p] = a;
          displacement += points.mass[p] * du.norm_square();
          mass += points.mass[p];
          stencil.scatter_value(weights[p],
                                points.mass[p] * points.velocity[p],
                                star);
        }
      const NodeExchange &ranks = in.grid.exchange();
      ranks.sum({{star, dim}});
      for (std::size_t i = 0; i < nodes.mass.size(); ++i)
        if (nodes.mass[i] > 0.)
          for (unsigned int c = 0; c < dim; ++c)
            star[dim * i + c] *= dt / nodes.mass[i];
      const auto &removed = in.fixities.removed_list();
      for (std::size_t k = 0; k < removed.size(); ++k)
        star[removed[k]] = removed_increments[k];

      // evaluate() overwrites the internal force: the reaction comes first.
      const double *const internal = nodes.internal_force.begin();
      const double *const external = nodes.external_force.begin();
      for (const unsigned int dof : removed)
        {
          if (!ranks.owns(dof / dim))
            continue;
          report.reaction[dof % dim] += internal[dof] - external[dof];
          report.support_work += (internal[dof] - external[dof]) * u[dof];
        }
      for (Resistance<dim> *const support : held.supports)
        {
          report.reaction += support->accept(nodes.increment, points);
          report.support_work += support->work(nodes.increment).mean();
        }
      for (std::size_t i = 0; i < nodes.mass.size(); ++i)
        {
          if (!ranks.owns(i))
            continue;
          report.gravity_work -= nodes.mass[i] * in.gravity * u[dim * i + 1];
          for (unsigned int c = 0; c < dim; ++c)
            report.load_work += external[dim * i + c] * u[dim * i + c];
        }
      report.load_work -= report.gravity_work;

      nodes.internal_force = 0.;
      held.soil.add_force(stretched, nodes.internal_force);
      ranks.sum({{nodes.internal_force.begin(), dim}});
      held.soil.accept(stretched, points);
      const StressReport &stress = held.soil.report();
      report.mean_plastic_strain = stress.plastic_strain;
      double sums[]              = {displacement, mass};
      ranks.sum(sums, 2);
      report.displacement_rate = displacement_rate(sums[0], sums[1], dt);
      report.dissipation       = stress.dissipation;
      report.elastic_energy    = stress.elastic_energy;
      report.kinetic_energy    = kinetic_energy(points);
      report.sum(ranks, points.n_points());
    }
  } // namespace


  template <int dim>
  std::unique_ptr<TimeScheme<dim>>
  make_explicit(const SchemeInput<dim> &input)
  {
    return std::make_unique<Explicit<dim>>(input);
  }


  template std::unique_ptr<TimeScheme<2>>
  make_explicit(const SchemeInput<2> &);
  template std::unique_ptr<TimeScheme<3>>
  make_explicit(const SchemeInput<3> &);
} // namespace Waker
