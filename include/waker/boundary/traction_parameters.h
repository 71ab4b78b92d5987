// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_boundary_traction_parameters_h
#define waker_boundary_traction_parameters_h

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  using namespace dealii;

  /// A traction as the user writes it: subsection "Tractions/<name>".
  struct TractionParameters
  {
    std::string name; // of the subsection

    /// Where it acts, chapter 3 of Remmerswaal 2023:
    ///   "fixed points", "updated points": equivalent loads of the points
    ///     nearest to the surface (eqs. 3.1, 3.2), chosen at the start or in
    ///     every step
    ///   "surface nodes": between active and inactive cells (eq. 3.3)
    ///   "proximity field": the detected surface (eq. 3.4)
    ///   "user surface": a line or triangulation that moves with the material
    ///     (eq. 3.4)
    ///   "volume": at the volume of the points in each cell; standard MPM, for
    ///     bodies that lie along the grid (eq. 3.5)
    ///   "contour": the outline of the support domains (GIMP)
    std::string method = "contour";
    /// File of the user's surface: in 2D lines of x, y, a blank line between
    /// chains; in 3D an STL or VTK triangulation. With "fixed points" and
    /// "updated points" it may say which surface the loads stand for; empty:
    /// the layers' outline.
    std::string surface_file;

    /// "vector": `value` (kPa), dim numbers or expressions of t; "pressure":
    /// `value` (kPa) against the normal; "hydrostatic": unit_weight times the
    /// depth below `level`.
    std::string kind  = "pressure";
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
    /// What carries the load once the soil moves. "soil": the part that is
    /// selected at the start, wherever it goes (boundary/riding_load.h);
    /// "space": what is in the box and faces that way now; "automatic": see
    /// rides().
    std::string follows = "automatic";

    /// "proximity field", "contour": are holes inside a body loaded, too? They
    /// are gaps that a liquid outside does not reach.
    bool holes = false;

    /// A node carries load only if its mass is at least this share of a full
    /// node's; 0: all do, and what falls on nodes without mass is lost.
    double minimum_support = 0.;

    /// Does the part that is loaded at the start carry the load for ever?
    /// "automatic": if there is a box, for what is put on soil (vector and
    /// pressure), on a surface that points or vertices can carry. A liquid
    /// stays where it stands, and the faces of cells do not move.
    bool
    rides() const;

    void
    add_parameters(ParameterHandler &prm);

    /// @throws UserError "Tractions/<name>/..."
    void
    check(const unsigned int dim, const std::string &functions) const;
  };
} // namespace Waker

#endif
