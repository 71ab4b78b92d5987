// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/mechanics/deformation.h>
#include <waker/observers/dyke_geometry.h>
#include <waker/observers/soil_at_sides.h>
#include <waker/simulation/realisation.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace Waker
{
  namespace
  {
    /// After this many steps at a halved time step it is doubled again.
    constexpr unsigned int steps_before_doubling = 4;


    /// What a step gives has to be numbers: a comparison with anything else is
    /// false, and would pass for rest.
    /// @throws NumericalFailure with the name of what is not
    template <int dim>
    void
    check_finite(const StepReport<dim> &report, const double time)
    {
      const std::pair<const char *, double> values[] = {
        {"displacement rate", report.displacement_rate},
        {"plastic strain", report.mean_plastic_strain},
        {"kinetic energy", report.kinetic_energy},
        {"elastic energy", report.elastic_energy},
        {"dissipation", report.dissipation},
        {"work of the weight", report.gravity_work},
        {"work of the loads", report.water_work},
        {"work of the supports", report.support_work},
        {"work of the ramp", report.ramp_work},
        {"mapping loss", report.mapping_loss}};
      for (const auto &[name, value] : values)
        if (!std::isfinite(value))
          {
            std::ostringstream message;
            message << "the " << name
                    << " of the step that ends at t = " << time
                    << " s is not finite";
            throw NumericalFailure(message.str());
          }
    }
  } // namespace


  template <int dim>
  Realisation<dim>::Realisation(const Case<dim> &the_case, State<dim> &state)
    : the_case(&the_case)
    , state(&state)
    , scene(the_case)
    , scheme(make_time_scheme(
        SchemeInput<dim>{the_case.grid,
                         scene.weights,
                         the_case.materials,
                         the_case.fixities,
                         the_case.parameters.time,
                         the_case.parameters.newton,
                         the_case.parameters.mapping,
                         the_case.parameters.gravity.acceleration,
                         the_case.full_node_mass,
                         scene.walls.empty() ? nullptr : &scene.walls}))
  {
    report.kinetic_energy = state.energy.kinetic;
    report.elastic_energy = state.energy.elastic;
  }


  template <int dim>
  StopReason
  Realisation<dim>::look()
  {
    const Parameters &parameters = the_case->parameters;
    try
      {
        scene.set(state->points, state->time, state->surface_vertices);
      }
    catch (const UserError &error)
      {
        // What the input allowed at the start is no mistake of it later.
        if (state->step == 0)
          throw;
        throw NumericalFailure(error.what());
      }
    scene.tractions.record(state->time, state->tractions);
    scene.walls.reinit(scene.nodes.mass, state->time, state->wall_tractions);
    if (state->step == 0)
      {
        scene.set_internal_force(state->points);
        scene.walls.add_start_force(scene.nodes.internal_force);
      }

    // The width is measured at one level all the time: a rise of the water is
    // no failure.
    state->failure.update(measure_dyke(scene.surfaces.chains(),
                                       the_case->measuring_level),
                          state->time,
                          scene.water_level(state->time),
                          parameters.water.side != "none",
                          parameters.initial_failure.limits);
    state->failure.watch_slopes(state->points,
                                the_case->grid,
                                parameters.water.inner_direction(),
                                state->time,
                                parameters.initial_failure.limits);
    return decide(parameters.stop,
                  state->failure,
                  state->time,
                  parameters.time.end_time,
                  parameters.time.ramp_duration,
                  the_case->last_load_change,
                  state->mean_plastic_strain,
                  state->displacement_rate,
                  state->rest);
  }


  template <int dim>
  Unrest
  Realisation<dim>::unrest() const
  {
    const Parameters &parameters = the_case->parameters;
    // Load steps are in balance, each as it is: they need no time to rest.
    const bool   is_static = parameters.time.scheme == "quasi-static";
    const double time      = state->time;
    const double since =
      is_static ? time : std::max(0., time - parameters.stop.rest_duration);

    Unrest unrest;
    unrest.moving =
      !is_static && !is_at_rest(parameters.stop, state->rest, time);
    // Of an expression only what it has done is known, of the others also what
    // they will do. Round-off in the sum of the steps changes no load.
    unrest.loads_change =
      the_case->last_load_change == LastChange::unknown
        ? scene.last_load_change(LastChange::never) > since * (1. + 1e-9) ||
            !scene.varying_load(since, time).empty()
        : the_case->last_load_change > since * (1. + 1e-9);
    unrest.at_box = soil_lies_against_side(the_case->grid,
                                           state->points,
                                           the_case->flow.open_faces());
    return unrest;
  }


  template <int dim>
  double
  Realisation<dim>::next_time_step() const
  {
    const double dt = std::ldexp(scheme->time_step(state->points),
                                 -static_cast<int>(state->halvings));
    return std::min(dt, the_case->parameters.time.end_time - state->time);
  }


  template <int dim>
  void
  Realisation<dim>::advance()
  {
    const TimeParameters &time       = the_case->parameters.time;
    const bool            loads_move = scene.loads_move();
    double                dt;
    if (loads_move)
      scene.nodes.start_force = scene.nodes.external_force;
    while (true)
      {
        dt = next_time_step();
        // The loads at the end of the step, on the surfaces at its start.
        if (loads_move)
          scene.set_loads(state->points, state->time + dt);
        scene.walls.set_step(state->time, dt);
        report = scheme->solve(
          state->points, scene.weights, state->time, dt, scene.nodes);
        state->newton_iterations += report.newton_iterations;
        state->linear_iterations += report.linear_iterations;
        if (report.converged)
          break;

        ++state->unconverged_steps;
        state->steps_since_change = 0;
        if (state->halvings == time.maximum_halvings)
          {
            std::ostringstream message;
            message << "the step from t = " << state->time
                    << " s does not converge, not even with dt = " << dt
                    << " s (residual " << report.residuals.back() << ")";
            throw NumericalFailure(message.str());
          }
        ++state->halvings;
      }

    scheme->update_points(
      scene.weights, state->time, dt, scene.nodes, state->points, report);
    if (!scene.walls.empty())
      {
        const auto work = scene.walls.work(scene.nodes.increment);
        report.support_work += 0.5 * (work.start + work.end);
        report.reaction +=
          scene.walls.accept(scene.nodes.increment, state->wall_tractions);
      }
    if (the_case->parameters.mapping.domains == "stretched")
      report.held_domains =
        stretch_domains(the_case->grid.cell_size(), state->points);

    if (time.scheme != "quasi-static" || time.move_points)
      for (std::vector<Point<dim>> &vertices : state->surface_vertices)
        carry_vertices(the_case->grid, scene.nodes, vertices);

    check_finite(report, state->time + dt);
    state->time += dt;
    ++state->step;
    state->last_dt             = dt;
    state->mean_plastic_strain = report.mean_plastic_strain;
    state->displacement_rate   = report.displacement_rate;
    if (state->halvings > 0 &&
        ++state->steps_since_change >= steps_before_doubling)
      {
        --state->halvings;
        state->steps_since_change = 0;
      }

    EnergyAccount &energy = state->energy;
    energy.kinetic        = report.kinetic_energy;
    energy.elastic        = report.elastic_energy;
    energy.dissipation += report.dissipation;
    energy.ramp_work += report.ramp_work;
    energy.mapping_loss += report.mapping_loss;
    energy.gravity_work += report.gravity_work;
    energy.water_work += report.water_work;
    energy.support_work += report.support_work;

    the_case->flow.exchange(scene.nodes, report, dt, *state);
  }


  template <int dim>
  StepView<dim>
  Realisation<dim>::view()
  {
    const Facets<dim> *const facets =
      scene.surfaces.is_spatial() ? &scene.surfaces.facets() : nullptr;
    return {state->step,
            state->time,
            state->last_dt,
            the_case->grid,
            state->points,
            scene.nodes,
            scene.surfaces.proximity_field(),
            scene.surfaces.last_chains(),
            scene.water.wetted_segments(),
            scene.water_resultant,
            state->failure,
            report,
            state->energy,
            state->unconverged_steps,
            the_case->flow.is_used() ? &state->flow : nullptr,
            scene.tractions,
            scene.walls,
            state->wall_tractions,
            scene.water_level(state->time),
            facets,
            scene.water.wetted_facets()};
  }


  template class Realisation<2>;
  template class Realisation<3>;
} // namespace Waker
