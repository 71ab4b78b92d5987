// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_control_parameters_h
#define waker_control_parameters_h

#include <waker/measures/failure_record.h>

#include <optional>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  using namespace dealii;

  /// Section "Initial failure": when a slide counts (all readings recorded).
  struct InitialFailureParameters
  {
    InitialFailureLimits limits;

    void
    add_parameters(ParameterHandler &prm);
    /// @throws UserError "Initial failure/..."
    void
    check() const;
  };

  /// Section "Sliding masses": slides while they happen.
  struct SlidingMassParameters
  {
    bool   watch        = true;
    double displacement = 0.2; // |u| of stable soil at most, m
    /// x of the crest's edge (m), or "detected".
    std::string crest_edge = "detected";

    /// The x that is given, if one is.
    /// @throws UserError "Sliding masses/Crest edge"
    std::optional<double>
    given_edge() const;

    void
    add_parameters(ParameterHandler &prm);
    /// @throws UserError "Sliding masses/..."
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
    /// Stop at initial failure (strength reduction does), in this reading.
    bool           on_initial_failure = false;
    FailureReading reading            = FailureReading::any;
    /// The user's word that no load that is an expression of t changes after
    /// this time (s), or "unknown".
    std::string loads_constant_from = "unknown";

    /// `loads_constant_from` (s); LastChange::unknown if it is not known.
    /// @throws UserError "Stop rules/Loads constant from"
    double
    declared_last_change() const;

    void
    add_parameters(ParameterHandler &prm);
    /// @throws UserError "Stop rules/..."
    void
    check() const;
  };
} // namespace Waker

#endif
