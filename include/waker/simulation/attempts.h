// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_simulation_attempts_h
#define waker_simulation_attempts_h

#include <waker/case/case.h>

#include <memory>
#include <vector>

namespace Waker
{
  /// The time step (s) of an attempt: halved as often.
  double
  time_step_of_attempt(const double time_step, const unsigned int attempt);

  /**
   * Make attempts until one does not fail numerically, or all are used up: the
   * one place that tries again.
   *
   * @param first number of the first attempt
   * @param n attempts in all
   * @param works makes the attempt of a number; false: it has failed
   * @return the number of the attempt that was made last
   */
  template <typename Attempt>
  unsigned int
  attempt_until_it_works(const unsigned int first,
                         const unsigned int n,
                         const Attempt     &works)
  {
    unsigned int attempt = first;
    while (!works(attempt) && attempt + 1 < n)
      ++attempt;
    return attempt;
  }


  /// A realisation that fails numerically is begun again with half the time
  /// step: the case of each attempt, made when it is first asked for.
  template <int dim>
  class Attempts
  {
  public:
    /// Makes the first case.
    /// @param n attempts in all, at least 1
    /// @param watcher of the initial stress of each; may be empty
    /// @throws UserError, NumericalFailure (of the gravity step)
    Attempts(const Parameters  &parameters,
             const unsigned int n,
             const MPI_Comm     communicator,
             BalanceWatcher     watcher = {});

    unsigned int
    size() const
    {
      return n;
    }

    const Case<dim> &
    first() const
    {
      return *cases[0];
    }

    /// The case with the time step halved `attempt` times.
    const Case<dim> &
    operator[](const unsigned int attempt);

    /// attempt_until_it_works() on these cases.
    /// @param works gets the case and the number of the attempt
    template <typename Attempt>
    unsigned int
    until_it_works(const Attempt &works, const unsigned int first = 0)
    {
      return attempt_until_it_works(first, n, [&](const unsigned int attempt) {
        return works((*this)[attempt], attempt);
      });
    }

  private:
    void
    add();

    Parameters                                    parameters;
    unsigned int                                  n;
    MPI_Comm                                      communicator;
    BalanceWatcher                                watcher;
    std::vector<std::unique_ptr<const Case<dim>>> cases;
  };
} // namespace Waker

#endif
