// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_strength_reduction_h
#define waker_campaign_strength_reduction_h

#include <waker/campaign/input.h>
#include <waker/simulation/run.h>

#include <cstdint>
#include <optional>

namespace Waker
{
  /**
   * run_strength_reduction() of what the input describes: with random fields,
   * of their means or of one realisation; without, of the materials' own
   * strengths. A trial that fails numerically is tried Campaign/Attempts times.
   *
   * @param realisation number; none: the means
   * @param scenario number, of those of the sweep
   * @throws UserError before anything is written
   */
  template <int dim>
  RunStatus
  reduce_strengths(const Input                        &input,
                   const std::optional<std::uint64_t> &realisation,
                   const std::uint64_t                 scenario,
                   const std::string                  &directory,
                   const RunOptions                   &options,
                   const MPI_Comm                      communicator);
} // namespace Waker

#endif
