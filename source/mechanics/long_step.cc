// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/stencil.h>
#include <waker/mechanics/energy.h>
#include <waker/mechanics/time_scheme.h>

namespace Waker
{
  namespace
  {
    /// A body moves if more than this share of its mass moves far: single
    /// points on a loose surface do not count.
    constexpr double moving_share = 1e-3;


    template <int dim>
    class LongStep : public TimeScheme<dim>
    {
    public:
      explicit LongStep(const SchemeInput<dim> &in)
        : grid(in.grid)
        , weights(in.weights)
        , time(of_a_body_that_moves(in.time))
        , quasi_static(make_quasi_static(SchemeInput<dim>{in.grid,
                                                          in.weights,
                                                          in.materials,
                                                          in.fixities,
                                                          time,
                                                          in.newton,
                                                          in.mapping,
                                                          in.gravity,
                                                          in.full_node_mass,
                                                          in.resistances}))
      {}

      double
      time_step(const MaterialPoints<dim> &) const override
      {
        return time.longest_step;
      }

      StepReport<dim>
      solve(const MaterialPoints<dim> &points,
            const double               t,
            const double               dt,
            NodalState                &nodes) override
      {
        StepReport<dim> report = quasi_static->solve(points, t, dt, nodes);
        report.converged       = report.converged && !goes_far(points, nodes);
        return report;
      }

      void
      to_points(const double         t,
                const double         dt,
                NodalState          &nodes,
                MaterialPoints<dim> &points,
                StepReport<dim>     &report) override
      {
        const double kinetic = grid.exchange().sum(kinetic_energy(points));
        quasi_static->to_points(t, dt, nodes, points, report);
        points.velocity.assign(points.n_points(), Tensor<1, dim>());
        report.mapping_loss += kinetic;
      }

    private:
      static TimeParameters
      of_a_body_that_moves(TimeParameters time)
      {
        time.load_duration = 0.;
        time.move_points   = true;
        return time;
      }

      /// Would the step take soil further than it may?
      bool
      goes_far(const MaterialPoints<dim> &points, const NodalState &nodes) const
      {
        const Stencil<dim> stencil(grid);
        const double       limit =
          time.largest_displacement * time.largest_displacement;
        double far = 0., all = 0.;
        for (std::size_t p = 0; p < points.n_points(); ++p)
          {
            const Tensor<1, dim> u =
              stencil.value(weights[p], nodes.increment.begin());
            all += points.mass[p];
            if (!(u.norm_square() <= limit))
              far += points.mass[p];
          }
        double sums[] = {far, all};
        grid.exchange().sum(sums, 2);
        return sums[0] > moving_share * sums[1];
      }

      const BackgroundGrid<dim>             &grid;
      const Weights<dim>                    &weights;
      const TimeParameters                   time;
      const std::unique_ptr<TimeScheme<dim>> quasi_static;
    };
  } // namespace


  template <int dim>
  std::unique_ptr<TimeScheme<dim>>
  make_scheme_at_rest(const SchemeInput<dim> &input)
  {
    if (!scheme_traits(input.time).has_long_steps)
      return nullptr;
    return std::make_unique<LongStep<dim>>(input);
  }


  template std::unique_ptr<TimeScheme<2>>
  make_scheme_at_rest(const SchemeInput<2> &);
  template std::unique_ptr<TimeScheme<3>>
  make_scheme_at_rest(const SchemeInput<3> &);
} // namespace Waker
