// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_realisation_runner_h
#define waker_campaign_realisation_runner_h

#include <waker/base/interrupt.h>
#include <waker/campaign/keeper.h>
#include <waker/campaign/random_properties.h>
#include <waker/simulation/attempts.h>
#include <waker/simulation/realisation.h>
#include <waker/store/record.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace Waker
{
  class Watcher;
  struct Unfinished;

  /**
   * A realisation as a function: white noise -> numbers. What a Monte Carlo
   * campaign, a subset simulation or a program of one's own calls.
   */
  template <int dim>
  class RealisationRunner
  {
  public:
    /**
     * @param attempts a realisation that fails numerically is begun again with
     *        half the time step, up to so many times in all
     * @param communicator of the ranks that compute a realisation together: all
     *        of them call each function
     * @param watcher of the initial stress, which is in balance before the
     * first realisation; may be empty
     * @throws UserError, NumericalFailure (of the gravity step)
     */
    RealisationRunner(const Parameters             &parameters,
                      const RandomFieldsParameters &fields,
                      const unsigned int            attempts,
                      const MPI_Comm                communicator,
                      BalanceWatcher                watcher = {});

    const Case<dim> &
    first_case() const
    {
      return cases.first();
    }

    const RandomProperties<dim> &
    properties() const
    {
      return random_properties;
    }

    /// Standard normal numbers that a realisation needs.
    std::size_t
    n_noise() const
    {
      return random_properties.n_noise();
    }

    /// The state at t = 0 of the realisation of this noise.
    State<dim>
    initial(const double *noise) const;

    /**
     * Run it to its end. `scenario` and `realisation` of the record are the
     * caller's.
     *
     * @param interrupt not 0: stop; may be null
     * @return nothing if interrupted
     */
    std::optional<Record>
    run(const double *noise, const Interrupt &interrupt);

    /// run() for realisation i of a campaign, with its realisation_noise().
    std::optional<Record>
    run(const std::uint64_t seed,
        const std::uint64_t realisation,
        const Interrupt    &interrupt)
    {
      Keeper nobody;
      return run(seed, realisation, interrupt, nobody);
    }

    /// The same.
    /// @param keeper what it has kept is gone on with; of several ranks that of
    ///        the first
    std::optional<Record>
    run(const std::uint64_t seed,
        const std::uint64_t realisation,
        const Interrupt    &interrupt,
        Keeper             &keeper);

  private:
    /// @param noise gives it when it is needed
    std::optional<Record>
    run_attempts(const std::function<const double *()> &noise,
                 const Interrupt                       &interrupt,
                 Keeper                                &keeper);

    /// @return false if interrupted
    bool
    record_run(const Case<dim> &the_case,
               Watcher         &watcher,
               const Interrupt &interrupt,
               State<dim>      &state,
               Unfinished      &so_far) const;

    Attempts<dim>         cases;
    RandomProperties<dim> random_properties;
  };
} // namespace Waker

#endif
