// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_observers_observer_h
#define waker_observers_observer_h

#include <waker/case/case.h>
#include <waker/case/scene.h>
#include <waker/case/state.h>
#include <waker/mechanics/time_scheme.h>

#include <memory>
#include <string_view>
#include <vector>

namespace Waker
{
  /// What is summed up, or the largest, over all points: on several ranks all
  /// of them know it.
  template <int dim>
  struct BodyTotals
  {
    double         mass = 0.;       // Mg
    Tensor<1, dim> momentum;        // kN s
    double         settlement = 0.; // largest, m, if load programmes watch it

    /// Of each load programme: the share of it that has left the grid with the
    /// soil that carried it.
    std::vector<double> lost_loads;
  };


  /**
   * A moment of a realisation, as observers see it: all of it, and nothing that
   * they could change. The scene is that of the state: its nodes hold the
   * mapped points and the external force. On several ranks the points of the
   * state are no more than their ids, unless they were asked for (Wanted), and
   * of the whole body there are the totals. The nodes' increment and internal
   * force belong to the step that ended there, as does `report`.
   */
  template <int dim>
  struct StepView
  {
    const Case<dim>       &the_case;
    const State<dim>      &state;
    const Scene<dim>      &scene;
    const StepReport<dim> &report;
    const BodyTotals<dim> &totals;
  };

  /// Where an observer puts its numbers: one column each, the same every step.
  class Row
  {
  public:
    virtual ~Row() = default;

    /// @param name with the unit in brackets, "Dyke width (m)"
    virtual void
    add(const std::string_view name, const double value) = 0;
  };

  /// Watches a run: const state in, numbers out.
  template <int dim>
  class Observer
  {
  public:
    virtual ~Observer() = default;

    virtual void
    observe(const StepView<dim> &view, Row &row) = 0;
  };

  /// Those that every run has: Newton, dyke, energy, forces; then those whose
  /// columns come and go: sliding masses, walls, tractions, load programmes,
  /// flow.
  template <int dim>
  std::vector<std::unique_ptr<Observer<dim>>>
  standard_observers();
} // namespace Waker

#endif
