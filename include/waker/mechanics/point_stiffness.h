// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_point_stiffness_h
#define waker_mechanics_point_stiffness_h

#include <waker/mechanics/stress_update.h>
#include <waker/nodes/matrix_entries.h>

namespace Waker
{
  /**
   * The stiffness of the soil as a matrix that couples neighbours only: what a
   * preconditioner is made of. Each support domain is cut at the lines of the
   * grid, and each part in a cell strains by itself,
   *   K_ij = sum_p V w [k gbar_i (x) gbar_j
   *                     + G ((g_i . g_j) I + g_j (x) g_i - 2/3 g_i (x) g_j)],
   * V the point's volume, g_i the mean of grad N_i over the part, gbar_i the
   * same with the point's share of B-bar (MeanDilatationMotion), k and G the
   * isotropic part of its tangent. The weights w of a domain's parts go with
   * the squares of their shares in each direction, as they do in the square of
   * the mean strain, and have the sum 1: uniform strain has its energy, and a
   * node that is touched by a share s has its stiffness, of s^2.
   *
   * Where domains lie in one cell and the tangents are elastic, that is the
   * tangent of the internal force.
   *
   * @param stress_update where it was last evaluated
   */
  template <int dim>
  void
  add_point_stiffness(const StressUpdate<dim>   &stress_update,
                      const MaterialPoints<dim> &points,
                      const Weights<dim>        &weights,
                      MatrixEntries             &entries);
} // namespace Waker

#endif
