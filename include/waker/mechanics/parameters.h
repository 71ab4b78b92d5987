// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_parameters_h
#define waker_mechanics_parameters_h

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  using namespace dealii;

  /// Section "Time stepping".
  struct TimeParameters
  {
    std::string scheme    = "Newmark"; // or "explicit", "quasi-static"
    double      time_step = 0.01;      // s (Newmark)
    double      end_time  = 40.;       // s
    /// The unbalanced force grows from 0 to full over this time (s); 0: off.
    double ramp_duration = 1.;
    /// A step that does not converge is halved at most this often.
    unsigned int maximum_halvings = 6;
    /// Explicit: time step as a share of h / (c_p + |v|).
    double courant_number = 0.5;
    /// Quasi-static: weight and loads grow from 0 to full over this time (s);
    /// 0: full from the start.
    double load_duration = 0.;
    /// Quasi-static: do the points move with the nodes, or stay in place?
    bool move_points = true;
    /// Quasi-static: stiffness of nodes that are hardly touched (see
    /// mechanics/ghost_stiffness.h), as a share of K + 4G/3; 0: none.
    double ghost_stiffness = 1e-4;

    void
    add_parameters(ParameterHandler &prm);
    /// @throws UserError "Time stepping/..."
    void
    check() const;
  };

  /// Section "Newton".
  struct NewtonParameters
  {
    std::string tangent = "consistent"; // or "double mapping"
    /// Converged when the mass-weighted norm of the residual is below this
    /// share of that of the external, internal and inertial forces together
    /// (see mechanics/newton.h).
    double       tolerance          = 1e-3;
    unsigned int maximum_iterations = 20;
    /// Relative accuracy of the linear solves (inexact Newton); they stop
    /// earlier where the tolerance above is reached.
    double       linear_tolerance          = 2e-3;
    unsigned int maximum_linear_iterations = 500;
    /// Start from v dt + a dt^2 / 2 instead of 0.
    bool predictor = true;

    void
    add_parameters(ParameterHandler &prm);
    /// @throws UserError "Newton/..."
    void
    check() const;
  };

  /// Section "Gravity".
  struct GravityParameters
  {
    double acceleration = 9.81; // m/s^2, along -y; 0: no weight
    /// Set up the in-situ stress by an elastic, quasi-static step with the
    /// points fixed in place, under weight and water.
    bool   initial_stress = true;
    double tolerance      = 1e-8; // of that step's residual

    /// The acceleration (m/s^2) that turns unit weight into density: a case
    /// without weight (a vibrating bar) has its mass all the same.
    double
    density_acceleration() const
    {
      return acceleration > 0. ? acceleration : 9.81;
    }

    void
    add_parameters(ParameterHandler &prm);
    /// @throws UserError "Gravity/..."
    void
    check() const;
  };

  /// Section "Kinematics and mapping".
  struct MappingParameters
  {
    std::string functions = "GIMP"; // or "linear"
    /// Strain at mid-step, stress turned with the body (Hughes & Winget
    /// 1980); off: small strain, no rotation.
    bool objective_rate = true;
    /// "step": the strain increment of each step (above); "logarithmic": Hencky
    /// strain of the elastic deformation since the start, with the internal
    /// force in the deformed configuration.
    std::string strain = "step";
    /// "standard", or "B-bar": the dilatation of the cells' centres (see
    /// MeanDilatationMotion).
    std::string volumetric_strain = "standard";
    /// Support domains: "constant", or "stretched" with the points' deformation
    /// (cpGIMP; Charlton et al. 2017).
    std::string domains = "constant";

    void
    add_parameters(ParameterHandler &prm);
    /// @throws UserError "Kinematics and mapping/..."
    void
    check() const;
  };

  /// What the time scheme and the other sections ask of each other.
  /// @throws UserError
  void
  check_time_scheme(const TimeParameters    &time,
                    const GravityParameters &gravity,
                    const MappingParameters &mapping);
} // namespace Waker

#endif
