// SPDX-License-Identifier: LGPL-2.1-or-later
// Tangents that are not symmetric: a body of soil with friction that yields.
#include <waker/materials/mohr_coulomb.h>
#include <waker/mechanics/double_mapped_tangent.h>

#include "mapping_lattice.h"
#include <gtest/gtest.h>

namespace mechanics_unsymmetric
{
  using namespace Waker;

  namespace
  {
    /// In a uniform state D is everywhere the same, so that for linear fields
    /// v . K u = V sym(grad v) : D : sym(grad u), whatever the grid.
    template <int dim>
    void
    check(const VolumetricStrain volumetric)
    {
      Lattice::Random           random(401);
      const BackgroundGrid<dim> grid(Lattice::grid<dim>(1.5, 0.25));
      MaterialPoints<dim>       points =
        Lattice::box(Point<dim>(random.vector<dim>(0.2, 0.4)), 4, 0.11);
      Materials materials;
      materials.push_back(std::make_unique<MohrCoulomb>(
        1.8, 5000., 0.3, MohrCoulomb::Angles{5., 30., 0.}, 0.));
      for (unsigned int p = 0; p < points.n_points(); ++p)
        points.stress[p] = -20. * unit_symmetric_tensor<3>();
      declare_material_variables(materials, points);

      Weights<dim> weights(grid, ShapeFunctions::gimp);
      weights.reinit(points);
      MappingParameters mapping;
      mapping.volumetric_strain = volumetric;
      mapping.objective_rate    = false;
      StressUpdate<dim> update(materials, make_small_motion<dim>(mapping));
      NodalVector       force(grid.n_dofs());
      update.begin(points, weights);
      Tensor<2, dim> gradient;
      gradient[0][0] = 0.01;
      gradient[1][1] = -0.02;
      gradient[0][1] = 0.004;
      update.evaluate(points,
                      weights,
                      Lattice::linear_field(grid, gradient, Tensor<1, dim>()),
                      force);
      DoubleMappedTangent<dim> tangent(weights);
      tangent.reinit(update, points);
      EXPECT_FALSE(tangent.is_symmetric());

      const auto embedded = [](const Tensor<2, dim> &A) {
        SymmetricTensor<2, 3> e;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = i; j < dim; ++j)
            e[i][j] = 0.5 * (A[i][j] + A[j][i]);
        return e;
      };
      SymmetricTensor<4, 3> D;
      SymmetricTensor<2, 3> stress       = points.stress[0];
      double                variables[4] = {5., 30., 0., 0.};
      materials[0]->update(embedded(gradient), stress, variables, &D);
      ASSERT_GT(variables[3], 1e-3); // it yields
      double volume = 0.;
      for (const double v : points.volume)
        volume += v;

      double unlike = 0.;
      for (unsigned int n = 0; n < 10; ++n)
        {
          const auto A = random.matrix<dim>(-1., 1.),
                     B = random.matrix<dim>(-1., 1.);
          const NodalVector u =
            Lattice::linear_field(grid, A, Tensor<1, dim>());
          const NodalVector v =
            Lattice::linear_field(grid, B, Tensor<1, dim>());
          NodalVector product(grid.n_dofs());
          tangent.vmult(product, u);
          const double expected = volume * (embedded(B) * (D * embedded(A)));
          EXPECT_NEAR(v * product, expected, 1e-10 * volume * D.norm());
          unlike = std::max(unlike,
                            std::abs(expected - volume * (embedded(A) *
                                                          (D * embedded(B)))));
        }
      EXPECT_GT(unlike, 1e-2 * volume * D.norm()); // a transposed one is seen
    }
  } // namespace


  TEST(Mechanics, double_mapping_takes_a_tangent_that_is_not_symmetric)
  {
    for (const auto volumetric :
         {VolumetricStrain::standard, VolumetricStrain::b_bar_everywhere})
      {
        check<2>(volumetric);
        check<3>(volumetric);
      }
  }
} // namespace mechanics_unsymmetric
