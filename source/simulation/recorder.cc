// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/loads/liquid.h>
#include <waker/output/files.h>
#include <waker/output/grid_writer.h>
#include <waker/output/output_files.h>
#include <waker/output/particle_writer.h>
#include <waker/output/surface_writer.h>
#include <waker/output/traction_writer.h>
#include <waker/output/wall_writer.h>
#include <waker/simulation/recorder.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace Waker
{
  namespace
  {
    /// The recorder's part of a checkpoint.
    struct Progress
    {
      /// Raised when what is stored, or in State, changes.
      static constexpr unsigned int this_layout = 4;

      std::string           state;
      StopParameters        stop; // by which state.rest was found
      std::vector<PvdEntry> particles;
      std::vector<PvdEntry> surfaces;
      std::vector<PvdEntry> grids;
      std::vector<PvdEntry> tractions;
      std::vector<PvdEntry> walls;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        unsigned int layout = this_layout;
        archive     &layout;
        if (layout != this_layout)
          throw std::runtime_error("another layout");
        archive &state &stop.rest_plastic_strain                &stop
          .rest_velocity &particles &surfaces &grids &tractions &walls;
      }
    };


    class StatisticsRow : public Row
    {
    public:
      explicit StatisticsRow(Statistics &statistics)
        : statistics(statistics)
      {}

      void
      add(const std::string_view name, const double value) override
      {
        statistics.add(name, value);
      }

    private:
      Statistics &statistics;
    };


    std::optional<double>
    time_or_nothing(const double time)
    {
      return time >= 0. ? std::optional<double>(time) : std::nullopt;
    }


    std::optional<double>
    z_or_nothing(const double z)
    {
      return std::isnan(z) ? std::nullopt : std::optional<double>(z);
    }


    /// Round-off in the sum of the time steps must not skip a time.
    bool
    is_due(const double t, const double due)
    {
      return t >= due * (1. - 1e-12);
    }


    std::optional<SlideSummary>
    slide_or_nothing(const SlopeSlide &slide)
    {
      if (slide.time < 0.)
        return {};
      SlideSummary summary{slide.time, slide.body.area, slide.body.share, {}};
      if (!std::isnan(slide.body.crest_cut))
        summary.crest_cut = slide.body.crest_cut;
      return summary;
    }


    /// The first multiple of the interval that is not due at t yet.
    double
    next_multiple(const double t, const double interval)
    {
      if (!(interval > 0.))
        return std::numeric_limits<double>::infinity();
      double n = std::floor(t / interval);
      if (n > 1e12) // too many to be counted: each step is one
        return t;
      while (is_due(t, n * interval))
        ++n;
      return n * interval;
    }
  } // namespace


  template <int dim>
  Recorder<dim>::Recorder(const Parameters &parameters)
    : parameters(&parameters)
    , slots(parameters.output.directory, parameters.hash)
    , particles(parameters.output.directory, FieldSeries::particles)
    , surfaces(parameters.output.directory, FieldSeries::surface)
    , grids(parameters.output.directory, FieldSeries::grid)
    , tractions(parameters.output.directory, FieldSeries::tractions)
    , walls(parameters.output.directory, FieldSeries::walls)
    , observers(standard_observers<dim>())
    , statistics(std::make_unique<Statistics>(
        file_path(parameters.output.directory, OutputFile::statistics)))
    , next_checkpoint(next_multiple(0., parameters.output.checkpoint_interval))
  {}


  template <int dim>
  Recorder<dim>::Recorder(const Parameters &parameters, State<dim> &state)
    : parameters(&parameters)
    , slots(parameters.output.directory, parameters.hash, parameters.text)
    , particles(parameters.output.directory, FieldSeries::particles)
    , surfaces(parameters.output.directory, FieldSeries::surface)
    , grids(parameters.output.directory, FieldSeries::grid)
    , tractions(parameters.output.directory, FieldSeries::tractions)
    , walls(parameters.output.directory, FieldSeries::walls)
    , observers(standard_observers<dim>())
  {
    const Checkpoint checkpoint = slots.read_latest(resume_warning);
    Progress         progress;
    try
      {
        std::istringstream              stream(checkpoint.blob);
        boost::archive::binary_iarchive archive(stream);
        archive                        &progress;
        state.read(progress.state);
      }
    catch (const std::exception &)
      {
        throw UserError("Output/Directory",
                        "the checkpoint in " + parameters.output.directory +
                          " was written by another program: " +
                          checkpoint.program,
                        "--resume with the program that wrote it, or "
                        "--overwrite");
      }
    // By the intervals and limits of now: they may have changed.
    if (progress.stop.rest_plastic_strain !=
          parameters.stop.rest_plastic_strain ||
        progress.stop.rest_velocity != parameters.stop.rest_velocity)
      state.rest = RestRecord();
    next_fields = next_multiple(state.time, parameters.output.interval);
    next_checkpoint =
      next_multiple(state.time, parameters.output.checkpoint_interval);
    std::vector<std::string> damaged;
    const auto               restore = [&](PvdSeries                   &series,
                             const std::vector<PvdEntry> &entries) {
      for (const std::string &file : series.restore(entries))
        damaged.push_back(file);
    };
    restore(particles, progress.particles);
    restore(surfaces, progress.surfaces);
    restore(grids, progress.grids);
    restore(tractions, progress.tractions);
    restore(walls, progress.walls);
    if (!damaged.empty())
      resume_warning += (resume_warning.empty() ? "" : "; ") +
                        std::to_string(damaged.size()) +
                        " field files of before the checkpoint are missing or "
                        "damaged, and stay so (--overwrite computes all "
                        "again): the first is " +
                        damaged.front();
    // The row of the checkpoint's step was written before it.
    statistics =
      std::make_unique<Statistics>(file_path(parameters.output.directory,
                                             OutputFile::statistics),
                                   state.step + 1);
  }


  template <int dim>
  void
  Recorder<dim>::record(const StepView<dim> &view, const bool last)
  {
    const double time = view.state.time;
    statistics->begin_row(view.state.step);
    StatisticsRow row(*statistics);
    row.add("Time (s)", time);
    for (const auto &observer : observers)
      observer->observe(view, row);
    statistics->end_row();

    if (last || is_due(time, next_fields))
      {
        write_fields(view);
        next_fields = next_multiple(time, parameters->output.interval);
        statistics->flush();
      }
  }


  template <int dim>
  void
  Recorder<dim>::write_fields(const StepView<dim> &view)
  {
    const OutputParameters &output = parameters->output;
    const State<dim>       &state  = view.state;
    const Scene<dim>       &scene  = view.scene;
    const double            time   = state.time;
    if (output.particles)
      {
        PointVectors<dim> loads;
        if (!state.points.load.empty())
          loads.push_back({"load", "kN", &state.points.load});
        for (std::size_t i = 0; i < scene.tractions.size(); ++i)
          {
            const auto traction = scene.tractions.view(i);
            if (!traction.point_loads->empty())
              loads.push_back(
                {"load_" + traction.name, "kN", traction.point_loads});
          }
        particles.add(
          time,
          write_particles(state.points, time, particles.next_path(), loads));
      }
    if (output.surface)
      surfaces.add(time,
                   write_surface(scene.surfaces.facets(),
                                 scene.water.wetted(),
                                 scene.water.now(),
                                 time,
                                 surfaces.next_path()));
    if (output.surface && scene.tractions.size() > 0)
      tractions.add(
        time, write_tractions(scene.tractions, time, tractions.next_path()));
    if (output.surface && !scene.walls.empty())
      walls.add(time,
                write_walls(
                  scene.walls, state.wall_tractions, time, walls.next_path()));
    if (output.grid)
      {
        const NodalState          &nodes = scene.nodes;
        const std::vector<double> &field = scene.surfaces.proximity_field();
        GridFields                 fields;
        if (field.size() == nodes.mass.size())
          fields.scalars.push_back({"proximity_field", "-", &field});
        fields.vectors.push_back({"velocity", "m/s", &nodes.velocity});
        fields.vectors.push_back(
          {"external_force", "kN", &nodes.external_force});
        fields.vectors.push_back(
          {"internal_force", "kN", &nodes.internal_force});
        fields.vectors.push_back({"increment", "m", &nodes.increment});
        for (std::size_t i = 0; i < scene.tractions.size(); ++i)
          {
            const auto traction = scene.tractions.view(i);
            fields.vectors.push_back(
              {"force_" + traction.name, "kN", traction.nodal_force});
          }
        grids.add(time,
                  write_grid(view.the_case.grid,
                             nodes.mass,
                             fields,
                             time,
                             grids.next_path()));
      }
  }


  template <int dim>
  void
  Recorder<dim>::checkpoint(const State<dim> &state, const bool now)
  {
    if (!now && !is_due(state.time, next_checkpoint))
      return;
    // An extra checkpoint must not shift the later ones.
    if (is_due(state.time, next_checkpoint))
      next_checkpoint =
        next_multiple(state.time, parameters->output.checkpoint_interval);
    statistics->flush();
    const Progress     progress{state.write(),
                            parameters->stop,
                            particles.entries(),
                            surfaces.entries(),
                            grids.entries(),
                            tractions.entries(),
                            walls.entries()};
    std::ostringstream bytes;
    {
      boost::archive::binary_oarchive archive(bytes);
      archive                        &progress;
    }
    slots.write(state.step, bytes.str());
  }


  template <int dim>
  void
  Recorder<dim>::write_summary(const State<dim>               &state,
                               const std::vector<LoadName>    &load_names,
                               const Outcome                   outcome,
                               const Unrest                   &unrest,
                               const std::string              &stop_reason,
                               const double                    wall_time,
                               const std::vector<std::string> &warnings) const
  {
    Summary summary;
    summary.outcome = to_string(outcome);
    if (outcome != Outcome::numerical_failure)
      {
        summary.still_moving = unrest.moving;
        summary.loads_change = unrest.loads_change;
        summary.at_box       = unrest.at_box;
      }
    summary.stop_reason          = stop_reason;
    summary.initial_failure_time = time_or_nothing(state.failure.initial_time);
    summary.initial_failure_time_thesis =
      time_or_nothing(state.failure.initial_time_thesis);
    summary.initial_failure_time_displacement =
      time_or_nothing(state.failure.time_of(FailureReading::by_displacement));
    summary.slope       = name_of(state.failure.slope());
    summary.inner_slide = slide_or_nothing(state.failure.inner_slide);
    summary.outer_slide = slide_or_nothing(state.failure.outer_slide);
    if (parameters->sliding.watch)
      summary.sliding_masses = state.sliding;
    summary.flooding_time     = time_or_nothing(state.failure.flooding_time);
    summary.initial_width     = state.failure.initial_width;
    summary.residual_width    = state.failure.geometry.width;
    summary.residual_height   = state.failure.geometry.height;
    summary.residual_width_z  = z_or_nothing(state.failure.geometry.width_z);
    summary.residual_height_z = z_or_nothing(state.failure.geometry.height_z);
    summary.end_time          = state.time;
    summary.steps             = state.step;
    summary.newton_iterations = state.newton_iterations;
    summary.linear_iterations = state.linear_iterations;
    summary.unconverged_steps = state.unconverged_steps;
    summary.particles         = state.points.n_points();
    for (const TractionRecord &traction : state.tractions)
      summary.vanished_tractions += traction.empty_time >= 0.;
    for (std::size_t i = 0; i < state.loads.size(); ++i)
      {
        const LoadRecord &load = state.loads[i];
        summary.loads.push_back({load_names[i].name,
                                 load_names[i].unit,
                                 load.factor,
                                 load.held_for,
                                 time_or_nothing(load.stop_time)});
      }
    summary.wall_time       = wall_time;
    summary.warnings        = warnings;
    summary.parameters_hash = parameters->hash;
    summary.write(file_path(parameters->output.directory, OutputFile::summary));
  }


  template class Recorder<2>;
  template class Recorder<3>;
} // namespace Waker
