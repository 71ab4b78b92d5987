// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_realisation_setup_h
#define waker_campaign_realisation_setup_h

#include <waker/campaign/input.h>
#include <waker/simulation/run.h>

#include <cstdint>
#include <string>

namespace Waker
{
  /// "realisation 17 of seed 1".
  std::string
  realisation_title(const Input &input, const std::uint64_t realisation);

  /// Give the points the properties of a realisation of the random fields.
  /// @param input is kept by reference
  /// @param title for the log
  template <int dim>
  InitialSetup<dim>
  realisation_setup(const Input        &input,
                    const std::uint64_t realisation,
                    const std::string  &title);

  /// Give them the means of the fields.
  /// @param input is kept by reference
  template <int dim>
  InitialSetup<dim>
  means_setup(const Input &input);
} // namespace Waker

#endif
