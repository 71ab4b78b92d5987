// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/case/rank_part.h>
#include <waker/case/scene.h>
#include <waker/loads/point_force.h>
#include <waker/mapping/transfer.h>
#include <waker/mechanics/point_motion.h>
#include <waker/mechanics/time_scheme.h>
#include <waker/nodes/wall_spots.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    template <int dim>
    SurfaceFinder<dim>
    surfaces_of(const Case<dim> &the_case, const ShapeFunctions functions)
    {
      const WallFaces<dim> walls =
        faces_along_walls(the_case.grid, the_case.parameters.walls);
      return {the_case.grid,
              the_case.parameters.surface,
              functions,
              the_case.fixities.closed_faces() | walls.closed,
              walls.setback};
    }
  } // namespace


  namespace
  {
    // On the nodes that this rank deals with.

    template <int dim>
    WaterLoad<dim>
    water_of(const Case<dim> &the_case, const RankPart<dim> *const part)
    {
      return {part != nullptr ? *part->load_grid : the_case.grid,
              the_case.parameters.water,
              the_case.parameters.surface};
    }


    template <int dim>
    Tractions<dim>
    tractions_of(const Case<dim> &the_case, const RankPart<dim> *const part)
    {
      return {the_case.grid,
              part != nullptr ? *part->load_grid : the_case.grid,
              the_case.parameters.tractions,
              the_case.user_surfaces,
              the_case.riding_loads};
    }


    template <int dim>
    Walls<dim>
    walls_of(const Case<dim> &the_case, const RankPart<dim> *const part)
    {
      return {part != nullptr ? *part->grid : the_case.grid,
              the_case.parameters.walls,
              stiffest_modulus(the_case.materials),
              the_case.full_node_mass};
    }
  } // namespace


  template <int dim>
  Scene<dim>::Scene(const Case<dim> &the_case, RankPart<dim> *const part)
    : weights(the_case.grid, the_case.parameters.mapping.functions)
    , nodes(the_case.grid)
    , surfaces(surfaces_of(the_case, weights.functions()))
    , water(water_of(the_case, part))
    , tractions(tractions_of(the_case, part))
    , walls(walls_of(the_case, part))
    , the_case(&the_case)
    , part(part)
    , driven(the_case.programmes, the_case.parameters)
  {}


  template <int dim>
  void
  Scene<dim>::follow_part()
  {
    water     = water_of(*the_case, part);
    tractions = tractions_of(*the_case, part);
    walls     = walls_of(*the_case, part);
  }


  template <int dim>
  void
  Scene<dim>::set(const MaterialPoints<dim>  &points,
                  const double                time,
                  const SurfaceVertices<dim> &vertices)
  {
    map(points);
    surfaces.reset(points);
    tractions.find(points, vertices, surfaces);
    add_up_loads(points, time, the_case->programmes.start());
  }


  template <int dim>
  void
  Scene<dim>::set(const MaterialPoints<dim> &points)
  {
    set(points, 0., initial_vertices(*the_case));
  }


  template <int dim>
  void
  Scene<dim>::map(const MaterialPoints<dim> &points)
  {
    if (part != nullptr)
      {
        part->map();
        return;
      }
    weights.reinit(points);
    to_nodes(points, weights, nodes);
  }


  template <int dim>
  NodalState &
  Scene<dim>::step_nodes()
  {
    return part != nullptr ? *part->nodes : nodes;
  }


  namespace
  {
    /// Do it. What the input allowed at the start is no mistake of it later.
    template <typename Action>
    void
    do_at_step(const std::uint64_t step, const Action &action)
    {
      try
        {
          action();
        }
      catch (const UserError &error)
        {
          if (step == 0)
            throw;
          throw NumericalFailure(error.what());
        }
    }
  } // namespace


  template <int dim>
  void
  Scene<dim>::find_surfaces(const State<dim> &state)
  {
    if (part != nullptr)
      surfaces.reset(part->body());
    else
      surfaces.reset(state.points);
    do_at_step(state.step, [&]() {
      tractions.find(part != nullptr ? part->points() : state.points,
                     state.surface_vertices,
                     surfaces);
    });
  }


  template <int dim>
  void
  Scene<dim>::set_loads(State<dim> &state)
  {
    the_case->pore_water.record(part != nullptr ? part->points() : state.points,
                                state.pore_water);
    do_at_step(state.step,
               [&]() { add_up_loads(state.points, state.time, state.loads); });
    tractions.record(state.time, state.tractions);
  }


  template <int dim>
  void
  Scene<dim>::meet_walls(State<dim> &state)
  {
    walls.reinit(part != nullptr ? part->points() : state.points,
                 step_nodes().mass,
                 state.time,
                 state.wall_tractions);
  }


  template <int dim>
  void
  Scene<dim>::set_first_force(const State<dim> &state)
  {
    if (state.step == 0)
      set_internal_force(state.points);
  }


  template <int dim>
  void
  Scene<dim>::begin_step()
  {
    if (loads_move())
      step_nodes().start_force = step_nodes().external_force;
  }


  template <int dim>
  void
  Scene<dim>::set_end_loads(const State<dim> &state, const double time)
  {
    if (loads_move())
      do_at_step(state.step,
                 [&]() { add_up_loads(state.points, time, state.loads); });
  }


  template <int dim>
  DykeGeometry
  Scene<dim>::measure_dyke(const double level)
  {
    if constexpr (dim == 3)
      if (!the_case->sections.empty())
        {
          DykeGeometry dyke =
            Waker::measure_dyke(surfaces.facets(), the_case->sections, level);
          // Between two sections, or on a way across them.
          if (const auto spill = water.spill();
              spill && spill->height < dyke.height)
            {
              dyke.height   = spill->height;
              dyke.height_z = spill->z;
            }
          return dyke;
        }
    return Waker::measure_dyke(surfaces.section(), level);
  }


  template <int dim>
  bool
  Scene<dim>::loads_move() const
  {
    return water.level().moves() || tractions.moves() || !driven.empty();
  }


  template <int dim>
  double
  Scene<dim>::last_load_change(const double unknown) const
  {
    const auto known = [=](const double change) {
      return change == LastChange::unknown ? unknown : change;
    };
    // The water in the ground comes after that outside.
    double last = std::max(full_loads_from(the_case->parameters.time),
                           known(water.level().last_change()) +
                             the_case->pore_water.time_to_settle());
    for (const double change : {tractions.last_change(),
                                walls.last_change(),
                                the_case->fixities.last_change()})
      last = std::max(last, known(change));
    return last;
  }


  template <int dim>
  std::string
  Scene<dim>::varying_load(const double from, const double to) const
  {
    if (full_loads_from(the_case->parameters.time) > from)
      return "Time stepping/Load duration";
    if (water.level().varies(from, to))
      return "Water/Rise";
    for (const std::string &path : {tractions.varying(from, to),
                                    walls.varying(from, to),
                                    the_case->fixities.varying(from, to)})
      if (!path.empty())
        return path;
    return the_case->programmes.changing_after(from);
  }


  template <int dim>
  void
  Scene<dim>::add_up_loads(const MaterialPoints<dim>     &points,
                           const double                   time,
                           const std::vector<LoadRecord> &records)
  {
    NodalState &mine = step_nodes();
    set_gravity<dim>(the_case->parameters.gravity.acceleration, mine);
    const MaterialPoints<dim> &own = part != nullptr ? part->points() : points;
    const Weights<dim>        &own_weights =
      part != nullptr ? *part->weights : weights;
    if (part != nullptr)
      {
        of_points.reinit(part->grid->n_dofs());
        part->load_force = 0.;
      }
    NodalVector &on_points = part != nullptr ? of_points : mine.external_force;
    NodalVector &on_surfaces =
      part != nullptr ? part->load_force : mine.external_force;
    const std::vector<double> &mass =
      part != nullptr ? part->load_mass : mine.mass;

    driven.drive(records,
                 time,
                 {own, own_weights, on_points, tractions, water});
    water.find(surfaces, time);
    water.add_nodal_forces(mass, the_case->full_node_mass, on_surfaces);
    water_resultant = water.resultant();
    tractions.add(time, own, mass, the_case->full_node_mass, on_surfaces);
    the_case->pore_water.add_nodal_forces(own, own_weights, on_points);
    for (std::size_t p = 0; p < own.load.size(); ++p)
      if (own.load[p] != Tensor<1, dim>())
        add_point_force(own_weights.background_grid(),
                        own.position[p],
                        own.load[p],
                        on_points);
    if (part != nullptr)
      part->add_loads(of_points);
  }


  template <int dim>
  void
  Scene<dim>::set_internal_force(const MaterialPoints<dim> &points)
  {
    NodalVector &force = step_nodes().internal_force;
    force              = 0.;
    const auto motion  = make_point_motion<dim>(the_case->parameters.mapping);
    const auto add     = [&](const MaterialPoints<dim> &points,
                         const Weights<dim>        &weights) {
      motion->start(points, weights);
      motion->add_force_of_stress(points, weights, force);
    };
    if (part != nullptr)
      add(part->points(), *part->weights);
    else
      add(points, weights);
    for (Resistance<dim> *const resistance : resistances())
      resistance->add_start_force(force);
    if (part != nullptr)
      part->grid->exchange().sum({{force.begin(), dim}});
  }


  template <int dim>
  Resistances<dim>
  Scene<dim>::resistances()
  {
    return walls.empty() ? Resistances<dim>() : Resistances<dim>{&walls};
  }


  template <int dim>
  void
  Scene<dim>::complete(const MaterialPoints<dim> &points, const bool forces)
  {
    surfaces.look_at_whole(points);
    if (forces)
      tractions.complete([&](const NodalVector &window, NodalVector &all) {
        part->gather_loads(window, all);
      });
  }


  template <int dim>
  double
  Scene<dim>::water_level(const double time) const
  {
    return water.level().at(time);
  }


  template class Scene<2>;
  template class Scene<3>;
} // namespace Waker
