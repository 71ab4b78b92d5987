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

  /// Section "Outflow".
  struct OutflowParameters
  {
    /// Faces of the grid's box through which points leave: "left, right, ...";
    /// empty: none, and soil that gets there ends the run.
    std::string faces;

    void
    add_parameters(ParameterHandler &prm);

    /// One flag per face (2d lower, 2d + 1 upper face in direction d).
    /// @throws UserError "Outflow/Faces"
    std::vector<bool>
    open_faces(const unsigned int dim) const;
  };

  /// Material that enters: subsection "Inflow/<name>".
  struct InflowParameters
  {
    std::string name; // of the subsection
    BoxFace     face = BoxFace::left;
    std::string material; // one of Materials/Names
    /// The opening: from .. to (m), along the face's own directions only;
    /// empty: the whole face.
    std::vector<double> from;
    std::vector<double> to;
    double              velocity = 0.; // m/s, into the box, constant

    void
    add_parameters(ParameterHandler &prm);

    /// Number of the face: 2d lower, 2d + 1 upper face in direction d.
    unsigned int
    face_number() const
    {
      return static_cast<unsigned int>(face);
    }

    /// What needs no other section: face, lengths, order, velocity.
    /// @throws UserError "Inflow/<name>/..."
    void
    check(const unsigned int dim) const;
  };
} // namespace Waker

#endif
