// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/von_mises_softening.h>
#include <waker/mechanics/consistent_tangent.h>
#include <waker/mechanics/deformation.h>
#include <waker/mechanics/logarithmic_motion.h>

#include "logarithmic_body.h"
#include "mapping_lattice.h"
#include <gtest/gtest.h>

namespace mechanics_logarithmic_tangent
{
  // The tangent against differences of the internal force.

  using namespace Waker;
  using namespace LogarithmicBody;
  using LogarithmicBody::identity; // there are others

  namespace
  {
    /// Elastic and softening points with stresses, sizes and strengths of all
    /// kinds, in a random motion with large strains.
    template <int dim>
    void
    check_tangent(const ShapeFunctions functions, const bool elastic)
    {
      const auto   grid = Lattice::grid<dim>(1., h);
      Weights<dim> weights(grid, functions);
      Materials    materials;
      materials.push_back(std::make_unique<LinearElastic>(1.5, 400., 0.2));
      if (!elastic)
        materials.push_back(
          std::make_unique<VonMisesSoftening>(1.5, 1000., 0.45, 13., 5., -50.));
      Lattice::Random random(51 + dim);
      auto points = Lattice::box(Point<dim>(random.vector<dim>(0.15, 0.2)),
                                 dim == 2 ? 6 : 4,
                                 0.5 * h,
                                 1.5);
      for (unsigned int p = 0; p < points.n_points(); ++p)
        {
          points.position[p] += random.vector<dim>(-0.03, 0.03);
          points.volume[p] *= random(0.5, 1.5);
          points.material[p] = !elastic && p % 4 != 3 ? 1 : 0;
          points.stress[p]   = random.stress<dim>(2.) -
                             random(0., 20.) * unit_symmetric_tensor<3>();
        }
      declare_material_variables(materials, points);
      if (!elastic)
        for (unsigned int p = 0; p < points.n_points(); p += 3)
          points.scalar("undrained shear strength")[p] = 500.;
      weights.reinit(points);
      auto u = Lattice::linear_field(grid,
                                     random.matrix<dim>(-0.3, 0.3),
                                     Tensor<1, dim>());
      for (double &value : u)
        value += random(-0.06, 0.06) * h;

      const unsigned int     n = grid.n_dofs();
      StressUpdate<dim>      update(materials,
                               std::make_unique<LogarithmicMotion<dim>>());
      ConsistentTangent<dim> tangent(weights, Precision::double_precision);
      NodalVector            force(n), up(n), down(n), product(n), other(n);
      const auto internal_force = [&](const NodalVector &v, NodalVector &f) {
        StressUpdate<dim> other(materials,
                                std::make_unique<LogarithmicMotion<dim>>());
        other.begin(points, weights);
        other.evaluate(points, weights, v, f);
      };
      update.begin(points, weights);
      update.evaluate(points, weights, u, force);
      tangent.reinit(update, points);
      for (unsigned int k = 0; k < 6; ++k)
        {
          const double delta = 1e-6 * h;
          NodalVector  direction(n), v;
          for (double &d : direction)
            d = random(-1., 1.);
          tangent.vmult(product, direction);
          v = u;
          v.add(delta, direction);
          internal_force(v, up);
          v.add(-2. * delta, direction);
          internal_force(v, down);
          up -= down;
          up /= 2. * delta;
          up -= product;
          EXPECT_LT(up.linfty_norm(), 2e-7 * product.linfty_norm());

          // An elastic body has a potential.
          NodalVector second(n);
          for (double &d : second)
            d = random(-1., 1.);
          tangent.vmult(other, second);
          if (elastic)
            {
              EXPECT_NEAR(second * product,
                          direction * other,
                          1e-9 * product.l2_norm() * second.l2_norm());
            }
        }

      NodalVector diagonal(n), unit(n);
      tangent.add_diagonal(diagonal);
      for (unsigned int i = 0; i < n; ++i)
        {
          unit            = 0.;
          unit.begin()[i] = 1.;
          tangent.vmult(product, unit);
          ASSERT_NEAR(diagonal.begin()[i], product.begin()[i], 1e-9) << i;
        }
      EXPECT_GT(diagonal.linfty_norm(), 10.);
      if (!elastic)
        {
          EXPECT_GT(update.accept(points).plastic_strain, 0.01);
        }
    }


    /// Domains follow U, not F: a rotation leaves them, and none outgrows a
    /// cell.
    template <int dim>
    void
    check_domains()
    {
      Body<dim>            body;
      const Tensor<1, 3>   axis({0., 0., 1.});
      const Tensor<2, dim> R = Lattice::rotation<dim>(0.7, axis);
      Tensor<2, dim>       U = identity<dim>();
      U[0][0]                = 1.3;
      U[1][1]                = 0.6;
      U[0][1] = U[1][0] = 0.2;
      body.deform(R * U);
      EXPECT_EQ(move_domains(SupportDomains::stretched, h, body.points), 0u);
      const double l0 = 0.25 * h;
      for (const auto &l : body.points.half_size)
        for (unsigned int d = 0; d < dim; ++d)
          EXPECT_NEAR(l[d], l0 * U[d][d], 1e-13 * l0);

      Tensor<2, dim> stretch = identity<dim>();
      stretch[0][0]          = 2.;
      body.deform(stretch * transpose(R));
      EXPECT_EQ(move_domains(SupportDomains::stretched, h, body.points),
                body.points.n_points());
      for (const auto &l : body.points.half_size)
        {
          EXPECT_EQ(l[0], 0.5 * h);
          EXPECT_GT(l[1], 0.5 * l0);
          EXPECT_LT(l[1], 0.7 * l0);
        }
    }
  } // namespace


  TEST(LogarithmicStrain, Tangent)
  {
    for (const auto functions : {ShapeFunctions::gimp, ShapeFunctions::linear})
      for (const bool elastic : {true, false})
        {
          check_tangent<2>(functions, elastic);
          check_tangent<3>(functions, elastic);
        }
  }


  TEST(LogarithmicStrain, StretchedDomains)
  {
    check_domains<2>();
    check_domains<3>();
  }
} // namespace mechanics_logarithmic_tangent
