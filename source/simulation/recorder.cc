// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/host.h>
#include <waker/output/files.h>
#include <waker/output/output_files.h>
#include <waker/output/point_arrays.h>
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
      /// Raised when what is stored changes; State has its own.
      static constexpr unsigned int this_layout = 6;

      std::string    state; // State::write_record()
      StopParameters stop;  // by which state.rest was found
      /// FieldFiles::Entries
      std::vector<std::vector<PvdEntry>> fields;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        unsigned int layout = this_layout;
        archive     &layout;
        if (layout != this_layout)
          throw std::runtime_error("another layout");
        archive &state &stop.rest_plastic_strain &stop.rest_velocity &fields;
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
    , fields(parameters.output)
    , observers(standard_observers<dim>())
    , statistics(std::make_unique<Statistics>(
        file_path(parameters.output.directory, OutputFile::statistics)))
    , next_checkpoint(next_multiple(0., parameters.output.checkpoint_interval))
  {}


  template <int dim>
  Recorder<dim>::Recorder(const Parameters &parameters, State<dim> &state)
    : parameters(&parameters)
    , slots(parameters.output.directory, parameters.hash, parameters.text)
    , fields(parameters.output)
    , observers(standard_observers<dim>())
  {
    const Checkpoint checkpoint = slots.read_latest(resume_warning);
    Progress         progress;
    try
      {
        std::istringstream              stream(checkpoint.blob);
        boost::archive::binary_iarchive archive(stream);
        archive                        &progress;
        state.read_record(progress.state);
        read_arrays(checkpoint.arrays(), state.points);
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
    const std::vector<std::string> damaged = fields.restore(progress.fields);
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
    if (!statistics->damage().empty())
      resume_warning +=
        (resume_warning.empty() ? "" : "; ") + statistics->damage();
  }


  template <int dim>
  Wanted
  Recorder<dim>::wants(const double time,
                       const bool   stops,
                       const bool   last) const
  {
    Wanted wanted =
      stops || is_due(time, next_fields) ? fields.wanted() : Wanted();
    wanted.checkpoint = last || is_due(time, next_checkpoint);
    return wanted;
  }


  template <int dim>
  void
  Recorder<dim>::write_files(const StepView<dim>  &view,
                             const OwnPoints<dim> &own)
  {
    fields.write(view, own);
    next_fields   = next_multiple(view.state.time, parameters->output.interval);
    files_are_new = true;
  }


  template <int dim>
  void
  Recorder<dim>::record(const StepView<dim> &view)
  {
    statistics->begin_row(view.state.step);
    StatisticsRow row(*statistics);
    row.add("Time (s)", view.state.time);
    for (const auto &observer : observers)
      observer->observe(view, row);
    statistics->end_row();

    if (files_are_new)
      statistics->flush();
    files_are_new = false;
  }


  template <int dim>
  void
  Recorder<dim>::checkpoint(const State<dim> &state, const OwnPoints<dim> &own)
  {
    // An extra checkpoint must not shift the later ones.
    if (is_due(state.time, next_checkpoint))
      next_checkpoint =
        next_multiple(state.time, parameters->output.checkpoint_interval);
    statistics->flush();
    const auto blob = [&](const std::vector<std::uint64_t> &array_sizes) {
      const Progress     progress{state.write_record(array_sizes),
                              parameters->stop,
                              fields.entries()};
      std::ostringstream bytes;
      {
        boost::archive::binary_oarchive archive(bytes);
        archive                        &progress;
      }
      return bytes.str();
    };
    slots.write(state.step, blob, own.points, own.rows);
    give_back_memory();
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
    // A case that could not be made has no points, and nobody has counted them.
    const bool has_case = state.step > 0 || state.points.n_points() > 0;
    if (parameters->sliding.watch && has_case)
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
    if (state.long_steps.n + state.long_steps.motions > 0)
      {
        summary.long_steps   = state.long_steps.n;
        summary.time_at_rest = state.long_steps.time;
        summary.motions      = state.long_steps.motions;
      }
    if (has_case)
      summary.particles = state.points.n_points();
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
