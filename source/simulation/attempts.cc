// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/simulation/attempts.h>

#include <cmath>
#include <utility>

namespace Waker
{
  double
  time_step_of_attempt(const double time_step, const unsigned int attempt)
  {
    return std::ldexp(time_step, -static_cast<int>(attempt));
  }


  template <int dim>
  Attempts<dim>::Attempts(const Parameters  &parameters,
                          const unsigned int n,
                          const MPI_Comm     communicator,
                          BalanceWatcher     watcher)
    : parameters(parameters)
    , n(n)
    , communicator(communicator)
    , watcher(std::move(watcher))
  {
    add();
  }


  template <int dim>
  void
  Attempts<dim>::add()
  {
    Parameters smaller = parameters;
    smaller.time.time_step =
      time_step_of_attempt(parameters.time.time_step, cases.size());
    cases.push_back(std::make_unique<const Case<dim>>(
      smaller, communicator, Materials(), watcher));
  }


  template <int dim>
  const Case<dim> &
  Attempts<dim>::operator[](const unsigned int attempt)
  {
    AssertIndexRange(attempt, n);
    while (cases.size() <= attempt)
      add();
    return *cases[attempt];
  }


  template class Attempts<2>;
  template class Attempts<3>;
} // namespace Waker
