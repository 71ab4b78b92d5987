// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <waker/base/errors.h>
#include <waker/base/host.h>
#include <waker/base/ranks.h>
#include <waker/campaign/realisation_runner.h>
#include <waker/campaign/unfinished.h>
#include <waker/simulation/run_to_end.h>

#include <chrono>
#include <tuple>
#include <utility>

namespace Waker
{
  namespace
  {
    /// The first slide is looked at so long after S1 (s).
    constexpr double first_look = 1.;
    using Clock                 = std::chrono::steady_clock;

    double
    seconds_since(const Clock::time_point start)
    {
      return std::chrono::duration<double>(Clock::now() - start).count();
    }


    /// @return nothing if the bytes are those of another version
    template <int dim>
    std::optional<State<dim>>
    state_from(const std::string &bytes)
    {
      try
        {
          State<dim> state;
          state.read(bytes);
          return state;
        }
      catch (const std::exception &)
        {
          return {};
        }
    }


    /// Traces the geometry, looks at the first slide, and keeps all that for
    /// another process.
    template <int dim>
    class RecordWatcher : public Watcher
    {
    public:
      /// @param so_far goes on from there
      /// @param begun when this process began with the realisation
      RecordWatcher(const bool              inner_is_positive,
                    const State<dim>       &state,
                    Unfinished             &so_far,
                    const Clock::time_point begun,
                    Keeper                 &keeper)
        : inner_is_positive(inner_is_positive)
        , state(state)
        , so_far(so_far)
        , begun(begun)
        , earlier_time(so_far.wall_time)
        , keeper(keeper)
      {}

      Wanted
      wants(const StopReason /*stop*/, const bool last) override
      {
        Wanted wanted;
        if (!last)
          is_due = keeper.is_due(state.time, false);
        wanted.all = last || is_due || is_first_look_due();
        return wanted;
      }

      void
      looked(const StopReason stop, const bool last) override
      {
        const FailureRecord &failure = state.failure;
        so_far.tracer.add(state.time, failure.geometry);
        if (!so_far.has_seen_slide && failure.failed() &&
            (stop != StopReason::none || is_first_look_due()))
          {
            so_far.has_seen_slide = true;
            so_far.record.first_inward =
              moved_soil(state.points, inner_is_positive);
            so_far.record.first_outward =
              moved_soil(state.points, !inner_is_positive);
          }
        if (stop == StopReason::none && last)
          is_due = keeper.is_due(state.time, true);
        if (stop == StopReason::none && is_due)
          {
            so_far.state     = state.write();
            so_far.wall_time = earlier_time + seconds_since(begun);
            keeper.keep(state.step, state.time, so_far.write());
            so_far.state = std::string();
            give_back_memory();
          }
      }

    private:
      /// At what has moved some time after the first slide.
      bool
      is_first_look_due() const
      {
        return !so_far.has_seen_slide && state.failure.failed() &&
               state.time >=
                 state.failure.time_of(FailureReading::any) + first_look;
      }

      const bool              inner_is_positive;
      const State<dim>       &state;
      Unfinished             &so_far;
      const Clock::time_point begun;
      const double            earlier_time; // s
      Keeper                 &keeper;
      bool                    is_due = false; // the moment is to be kept
    };
  } // namespace


  template <int dim>
  RealisationRunner<dim>::RealisationRunner(
    const Parameters             &parameters,
    const RandomFieldsParameters &fields,
    const unsigned int            attempts,
    const MPI_Comm                communicator,
    BalanceWatcher                watcher)
    : cases(parameters, attempts, communicator, std::move(watcher))
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
                                     Watcher         &watcher,
                                     const Interrupt &interrupt,
                                     State<dim>      &state,
                                     Unfinished      &so_far) const
  {
    const bool inner_is_positive =
      the_case.parameters.water.inner_direction() > 0;
    Record          &record = so_far.record;
    Realisation<dim> realisation(the_case, state);
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
        realisation.complete(); // to be measured
      }

    static_cast<FailureEvents &>(record) = state.failure;
    record.end_time                      = state.time;
    record.initial_width                 = state.failure.initial_width;
    record.initial_height                = state.failure.initial_height;
    record.residual_width                = state.failure.geometry.width;
    record.residual_height               = state.failure.geometry.height;
    record.inward  = moved_soil(state.points, inner_is_positive);
    record.outward = moved_soil(state.points, !inner_is_positive);
    if (!std::isnan(state.failure.geometry.width_z))
      record.residual_width_z = state.failure.geometry.width_z;
    if (!std::isnan(state.failure.geometry.height_z))
      record.residual_height_z = state.failure.geometry.height_z;
    if (the_case.parameters.sliding.watch)
      record.sliding_masses = state.sliding;
    if (!state.loads.empty())
      {
        record.load           = state.loads.front().factor;
        record.load_stop_time = state.loads.front().stop_time;
      }
    record.steps += state.step;
    record.newton_iterations += state.newton_iterations;
    record.linear_iterations += state.linear_iterations;
    record.unconverged_steps += state.unconverged_steps;
    if (state.failure.failed())
      record.trace = so_far.tracer.finish();
    return true;
  }


  template <int dim>
  std::optional<Record>
  RealisationRunner<dim>::run_attempts(
    const std::function<const double *()> &noise,
    const Interrupt                       &interrupt,
    Keeper                                &keeper)
  {
    const MPI_Comm            ranks = cases.first().grid.communicator();
    const Clock::time_point   start = Clock::now();
    Unfinished                so_far;
    std::optional<State<dim>> kept;
    if (std::optional<Unfinished> earlier =
          Unfinished::read(shared(keeper.earlier(), ranks)))
      if (earlier->attempt < cases.size())
        if ((kept = state_from<dim>(earlier->state)))
          so_far = std::move(*earlier);
    const double earlier_time = so_far.wall_time;

    bool interrupted = false;
    cases.until_it_works(
      [&](const Case<dim> &the_case, const unsigned int attempt) {
        State<dim> state = kept ? std::move(*kept) : initial_state(the_case);
        if (!kept)
          {
            // The work of all attempts counts, what came out only of the last.
            const Record before      = std::move(so_far.record);
            so_far                   = Unfinished();
            so_far.attempt           = attempt;
            Record &record           = so_far.record;
            record.attempts          = attempt + 1;
            record.steps             = before.steps;
            record.newton_iterations = before.newton_iterations;
            record.linear_iterations = before.linear_iterations;
            record.unconverged_steps = before.unconverged_steps;
            record.field_time        = before.field_time;

            const Clock::time_point field_start = Clock::now();
            try
              {
                random_properties.apply(noise(), state);
              }
            catch (const NumericalFailure &failure)
              {
                record.outcome     = Outcome::numerical_failure;
                record.stop_reason = failure.what();
                return false;
              }
            record.field_time += seconds_since(field_start);
            std::tie(record.mean_strength, record.least_strength) =
              random_properties.mean_and_least(state);
            record.random_fields     = random_properties.summaries(state);
            record.points_beyond_law = random_properties.n_beyond_law(state);
          }
        kept.reset();
        so_far.wall_time = earlier_time;
        RecordWatcher<dim> watcher(the_case.parameters.water.inner_direction() >
                                     0,
                                   state,
                                   so_far,
                                   start,
                                   keeper);
        interrupted = !record_run(the_case, watcher, interrupt, state, so_far);
        return interrupted ||
               so_far.record.outcome != Outcome::numerical_failure;
      },
      so_far.attempt);
    if (interrupted)
      return {};
    so_far.record.wall_time    = earlier_time + seconds_since(start);
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(ranks);
    if (n_ranks > 1)
      so_far.record.ranks = n_ranks;
    return std::move(so_far.record);
  }


  template <int dim>
  std::optional<Record>
  RealisationRunner<dim>::run(const double *noise, const Interrupt &interrupt)
  {
    Keeper nobody;
    return run_attempts([=]() { return noise; }, interrupt, nobody);
  }


  template <int dim>
  std::optional<Record>
  RealisationRunner<dim>::run(const std::uint64_t seed,
                              const std::uint64_t realisation,
                              const Interrupt    &interrupt,
                              Keeper             &keeper)
  {
    std::vector<double>   noise;
    std::optional<Record> record = run_attempts(
      [&]() {
        if (noise.empty())
          noise = realisation_noise(seed, realisation, n_noise());
        return noise.data();
      },
      interrupt,
      keeper);
    if (record)
      record->realisation = realisation;
    return record;
  }


  template class RealisationRunner<2>;
  template class RealisationRunner<3>;
} // namespace Waker
