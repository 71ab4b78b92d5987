// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_case_load_programmes_h
#define waker_case_load_programmes_h

#include <waker/case/parameters.h>
#include <waker/case/state.h>
#include <waker/control/load_programme.h>

#include <string>
#include <vector>

namespace Waker
{
  /// Do the programmes fit to each other and to what they drive?
  /// @throws UserError "Load programmes/..."
  void
  check_load_programmes(const Parameters &parameters);

  /// What is set but of no effect, what never acts and what never holds.
  std::vector<std::string>
  unused_in_load_programmes(const Parameters &parameters);


  /**
   * The load programmes of a case: what their points carry, what they watch,
   * and the mass that comes. Their records are part of the state.
   *
   * Which points carry a weight or a driven point load, and how much of it, is
   * a scalar of the points, "programme_<name>": kN per unit of the factor, or
   * the share (-).
   */
  template <int dim>
  class LoadProgrammes
  {
  public:
    explicit LoadProgrammes(const Parameters &parameters);

    const std::vector<LoadProgramme> &
    list() const
    {
      return programmes;
    }

    /// One each.
    const std::vector<LoadName> &
    names() const
    {
      return load_names;
    }

    /// Let the points of t = 0 carry what they have to.
    /// @throws UserError "Load programmes/<name>/From", ...
    void
    prepare(const Parameters &parameters, MaterialPoints<dim> &points) const;

    /// Is what the programmes watch there?
    /// @param measuring_level where W is measured (m), or NaN
    /// @throws UserError "Load programmes/<name>/..."
    void
    check_watched(const MaterialPoints<dim> &points,
                  const double               measuring_level) const;

    /// The records at t = 0, one each.
    std::vector<LoadRecord>
    start() const;

    /// Decide by the state what the next step brings. Idempotent. Collective.
    /// @param body the points of the state
    void
    watch(const Body<dim> &body, State<dim> &state) const;

    /// A step is accepted: the records go on to the time of the state, and what
    /// has become mass comes with the velocity of its point; its energy is
    /// counted as inflow.
    /// @param points of the state; on several ranks those of this one
    void
    proceed(const NodeExchange  &ranks,
            MaterialPoints<dim> &points,
            State<dim>          &state) const;

    /// The last time at which any of the loads changes (s): see LastChange.
    double
    last_change(const std::vector<LoadRecord> &records) const;

    /// The path of a table of time that changes after a time (s); empty if none
    /// does.
    std::string
    changing_after(const double time) const;

    /// Of each programme's load the share (-) whose points have left the grid:
    /// its factor goes on counting all of it. 0 for what no points carry.
    /// Collective.
    std::vector<double>
    shares_lost(const Body<dim> &body) const;

  private:
    void
    add_mass(const LoadProgrammeParameters &programme,
             const double                   height,
             const NodeExchange            &ranks,
             MaterialPoints<dim>           &points,
             State<dim>                    &state) const;

    std::vector<LoadProgramme> programmes;
    std::vector<LoadName>      load_names;
    double                     gravity; // m/s^2
  };


  /// What the points carry of a programme: see LoadProgrammes. Empty if it is
  /// none that points carry.
  template <int dim>
  const std::vector<double> &
  carried_load(const LoadProgrammeParameters &programme,
               const MaterialPoints<dim>     &points);
} // namespace Waker

#endif
