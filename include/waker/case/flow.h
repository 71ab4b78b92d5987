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

  /**
   * What flows through the faces of the grid's box: points that pass an open
   * face are removed, others enter through inflows. Part of the case: what has
   * flowed so far is in the state (FlowAccount).
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
     *         grid's lines, an unknown material, a face that a boundary
     *         condition closes or that is both inflow and outflow
     */
    Flow(const BackgroundGrid<dim> &grid,
         const Materials           &materials,
         const Parameters          &parameters);

    bool
    is_used() const
    {
      return has_outflow || !feeders.empty();
    }

    /// Faces of the box through which material leaves or enters, by number (2d
    /// lower, 2d + 1 upper face in direction d).
    std::vector<bool>
    open_faces() const;

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
     */
    void
    exchange(const NodalState      &nodes,
             const StepReport<dim> &report,
             const double           dt,
             State<dim>            &state) const;

  private:
    /// Force on the body at the end of a step (kN).
    Tensor<1, dim>
    force(const NodalState      &nodes,
          const StepReport<dim> &report,
          const double           t) const;

    void
    remove(State<dim> &state) const;

    const BackgroundGrid<dim>    *grid;
    const Materials              *materials;
    SchemeTraits                  scheme;
    double                        ramp_duration;
    bool                          has_outflow;
    std::vector<bool>             outflow_faces;
    std::vector<unsigned int>     inflow_faces;
    std::vector<Feeder<dim>>      feeders;
    std::vector<FixityParameters> all_conditions;
  };
} // namespace Waker

#endif
