// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_measures_watched_h
#define waker_measures_watched_h

#include <waker/measures/failure_record.h>
#include <waker/particles/body.h>

#include <vector>

namespace Waker
{
  /// A number that tells how far a body has got: 0 at the start, larger the
  /// worse it is. Load programmes watch it.
  enum class Watched
  {
    nothing,
    largest_settlement,      // of any point, m
    largest_settlement_rate, // of any point in the last step, m/s
    largest_displacement,    // of any point, m
    settlement_of_load,      // mean over the load, m
    plastic_strain,          // largest of any point, -
    loss_of_height,          // H_i - H, m
    loss_of_width            // W_i - W, m
  };

  constexpr const char *
  name_of(const Watched choice)
  {
    switch (choice)
      {
        case Watched::nothing:
          return "nothing";
        case Watched::largest_settlement:
          return "largest settlement";
        case Watched::largest_settlement_rate:
          return "largest settlement rate";
        case Watched::largest_displacement:
          return "largest displacement";
        case Watched::settlement_of_load:
          return "settlement of the load";
        case Watched::plastic_strain:
          return "largest plastic strain";
        case Watched::loss_of_height:
          return "loss of height";
        case Watched::loss_of_width:
          return "loss of width";
      }
    return nullptr;
  }

  /// What must be there for it to be watched?
  struct WatchedFacts
  {
    const char *unit;
    /// Do points have to move with the soil?
    bool needs_motion = false;
    /// Must it be known which points carry the load?
    bool needs_load = false;
  };

  WatchedFacts
  facts_of(const Watched watched);


  /// Largest settlement, y at the start minus y now, of any point (m). At least
  /// 0.
  template <int dim>
  double
  largest_settlement(const Body<dim> &body);


  /**
   * The value of a quantity; NaN if there is none. Collective.
   *
   * @param failure with heights and widths at the start and now
   * @param settlement_rate largest of any point in the last step (m/s)
   * @param load share of each own point of the body in a load (any unit); empty
   *        if not known
   */
  template <int dim>
  double
  watched_value(const Watched              watched,
                const Body<dim>           &body,
                const FailureRecord       &failure,
                const double               settlement_rate,
                const std::vector<double> &load);
} // namespace Waker

#endif
