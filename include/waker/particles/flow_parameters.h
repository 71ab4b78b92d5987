// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_flow_parameters_h
#define waker_particles_flow_parameters_h

#include <waker/grid/box_face.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  using namespace dealii;

  /// A part of a face of the grid's box through which material goes.
  struct OpeningParameters
  {
    std::string name; // of the subsection
    BoxFace     face = BoxFace::left;
    /// It reaches from .. to (m), along the face's own directions only; empty:
    /// the whole face.
    std::vector<double> from;
    std::vector<double> to;

    /// Number of the face: 2d lower, 2d + 1 upper face in direction d.
    unsigned int
    face_number() const
    {
      return static_cast<unsigned int>(face);
    }

  protected:
    /// @param purpose of the face, for the documentation
    void
    add_opening_parameters(ParameterHandler &prm, const std::string &purpose);

    /// What needs no other section: face, lengths, order.
    /// @throws UserError "<section>/<name>/..."
    void
    check_opening(const std::string &section, const unsigned int dim) const;
  };


  /// A part of a face through which points leave: subsection "Outflow/<name>".
  struct OutletParameters : OpeningParameters
  {
    void
    add_parameters(ParameterHandler &prm);

    /// @throws UserError "Outflow/<name>/..."
    void
    check(const unsigned int dim) const;
  };


  /// Section "Outflow".
  struct OutflowParameters
  {
    /// Faces of the grid's box through which points leave: "left, right, ...";
    /// empty: none but the outlets, and soil that gets there ends the run.
    std::string faces;

    void
    add_parameters(ParameterHandler &prm);

    /// One flag per face (2d lower, 2d + 1 upper face in direction d).
    /// @throws UserError "Outflow/Faces"
    std::vector<bool>
    open_faces(const unsigned int dim) const;
  };

  /// Material that enters: subsection "Inflow/<name>".
  struct InflowParameters : OpeningParameters
  {
    std::string material;      // one of Materials/Names
    double      velocity = 0.; // m/s, into the box, constant

    void
    add_parameters(ParameterHandler &prm);

    /// What needs no other section: opening, velocity.
    /// @throws UserError "Inflow/<name>/..."
    void
    check(const unsigned int dim) const;
  };
} // namespace Waker

#endif
