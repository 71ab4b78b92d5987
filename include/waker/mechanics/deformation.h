// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_deformation_h
#define waker_mechanics_deformation_h

#include <waker/mechanics/parameters.h>
#include <waker/particles/material_points.h>

namespace Waker
{
  /// What support domains need of the points from now on: the deformation
  /// gradient and their initial size, if they stretch.
  template <int dim>
  void
  prepare_domains(const SupportDomains domains, MaterialPoints<dim> &points);

  /**
   * After a step. Support domains that stretch with their points (cpGIMP;
   * Charlton et al. 2017): half_size_d = initial_half_size_d U_dd,
   * U = sqrt(F^T F). A domain reaches three nodes in each direction: none gets
   * longer than a cell.
   *
   * @param cell_size h (m)
   * @return the number of domains that were held at the length of a cell
   */
  template <int dim>
  std::size_t
  move_domains(const SupportDomains domains,
               const double         cell_size,
               MaterialPoints<dim> &points);
} // namespace Waker

#endif
