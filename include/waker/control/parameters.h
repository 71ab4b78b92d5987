// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_control_parameters_h
#define waker_control_parameters_h

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  using namespace dealii;

  /// Section "Initial failure": when a slide counts (both readings recorded).
  struct InitialFailureParameters
  {
    double width_change = 0.3; // m
    double height_loss  = 0.1; // m

    void
    add_parameters(ParameterHandler &prm);
    /// @throws UserError "Initial failure/..."
    void
    check() const;
  };

  /// Section "Stop rules".
  struct StopParameters
  {
    bool on_flooding = true;
    bool at_rest     = true;
    /// Both must be below their limit for `rest_duration`:
    double rest_plastic_strain = 1e-6; // mean increment per step
    double rest_velocity       = 0.05; // rms displacement rate, m/s
    double rest_duration       = 1.;   // s
    /// Stop at initial failure (strength reduction does).
    bool on_initial_failure = false;

    void
    add_parameters(ParameterHandler &prm);
    /// @throws UserError "Stop rules/..."
    void
    check() const;
  };
} // namespace Waker

#endif
