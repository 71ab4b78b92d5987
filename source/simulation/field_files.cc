// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/host.h>
#include <waker/base/ranks.h>
#include <waker/loads/liquid.h>
#include <waker/output/grid_writer.h>
#include <waker/output/particle_writer.h>
#include <waker/output/surface_writer.h>
#include <waker/output/top_view_writer.h>
#include <waker/output/traction_writer.h>
#include <waker/output/wall_writer.h>
#include <waker/simulation/field_files.h>


namespace Waker
{
  template <int dim>
  FieldFiles<dim>::FieldFiles(const OutputParameters &output)
    : output(output)
  {
    for (unsigned int k = 0; k < n_field_series; ++k)
      series.emplace_back(output.directory, static_cast<FieldSeries>(k));
  }


  template <int dim>
  typename FieldFiles<dim>::Entries
  FieldFiles<dim>::entries() const
  {
    Entries result;
    for (const PvdSeries &files : series)
      result.push_back(files.entries());
    return result;
  }


  template <int dim>
  std::vector<std::string>
  FieldFiles<dim>::restore(const Entries &entries)
  {
    AssertDimension(entries.size(), series.size());
    std::vector<std::string> damaged;
    for (std::size_t k = 0; k < series.size(); ++k)
      for (const std::string &file : series[k].restore(entries[k]))
        damaged.push_back(file);
    return damaged;
  }


  template <int dim>
  template <typename Function>
  void
  FieldFiles<dim>::add(const FieldSeries which,
                       const double      time,
                       const Function   &f,
                       const MPI_Comm    ranks)
  {
    PvdSeries        &files    = series[static_cast<std::size_t>(which)];
    const std::string checksum = f(shared(files.next_path(), ranks));
    if (is_first_rank(ranks))
      files.add(time, checksum);
  }


  template <int dim>
  void
  FieldFiles<dim>::write(const StepView<dim> &view, const OwnPoints<dim> &own)
  {
    if (output.particles)
      write_particles(view, own);
    if (output.top_view)
      write_top_view(view, own);
    const bool is_first = is_first_rank(own.rows.communicator);
    if (is_first && output.surface)
      write_surfaces(view);
    if (is_first && output.grid)
      write_grid(view);
    give_back_memory();
  }


  template <int dim>
  Wanted
  FieldFiles<dim>::wanted() const
  {
    Wanted wanted;
    wanted.files  = true;
    wanted.places = output.surface || output.grid || output.top_view;
    wanted.nodes  = output.grid;
    return wanted;
  }


  template <int dim>
  void
  FieldFiles<dim>::write_particles(const StepView<dim>  &view,
                                   const OwnPoints<dim> &own)
  {
    const State<dim> &state = view.state;
    PointVectors<dim> loads;
    if (view.the_case.has_point_loads)
      loads.push_back({"load", "kN", &own.points.load});
    for (std::size_t i = 0; i < view.scene.tractions.size(); ++i)
      {
        const auto traction = view.scene.tractions.view(i);
        if (traction.point_loads != nullptr)
          loads.push_back(
            {"load_" + traction.name, "kN", traction.point_loads});
      }
    add(
      FieldSeries::particles,
      state.time,
      [&](const std::string &path) {
        return Waker::write_particles(
          own.points, own.rows, state.time, path, loads);
      },
      own.rows.communicator);
  }


  template <int dim>
  void
  FieldFiles<dim>::write_surfaces(const StepView<dim> &view)
  {
    const Scene<dim> &scene = view.scene;
    const double      time  = view.state.time;
    add(FieldSeries::surface, time, [&](const std::string &path) {
      return write_surface(scene.surfaces.facets(),
                           scene.water.wetted(),
                           scene.water.now(),
                           time,
                           path);
    });
    if (scene.tractions.size() > 0)
      add(FieldSeries::tractions, time, [&](const std::string &path) {
        return write_tractions(scene.tractions, time, path);
      });
    if (!scene.walls.empty())
      add(FieldSeries::walls, time, [&](const std::string &path) {
        return write_walls(scene.walls, view.state.wall_tractions, time, path);
      });
  }


  template <int dim>
  void
  FieldFiles<dim>::write_grid(const StepView<dim> &view)
  {
    const Scene<dim>          &scene = view.scene;
    const NodalState          &nodes = scene.nodes;
    const std::vector<double> &field = scene.surfaces.proximity_field();
    GridFields                 fields;
    if (field.size() == nodes.mass.size())
      fields.scalars.push_back({"proximity_field", "-", &field});
    fields.vectors.push_back({"velocity", "m/s", &nodes.velocity});
    fields.vectors.push_back({"external_force", "kN", &nodes.external_force});
    fields.vectors.push_back({"internal_force", "kN", &nodes.internal_force});
    fields.vectors.push_back({"increment", "m", &nodes.increment});
    for (std::size_t i = 0; i < scene.tractions.size(); ++i)
      {
        const auto traction = scene.tractions.view(i);
        fields.vectors.push_back(
          {"force_" + traction.name, "kN", traction.nodal_force});
      }
    const double time = view.state.time;
    add(FieldSeries::grid, time, [&](const std::string &path) {
      return Waker::write_grid(
        view.the_case.grid, nodes.mass, fields, time, path);
    });
  }


  template <int dim>
  void
  FieldFiles<dim>::write_top_view(const StepView<dim>  &view,
                                  const OwnPoints<dim> &own)
  {
    const State<dim>          &state = view.state;
    const BackgroundGrid<dim> &grid  = view.the_case.grid;
    const TopView<dim>         ground(grid, state.points);
    add(
      FieldSeries::top_view,
      state.time,
      [&](const std::string &path) {
        return Waker::write_top_view(
          ground, own.points, own.rows, state.time, path);
      },
      own.rows.communicator);
    if constexpr (dim == 3)
      if (is_first_rank(own.rows.communicator))
        add(FieldSeries::ground_lines,
            state.time,
            [&](const std::string &path) {
              const auto lines = ground_lines(ground,
                                              state.points,
                                              view.the_case.initial_height,
                                              ground_step(grid));
              return write_ground_lines(lines, state.time, path);
            });
  }


  template class FieldFiles<2>;
  template class FieldFiles<3>;
} // namespace Waker
