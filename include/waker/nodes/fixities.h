// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_nodes_fixities_h
#define waker_nodes_fixities_h

#include <waker/grid/background_grid.h>
#include <waker/grid/box_face.h>
#include <waker/particles/openings.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  /// The nodes of a condition: a face of the grid's box, or those in a box.
  enum class FixityRegion
  {
    left,
    right,
    bottom,
    top,
    back,
    front,
    box
  };

  constexpr const char *
  name_of(const FixityRegion choice)
  {
    switch (choice)
      {
        case FixityRegion::left:
          return "left";
        case FixityRegion::right:
          return "right";
        case FixityRegion::bottom:
          return "bottom";
        case FixityRegion::top:
          return "top";
        case FixityRegion::back:
          return "back";
        case FixityRegion::front:
          return "front";
        case FixityRegion::box:
          return "box";
      }
    return nullptr;
  }

  constexpr FixityRegion
  region_of(const BoxFace face)
  {
    return static_cast<FixityRegion>(face); // the faces come first
  }


  /// What a condition holds.
  enum class FixityType
  {
    fixed,     // all components
    roller,    // the one normal to the face
    prescribed // those with a displacement
  };

  constexpr const char *
  name_of(const FixityType choice)
  {
    switch (choice)
      {
        case FixityType::fixed:
          return "fixed";
        case FixityType::roller:
          return "roller";
        case FixityType::prescribed:
          return "prescribed";
      }
    return nullptr;
  }


  /// How a condition holds.
  enum class FixityMethod
  {
    elimination, // removes the equations
    penalty      // adds a stiff spring
  };

  constexpr const char *
  name_of(const FixityMethod choice)
  {
    switch (choice)
      {
        case FixityMethod::elimination:
          return "elimination";
        case FixityMethod::penalty:
          return "penalty";
      }
    return nullptr;
  }


  /**
   * One boundary condition as the user writes it: a set of nodes, the
   * components it holds, and how. Subsection "Boundary conditions/<name>".
   */
  struct FixityParameters
  {
    std::string name; // of the subsection

    /// A face also holds the margin beyond it.
    FixityRegion region = FixityRegion::bottom;
    /// Limits the region: nodes outside [from, to] (m) are left free. A face is
    /// limited along its own directions only, not in the normal one. For a
    /// box it is the region, and both are needed. Empty: no limit.
    std::vector<double> from;
    std::vector<double> to;
    /// Roller: not for a box.
    FixityType type = FixityType::fixed;
    /// If prescribed: per component an expression (m) of the node's place x,
    /// y, z (m) and of t (s), or "free". For example "0.1*t; free".
    std::string  displacement;
    FixityMethod method = FixityMethod::elimination;
    /// Spring stiffness of a node, as a multiple of (K + 4G/3) h^(dim-2)
    /// (kPa m^(dim-2)).
    double penalty_factor = 1e4;

    /// Of each component: the expression that prescribes its displacement;
    /// none if it is free. Of `displacement`, whatever the type.
    std::vector<std::optional<std::string>>
    expressions() const;

    /// Is this component of its nodes held?
    bool
    holds(const unsigned int component) const;

    void
    add_parameters(ParameterHandler &prm);

    /// @throws UserError with path "Boundary conditions/<name>/...": a region,
    /// type or limit that the others or `dim` do not allow
    void
    check(const unsigned int dim) const;
  };

  /**
   * All fixities of the grid, ready for the time loop.
   *
   * Displacements are total displacements since t = 0; a step from t to t + dt
   * prescribes the increment u(t + dt) - u(t).
   *
   * Where conditions meet in a dof, elimination wins over penalty, and then the
   * later condition over the earlier one.
   *
   * The increments are evaluated with one parser per expression: not for
   * several threads at a time.
   */
  template <int dim>
  class Fixities
  {
  public:
    /// @param openings the parts of faces through which soil leaves: see
    ///        closed_faces()
    /// @throws UserError if a region holds no node or an expression is wrong
    Fixities(const BackgroundGrid<dim>           &grid,
             const std::vector<FixityParameters> &parameters,
             const Openings<dim>                 &openings);

    /// Without openings.
    Fixities(const BackgroundGrid<dim>           &grid,
             const std::vector<FixityParameters> &parameters)
      : Fixities(grid, parameters, Openings<dim>(grid))
    {}

    /// Those of a window: removed are the equations of all of its nodes,
    /// springs are those of the nodes that this rank owns. The faces that are
    /// closed are those of the whole grid.
    Fixities(const Fixities            &whole,
             const BackgroundGrid<dim> &whole_grid,
             const BackgroundGrid<dim> &window);

    ~Fixities();
    Fixities(Fixities &&);

    /// Is the equation of this dof removed? One byte per dof: 1 = removed.
    const std::vector<unsigned char> &
    removed() const
    {
      return removed_dofs;
    }

    /// The removed dofs, ascending.
    const std::vector<unsigned int> &
    removed_list() const
    {
      return removed_dof_list;
    }

    struct Penalty
    {
      unsigned int dof;
      double       factor; // FixityParameters::penalty_factor
    };

    /// Dofs held by penalty springs, ascending.
    const std::vector<Penalty> &
    penalties() const
    {
      return penalty_dofs;
    }

    /// Does the whole grid have such dofs? Each rank knows, also one that has
    /// none of them.
    bool
    has_penalties() const
    {
      return penalties_exist;
    }

    /// Does anything move, that is, does a displacement depend on time?
    bool
    has_prescribed_motion() const
    {
      return moves;
    }

    /// The last time at which one of them moves (s): see LastChange.
    double
    last_change() const;

    /// The path of one that moves between two times; empty if none does.
    std::string
    varying(const double from, const double to) const;

    /// Increments u(t + dt) - u(t) of the removed dofs (in the order of
    /// removed_list()), m. All zero, and cheap, where nothing moves.
    void
    removed_increments(const double         t,
                       const double         dt,
                       std::vector<double> &increments) const;

    /// The same for the penalty dofs, in the order of penalties().
    void
    penalty_increments(const double         t,
                       const double         dt,
                       std::vector<double> &increments) const;

    /// Faces of the box that are closed: each of their nodes is held at rest in
    /// the normal direction, or lies in an opening beside those that are: where
    /// a face is open in a part, the box ends there, not the soil. Bit 2d for
    /// the lower, 2d + 1 for the upper face in direction d. The proximity field
    /// is mirrored there.
    unsigned int
    closed_faces() const
    {
      return closed_face_bits;
    }

  private:
    struct Motion;

    std::vector<unsigned char> removed_dofs;
    std::vector<unsigned int>  removed_dof_list;
    std::vector<Penalty>       penalty_dofs;
    bool                       penalties_exist  = false;
    bool                       moves            = false;
    unsigned int               closed_face_bits = 0;
    std::unique_ptr<Motion>    motion;
  };
} // namespace Waker

#endif
