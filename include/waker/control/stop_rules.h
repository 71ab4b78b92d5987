// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_control_stop_rules_h
#define waker_control_stop_rules_h

#include <waker/control/parameters.h>
#include <waker/measures/failure_record.h>

#include <string>

namespace Waker
{
  /// Since when the dyke has been at rest; part of the state.
  struct RestRecord
  {
    double since = -1.; // s; -1: it moves

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &since;
    }
  };

  enum class StopReason
  {
    none,
    flooding,
    initial_failure,
    stable_at_rest,
    failed_at_rest,
    end_time
  };

  /// In words, for log and summary.
  std::string
  to_string(const StopReason reason);

  /// Has the dyke been at rest for the rest duration, whatever its loads do?
  bool
  is_at_rest(const StopParameters &parameters,
             const RestRecord     &rest,
             const double          time);

  /**
   * When a run is over. Rest is judged by averages over the body, not by
   * maxima: single points may ring for ever.
   *
   * @param mean_plastic_strain increment of the last step
   * @param displacement_rate rms, m/s
   * @param settling_time rest counts only after it (the residual ramp, s)
   * @param loads_settle_at no rest ends a run before the loads have been
   *        constant for the rest duration (s): the last change of any of them
   *        (see LastChange)
   */
  StopReason
  decide(const StopParameters &parameters,
         const FailureRecord  &failure,
         const double          time,
         const double          end_time,
         const double          settling_time,
         const double          loads_settle_at,
         const double          mean_plastic_strain,
         const double          displacement_rate,
         RestRecord           &rest);
} // namespace Waker

#endif
