// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_case_initial_stress_parameters_h
#define waker_case_initial_stress_parameters_h

#include <waker/base/errors.h>

#include <optional>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  using namespace dealii;

  struct Parameters;

  /// What the stress in the ground is before it is brought into balance.
  enum class StressFrom
  {
    gravity, // none
    k0       // vertical stress of columns, horizontally K0 times as much
  };

  constexpr const char *
  name_of(const StressFrom choice)
  {
    switch (choice)
      {
        case StressFrom::gravity:
          return "gravity";
        case StressFrom::k0:
          return "K0";
      }
    return nullptr;
  }


  /// The laws with which it is brought into balance.
  enum class BalanceLaws
  {
    elastic, // one linear step (gravity_step.h); it may lie beyond strengths
    plastic  // load steps of the soil as it is (balance_step.h)
  };

  constexpr const char *
  name_of(const BalanceLaws choice)
  {
    switch (choice)
      {
        case BalanceLaws::elastic:
          return "elastic";
        case BalanceLaws::plastic:
          return "plastic";
      }
    return nullptr;
  }


  /// Section "Initial stress".
  struct InitialStressParameters
  {
    StressFrom   from  = StressFrom::gravity;
    BalanceLaws  laws  = BalanceLaws::elastic;
    unsigned int steps = 10; // of what is out of balance; plastic laws
    /// Is there a stage before, of the water of usual days?
    bool daily_stage = false;
    /// Level (m) of the water outside in it, or "none"; empty: not said.
    std::string daily_level;

    /// Of the daily stage; none: no water stands outside.
    std::optional<double>
    level() const;

    /// Is it what a gravity step alone does?
    bool
    is_gravity_step() const
    {
      return from == StressFrom::gravity && laws == BalanceLaws::elastic &&
             !daily_stage;
    }

    void
    add_parameters(ParameterHandler &prm);

    /// @throws UserError "Initial stress/..."
    void
    check() const;
  };


  /// The case as it stands on usual days: with the daily water outside and in
  /// the ground, without tractions, point loads and load programmes.
  Parameters
  daily_stage(const Parameters &parameters);

  /// What the case as it stands on usual days is refused for, as the case is:
  /// a soil keeps its place, the daily stage is named with it.
  UserError
  in_daily_stage(const UserError &error);

  /// What the section and the others ask of each other.
  /// @throws UserError
  void
  check_initial_stress(const Parameters &parameters);
} // namespace Waker

#endif
