// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_case_given_stress_check_h
#define waker_source_case_given_stress_check_h

#include <waker/case/parameters.h>
#include <waker/mechanics/stress_update.h>

#include <vector>

namespace Waker
{
  /**
   * The stress that a layer is given must be one that its law bears: else the
   * first step would take away what is too much, and nobody would hear of it.
   *
   * @param layers number of each point's layer
   * @throws UserError Soil profile/<layer>/Initial stress, with the worst place
   */
  template <int dim>
  void
  check_given_stress(const Parameters                &parameters,
                     const Materials                 &materials,
                     const std::vector<unsigned int> &layers,
                     const MaterialPoints<dim>       &points);
} // namespace Waker

#endif
