// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/balance_step.h>
#include <waker/mechanics/time_scheme.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Waker
{
  namespace
  {
    /// Of the residual, relative to all forces.
    constexpr double tolerance = 1e-6;
    /// A step is not made shorter than this share of the first one.
    constexpr double shortest = 1. / 64.;


    /// Volume of the points whose plastic strain has grown.
    template <int dim>
    double
    yielded_volume(const MaterialPoints<dim> &points,
                   const std::vector<double> &before,
                   std::vector<bool>         &has_yielded)
    {
      const int number = points.find_scalar("plastic strain");
      double    volume = 0.;
      for (std::size_t p = 0; p < points.n_points(); ++p)
        {
          if (number >= 0 && points.scalars[number].values[p] > before[p])
            has_yielded[p] = true;
          volume += has_yielded[p] ? points.volume[p] : 0.;
        }
      return volume;
    }
  } // namespace


  template <int dim>
  double
  out_of_balance(const Fixities<dim> &fixities, const NodalState &nodes)
  {
    const double *const external = nodes.external_force.begin();
    const double *const internal = nodes.internal_force.begin();
    double              rest = 0., loads = 0.;
    for (std::size_t dof = 0; dof < fixities.removed().size(); ++dof)
      if (!fixities.removed()[dof] && nodes.mass[dof / dim] > 0.)
        {
          rest += std::pow(external[dof] - internal[dof], 2);
          loads += std::pow(external[dof], 2);
        }
    return loads > 0. ? std::sqrt(rest / loads) : 0.;
  }


  template <int dim>
  BalanceReport
  balance_step(const Materials         &materials,
               const Weights<dim>      &weights,
               const Fixities<dim>     &fixities,
               const double             full_node_mass,
               const unsigned int       n_steps,
               const MappingParameters &mapping,
               NodalState              &nodes,
               MaterialPoints<dim>     &points,
               const Resistances<dim>  &resistances,
               const BalanceWatcher    &watcher)
  {
    TimeParameters time;
    time.move_points = false;
    NewtonParameters newton;
    newton.tolerance                 = tolerance;
    newton.maximum_iterations        = 40;
    newton.linear_tolerance          = 1e-4; // in 3D
    newton.maximum_linear_iterations = 2000;
    MappingParameters small          = mapping;
    small.objective_rate             = false;
    const std::unique_ptr<TimeScheme<dim>> scheme =
      make_quasi_static(SchemeInput<dim>{weights.background_grid(),
                                         weights,
                                         materials,
                                         fixities,
                                         time,
                                         newton,
                                         small,
                                         /*gravity=*/0., // of works only
                                         full_node_mass,
                                         resistances});

    const NodalVector             full   = nodes.external_force;
    const NodalVector             start  = nodes.internal_force;
    const std::vector<NamedArray> kept   = points.scalars;
    const int                     strain = points.find_scalar("plastic strain");
    const double                  volume =
      std::accumulate(points.volume.begin(), points.volume.end(), 0.);
    std::vector<bool> has_yielded(points.n_points(), false);

    BalanceReport report;
    double        step = 1. / n_steps;
    while (report.share < 1.)
      {
        double share = report.share + step;
        if (share > 1. - 1e-9)
          share = 1.;
        nodes.external_force = start;
        nodes.external_force *= 1. - share;
        nodes.external_force.add(share, full);
        StepReport<dim> solved = scheme->solve(points, 0., 0., nodes);
        report.iterations += solved.newton_iterations;
        report.strong_failures += solved.strong_failures;
        report.residual = solved.residuals.back();
        if (watcher)
          watcher(report);
        if (!solved.converged)
          {
            step *= 0.5;
            if (step < shortest / n_steps)
              break;
            continue;
          }
        scheme->to_points(0., 0., nodes, points, solved);
        if (strain >= 0 && volume > 0.)
          report.yielding =
            yielded_volume(points, kept[strain].values, has_yielded) / volume;
        points.scalars = kept;
        consolidate(materials, points);
        report.share = share;
        ++report.steps;
      }
    report.converged     = report.share >= 1.;
    nodes.external_force = full;
    return report;
  }


  template double
  out_of_balance(const Fixities<2> &, const NodalState &);
  template double
  out_of_balance(const Fixities<3> &, const NodalState &);
  template BalanceReport
  balance_step(const Materials &,
               const Weights<2> &,
               const Fixities<2> &,
               const double,
               const unsigned int,
               const MappingParameters &,
               NodalState &,
               MaterialPoints<2> &,
               const Resistances<2> &,
               const BalanceWatcher &);
  template BalanceReport
  balance_step(const Materials &,
               const Weights<3> &,
               const Fixities<3> &,
               const double,
               const unsigned int,
               const MappingParameters &,
               NodalState &,
               MaterialPoints<3> &,
               const Resistances<3> &,
               const BalanceWatcher &);
} // namespace Waker
