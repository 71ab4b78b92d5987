// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/host.h>
#include <waker/base/numbers.h>
#include <waker/base/ranks.h>
#include <waker/base/text.h>
#include <waker/case/case.h>
#include <waker/case/initial_properties.h>
#include <waker/case/initial_stress.h>
#include <waker/case/scene.h>
#include <waker/case/sizes.h>
#include <waker/case/soil.h>
#include <waker/loads/water_level.h>
#include <waker/measures/dyke_geometry.h>
#include <waker/measures/ground_lines.h>
#include <waker/mechanics/deformation.h>
#include <waker/mechanics/time_scheme.h>

#include "given_stress_check.h"
#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace Waker
{
  namespace
  {
    Materials
    make_materials(const Parameters &parameters)
    {
      Materials materials;
      for (const MaterialParameters &material : parameters.materials)
        materials.push_back(
          make_material(material,
                        parameters.gravity.density_acceleration(),
                        parameters.grid.cell_size));
      return materials;
    }


    /// Those that no load programme drives.
    std::vector<PointLoadParameters>
    undriven_point_loads(const Parameters &p)
    {
      std::vector<PointLoadParameters> loads = p.point_loads;
      for (const LoadProgrammeParameters &programme : p.load_programmes)
        if (programme.drives == LoadTarget::point_load)
          loads.erase(std::remove_if(loads.begin(),
                                     loads.end(),
                                     [&](const PointLoadParameters &load) {
                                       return load.name == programme.load;
                                     }),
                      loads.end());
      return loads;
    }


    /// Weight below the phreatic line over the unit weight.
    double
    saturation(const Parameters &parameters, const unsigned int m)
    {
      if (!parameters.pore_water.is_there() || m >= parameters.materials.size())
        return 1.;
      return unit_weight_below_line(parameters.materials, m) /
             parameters.materials[m].unit_weight;
    }


    double
    largest_density(const Materials &materials, const Parameters &parameters)
    {
      double largest = 0.;
      for (unsigned int m = 0; m < materials.size(); ++m)
        largest = std::max(largest,
                           materials[m]->density() * saturation(parameters, m));
      return largest;
    }


    std::vector<bool>
    of_effective_stress(const Materials &materials)
    {
      std::vector<bool> result;
      for (const auto &material : materials)
        result.push_back(material->is_of_effective_stress());
      return result;
    }


    /// The points' scalar "initial vertical stress" (kPa), effective, of
    /// columns; if anything follows from it.
    template <int dim>
    void
    record_vertical_stress(const Ground<dim>               &ground,
                           const Parameters                &parameters,
                           const std::vector<unsigned int> &layers,
                           MaterialPoints<dim>             &points)
    {
      if (!ground.knows_stress() ||
          (parameters.initial_stress.is_gravity_step() &&
           std::none_of(parameters.materials.begin(),
                        parameters.materials.end(),
                        [](const MaterialParameters &m) {
                          return m.strength_follows_stress();
                        })))
        return;
      std::vector<double> &values = points.scalar("initial vertical stress");
      for (std::size_t p = 0; p < points.n_points(); ++p)
        if (layers[p] < ground.depths().n_layers())
          values[p] =
            ground.at(points.initial_position[p], layers[p]).vertical_stress;
    }


    /// The soil below the phreatic line gets the weight and the material that
    /// it has there.
    template <int dim>
    void
    put_below_line(const PoreWater<dim> &pore_water,
                   const Parameters     &parameters,
                   MaterialPoints<dim>  &points)
    {
      if (pore_water.empty())
        return;
      for (std::size_t p = 0; p < points.n_points(); ++p)
        if (pore_water.line().height(points.initial_position[p][0]) >
            points.initial_position[p][1])
          {
            const unsigned int m = points.material[p];
            points.mass[p] *= saturation(parameters, m);
            if (m < parameters.materials.size())
              points.material[p] = material_below_line(parameters.materials, m);
          }
    }
  } // namespace


  template <int dim>
  Case<dim>::Case(const Parameters     &p,
                  const MPI_Comm        communicator,
                  Materials             given_materials,
                  const BalanceWatcher &watcher)
    : parameters(p)
    , grid(make_grid<dim>(p.grid, communicator))
    , user_surfaces(read_surfaces(p.tractions, grid))
    , materials(given_materials.empty() ? make_materials(p)
                                        : std::move(given_materials))
    , flow(grid, materials, p)
    , fixities(grid, flow.conditions(), flow.outflow())
    , programmes(p)
    , pore_water(p.pore_water,
                 p.water.unit_weight,
                 of_effective_stress(materials),
                 WaterLevel(p.water).at(0.))
    , ground(grid, p, pore_water)
    , full_node_mass(largest_density(materials, p) *
                     std::pow(p.grid.cell_size, dim))
    , riding_loads(p.tractions.size())
  {
    initial_points = make_soil(grid, p, materials, &layers_of_points);
    put_below_line(pore_water, p, initial_points);
    flow.fill(initial_points);
    layers_of_points.resize(initial_points.n_points(),
                            ground.depths().n_layers());
    apply_point_loads(undriven_point_loads(p),
                      p.grid.cell_size,
                      initial_points);
    declare_material_variables(materials, initial_points);
    InitialProperties<dim>(materials, ground)
      .set(layers_of_points, initial_points);
    ground.record_loads(layers_of_points, initial_points);
    record_vertical_stress(ground, p, layers_of_points, initial_points);
    pore_water.record(initial_points, WaterLevel(p.water).at(0.));
    prepare_domains(p.mapping.domains, initial_points);
    programmes.prepare(p, initial_points);
    has_point_loads = !initial_points.load.empty();
    check_run_sizes(run_sizes(*this), p, n_ranks_here(grid.communicator()));
    initial_height = crest_height(initial_points);
    if constexpr (dim == 3)
      if (!p.surface.is_of_section(dim))
        sections = dyke_sections(grid, initial_points);
    if (p.sliding.watch)
      slides.emplace(initial_points,
                     initial_crest(*this),
                     p.sliding.displacement);
    set_initial_state(watcher);
  }


  template <int dim>
  MaterialPoints<dim>
  Case<dim>::take_initial_points()
  {
    return std::exchange(initial_points, MaterialPoints<dim>());
  }


  template <int dim>
  double
  Case<dim>::declared_last_load_change(const Scene<dim> &scene) const
  {
    const double declared = parameters.stop.declared_last_change();
    if (declared != LastChange::unknown)
      {
        const std::string path =
          scene.varying_load(declared,
                             std::max(declared, parameters.time.end_time));
        if (!path.empty())
          throw UserError("Stop rules/Loads constant from",
                          "is " + tidy(parameters.stop.loads_constant_from) +
                            " s, but " + path +
                            " changes between then and the end time",
                          "a time after which no load changes, or unknown");
      }
    return scene.last_load_change(declared);
  }


  template <int dim>
  double
  Case<dim>::checked_measuring_level(Scene<dim> &scene) const
  {
    const auto metres = [](const double y) {
      std::ostringstream text;
      text << y;
      return text.str();
    };
    const bool         has_water = parameters.water.stands();
    const DykeGeometry dyke      = scene.measure_dyke(parameters.water.level);
    if (dyke.width > 0.)
      {
        const double water = scene.water_level(0.);
        if (has_water && dyke.height <= water)
          throw UserError("Water/Rise",
                          "puts the water at " + metres(water) +
                            " m at the start, not below the detected crest "
                            "at " +
                            metres(dyke.height) + " m: the dyke is flooded",
                          "less than the crest at t = 0");
        return dyke.level;
      }
    if (has_water)
      throw UserError("Water/Level",
                      "is " + metres(dyke.level) +
                        " m, where there is no soil at the start: " +
                        (dyke.height > dyke.level
                           ? "all of it is above"
                           : "it rises to " + metres(dyke.height) +
                               " m, and is flooded"),
                      "a level within the height of the soil (or Water/Side = "
                      "none)");
    return nan;
  }


  template <int dim>
  void
  Case<dim>::set_initial_state(const BalanceWatcher &watcher)
  {
    MaterialPoints<dim> &points = initial_points;
    Scene<dim>           scene(*this);
    scene.set(points);
    scene.tractions.check_something_is_loaded();
    last_load_change = declared_last_load_change(scene);
    measuring_level  = checked_measuring_level(scene);
    programmes.check_watched(points, measuring_level);
    if (scheme_traits(parameters.time).has_long_steps)
      {
        const double end = parameters.time.end_time;
        for (const std::string &path : {scene.tractions.varying(0., end),
                                        scene.walls.varying(0., end),
                                        fixities.varying(0., end)})
          if (!path.empty())
            throw UserError(
              path,
              "changes in time, and long steps look at Water/Rise "
              "alone: they would jump over it",
              std::string("what does not change, or Time "
                          "stepping/Scheme = ") +
                name_of(Scheme::newmark));
      }
    water_touches = scene.water.touches();
    scene.tractions.fix_point_loads(points);
    scene.tractions.ride(points, riding_loads);
    for (std::size_t i = 0; i < scene.tractions.size(); ++i)
      initial_tractions.push_back(scene.tractions.resultant(i));
    if (!std::isfinite(scene.nodes.external_force.l2_norm()))
      throw NumericalFailure("the loads at t = 0 are not finite: is a unit "
                             "weight, a traction or a force too large?");
    initial_wall_tractions.resize(scene.walls.n_spots());
    scene.walls.reinit(points, scene.nodes.mass, 0., initial_wall_tractions);
    scene.walls.check_start();
    idle_walls = scene.walls.idle();
    if (parameters.gravity.initial_stress)
      {
        const NodalVector full = scene.nodes.external_force;
        scene.nodes.external_force *= parameters.gravity.initial_share;
        set_stress(scene, watcher);
        scene.nodes.external_force = full; // the rest acts from now on
        give_back_memory();                // what the solver took
      }
    else
      {
        check_given_stress(parameters, materials, layers_of_points, points);
        scene.set_internal_force(points);
      }
    consolidate(materials, points);

    // Newmark starts from the acceleration that fits the forces at t = 0.
    set_initial_acceleration(*this, scene, points);
  }


  template <int dim>
  SurfaceVertices<dim>
  initial_vertices(const Case<dim> &the_case)
  {
    SurfaceVertices<dim> vertices;
    for (std::size_t i = 0; i < the_case.riding_loads.size(); ++i)
      vertices.push_back(the_case.riding_loads[i].pieces.empty()
                           ? the_case.user_surfaces[i].vertices
                           : the_case.riding_loads[i].start_vertices());
    return vertices;
  }


  template SurfaceVertices<2>
  initial_vertices(const Case<2> &);
  template SurfaceVertices<3>
  initial_vertices(const Case<3> &);
  template struct Case<2>;
  template struct Case<3>;
} // namespace Waker
