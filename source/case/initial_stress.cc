// SPDX-License-Identifier: LGPL-2.1-or-later
// The stress of a case at t = 0.
#include <waker/base/errors.h>
#include <waker/base/host.h>
#include <waker/case/initial_stress.h>
#include <waker/case/k0_stress.h>
#include <waker/case/rank_part.h>
#include <waker/case/scene.h>
#include <waker/loads/water_level.h>
#include <waker/mapping/stencil.h>
#include <waker/mechanics/deformation.h>
#include <waker/mechanics/energy.h>
#include <waker/mechanics/time_scheme.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <typeinfo>

namespace Waker
{
  namespace
  {
    /// @throws NumericalFailure
    void
    require_balance(const GravityReport &report,
                    const double         tolerance,
                    const bool           has_friction)
    {
      if (report.converged)
        return;
      std::ostringstream message;
      message << "the gravity step stops at a residual of "
              << (report.residuals.empty() ? 0. : report.residuals.back())
              << ", above Gravity/Tolerance " << tolerance
              << ": is the body held"
              << (has_friction ? ", or does it slide on a frictional wall" : "")
              << ", and no Poisson's ratio above 0.49?";
      throw NumericalFailure(message.str());
    }


    /// @throws NumericalFailure
    void
    require_balance(const BalanceReport &report)
    {
      if (report.converged)
        return;
      std::ostringstream message;
      message.precision(3);
      message << "the soil does not come into balance with its laws: of what "
                 "the stress at first leaves over, "
              << 100. * report.share << " % is carried after " << report.steps
              << " load steps (residual " << report.residual
              << "): does it slide already? Initial stress/Laws = elastic "
                 "starts without, more Steps are smaller ones";
      throw NumericalFailure(message.str());
    }


    /// By the water outside, if there is a daily stage to compare it with.
    std::string
    name_of_last_stage(const Parameters &p)
    {
      const auto daily = p.initial_stress.level();
      if (p.initial_stress.daily_stage && p.water.stands())
        {
          const double level = WaterLevel(p.water).at(0.);
          if (!daily || level > *daily)
            return "high water";
          if (level < *daily)
            return "low water";
        }
      return "the start";
    }


    /// How the points' vertical stress differs from that of columns.
    template <int dim>
    void
    compare_with_columns(const PoreWater<dim>      &pore_water,
                         const Materials           &materials,
                         const MaterialPoints<dim> &points,
                         StageReport               &report)
    {
      const int number = points.find_scalar("initial vertical stress");
      if (number < 0)
        return;
      const int of_loads = points.find_scalar("pore pressure of loads");
      const std::vector<double> &columns = points.scalars[number].values;
      double                     square = 0., sum = 0., volume = 0.;
      for (std::size_t p = 0; p < points.n_points(); ++p)
        {
          double vertical = -points.stress[p][1][1];
          if (!pore_water.empty() &&
              !materials[points.material[p]]->is_of_effective_stress())
            vertical -=
              pore_water.pressure(points.initial_position[p]) +
              (of_loads < 0 ? 0. : points.scalars[of_loads].values[p]);
          square += points.volume[p] * std::pow(vertical - columns[p], 2);
          sum += points.volume[p] * columns[p];
          volume += points.volume[p];
        }
      if (volume > 0.)
        {
          report.difference_rms       = std::sqrt(square / volume);
          report.mean_vertical_stress = sum / volume;
        }
    }


    /// On several ranks each does its part of the step, and all get the stress
    /// of all points. Walls, and soils whose stiffnesses mix in cells, are
    /// looked at as a whole: then each rank makes the whole step.
    template <int dim>
    GravityReport
    shared_gravity_step(const Case<dim>     &the_case,
                        Scene<dim>          &scene,
                        MaterialPoints<dim> &points)
    {
      const auto step = [&](const Weights<dim>     &weights,
                            const Fixities<dim>    &fixities,
                            NodalState             &nodes,
                            MaterialPoints<dim>    &points,
                            const Resistances<dim> &resistances) {
        return gravity_step(the_case.materials,
                            weights,
                            fixities,
                            the_case.full_node_mass,
                            the_case.parameters.gravity.tolerance,
                            the_case.parameters.mapping,
                            nodes,
                            points,
                            resistances);
      };
      if (!has_several_ranks(the_case) || !scene.resistances().empty() ||
          may_mix(the_case.materials))
        return step(scene.weights,
                    the_case.fixities,
                    scene.nodes,
                    points,
                    scene.resistances());
      RankPart<dim> part(the_case, points);
      part.map();
      part.take_external_force(scene.nodes.external_force);
      const GravityReport report =
        step(*part.weights, *part.fixities, *part.nodes, part.points(), {});
      part.complete(scene.nodes);
      return report;
    }
  } // namespace


  template <int dim>
  void
  Case<dim>::set_stress(Scene<dim> &scene, const BalanceWatcher &watcher)
  {
    const InitialStressParameters &in     = parameters.initial_stress;
    MaterialPoints<dim>           &points = initial_points;
    if (in.daily_stage)
      carry_daily_stress(watcher);
    else if (in.from == StressFrom::k0)
      set_k0_stress(parameters.materials,
                    materials,
                    ground,
                    pore_water,
                    layers_of_points,
                    points);

    StageReport report;
    report.name = name_of_last_stage(parameters);
    if (!in.is_gravity_step())
      {
        scene.set_internal_force(points);
        report.imbalance = out_of_balance(fixities, scene.nodes);
      }
    switch (in.laws)
      {
        case BalanceLaws::elastic:
          gravity_report = shared_gravity_step(*this, scene, points);
          require_balance(gravity_report,
                          parameters.gravity.tolerance,
                          scene.walls.have_friction());
          report.gravity = gravity_report;
          break;
        case BalanceLaws::plastic:
          report.balance = balance_step(materials,
                                        scene.weights,
                                        fixities,
                                        full_node_mass,
                                        in.steps,
                                        parameters.mapping,
                                        scene.nodes,
                                        points,
                                        scene.resistances(),
                                        watcher);
          require_balance(*report.balance);
          break;
      }
    compare_with_columns(pore_water, materials, points, report);
    stages.push_back(report);
  }


  template <int dim>
  void
  Case<dim>::carry_daily_stress(const BalanceWatcher &watcher)
  {
    std::unique_ptr<const Case<dim>> daily;
    try
      {
        daily = std::make_unique<const Case<dim>>(daily_stage(parameters),
                                                  grid.communicator(),
                                                  Materials(),
                                                  watcher);
      }
    catch (const UserError &error)
      {
        throw in_daily_stage(error);
      }
    catch (const NumericalFailure &failure)
      {
        throw NumericalFailure(std::string("in the daily stage, ") +
                               failure.what());
      }
    for (unsigned int m = 0; m < materials.size(); ++m)
      if (m >= daily->materials.size() ||
          typeid(*daily->materials[m]) != typeid(*materials[m]))
        throw UserError("Initial stress/Daily stage",
                        "is true, but the program has materials of its own",
                        "false");
    const MaterialPoints<dim> &before = daily->initial_points;
    AssertThrow(before.n_points() == initial_points.n_points(),
                ExcInternalError());
    for (std::size_t p = 0; p < before.n_points(); ++p)
      {
        const Point<dim> &x = initial_points.initial_position[p];
        AssertThrow(before.initial_position[p] == x, ExcInternalError());
        // Drained soil keeps the stress of its grains, all other soil the whole
        // of it.
        const bool was_effective =
          daily->materials[before.material[p]]->is_of_effective_stress();
        const bool is_effective =
          materials[initial_points.material[p]]->is_of_effective_stress();
        const double pressure =
          was_effective == is_effective || daily->pore_water.empty()
            ? 0.
            : daily->pore_water.pressure(x);
        initial_points.stress[p] =
          before.stress[p] + (is_effective ? pressure : -pressure) *
                               dealii::unit_symmetric_tensor<3>();
      }
    consolidate(materials, initial_points); // by the stress of that stage
    stages             = daily->stages;
    stages.back().name = "daily stage";
  }


  template <int dim>
  void
  set_initial_acceleration(const Case<dim>     &the_case,
                           Scene<dim>          &scene,
                           MaterialPoints<dim> &points)
  {
    const double ramp =
      residual_ramp(0., the_case.parameters.time.ramp_duration);
    const Stencil<dim> stencil(the_case.grid);
    NodalVector       &a = scene.nodes.acceleration;
    a                    = scene.nodes.external_force;
    a -= scene.nodes.internal_force;
    for (unsigned int dof = 0; dof < the_case.grid.n_dofs(); ++dof)
      {
        const double mass = scene.nodes.mass[dof / dim];
        a.begin()[dof] *=
          (mass > 0. && !the_case.fixities.removed()[dof]) ? ramp / mass : 0.;
      }
    for (std::size_t q = 0; q < points.n_points(); ++q)
      points.acceleration[q] = stencil.value(scene.weights[q], a.begin());
  }


  template <int dim>
  void
  renew_initial_stress(const Case<dim> &the_case, State<dim> &state)
  {
    const GravityParameters &gravity = the_case.parameters.gravity;
    AssertThrow(the_case.parameters.initial_stress.is_gravity_step(),
                ExcInternalError());
    MaterialPoints<dim> &points = state.points;
    if (gravity.initial_stress)
      std::fill(points.stress.begin(),
                points.stress.end(),
                SymmetricTensor<2, 3>());
    std::fill(state.wall_tractions.begin(),
              state.wall_tractions.end(),
              Tensor<1, dim>());
    prepare_domains(the_case.parameters.mapping.domains, points);
    Scene<dim> scene(the_case);
    scene.set(points);
    scene.walls.reinit(points, scene.nodes.mass, 0., state.wall_tractions);
    if (gravity.initial_stress)
      {
        const NodalVector full = scene.nodes.external_force;
        scene.nodes.external_force *= gravity.initial_share;
        require_balance(shared_gravity_step(the_case, scene, points),
                        gravity.tolerance,
                        scene.walls.have_friction());
        scene.nodes.external_force = full; // the rest acts from now on
        give_back_memory();                // what the solver took
      }
    else
      scene.set_internal_force(points);
    consolidate(the_case.materials, points);
    set_initial_acceleration(the_case, scene, points);
    state.energy.elastic_start = elastic_energy(points, the_case.materials);
    state.energy.elastic       = state.energy.elastic_start;
  }


  template void
  Case<2>::set_stress(Scene<2> &, const BalanceWatcher &);
  template void
  Case<3>::set_stress(Scene<3> &, const BalanceWatcher &);
  template void
  Case<2>::carry_daily_stress(const BalanceWatcher &);
  template void
  Case<3>::carry_daily_stress(const BalanceWatcher &);
  template void
  set_initial_acceleration(const Case<2> &, Scene<2> &, MaterialPoints<2> &);
  template void
  set_initial_acceleration(const Case<3> &, Scene<3> &, MaterialPoints<3> &);
  template void
  renew_initial_stress(const Case<2> &, State<2> &);
  template void
  renew_initial_stress(const Case<3> &, State<3> &);
} // namespace Waker
