// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_parameters_h
#define waker_mechanics_parameters_h

#include <waker/mapping/shape_functions.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  using namespace dealii;

  /// Of the time steps: mechanics/time_scheme.h.
  enum class Scheme
  {
    newmark,
    explicit_steps,
    quasi_static,
    static_at_rest // quasi-static until it moves, then Newmark
  };

  constexpr const char *
  name_of(const Scheme choice)
  {
    switch (choice)
      {
        case Scheme::newmark:
          return "Newmark";
        case Scheme::explicit_steps:
          return "explicit";
        case Scheme::quasi_static:
          return "quasi-static";
        case Scheme::static_at_rest:
          return "quasi-static at rest";
      }
    return nullptr;
  }


  /// Section "Time stepping".
  struct TimeParameters
  {
    Scheme scheme    = Scheme::newmark;
    double time_step = 0.01; // s (Newmark)
    double end_time  = 40.;  // s
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
    /// Quasi-static at rest: longest step (s), and in it the largest change of
    /// the water's level (m) and the largest displacement of soil that rests
    /// (m).
    double longest_step         = 300.;
    double largest_rise         = 0.05;
    double largest_displacement = 0.01;

    void
    add_parameters(ParameterHandler &prm);
    /// @throws UserError "Time stepping/..."
    void
    check() const;
  };

  /// Of Newton's method.
  enum class Tangent
  {
    consistent,
    double_mapping
  };

  constexpr const char *
  name_of(const Tangent choice)
  {
    switch (choice)
      {
        case Tangent::consistent:
          return "consistent";
        case Tangent::double_mapping:
          return "double mapping";
      }
    return nullptr;
  }


  /// Section "Newton".
  struct NewtonParameters
  {
    Tangent tangent = Tangent::consistent;
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
    /// Share of weight and loads that the step applies (-), above 0, at most
    /// 1. The rest acts from the start of the run, on points that move and
    /// yield.
    double initial_share = 1.;

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

  /// What a law's strain is.
  enum class StrainMeasure
  {
    step,       // the strain increment of each step
    logarithmic // Hencky strain of the elastic deformation since
  };

  constexpr const char *
  name_of(const StrainMeasure choice)
  {
    switch (choice)
      {
        case StrainMeasure::step:
          return "step";
        case StrainMeasure::logarithmic:
          return "logarithmic";
      }
    return nullptr;
  }


  /// Of GIMP.
  enum class SupportDomains
  {
    constant,
    stretched // with the deformation (cpGIMP; Charlton et al. 2017)
  };

  constexpr const char *
  name_of(const SupportDomains choice)
  {
    switch (choice)
      {
        case SupportDomains::constant:
          return "constant";
        case SupportDomains::stretched:
          return "stretched";
      }
    return nullptr;
  }


  /// Where the dilatation of a point comes from.
  enum class VolumetricStrain
  {
    standard,        // the point
    b_bar,           // the cells' centres, where soil fills them
    b_bar_everywhere // the cells' centres
  };

  constexpr const char *
  name_of(const VolumetricStrain choice)
  {
    switch (choice)
      {
        case VolumetricStrain::standard:
          return "standard";
        case VolumetricStrain::b_bar:
          return "B-bar";
        case VolumetricStrain::b_bar_everywhere:
          return "B-bar in all cells";
      }
    return nullptr;
  }


  /// Section "Kinematics and mapping".
  struct MappingParameters
  {
    ShapeFunctions functions = ShapeFunctions::gimp;
    /// Strain at mid-step, stress turned with the body (Hughes & Winget
    /// 1980); off: small strain, no rotation.
    bool objective_rate = true;
    /// Logarithmic: with the internal force in the deformed configuration.
    StrainMeasure  strain  = StrainMeasure::step;
    SupportDomains domains = SupportDomains::constant;
    /// B-bar: see MeanDilatationMotion.
    VolumetricStrain volumetric_strain = VolumetricStrain::standard;

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
