// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_control_long_steps_h
#define waker_control_long_steps_h

#include <cstdint>

namespace Waker
{
  /// Of a scheme that takes long steps while the dyke rests: which steps come
  /// now, and what there was of both. Part of the state.
  struct LongSteps
  {
    bool active = false; // the next step is tried as a long one
    /// Not tried again for a while: since when (s), and how often in a row.
    double       given_up = 0.;
    unsigned int failures = 0;

    // Of the steps that were accepted.
    bool          last    = false; // the last one was long
    std::uint64_t n       = 0;
    double        time    = 0.; // that they took together, s
    std::uint64_t motions = 0;  // how often short ones followed

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &active &given_up &failures &last &n &time &motions;
    }
  };
} // namespace Waker

#endif
