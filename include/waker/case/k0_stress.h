// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_case_k0_stress_h
#define waker_case_k0_stress_h

#include <waker/case/ground.h>
#include <waker/materials/factory.h>
#include <waker/mechanics/stress_update.h>

#include <vector>

namespace Waker
{
  /**
   * The stress of ground at rest (Initial stress/From = K0): effective
   *   sigma'_yy = -sigma'_v,  sigma'_xx = sigma'_zz = -K0 sigma'_v,
   * with sigma'_v of columns (Ground); of laws of total stress less the
   * pressure of the water. In balance only in level ground.
   *
   * @param layers number of each point's layer
   * @param points their variables are those of the start
   * @throws UserError Materials/<name>/K0: it is no number of at least 0
   *         somewhere, or the law does not bear it (with the place, by how
   *         much, and between which K0 it would)
   */
  template <int dim>
  void
  set_k0_stress(const std::vector<MaterialParameters> &parameters,
                const Materials                       &materials,
                const Ground<dim>                     &ground,
                const PoreWater<dim>                  &pore_water,
                const std::vector<unsigned int>       &layers,
                MaterialPoints<dim>                   &points);
} // namespace Waker

#endif
