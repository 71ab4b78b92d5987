// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/campaign/realisation_runner.h>
#include <waker/simulation/run_to_end.h>

#include <chrono>
#include <cmath>

namespace Waker
{
  namespace
  {
    /// The first slide is looked at so long after S1 (s).
    constexpr double first_look = 1.;
    /// Change of W or H that goes into the trace (m).
    constexpr double trace_resolution = 0.02;

    using Clock = std::chrono::steady_clock;

    double
    seconds_since(const Clock::time_point start)
    {
      return std::chrono::duration<double>(Clock::now() - start).count();
    }


    /// Keeps the geometry where it changes: the moment before a change, and
    /// the one after.
    class Tracer
    {
    public:
      void
      add(const double time, const DykeGeometry &geometry)
      {
        const TracePoint now{time, geometry.width, geometry.height};
        if (points.empty())
          points.push_back(now);
        else if (std::abs(now.width - points.back().width) > trace_resolution ||
                 std::abs(now.height - points.back().height) > trace_resolution)
          {
            if (last.time > points.back().time)
              points.push_back(last);
            points.push_back(now);
          }
        last = now;
      }

      std::vector<TracePoint>
      finish()
      {
        if (!points.empty() && last.time > points.back().time)
          points.push_back(last);
        return std::move(points);
      }

    private:
      std::vector<TracePoint> points;
      TracePoint              last{};
    };


    /// Traces the geometry, and looks at the first slide.
    template <int dim>
    class RecordWatcher : public Watcher
    {
    public:
      RecordWatcher(const bool        inner_is_positive,
                    const State<dim> &state,
                    Record           &record)
        : inner_is_positive(inner_is_positive)
        , state(state)
        , record(record)
      {}

      void
      looked(const StopReason stop, const bool) override
      {
        const FailureRecord &failure = state.failure;
        tracer.add(state.time, failure.geometry);
        if (!has_seen_slide && failure.failed() &&
            (stop != StopReason::none ||
             state.time >= failure.time_of(FailureReading::any) + first_look))
          {
            has_seen_slide       = true;
            record.first_inward  = moved_soil(state.points, inner_is_positive);
            record.first_outward = moved_soil(state.points, !inner_is_positive);
          }
      }

      Tracer tracer;

    private:
      const bool        inner_is_positive;
      const State<dim> &state;
      Record           &record;
      bool              has_seen_slide = false;
    };
  } // namespace


  template <int dim>
  RealisationRunner<dim>::RealisationRunner(
    const Parameters             &parameters,
    const RandomFieldsParameters &fields,
    const unsigned int            attempts,
    const MPI_Comm                communicator)
    : cases(parameters, attempts, communicator)
    , random_properties(cases.first(), fields)
  {}


  template <int dim>
  State<dim>
  RealisationRunner<dim>::initial(const double *noise) const
  {
    State<dim> state = initial_state(cases.first());
    random_properties.apply(noise, state);
    return state;
  }


  template <int dim>
  bool
  RealisationRunner<dim>::record_run(const Case<dim> &the_case,
                                     const Interrupt &interrupt,
                                     State<dim>      &state,
                                     Record          &record) const
  {
    const bool inner_is_positive =
      the_case.parameters.water.inner_direction() > 0;
    Realisation<dim>   realisation(the_case, state);
    RecordWatcher<dim> watcher(inner_is_positive, state, record);
    try
      {
        const StopReason stop = run_to_end(realisation, watcher, interrupt);
        if (stop == StopReason::none)
          return false;
        record.stop_reason = to_string(stop);
        record.unrest      = realisation.unrest();
        record.outcome     = outcome_of(state.failure, *record.unrest);
      }
    catch (const NumericalFailure &failure)
      {
        record.outcome     = Outcome::numerical_failure;
        record.stop_reason = failure.what();
      }

    static_cast<FailureEvents &>(record) = state.failure;
    record.end_time                      = state.time;
    record.initial_width                 = state.failure.initial_width;
    record.initial_height                = state.failure.initial_height;
    record.residual_width                = state.failure.geometry.width;
    record.residual_height               = state.failure.geometry.height;
    record.inward  = moved_soil(state.points, inner_is_positive);
    record.outward = moved_soil(state.points, !inner_is_positive);
    record.steps += state.step;
    record.newton_iterations += state.newton_iterations;
    record.linear_iterations += state.linear_iterations;
    record.unconverged_steps += state.unconverged_steps;
    if (state.failure.failed())
      record.trace = watcher.tracer.finish();
    return true;
  }


  template <int dim>
  std::optional<Record>
  RealisationRunner<dim>::run(const double *noise, const Interrupt &interrupt)
  {
    const Clock::time_point start = Clock::now();
    Record                  record;
    bool                    interrupted = false;
    cases.until_it_works(
      [&](const Case<dim> &the_case, const unsigned int attempt) {
        // The work of all attempts counts, what came out only of the last.
        Record next;
        next.attempts          = attempt + 1;
        next.steps             = record.steps;
        next.newton_iterations = record.newton_iterations;
        next.linear_iterations = record.linear_iterations;
        next.unconverged_steps = record.unconverged_steps;
        next.field_time        = record.field_time;
        record                 = std::move(next);

        State<dim>              state       = initial_state(the_case);
        const Clock::time_point field_start = Clock::now();
        random_properties.apply(noise, state);
        record.field_time += seconds_since(field_start);
        std::tie(record.mean_strength, record.least_strength) =
          random_properties.mean_and_least(state);
        interrupted = !record_run(the_case, interrupt, state, record);
        return interrupted || record.outcome != Outcome::numerical_failure;
      });
    if (interrupted)
      return {};
    record.wall_time = seconds_since(start);
    return record;
  }


  template <int dim>
  std::optional<Record>
  RealisationRunner<dim>::run(const std::uint64_t seed,
                              const std::uint64_t realisation,
                              const Interrupt    &interrupt)
  {
    const Clock::time_point   start = Clock::now();
    const std::vector<double> noise =
      realisation_noise(seed, realisation, n_noise());
    const double          noise_time = seconds_since(start);
    std::optional<Record> record     = run(noise.data(), interrupt);
    if (record)
      {
        record->realisation = realisation;
        record->field_time += noise_time;
        record->wall_time += noise_time;
      }
    return record;
  }


  template class RealisationRunner<2>;
  template class RealisationRunner<3>;
} // namespace Waker
