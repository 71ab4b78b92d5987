// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/stencil.h>
#include <waker/mechanics/displacement_rate.h>
#include <waker/mechanics/time_scheme.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    template <int dim>
    class QuasiStatic : public TimeScheme<dim>
    {
    public:
      explicit QuasiStatic(const SchemeInput<dim> &in)
        : in(in)
        , stress_update(in.materials, make_point_motion<dim>(in.mapping))
        , springs(make_springs(in.fixities,
                               stiffest_modulus(in.materials),
                               in.grid.cell_size()))
        , ghost(in.grid,
                in.fixities,
                in.time.ghost_stiffness * stiffest_modulus(in.materials))
        , newton(in.weights,
                 in.fixities,
                 in.newton,
                 in.full_node_mass,
                 springs,
                 LinearMethod::direct,
                 in.walls,
                 in.time.ghost_stiffness > 0. ? &ghost : nullptr)
        , reached(in.grid)
        , start_force(in.grid.n_dofs())
      {}

      double
      time_step(const MaterialPoints<dim> &) const override
      {
        return in.time.time_step;
      }

      StepReport<dim>
      solve(const MaterialPoints<dim> &points,
            const Weights<dim>        &weights,
            const double               t,
            const double               dt,
            NodalState                &nodes) override;

      void
      update_points(const Weights<dim>  &weights,
                    const double         t,
                    const double         dt,
                    NodalState          &nodes,
                    MaterialPoints<dim> &points,
                    StepReport<dim>     &report) override;

    private:
      /// Share of weight and loads that acts at t.
      double
      load_factor(const double t) const
      {
        return residual_ramp(t, in.time.load_duration);
      }

      /// Carry the motion to the points.
      void
      move(const Weights<dim>  &weights,
           const double         dt,
           const NodalState    &nodes,
           MaterialPoints<dim> &points,
           StepReport<dim>     &report) const;

      /// The works of the step.
      void
      add_works(const double      t,
                const double      dt,
                const NodalState &nodes,
                StepReport<dim>  &report);

      const SchemeInput<dim> in;
      StressUpdate<dim>      stress_update;
      const Springs          springs;
      GhostStiffness<dim>    ghost;
      NewtonSolver<dim>      newton;
      ReachedNodes           reached;
      NodalVector            start_force; // internal, at the start, kN
      std::vector<double>    removed_increments;
      std::vector<double>    spring_targets;
    };


    template <int dim>
    StepReport<dim>
    QuasiStatic<dim>::solve(const MaterialPoints<dim> &points,
                            const Weights<dim>        &weights,
                            const double               t,
                            const double               dt,
                            NodalState                &nodes)
    {
      in.fixities.removed_increments(t, dt, removed_increments);
      in.fixities.penalty_increments(t, dt, spring_targets);
      reached.reinit(nodes.mass);
      ghost.reinit(nodes.mass, in.full_node_mass);

      nodes.increment = 0.;
      stress_update.evaluate(points, weights, nodes.increment, start_force);
      if (in.walls != nullptr)
        in.walls->add_start_force(start_force);

      const auto &removed = in.fixities.removed_list();
      for (std::size_t k = 0; k < removed.size(); ++k)
        nodes.increment.begin()[removed[k]] = removed_increments[k];
      typename NewtonSolver<dim>::Inertia inertia;
      inertia.load = load_factor(t + dt);
      const NewtonReport newton_report =
        newton.solve(points, inertia, spring_targets, stress_update, nodes);

      StepReport<dim> report;
      report.converged         = newton_report.converged;
      report.newton_iterations = newton_report.iterations;
      report.linear_iterations = newton_report.linear_iterations;
      report.residuals         = newton_report.residuals;

      nodes.new_velocity = nodes.increment;
      nodes.new_velocity *= 1. / dt;
      nodes.new_acceleration = 0.;
      return report;
    }


    template <int dim>
    void
    QuasiStatic<dim>::update_points(const Weights<dim>  &weights,
                                    const double         t,
                                    const double         dt,
                                    NodalState          &nodes,
                                    MaterialPoints<dim> &points,
                                    StepReport<dim>     &report)
    {
      const StressReport stress  = stress_update.accept(points);
      report.mean_plastic_strain = stress.plastic_strain;
      report.dissipation         = stress.dissipation;
      report.elastic_energy      = stress.elastic_energy;
      move(weights, dt, nodes, points, report);
      add_works(t, dt, nodes, report);
    }


    template <int dim>
    void
    QuasiStatic<dim>::move(const Weights<dim>  &weights,
                           const double         dt,
                           const NodalState    &nodes,
                           MaterialPoints<dim> &points,
                           StepReport<dim>     &report) const
    {
      const Stencil<dim>  stencil(weights.background_grid());
      const double *const u      = nodes.increment.begin();
      double              square = 0., mass = 0.;
      for (std::size_t p = 0; p < points.n_points(); ++p)
        {
          const Tensor<1, dim> du = stencil.value(weights[p], u);
          square += points.mass[p] * du.norm_square();
          mass += points.mass[p];
          points.acceleration[p] = 0.;
          if (in.time.move_points)
            {
              points.position[p] += du;
              points.velocity[p] = du / dt; // without energy: no inertia
            }
        }
      report.displacement_rate = displacement_rate(square, mass, dt);
    }


    template <int dim>
    void
    QuasiStatic<dim>::add_works(const double      t,
                                const double      dt,
                                const NodalState &nodes,
                                StepReport<dim>  &report)
    {
      const double *const u        = nodes.increment.begin();
      const double *const external = nodes.external_force.begin();
      const double *const internal = nodes.internal_force.begin();
      double *const       start    = start_force.begin();
      const double *const before =
        nodes.start_force.size() > 0 ? nodes.start_force.begin() : external;

      // A body without stress has carried no load.
      const double s_end = load_factor(t + dt);
      const double s_start =
        start_force.linfty_norm() > 0. ? load_factor(t) : 0.;
      const unsigned char *const removed = in.fixities.removed().data();

      for (const auto &run : reached)
        for (std::size_t i = run.begin; i < run.end; ++i)
          for (unsigned int c = 0; c < dim; ++c)
            {
              const std::size_t dof = dim * i + c;
              const double weight   = c == 1 ? -nodes.mass[i] * in.gravity : 0.;
              const double load     = external[dof] - weight;
              const double balance  = start[dof] - s_start * weight;
              const double start_load = s_start * (before[dof] - weight);

              report.gravity_work += 0.5 * (s_start + s_end) * weight * u[dof];
              report.water_work += 0.5 * (start_load + s_end * load) * u[dof];
              const double start_gap = start_load - balance;
              if (removed[dof])
                {
                  const double force = internal[dof] - s_end * external[dof];
                  report.reaction[c] += force;
                  report.support_work += 0.5 * (force - start_gap) * u[dof];
                }
              else
                report.mapping_loss += 0.5 * start_gap * u[dof];
            }
      add_spring_reaction(springs, spring_targets, nodes, report);
      if (in.time.ghost_stiffness > 0.)
        {
          // It keeps no energy: what it takes in a step is lost.
          start_force = 0.;
          ghost.vmult_add(start_force, nodes.increment);
          report.mapping_loss += 0.5 * (start_force * nodes.increment);
        }
    }
  } // namespace


  template <int dim>
  std::unique_ptr<TimeScheme<dim>>
  make_quasi_static(const SchemeInput<dim> &input)
  {
    return std::make_unique<QuasiStatic<dim>>(input);
  }


  template std::unique_ptr<TimeScheme<2>>
  make_quasi_static(const SchemeInput<2> &);
  template std::unique_ptr<TimeScheme<3>>
  make_quasi_static(const SchemeInput<3> &);
} // namespace Waker
