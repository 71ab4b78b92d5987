// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_nodes_wall_h
#define waker_nodes_wall_h

#include <waker/base/expression.h>
#include <waker/grid/background_grid.h>
#include <waker/nodes/resistance.h>
#include <waker/nodes/wall_gaps.h>
#include <waker/nodes/wall_law.h>
#include <waker/nodes/wall_parameters.h>

#include <string>
#include <vector>

namespace Waker
{
  /**
   * Walls and rigid footings off the grid: displacements that are prescribed on
   * a surface which crosses the cells.
   *
   * A wall is a bed of springs between soil and wall, of stiffness
   * k = f (K + 4G/3) / h per area, f the penalty factor. Weak form: the sum
   * over the spots q, small pieces of the wall that move with it, of
   *   N_i(x_q) t_q(w_q) A_q,   w_q = sum_j N_j(x_q) u_j - g,
   * u and g the displacements of soil and wall in the step, t_q the traction of
   * the law (WallLaw): rough, smooth or frictional. It is carried from step to
   * step, so that a loaded wall does not creep. Rough and smooth walls hold:
   * soil that touches them can be pulled. A frictional one pushes only.
   *
   * A spot of a frictional wall acts where the soil is less than half a cell
   * away, by the support domains of the points (WallGaps): once it has closed
   * the gap. While it carries a pressure it needs no gap to be known, and keeps
   * it until the soil is pulled away or has gone.
   *
   * Others act where there is soil: if the share of a full node's mass, the
   * nodes' linear interpolation, is at least contact_share. On a flat surface
   * that share is 0.45 to 0.55, by its place on the grid, at an edge of 90
   * degrees the square of that and at a corner its cube: the least of these is
   * the limit. Soil is held from a distance of 0.4 h or so. Where there is
   * none, the traction is forgotten.
   *
   * A node that the soil does not reach (less than weak_share) would give way
   * to any force, and the wall would hold nothing. Its displacement is
   * therefore taken to be the linear continuation of those of the next two
   * nodes inwards, and its force goes to them: resultant, moment and linear
   * fields are kept. A node that the soil touches, be it by a sliver, is left
   * alone: where the support domains end at the wall, its share of the traction
   * is what the internal force needs.
   *
   * Work space: made once, used in every step.
   */
  template <int dim>
  class Walls : public Resistance<dim>
  {
  public:
    static constexpr double contact_share = dim == 2 ? 0.2 : 0.09;
    static constexpr double weak_share    = 1e-6;
    /// Soil that a frictional wall may meet in a step, and soil that has gone
    /// though the spot has not felt it go: gaps, in cells.
    static constexpr double reach = 0.5, lost = 0.25;

    /// What a wall carries from step to step, and a state keeps: tractions on
    /// the soil (kPa) in all spots.
    using Tractions = std::vector<Tensor<1, dim>>;

    /**
     * @param grid on several ranks the window of this one, which deals with the
     *        spots in its own cells
     * @param modulus the stiffest K + 4G/3 (kPa)
     * @param full_node_mass mass of a node inside the body (Mg)
     * @throws UserError "Walls/<name>/..."
     */
    Walls(const BackgroundGrid<dim>         &grid,
          const std::vector<WallParameters> &parameters,
          const double                       modulus,
          const double                       full_node_mass);

    bool
    empty() const
    {
      return spots.empty();
    }

    std::size_t
    n_spots() const
    {
      return spots.size();
    }

    /// Where the walls stand at time t (s) and which of their spots touch soil.
    /// @param points of which node_mass is; on several ranks those of this one
    /// @param tractions of all spots; those without contact are set to zero.
    ///        accept() writes those at the end of a step here: they must live
    ///        until then.
    void
    reinit(const MaterialPoints<dim> &points,
           const std::vector<double> &node_mass,
           const double               t,
           Tractions                 &tractions);

    /// As the soil lies at the start.
    /// @throws UserError "Walls/<name>/Line" if it lies behind a frictional
    ///         wall
    void
    check_start() const;

    /// The numbers of those that no soil touches.
    std::vector<unsigned int>
    idle() const;

    /// Can soil slide along one of them against friction?
    bool
    have_friction() const
    {
      return !one_sided.empty();
    }

    /// The step from t to t + dt, in which the walls move from u(t) to
    /// u(t + dt). Without it they stand still.
    void
    set_step(const double t, const double dt);

    /// The last time at which one of them moves (s): see LastChange.
    double
    last_change() const;

    /// The path of one that moves between two times; empty if none does.
    std::string
    varying(const double from, const double to) const;

    typename Resistance<dim>::Role
    role() const override
    {
      return Resistance<dim>::Role::load;
    }

    void
    begin(const MaterialPoints<dim> &points,
          const NodalState          &nodes,
          const double               t,
          const double               dt) override
    {
      (void)points;
      (void)nodes;
      set_step(t, dt);
    }

    /// internal -= the force of the walls for an increment (kN)
    void
    add_force(const NodalVector &increment, NodalVector &internal) override;

    void
    add_start_force(NodalVector &internal) override;

    void
    linearise() override;

    bool
    has_corners() const override;

    bool
    is_symmetric() const override;

    void
    vmult_add(NodalVector &dst, const NodalVector &src) const override;

    void
    add_diagonal(NodalVector &diagonal) const override;

    /// Of what slides without what the pressure adds to friction.
    void
    add_entries(MatrixEntries &entries) const override;

    /// Take the tractions at the end of a step.
    Tensor<1, dim>
    accept(const NodalVector &increment, MaterialPoints<dim> &points) override;

    ResistanceWork
    work(const NodalVector &increment) const override;

    /// Force of the wall of this number on the soil, with these tractions (kN).
    Tensor<1, dim>
    force(const unsigned int wall, const Tractions &tractions) const;

    /// A piece of a wall.
    struct Spot
    {
      unsigned int   wall;      // number
      Point<dim>     reference; // place at t = 0, m
      Point<dim>     position;  // m
      Tensor<1, dim> normal;    // into the soil
      double         area;      // m^(dim-1)
      bool           touches;   // soil
      double         gap;       // to the soil, m, of a frictional wall
    };

    const std::vector<Spot> &
    all_spots() const
    {
      return spots;
    }

    const std::vector<std::string> &
    names() const
    {
      return wall_names;
    }

  private:
    struct Wall
    {
      WallLaw<dim>                 law;
      std::vector<Expression<dim>> motion; // none: at rest
      Tensor<1, dim>               target; // g of the step, m
    };

    /// A spot with soil: its nodes are nodes[begin..end).
    struct Contact
    {
      std::size_t                  spot;
      std::size_t                  begin, end;
      typename WallLaw<dim>::Start start;
      Tensor<1, dim>               motion;     // w of the last force, m
      Tensor<2, dim>               derivative; // kPa/m
    };

    /// Displacement of a wall at t (m).
    Tensor<1, dim>
    displacement(const Wall &wall, const double t) const;

    /// What each rank has found of its own spots is told to all.
    void
    share_contacts(Tractions &tractions);

    /// The gaps of the frictional walls' spots.
    void
    find_gaps(const MaterialPoints<dim> &points);

    /// Is there soil at a spot that may carry a traction already? By its gap;
    /// `share` is that of a full node's mass.
    bool
    has_soil(const Spot           &spot,
             const double          share,
             const Tensor<1, dim> &traction) const;

    /// Append the nodes and weights of a spot. False if it has no soil.
    bool
    find_nodes(const Spot                &spot,
               const std::vector<double> &node_mass,
               const Tensor<1, dim>      &traction);

    /// Give the weight of a node without mass to those behind it.
    void
    hand_inwards(const unsigned int         node,
                 const unsigned int         corner,
                 const double               weight,
                 const Spot                &spot,
                 const std::vector<double> &node_mass);

    /// sum_i N_i u_i
    Tensor<1, dim>
    value(const Contact &contact, const NodalVector &u) const;

    const WallLaw<dim> &
    law(const Contact &contact) const
    {
      return walls[spots[contact.spot].wall].law;
    }

    /// w: the motion of soil relative to the wall (m).
    Tensor<1, dim>
    motion(const Contact &contact, const NodalVector &increment) const;

    /// internal -= a traction's share
    void
    scatter(const Contact        &contact,
            const Tensor<1, dim> &traction,
            NodalVector          &internal) const;

    /// Traction at the end of the step (kPa).
    Tensor<1, dim>
    traction(const Contact &contact, const NodalVector &increment) const;

    const BackgroundGrid<dim> *grid;
    const NodeExchange        *ranks; // that share the contacts
    double                     full_node_mass;
    std::vector<std::string>   wall_names;
    std::vector<Wall>          walls;
    std::vector<Spot>          spots;
    std::vector<Contact>       contacts;
    std::vector<unsigned int>  nodes;             // of the contacts
    std::vector<double>        weights;           // likewise
    Tractions                 *carried = nullptr; // from step to step
    bool                       slides  = false;   // in the derivative
    // Of frictional walls:
    std::vector<std::size_t> one_sided; // numbers of their spots
    WallGaps<dim>            wall_gaps;
    std::vector<double>      gaps; // of one_sided, m
  };
} // namespace Waker

#endif
