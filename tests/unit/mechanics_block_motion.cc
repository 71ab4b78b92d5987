// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/block_motion.h>
#include <waker/mechanics/kinematics.h>

#include "mapping_lattice.h"
#include <gtest/gtest.h>

namespace mechanics_block_motion
{
  // The motion of a block of points against Kinematics, point by point.

  using namespace Waker;

  namespace
  {
    constexpr unsigned int N = Material::block_size;


    template <int dim>
    void
    check(const bool objective, const double size)
    {
      constexpr unsigned int n = BlockMotion<dim>::n_stresses;
      Lattice::Random        random(71 + dim);
      BlockMotion<dim>       motion;
      motion.objective_rate = objective;
      Material::Block                      block;
      std::array<Tensor<2, dim>, N>        H;
      std::array<SymmetricTensor<2, 3>, N> start;
      std::array<SymmetricTensor<4, 3>, N> tangents;
      double                               D[n * n][N], scale[N];
      for (unsigned int l = 0; l < N; ++l)
        {
          H[l]     = random.matrix<dim>(-size, size);
          start[l] = random.stress<dim>(20.);
          scale[l] = random(0.5, 2.);
          for (unsigned int k = 0; k < dim * dim; ++k)
            motion.H[k][l] = H[l][k / dim][k % dim];
          for (unsigned int a = 0; a < 6; ++a)
            block.stress[a][l] = start[l].access_raw_entry(a);
          // Any tangent will do.
          for (unsigned int a = 0; a < 6; ++a)
            for (unsigned int b = 0; b < 6; ++b)
              tangents[l].access_raw_entry(6 * a + b) = random(-900., 900.);
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int b = 0; b < n; ++b)
              D[n * a + b][l] = tangents[l].access_raw_entry(
                6 * motion.components[a] + motion.components[b]);
        }

      motion.move(block);
      double A[n][dim * dim][N], expected[n][dim * dim];
      motion.stress_derivative(D, block.stress, 345., scale, A);
      for (unsigned int l = 0; l < N; ++l)
        {
          const Kinematics<dim> one(H[l], objective);
          const auto            turned = one.turn(start[l]);
          const auto            strain = one.strain();
          for (unsigned int a = 0; a < 6; ++a)
            {
              EXPECT_NEAR(block.stress[a][l],
                          turned.access_raw_entry(a),
                          1e-13 * 20.);
              EXPECT_NEAR(block.strain_increment[a][l],
                          strain.access_raw_entry(a),
                          1e-14);
            }
          one.stress_derivative(tangents[l], turned, 345., scale[l], expected);
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int k = 0; k < dim * dim; ++k)
              EXPECT_NEAR(A[a][k][l], expected[a][k], 1e-14 * 9. * 900.);
        }
    }
  } // namespace


  TEST(BlockMotion, is_that_of_its_points)
  {
    for (const bool objective : {true, false})
      for (const double size : {1e-4, 0.5})
        {
          check<2>(objective, size);
          check<3>(objective, size);
        }
  }
} // namespace mechanics_block_motion
