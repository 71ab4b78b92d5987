// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/transfer.h>
#include <waker/mechanics/displacement_rate.h>
#include <waker/mechanics/implicit_scheme.h>

namespace Waker
{
  namespace
  {
    template <int dim>
    class Newmark : public ImplicitScheme<dim>
    {
    public:
      explicit Newmark(const SchemeInput<dim> &in)
        : ImplicitScheme<dim>(in, LinearMethod::krylov)
        , history(in.grid.n_dofs())
      {}

    protected:
      using typename ImplicitScheme<dim>::ResidualTerms;
      using ImplicitScheme<dim>::in;
      using ImplicitScheme<dim>::reached;
      using ImplicitScheme<dim>::removed_increments;

      ResidualTerms
      begin(const double t, const double dt, NodalState &nodes) override;

      void
      move_nodes(const double dt, NodalState &nodes) const override;

      void
      move_points(const double         dt,
                  const NodalState    &nodes,
                  MaterialPoints<dim> &points,
                  StepReport<dim>     &report) override;

      void
      add_works(const double          t,
                const double          dt,
                const NodalState     &nodes,
                const ResistanceWork &internal,
                StepReport<dim>      &report) override;

    private:
      NodalVector    history; // 4 v / dt + a, m/s^2
      TransferReport moved;   // of the step
    };


    template <int dim>
    typename Newmark<dim>::ResidualTerms
    Newmark<dim>::begin(const double t, const double dt, NodalState &nodes)
    {
      // A support moves at constant velocity through the step.
      double *const v       = nodes.velocity.begin();
      double *const a       = nodes.acceleration.begin();
      const auto   &removed = in.fixities.removed_list();
      for (std::size_t k = 0; k < removed.size(); ++k)
        {
          v[removed[k]] = removed_increments[k] / dt;
          a[removed[k]] = 0.;
        }

      double *const u     = nodes.increment.begin();
      double *const q     = history.begin();
      const double  share = in.newton.predictor ? 1. : 0.;
      for (const auto &run : reached)
        for (std::size_t i = dim * run.begin; i < dim * run.end; ++i)
          {
            q[i] = 4. / dt * v[i] + a[i];
            u[i] = share * (dt * v[i] + 0.5 * dt * dt * a[i]);
          }

      ResidualTerms terms; // eqs. 2.22, 2.25
      terms.ramp    = residual_ramp(t + dt, in.time.ramp_duration);
      terms.factor  = 4. / (dt * dt);
      terms.history = &history;
      return terms;
    }


    template <int dim>
    void
    Newmark<dim>::move_nodes(const double dt, NodalState &nodes) const
    {
      const double *const u     = nodes.increment.begin();
      const double *const v     = nodes.velocity.begin();
      const double *const q     = history.begin();
      double *const       new_v = nodes.new_velocity.begin();
      double *const       new_a = nodes.new_acceleration.begin();
      nodes.new_velocity        = 0.;
      nodes.new_acceleration    = 0.;
      for (const auto &run : reached)
        for (std::size_t i = dim * run.begin; i < dim * run.end; ++i)
          {
            new_v[i] = 2. / dt * u[i] - v[i];        // eq. 2.21
            new_a[i] = 4. / (dt * dt) * u[i] - q[i]; // eq. 2.20
          }
    }


    template <int dim>
    void
    Newmark<dim>::move_points(const double         dt,
                              const NodalState    &nodes,
                              MaterialPoints<dim> &points,
                              StepReport<dim>     &report)
    {
      moved         = to_particles(nodes, in.weights, dt, points);
      double sums[] = {moved.squared_displacement, moved.mass};
      in.grid.exchange().sum(sums, 2);
      report.displacement_rate = displacement_rate(sums[0], sums[1], dt);
      report.kinetic_energy    = moved.kinetic_after;
    }


    template <int dim>
    void
    Newmark<dim>::add_works(const double          t,
                            const double          dt,
                            const NodalState     &nodes,
                            const ResistanceWork &internal_work,
                            StepReport<dim>      &report)
    {
      // Work of the external and inertial forces over the step, and kinetic
      // energy of the nodes at its start and end.
      const double *const u        = nodes.increment.begin();
      const double *const external = nodes.external_force.begin();
      const double *const before =
        nodes.start_force.size() > 0 ? nodes.start_force.begin() : external;
      const double *const internal = nodes.internal_force.begin();
      const double *const a        = nodes.acceleration.begin();
      const double *const v        = nodes.velocity.begin();
      const double *const new_v    = nodes.new_velocity.begin();
      double start_work = 0., external_work = 0., inertia_work = 0.;
      double kinetic_before = 0., kinetic_after = 0.;
      for (const auto &run : reached.owned())
        for (std::size_t i = run.begin; i < run.end; ++i)
          {
            const double mass = nodes.mass[i];
            report.gravity_work -= mass * in.gravity * u[dim * i + 1];
            for (unsigned int c = 0; c < dim; ++c)
              {
                const std::size_t dof = dim * i + c;
                start_work += before[dof] * u[dof];
                external_work += external[dof] * u[dof];
                inertia_work += mass * a[dof] * u[dof];
                kinetic_before += 0.5 * mass * v[dof] * v[dof];
                kinetic_after += 0.5 * mass * new_v[dof] * new_v[dof];
              }
          }
      report.load_work =
        0.5 * (start_work + external_work) - report.gravity_work;

      const double r_start = residual_ramp(t, in.time.ramp_duration);
      const double r_end   = residual_ramp(t + dt, in.time.ramp_duration);
      report.ramp_work =
        0.5 * ((1. - r_start) * (start_work + internal_work.start) +
               (1. - r_end) * (external_work + internal_work.end));
      // What the way from points to nodes and back takes: kinetic energy, and
      // the work that the force at the start would have done over the work of
      // the acceleration that the nodes were given instead.
      report.mapping_loss =
        (moved.kinetic_before - kinetic_before) +
        (kinetic_after - report.kinetic_energy) +
        0.5 * (r_start * (start_work + internal_work.start) - inertia_work);

      const double *const new_a = nodes.new_acceleration.begin();
      for (const unsigned int dof : in.fixities.removed_list())
        {
          if (!reached.ranks().owns(dof / dim))
            continue;
          const double force = r_end * (internal[dof] - external[dof]) +
                               nodes.mass[dof / dim] * new_a[dof];
          report.reaction[dof % dim] += internal[dof] - external[dof];
          report.support_work += force * u[dof];
          // Half of it is in the kinetic energy of the nodes; at the start they
          // were given no acceleration.
          report.mapping_loss += 0.5 * force * u[dof];
        }
    }
  } // namespace


  template <int dim>
  std::unique_ptr<TimeScheme<dim>>
  make_newmark(const SchemeInput<dim> &input)
  {
    return std::make_unique<Newmark<dim>>(input);
  }


  template std::unique_ptr<TimeScheme<2>>
  make_newmark(const SchemeInput<2> &);
  template std::unique_ptr<TimeScheme<3>>
  make_newmark(const SchemeInput<3> &);
} // namespace Waker
