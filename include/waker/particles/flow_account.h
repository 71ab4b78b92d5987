// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_flow_account_h
#define waker_particles_flow_account_h

#include <waker/particles/material_points.h>

#include <cstdint>
#include <vector>

namespace Waker
{
  /**
   * What has entered and left a body with open faces, so that
   *   mass = mass_start + mass_in - mass_out                        (Mg)
   *   momentum = momentum_start + impulse + momentum_in - momentum_out (kN s)
   * hold at every moment; the material in the margin, about to enter, is part
   * of the body. All zero in a case without inflow and outflow.
   *
   * The impulse is that of weight, loads and supports over the steps, from the
   * forces on the nodes, not from the points that it moves: the remainder of
   * the balance measures Newton's residual.
   */
  template <int dim>
  struct FlowAccount
  {
    double         mass_start = 0., mass_in = 0., mass_out = 0.;
    Tensor<1, dim> momentum_start, momentum_in, momentum_out, impulse;
    /// On the points that are still there, at the end of the last step (kN).
    Tensor<1, dim>             force;
    std::uint64_t              points_in = 0, points_out = 0;
    std::uint64_t              next_id = 0; // of the next point to enter
    std::vector<std::uint64_t> rows;        // that entered so far, per inflow

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &mass_start &mass_in &mass_out &points_in &points_out &next_id
        &rows;
      for (Tensor<1, dim> *v :
           {&momentum_start, &momentum_in, &momentum_out, &impulse, &force})
        for (unsigned int d = 0; d < dim; ++d)
          archive &(*v)[d];
    }
  };
} // namespace Waker

#endif
