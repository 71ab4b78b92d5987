// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_case_flow_h
#define waker_case_flow_h

#include <waker/case/parameters.h>
#include <waker/mechanics/stress_update.h>
#include <waker/mechanics/time_scheme.h>
#include <waker/nodes/fixities.h>
#include <waker/particles/feeder.h>

#include <vector>

namespace Waker
{
  template <int dim>
  struct State;

  template <int dim>
  class RankPart;

  /**
   * What flows through the faces of the grid's box: points that pass the open
   * part of a face are removed, others enter through inflows. Part of the case:
   * what has flowed so far is in the state (FlowAccount).
   *
   * An inflow is pushed: the nodes of its opening, on the face and in the
   * margin, move into the box at its velocity, and hold the other components.
   */
  template <int dim>
  class Flow
  {
  public:
    /**
     * @throws UserError "Outflow/..." or "Inflow/...": an opening off the
     *         grid's lines, an unknown material, a part of a face that is both
     *         open and held by a boundary condition, or both inflow and outflow
     */
    Flow(const BackgroundGrid<dim> &grid,
         const Materials           &materials,
         const Parameters          &parameters);

    bool
    is_used() const
    {
      return !outlets.empty() || !feeders.empty();
    }

    bool
    has_inflow() const
    {
      return !feeders.empty();
    }

    /// The parts of the box's faces through which material leaves or enters.
    const Openings<dim> &
    openings() const
    {
      return all_openings;
    }

    /// Those through which it leaves.
    const Openings<dim> &
    outflow() const
    {
      return outlets;
    }

    /// The boundary conditions of the parameters, and those that move the
    /// nodes of the inflows. At the edge of an opening the inflow wins.
    const std::vector<FixityParameters> &
    conditions() const
    {
      return all_conditions;
    }

    /// Put the material in front of the inflows.
    void
    fill(MaterialPoints<dim> &points) const;

    /// Open the state's account.
    void
    start(State<dim> &state) const;

    /**
     * After a step: account for its impulse, remove what has passed an open
     * face and let in what is due. The state's time is that of its end.
     *
     * @param nodes, report of the step, which took dt (s)
     * @param part on several ranks that of this one, to which the nodes belong;
     *        else nullptr
     */
    void
    exchange(const NodalState      &nodes,
             const StepReport<dim> &report,
             const double           dt,
             State<dim>            &state,
             RankPart<dim>         *part) const;

  private:
    void
    add_outlet(const OpeningParameters &parameters,
               const std::string       &path,
               const std::string       &where);

    void
    add_inflow(const InflowParameters &inflow, const Parameters &parameters);

    /// The condition that holds the motion through a part of an opening; none:
    /// nullptr.
    const FixityParameters *
    holder_of(const Opening<dim> &opening) const;

    /// Force on the body at the end of a step (kN).
    Tensor<1, dim>
    force(const NodeExchange    &ranks,
          const NodalState      &nodes,
          const StepReport<dim> &report,
          const double           t) const;

    /// What has passed an open face leaves.
    void
    remove(State<dim> &state, RankPart<dim> *part) const;

    /// What is due comes in.
    void
    feed(State<dim> &state, RankPart<dim> *part) const;

    const BackgroundGrid<dim>    *grid;
    const Materials              *materials;
    SchemeTraits                  scheme;
    double                        ramp_duration;
    Openings<dim>                 outlets;
    Openings<dim>                 all_openings;
    std::vector<Feeder<dim>>      feeders;
    std::vector<FixityParameters> all_conditions;
  };
} // namespace Waker

#endif
