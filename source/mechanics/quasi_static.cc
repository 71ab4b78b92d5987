// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/stencil.h>
#include <waker/mechanics/displacement_rate.h>
#include <waker/mechanics/ghost_stiffness.h>
#include <waker/mechanics/implicit_scheme.h>

namespace Waker
{
  namespace
  {
    template <int dim>
    class QuasiStatic : public ImplicitScheme<dim>
    {
    public:
      explicit QuasiStatic(const SchemeInput<dim> &in)
        : ImplicitScheme<dim>(in,
                              in.is_elastic ? LinearMethod::elastic
                                            : LinearMethod::direct)
        , ghost(in.grid,
                in.fixities,
                in.time.ghost_stiffness * stiffest_modulus(in.materials),
                in.full_node_mass)
        , start_force(in.grid.n_dofs())
      {
        if (in.time.ghost_stiffness > 0.)
          this->add_resistance(ghost);
      }

    protected:
      using typename ImplicitScheme<dim>::ResidualTerms;
      using ImplicitScheme<dim>::in;
      using ImplicitScheme<dim>::reached;

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
      /// Share of weight and loads that acts at t.
      double
      load_factor(const double t) const
      {
        return residual_ramp(t, in.time.load_duration);
      }

      GhostStiffness<dim> ghost;
      NodalVector         start_force; // internal, at the start, kN
    };


    template <int dim>
    typename QuasiStatic<dim>::ResidualTerms
    QuasiStatic<dim>::begin(const double t, const double dt, NodalState &)
    {
      start_force = 0.;
      for (Resistance<dim> *const resistance : this->resistances)
        resistance->add_start_force(start_force);
      in.grid.exchange().sum({{start_force.begin(), dim}});
      ResidualTerms terms;
      terms.load = load_factor(t + dt);
      return terms;
    }


    template <int dim>
    void
    QuasiStatic<dim>::move_nodes(const double dt, NodalState &nodes) const
    {
      nodes.new_velocity = nodes.increment;
      nodes.new_velocity *= dt > 0. ? 1. / dt : 0.;
      nodes.new_acceleration = 0.;
    }


    template <int dim>
    void
    QuasiStatic<dim>::move_points(const double         dt,
                                  const NodalState    &nodes,
                                  MaterialPoints<dim> &points,
                                  StepReport<dim>     &report)
    {
      const Stencil<dim>  stencil(in.grid);
      const double *const u      = nodes.increment.begin();
      double              square = 0., mass = 0.;
      for (std::size_t p = 0; p < points.n_points(); ++p)
        {
          const Tensor<1, dim> du = stencil.value(in.weights[p], u);
          square += points.mass[p] * du.norm_square();
          mass += points.mass[p];
          points.acceleration[p] = 0.;
          if (in.time.move_points)
            {
              points.position[p] += du;
              points.velocity[p] = du / dt; // without energy: no inertia
            }
        }
      double sums[] = {square, mass};
      in.grid.exchange().sum(sums, 2);
      report.displacement_rate = displacement_rate(sums[0], sums[1], dt);
    }


    template <int dim>
    void
    QuasiStatic<dim>::add_works(const double      t,
                                const double      dt,
                                const NodalState &nodes,
                                const ResistanceWork &,
                                StepReport<dim> &report)
    {
      const double *const u        = nodes.increment.begin();
      const double *const external = nodes.external_force.begin();
      const double *const internal = nodes.internal_force.begin();
      const double *const start    = start_force.begin();
      const double *const before =
        nodes.start_force.size() > 0 ? nodes.start_force.begin() : external;

      // A body without stress has carried no load.
      const double s_end = load_factor(t + dt);
      const bool   has_carried =
        in.grid.exchange().largest(start_force.linfty_norm()) > 0.;
      const double               s_start = has_carried ? load_factor(t) : 0.;
      const unsigned char *const removed = in.fixities.removed().data();

      for (const auto &run : reached.owned())
        for (std::size_t i = run.begin; i < run.end; ++i)
          for (unsigned int c = 0; c < dim; ++c)
            {
              const std::size_t dof = dim * i + c;
              const double weight   = c == 1 ? -nodes.mass[i] * in.gravity : 0.;
              const double load     = external[dof] - weight;
              const double balance  = start[dof] - s_start * weight;
              const double start_load = s_start * (before[dof] - weight);

              report.gravity_work += 0.5 * (s_start + s_end) * weight * u[dof];
              report.load_work += 0.5 * (start_load + s_end * load) * u[dof];
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
