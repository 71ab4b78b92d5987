// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_simulation_realisation_h
#define waker_simulation_realisation_h

#include <waker/case/case.h>
#include <waker/case/rank_part.h>
#include <waker/case/scene.h>
#include <waker/case/state.h>
#include <waker/control/outcome.h>
#include <waker/measures/settlements.h>
#include <waker/mechanics/time_scheme.h>
#include <waker/observers/observer.h>
#include <waker/simulation/carried.h>
#include <waker/simulation/step_control.h>

#include <memory>
#include <optional>

namespace Waker
{
  /// What a rank asks for of a moment, beyond what each step leaves: places and
  /// velocities of the points, as far as loads look at them, and what is
  /// measured.
  struct Wanted
  {
    bool files      = false; // to write files of it together with the others
    bool places     = false; // of all points
    bool nodes      = false; // of the whole grid
    bool all        = false; // state and nodes as they would be on one rank
    bool checkpoint = false; // to write one together with the others
  };


  /// The points that a rank has.
  template <int dim>
  struct OwnPoints
  {
    const MaterialPoints<dim> &points;
    OwnRows                    rows; // which they are of those of the state
  };


  /**
   * One realisation: the algorithm. The caller turns the handle:
   *
   *   while (realisation.look() == StopReason::none)
   *     realisation.advance();
   *
   * Between the two the state is that of one moment, and may be watched
   * (view()), written to disk, or taken away.
   */
  template <int dim>
  class Realisation
  {
  public:
    /// Both are kept by reference; the state is advanced in place.
    Realisation(const Case<dim> &the_case, State<dim> &state);

    /// Map the points, find the surface and the loads, measure the dyke, and
    /// decide whether the run is over. Idempotent.
    StopReason
    look();

    /// One step from the moment last looked at.
    /// @throws NumericalFailure if it does not converge at the smallest dt
    void
    advance();

    /// What keeps the state that look() has seen from being final.
    Unrest
    unrest() const;

    /// What look() has seen.
    StepView<dim>
    view() const;

    /// What any of the ranks wants. Collective.
    Wanted
    wanted_by_any(const Wanted &mine) const;

    /// On several ranks steps leave behind what nobody has asked for: from now
    /// on until the next step this is as it should be. Collective.
    /// @param wanted the same on all ranks
    void
    complete(const Wanted &wanted = {true, true, true, true, true});

    /// Do all points hold numbers? Collective.
    bool
    has_numbers() const;

    /// Those that this rank computes.
    OwnPoints<dim>
    own() const
    {
      return {own_points(),
              part ? part->point_exchange().rows()
                   : OwnRows(state->points.n_points())};
    }

    /// What this rank has told others of nodes so far; nothing on one rank.
    NodeExchange::Traffic
    traffic() const
    {
      return part ? part->traffic() : NodeExchange::Traffic();
    }

    /// Does one of the ranks say so? Collective.
    bool
    any(const bool one_does) const;

  private:
    /// The step, not converged if it is a long one that cannot be solved.
    StepReport<dim>
    solve(const double t, const double dt, NodalState &nodes);

    /// What of the dyke fails: into the state's record.
    void
    measure();

    /// Of the next step.
    TimeScheme<dim> &
    scheme() const
    {
      return control.is_long() ? *scheme_at_rest : *scheme_in_motion;
    }

    /// The step that it wants (s).
    double
    wanted_step() const;

    /// The last time at which any load changes (s), as known by now.
    double
    last_load_change() const;

    void
    make_schemes();

    Body<dim>
    body();

    /// Domains, and what else the material carries.
    /// @return Carried::move()
    std::size_t
    move_carried();

    /// What the ranks tell each other after a step.
    void
    end_step_on_ranks();

    /// Those that this rank computes.
    MaterialPoints<dim> &
    own_points() const
    {
      return part ? part->points() : state->points;
    }

    const Case<dim> *the_case;
    State<dim>      *state;
    /// None on one rank.
    std::unique_ptr<RankPart<dim>>   part;
    Scene<dim>                       scene;
    Carried<dim>                     carried;
    Settlements<dim>                 settlements;
    StepControl<dim>                 control;
    std::unique_ptr<TimeScheme<dim>> scheme_in_motion;
    std::unique_ptr<TimeScheme<dim>> scheme_at_rest; // or none
    StepReport<dim>                  report;         // of the last step
    BodyTotals<dim>                  totals;
    bool                             lies_at_box = false; // soil
  };
} // namespace Waker

#endif
