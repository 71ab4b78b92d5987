// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_traction_parameters_h
#define waker_loads_traction_parameters_h

#include <waker/mapping/shape_functions.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  using namespace dealii;

  /// Where a traction acts, chapter 3 of Remmerswaal 2023.
  enum class TractionMethod
  {
    /// Equivalent loads of the points nearest to the surface (eqs. 3.1, 3.2),
    /// chosen at the start or in every step.
    fixed_points,
    updated_points,
    /// Between active and inactive cells (eq. 3.3).
    surface_nodes,
    /// The detected surface (eq. 3.4).
    proximity_field,
    /// A line or triangulation that moves with the material (eq. 3.4).
    user_surface,
    /// At the volume of the points in each cell; standard MPM, for bodies that
    /// lie along the grid (eq. 3.5).
    volume,
    /// The outline of the support domains (GIMP).
    contour
  };

  constexpr const char *
  name_of(const TractionMethod method)
  {
    switch (method)
      {
        case TractionMethod::fixed_points:
          return "fixed points";
        case TractionMethod::updated_points:
          return "updated points";
        case TractionMethod::surface_nodes:
          return "surface nodes";
        case TractionMethod::proximity_field:
          return "proximity field";
        case TractionMethod::user_surface:
          return "user surface";
        case TractionMethod::volume:
          return "volume";
        case TractionMethod::contour:
          return "contour";
      }
    return nullptr;
  }


  /// What the input of a traction must know of its method.
  struct MethodFacts
  {
    /// Are loads given to points? Then the surface may be the user's.
    bool on_points = false;
    /// ... which keep them.
    bool is_fixed = false;
    /// Is there something in its surface that a load can ride on?
    bool can_ride = false;
    /// Must the surface be the user's?
    bool needs_file = false;
    /// Does it fit the internal force of linear functions only?
    bool needs_linear = false;
  };

  MethodFacts
  facts_of(const TractionMethod method);


  /// What a traction is.
  enum class TractionKind
  {
    vector,     // in a constant direction
    pressure,   // against the outward normal
    hydrostatic // a pressure that grows below a level
  };

  constexpr const char *
  name_of(const TractionKind choice)
  {
    switch (choice)
      {
        case TractionKind::vector:
          return "vector";
        case TractionKind::pressure:
          return "pressure";
        case TractionKind::hydrostatic:
          return "hydrostatic";
      }
    return nullptr;
  }


  /// What carries the load once the soil moves.
  enum class TractionFollows
  {
    automatic, // see TractionParameters::rides()
    soil,      // the part that is selected at the start
    space      // what is in the box and faces that way now
  };

  constexpr const char *
  name_of(const TractionFollows choice)
  {
    switch (choice)
      {
        case TractionFollows::automatic:
          return "automatic";
        case TractionFollows::soil:
          return "soil";
        case TractionFollows::space:
          return "space";
      }
    return nullptr;
  }


  /// A traction as the user writes it: subsection "Tractions/<name>".
  struct TractionParameters
  {
    std::string name; // of the subsection

    TractionMethod method = TractionMethod::contour;
    /// File of the user's surface: in 2D lines of x, y, a blank line between
    /// chains; in 3D an STL or VTK triangulation. With loads on
    /// points it may say which surface the loads stand for; empty:
    /// the layers' outline.
    std::string surface_file;

    TractionKind kind = TractionKind::pressure;
    /// Of a vector (kPa): dim numbers or expressions; of a pressure: one.
    std::string value = "0";
    /// Level (m): a number, an expression of t (s), or a table "t0: y0, t1: y1,
    /// ..." with straight lines between its entries.
    std::string level;
    double      unit_weight = 10.; // kN/m^3

    /// Only the part of the surface within this box is loaded (m); empty: all.
    std::vector<double> from;
    std::vector<double> to;
    /// Only the part whose outward normal points this way, within `opening`
    /// degrees; empty: all.
    std::vector<double> facing;
    double              opening = 89.;
    TractionFollows     follows = TractionFollows::automatic;

    /// Proximity field, contour: are holes inside a body loaded, too? They
    /// are gaps that a liquid outside does not reach.
    bool holes = false;

    /// A node carries load only if its mass is at least this share of a full
    /// node's; 0: all do, and what falls on nodes without mass is lost.
    double minimum_support = 0.;

    /// How far the soil has consolidated under it, "degree" or "layer: degree,
    /// ..." (-); empty: it is not asked. See loads/quick_loads.h.
    std::string consolidation;
    /// To the vertical (degrees), for that.
    double spread = 0.;

    /// Does the part that is loaded at the start carry the load for ever?
    /// Automatic: if there is a box, for what is put on soil (vector and
    /// pressure), on a surface that points or vertices can carry. A liquid
    /// stays where it stands, and the faces of cells do not move.
    bool
    rides() const;

    /// Does the load go with the soil, in one way or another?
    bool
    goes_with_soil() const;

    /// Is there a surface of the user's?
    bool
    has_user_surface() const;

    void
    add_parameters(ParameterHandler &prm);

    /// @throws UserError "Tractions/<name>/..."
    void
    check(const unsigned int dim, const ShapeFunctions functions) const;
  };
} // namespace Waker

#endif
