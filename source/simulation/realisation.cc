// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/measures/dyke_geometry.h>
#include <waker/measures/soil_at_sides.h>
#include <waker/measures/watched.h>
#include <waker/simulation/realisation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

namespace Waker
{
  namespace
  {
    /// Between two looks at how the points are dealt out to the ranks.
    constexpr unsigned int steps_between_balances = 20;


    /// The last change of what load programmes drive, also of the water in the
    /// ground that follows (s).
    template <int dim>
    double
    programmes_change_until(const Case<dim> &the_case, const State<dim> &state)
    {
      return the_case.programmes.last_change(state.loads) +
             the_case.pore_water.time_to_settle();
    }
  } // namespace


  template <int dim>
  Realisation<dim>::Realisation(const Case<dim> &the_case, State<dim> &state)
    : the_case(&the_case)
    , state(&state)
    , part(make_rank_part(the_case, state.points))
    , scene(the_case, part.get())
    , carried(the_case)
    , control(the_case.parameters.time, state)
  {
    make_schemes();
    report.kinetic_energy = state.energy.kinetic;
    report.elastic_energy = state.energy.elastic;
  }


  template <int dim>
  void
  Realisation<dim>::make_schemes()
  {
    const SchemeInput<dim> input{part ? *part->grid : the_case->grid,
                                 part ? *part->weights : scene.weights,
                                 the_case->materials,
                                 part ? *part->fixities : the_case->fixities,
                                 the_case->parameters.time,
                                 the_case->parameters.newton,
                                 the_case->parameters.mapping,
                                 the_case->parameters.gravity.acceleration,
                                 the_case->full_node_mass,
                                 scene.resistances()};
    scheme_in_motion = make_time_scheme(input);
    scheme_at_rest   = make_scheme_at_rest(input);
  }


  template <int dim>
  StopReason
  Realisation<dim>::look()
  {
    if (part && state->step % steps_between_balances == 0 && part->balance())
      {
        scene.follow_part();
        make_schemes();
      }
    scene.map(state->points);      // to the nodes: 2.31, 2.32
    scene.find_surfaces(*state);   // 3.8-3.14, as far as they are asked for
    scene.set_loads(*state);       // weight, water, tractions: 2.27, 3.4
    scene.meet_walls(*state);      // what touches them
    scene.set_first_force(*state); // of the stress in situ: 2.28
    measure();                     // H, W, bodies that have moved: 5.2, 6.2
    the_case->programmes.watch(body(), *state); // what waits, or stops: 6.2.1
    return decide(the_case->parameters.stop,
                  state->failure,
                  state->time,
                  the_case->parameters.time.end_time,
                  the_case->parameters.time.ramp_duration,
                  last_load_change(),
                  state->mean_plastic_strain,
                  state->displacement_rate,
                  state->rest);
  }


  template <int dim>
  StepReport<dim>
  Realisation<dim>::solve(const double t, const double dt, NodalState &nodes)
  {
    try
      {
        return scheme().solve(own_points(), t, dt, nodes);
      }
    catch (const NumericalFailure &)
      {
        // On all of several ranks (NodeExchange::together()). Soil without
        // stiffness (that water lifts, say) is in no balance: it moves.
        if (!control.is_long())
          throw;
        StepReport<dim> none;
        none.residuals = {std::numeric_limits<double>::infinity()};
        return none;
      }
  }


  template <int dim>
  void
  Realisation<dim>::advance()
  {
    const double          t      = state->time;
    NodalState           &nodes  = scene.step_nodes();
    MaterialPoints<dim>  &points = own_points();
    const StopParameters &stop   = the_case->parameters.stop;
    if (is_at_rest(stop, state->rest, t))
      control.try_long_steps(stop.rest_duration);
    scene.begin_step();
    settlements.begin(points);
    const double dt =
      control.solve([&]() { return wanted_step(); },
                    [&](const double tried) {
                      scene.set_end_loads(*state,
                                          t + tried); // weight, water, loads
                      // 2.23 with 2.28, or 2.34
                      return report = solve(t, tried, nodes);
                    });
    // Stress and motion: 2.33, 2.38-2.40, or 2.35-2.37
    scheme().to_points(t, dt, nodes, points, report);
    report.held_domains    = move_carried(); // domains, surfaces
    state->settlement_rate = settlements.largest(points) / dt;
    if (part)
      end_step_on_ranks();
    report.check_finite(t + dt);
    state->energy += report;
    control.accept(dt, report); // time goes on
    the_case->pore_water.follow(scene.water_level(state->time),
                                dt,
                                state->pore_water);
    the_case->flow.exchange(nodes, report, dt, *state, part.get());
    the_case->programmes.proceed(part ? part->grid->exchange()
                                      : the_case->grid.exchange(),
                                 own_points(),
                                 *state); // loads go on: 6.2.1
  }


  template <int dim>
  Body<dim>
  Realisation<dim>::body()
  {
    return part ? part->body() : Body<dim>(state->points);
  }


  template <int dim>
  std::size_t
  Realisation<dim>::move_carried()
  {
    if (!part)
      return carried.move(the_case->grid,
                          scene.nodes.mass,
                          scene.nodes.increment,
                          state->points,
                          *state);
    NodalVector increment;
    if (!state->surface_vertices.empty())
      part->spread_increment(increment);
    return carried.move(
      *part->load_grid, part->load_mass, increment, part->points(), *state);
  }


  template <int dim>
  void
  Realisation<dim>::end_step_on_ranks()
  {
    const NodeExchange &ranks = part->grid->exchange();
    state->settlement_rate    = ranks.largest(state->settlement_rate);
    report.held_domains       = static_cast<std::size_t>(
      ranks.sum(static_cast<double>(report.held_domains)));
    part->moved();
  }


  template <int dim>
  void
  Realisation<dim>::complete(const Wanted &wanted)
  {
    if (!part || !(wanted.places || wanted.nodes || wanted.all))
      return;
    if (wanted.all)
      part->complete(scene.nodes);
    else
      {
        part->know_places();
        if (wanted.nodes)
          part->complete_nodes(scene.nodes);
      }
    scene.complete(state->points, wanted.nodes || wanted.all);
  }


  template <int dim>
  Wanted
  Realisation<dim>::wanted_by_any(const Wanted &mine) const
  {
    if (!part)
      return mine;
    double any[5] = {double(mine.files),
                     double(mine.places),
                     double(mine.nodes),
                     double(mine.all),
                     double(mine.checkpoint)};
    part->grid->exchange().largest(any, 5);
    return {any[0] > 0., any[1] > 0., any[2] > 0., any[3] > 0., any[4] > 0.};
  }


  template <int dim>
  bool
  Realisation<dim>::any(const bool one_does) const
  {
    return part ? part->grid->exchange().largest(one_does ? 1. : 0.) > 0.
                : one_does;
  }


  namespace
  {
    template <int dim>
    bool
    is_finite(const MaterialPoints<dim> &points)
    {
      const auto finite = [](const auto &values) {
        return std::all_of(values.begin(), values.end(), [](const auto &value) {
          return std::isfinite(value.norm());
        });
      };
      return std::all_of(points.position.begin(),
                         points.position.end(),
                         [](const Point<dim> &x) {
                           return std::isfinite(x.square());
                         }) &&
             finite(points.velocity) && finite(points.stress);
    }
  } // namespace


  template <int dim>
  bool
  Realisation<dim>::has_numbers() const
  {
    return !any(!is_finite(own_points()));
  }


  template <int dim>
  void
  Realisation<dim>::measure()
  {
    // The width is measured at one level all the time: a rise of the water is
    // no failure.
    const Parameters &parameters = the_case->parameters;
    state->failure.update(scene.measure_dyke(the_case->measuring_level),
                          state->time,
                          scene.water_level(state->time),
                          parameters.water.stands(),
                          parameters.initial_failure.limits);
    const Body<dim>            body     = this->body();
    const std::vector<double> &mass     = body.own().mass;
    const Tensor<1, dim>       momentum = Waker::momentum(body.own());
    SoilAtSides<dim>           at_sides =
      soil_at_sides(the_case->grid, body.own(), the_case->flow.openings());
    std::array<double, 3 + dim> sums;
    sums[0] = std::accumulate(mass.begin(), mass.end(), 0.);
    for (unsigned int d = 0; d < dim; ++d)
      sums[1 + d] = momentum[d];
    std::copy_n(at_sides.volume.begin(), 2, &sums[1 + dim]);
    body.sum(sums.data(), sums.size());
    totals.mass = sums[0];
    for (unsigned int d = 0; d < dim; ++d)
      totals.momentum[d] = sums[1 + d];
    std::copy_n(&sums[1 + dim], 2, at_sides.volume.begin());
    lies_at_box = lies_against_side(the_case->grid, at_sides);
    state->failure.watch_slopes(body,
                                the_case->grid,
                                parameters.water.inner_direction(),
                                state->time,
                                parameters.initial_failure.limits);
    if (!the_case->programmes.list().empty())
      {
        totals.settlement = largest_settlement(body);
        totals.lost_loads = the_case->programmes.shares_lost(body);
      }
    const bool slid =
      the_case->slides && the_case->slides->update(state->time,
                                                   body,
                                                   state->points,
                                                   state->sliding);
    if (slid && part)
      part->point_exchange().take(SlidingMassFinder<dim>::changed_scalar(),
                                  state->points);
  }


  template <int dim>
  Unrest
  Realisation<dim>::unrest() const
  {
    const Parameters &parameters = the_case->parameters;
    // Load steps are in balance, each as it is: they need no time to rest.
    const bool is_static =
      !scheme_traits(parameters.time).has_inertia || state->long_steps.last;
    const double time = state->time;
    const double since =
      is_static ? time : std::max(0., time - parameters.stop.rest_duration);

    Unrest unrest;
    unrest.moving =
      !is_static && !is_at_rest(parameters.stop, state->rest, time);
    // The water in the ground still follows what the water outside did then.
    const double seen =
      std::max(0., since - the_case->pore_water.time_to_settle());
    // Of an expression only what it has done is known, of the others also what
    // they will do. Round-off in the sum of the steps changes no load.
    unrest.loads_change =
      the_case->last_load_change == LastChange::unknown
        ? scene.last_load_change(LastChange::never) > since * (1. + 1e-9) ||
            !scene.varying_load(seen, time).empty()
        : the_case->last_load_change > since * (1. + 1e-9);
    unrest.loads_change =
      unrest.loads_change ||
      programmes_change_until(*the_case, *state) > since * (1. + 1e-9);
    unrest.at_box = lies_at_box;
    return unrest;
  }


  template <int dim>
  double
  Realisation<dim>::last_load_change() const
  {
    return std::max(the_case->last_load_change,
                    programmes_change_until(*the_case, *state));
  }


  template <int dim>
  double
  Realisation<dim>::wanted_step() const
  {
    const double          step = scheme().time_step(own_points());
    const TimeParameters &time = the_case->parameters.time;
    return control.is_long()
             ? scene.water.level().longest_step(state->time,
                                                step,
                                                time.largest_rise,
                                                time.time_step)
             : step;
  }


  template <int dim>
  StepView<dim>
  Realisation<dim>::view() const
  {
    return {*the_case, *state, scene, report, totals};
  }


  template class Realisation<2>;
  template class Realisation<3>;
} // namespace Waker
