// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/von_mises_softening.h>
#include <waker/mechanics/consistent_tangent.h>

#include "mapping_lattice.h"
#include "verification_data.h"
#include <gtest/gtest.h>

namespace mechanics_consistent_tangent
{
  // The consistent tangent against central differences of the internal force:
  // material, mapping and objective rate together.

  using namespace Waker;

  namespace
  {
    constexpr double h = 0.25;


    /// A body of elastic and softening points with random stresses and
    /// strengths, in a random motion with 30 degrees of rotation.
    template <int dim>
    struct Body
    {
      Body(const ShapeFunctions functions, const MappingParameters &mapping)
        : grid(Lattice::grid<dim>(1., h))
        , weights(grid, functions)
        , increment(grid.n_dofs())
        , mapping(mapping)
      {
        materials.push_back(
          std::make_unique<VonMisesSoftening>(1.5, 1000., 0.45, 13., 5., -50.));
        materials.push_back(std::make_unique<LinearElastic>(1.5, 400., 0.2));

        Lattice::Random random(51 + dim);
        points = Lattice::box(Point<dim>(random.vector<dim>(0.15, 0.2)),
                              dim == 2 ? 6 : 4,
                              0.5 * h);
        for (unsigned int p = 0; p < points.n_points(); ++p)
          {
            points.position[p] += random.vector<dim>(-0.03, 0.03);
            points.volume[p] *= random(0.5, 1.5);
            points.material[p] = p % 4 == 3 ? 1 : 0;
            points.stress[p]   = random.stress<dim>(2.) -
                               random(0., 20.) * unit_symmetric_tensor<3>();
          }
        declare_material_variables(materials, points);
        for (unsigned int p = 0; p < points.n_points(); ++p)
          {
            points.scalar("undrained shear strength")[p] =
              p % 3 == 0 ? 200. : (p % 3 == 1 ? random(8., 25.) : 5.);
            points.scalar("residual strength")[p] = 5.;
          }
        weights.reinit(points);

        Tensor<2, dim> A =
          Lattice::rotation<dim>(0.5, Tensor<1, 3>({0.2, -0.3, 1.}));
        if (dim == 2)
          A = Lattice::rotation<dim>(0.5, Tensor<1, 3>({0., 0., 1.}));
        for (unsigned int d = 0; d < dim; ++d)
          A[d][d] -= 1.;
        increment = Lattice::linear_field(grid, A, Tensor<1, dim>());
        for (double &u : increment)
          u += random(-0.06, 0.06) * h;
      }

      NodalVector
      internal_force(const NodalVector &u)
      {
        NodalVector       force(grid.n_dofs());
        StressUpdate<dim> update(materials, make_point_motion<dim>(mapping));
        update.begin(points, weights);
        update.evaluate(points, weights, u, force);
        return force;
      }

      BackgroundGrid<dim> grid;
      MaterialPoints<dim> points;
      Materials           materials;
      Weights<dim>        weights;
      NodalVector         increment;
      MappingParameters   mapping;
    };


    template <int dim>
    void
    check_tangent(const ShapeFunctions     functions,
                  const MappingParameters &mapping,
                  const Precision          precision)
    {
      Body<dim>          body(functions, mapping);
      const unsigned int n = body.grid.n_dofs();
      NodalVector        force(n);
      StressUpdate<dim> update(body.materials, make_point_motion<dim>(mapping));
      ConsistentTangent<dim> tangent(body.weights, precision);
      update.begin(body.points, body.weights);
      update.evaluate(body.points, body.weights, body.increment, force);
      tangent.reinit(update, body.points);

      // All branches of the return must be there.
      auto after = body.points;
      update.accept(after);
      unsigned int n_elastic = 0, n_softening = 0, n_residual = 0;
      for (unsigned int p = 0; p < after.n_points(); ++p)
        if (after.material[p] == 0)
          {
            const double c = after.scalar("undrained shear strength")[p];
            if (after.scalar("plastic strain")[p] == 0.)
              ++n_elastic;
            else if (c > 5.)
              ++n_softening;
            else
              ++n_residual;
          }
      EXPECT_GT(n_elastic, 2u);
      EXPECT_GT(n_softening, 2u);
      EXPECT_GT(n_residual, 2u);

      // Random directions.
      Lattice::Random random(61);
      double          worst = 0.;
      for (unsigned int k = 0; k < 6; ++k)
        {
          NodalVector  direction(n), product(n);
          const double delta = 1e-6 * h;
          for (double &d : direction)
            d = random(-1., 1.);
          tangent.vmult(product, direction);
          NodalVector up = body.increment, down = body.increment;
          up.add(delta, direction);
          down.add(-delta, direction);
          NodalVector difference = body.internal_force(up);
          difference -= body.internal_force(down);
          difference /= 2. * delta;
          difference -= product;
          worst =
            std::max(worst, difference.linfty_norm() / product.linfty_norm());
        }
      // Single: round-off of its numbers, of sums of up to 9 x 27 of them.
      EXPECT_LT(worst, precision == Precision::double_precision ? 2e-7 : 1e-6);
      if (precision == Precision::double_precision)
        Verification::row(
          "tangents_consistent",
          "dimension,functions,objective rate,volumetric strain,"
          "points elastic,"
          "softening,residual,largest relative error",
          dim,
          functions == ShapeFunctions::gimp ? "GIMP" : "linear",
          mapping.objective_rate,
          name_of(mapping.volumetric_strain),
          n_elastic,
          n_softening,
          n_residual,
          worst);

      // The diagonal, added to what is there.
      NodalVector diagonal(n), unit(n), column(n);
      diagonal = 7.;
      tangent.add_diagonal(diagonal);
      double largest = 0.;
      for (unsigned int i = 0; i < n; ++i)
        {
          unit            = 0.;
          unit.begin()[i] = 1.;
          tangent.vmult(column, unit);
          largest = std::max(largest, std::abs(column.begin()[i]));
        }
      for (unsigned int i = 0; i < n; ++i)
        {
          unit            = 0.;
          unit.begin()[i] = 1.;
          tangent.vmult(column, unit);
          ASSERT_NEAR(
            diagonal.begin()[i] - 7.,
            column.begin()[i],
            (precision == Precision::double_precision ? 1e-13 : 1e-6) * largest)
            << i;
        }
      EXPECT_GT(largest, 100.);
    }


    /// Relative error of central differences over their step, for the figure:
    /// it falls with delta^2 until round-off takes over.
    template <int dim>
    void
    scan_differences(const ShapeFunctions functions)
    {
      Body<dim>              body(functions, MappingParameters());
      const unsigned int     n = body.grid.n_dofs();
      NodalVector            force(n), direction(n), product(n);
      StressUpdate<dim>      update(body.materials,
                               make_point_motion<dim>(body.mapping));
      ConsistentTangent<dim> tangent(body.weights, Precision::double_precision);
      update.begin(body.points, body.weights);
      update.evaluate(body.points, body.weights, body.increment, force);
      tangent.reinit(update, body.points);
      Lattice::Random random(61);
      for (double &d : direction)
        d = random(-1., 1.);
      tangent.vmult(product, direction);
      std::vector<double> errors;
      for (int k = 0; k <= 12; ++k)
        {
          const double delta = std::pow(10., -3. - 0.5 * k) * h;
          NodalVector  up = body.increment, down = body.increment;
          up.add(delta, direction);
          down.add(-delta, direction);
          NodalVector difference = body.internal_force(up);
          difference -= body.internal_force(down);
          difference /= 2. * delta;
          difference -= product;
          errors.push_back(difference.l2_norm() / product.l2_norm());
          Verification::row("tangents_differences",
                            "dimension,functions,step / h,relative error",
                            dim,
                            functions == ShapeFunctions::gimp ? "GIMP"
                                                              : "linear",
                            delta / h,
                            errors.back());
        }
      // A wrong term of relative size 1e-6 would end this line.
      EXPECT_LT(*std::min_element(errors.begin(), errors.end()), 1e-8);
    }
  } // namespace


  TEST(Mechanics, consistent_tangent_is_the_derivative)
  {
    for (const auto functions : {ShapeFunctions::gimp, ShapeFunctions::linear})
      for (const bool objective : {true, false})
        for (const auto volumetric : {VolumetricStrain::standard,
                                      VolumetricStrain::b_bar,
                                      VolumetricStrain::b_bar_everywhere})
          {
            MappingParameters mapping;
            mapping.objective_rate    = objective;
            mapping.volumetric_strain = volumetric;
            check_tangent<2>(functions, mapping, Precision::double_precision);
            for (const auto precision :
                 {Precision::single_precision, Precision::double_precision})
              check_tangent<3>(functions, mapping, precision);
          }
  }


  TEST(Mechanics, central_differences_close_in_on_the_tangent)
  {
    for (const auto functions : {ShapeFunctions::gimp, ShapeFunctions::linear})
      {
        scan_differences<2>(functions);
        scan_differences<3>(functions);
      }
  }
} // namespace mechanics_consistent_tangent
