// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_simulation_attempts_h
#define waker_simulation_attempts_h

#include <waker/simulation/case.h>

#include <memory>
#include <vector>

namespace Waker
{
  /// A realisation that fails numerically is begun again with half the time
  /// step: the case of each attempt, made when it is first asked for.
  template <int dim>
  class Attempts
  {
  public:
    /// Makes the first case.
    /// @param n attempts in all, at least 1
    /// @throws UserError, NumericalFailure (of the gravity step)
    Attempts(const Parameters  &parameters,
             const unsigned int n,
             const MPI_Comm     communicator);

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

  private:
    void
    add();

    Parameters                                    parameters;
    unsigned int                                  n;
    MPI_Comm                                      communicator;
    std::vector<std::unique_ptr<const Case<dim>>> cases;
  };
} // namespace Waker

#endif
