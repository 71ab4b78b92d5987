// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/von_mises_softening.h>
#include <waker/mechanics/step_motion.h>
#include <waker/mechanics/stress_update.h>

#include "mapping_lattice.h"
#include "verification_data.h"
#include <gtest/gtest.h>

namespace mechanics_rigid_motion
{
  // Rigid motions, prescribed on all nodes: they strain nothing, and the stress
  // turns with the body.

  using namespace Waker;

  namespace
  {
    constexpr double h = 0.25, E = 1000., nu = 0.45;
    constexpr double G = E / (2. * (1. + nu)), K = E / (3. * (1. - 2. * nu));


    /// A body with a stress on its yield surface: any strain would show.
    template <int dim>
    struct Body
    {
      explicit Body(const bool objective)
        : grid(Lattice::grid<dim>(2., h))
        , points(
            Lattice::box(Point<dim>(Lattice::Random(3).vector<dim>(0.7, 0.9)),
                         3,
                         0.5 * h))
        , weights(grid, ShapeFunctions::gimp)
        , force(grid.n_dofs())
      {
        materials.push_back(
          std::make_unique<VonMisesSoftening>(1.5, E, nu, 13., 5., -50.));
        declare_material_variables(materials, points);
        Lattice::Random random(4);
        for (auto &stress : points.stress)
          {
            const auto s = deviator(random.stress<dim>(1.));
            stress       = (1. - 1e-12) * 13. * std::sqrt(2.) / s.norm() * s -
                     random(0., 50.) * unit_symmetric_tensor<3>();
          }
        initial = points;
        update  = std::make_unique<StressUpdate<dim>>(
          materials, std::make_unique<StepMotion<dim>>(objective));
      }

      /// One step with u = A (x - centre) + b on all nodes.
      StressReport
      move(const Tensor<2, dim> &A,
           const Tensor<1, dim> &b,
           const Point<dim>     &centre)
      {
        weights.reinit(points);
        const NodalVector u = Lattice::linear_field(grid, A, b, centre);
        update->begin(points, weights);
        update->evaluate(points, weights, u, force);
        const StressReport report = update->accept(points);
        const Stencil<dim> stencil(grid);
        for (unsigned int p = 0; p < points.n_points(); ++p)
          points.position[p] += stencil.value(weights[p], u.begin());
        return report;
      }

      BackgroundGrid<dim>                grid;
      MaterialPoints<dim>                points, initial;
      Materials                          materials;
      Weights<dim>                       weights;
      NodalVector                        force;
      std::unique_ptr<StressUpdate<dim>> update;
    };


    template <int dim>
    void
    check_translation()
    {
      for (const bool objective : {true, false})
        {
          Body<dim>       body(objective);
          Lattice::Random random(5);
          Tensor<1, dim>  way;
          const double    elastic = elastic_energy(body.points, body.materials);
          for (unsigned int step = 0; step < 50; ++step)
            {
              const auto b = random.vector<dim>(-0.06, 0.065);
              way += b;
              const StressReport report =
                body.move(Tensor<2, dim>(), b, Point<dim>());
              EXPECT_EQ(report.dissipation, 0.);
              EXPECT_EQ(report.plastic_strain, 0.);
              EXPECT_NEAR(report.work_start, 0., 1e-12);
              EXPECT_NEAR(report.elastic_energy, elastic, 1e-10 * elastic);
            }
          for (unsigned int p = 0; p < body.points.n_points(); ++p)
            {
              EXPECT_LT((body.points.stress[p] - body.initial.stress[p]).norm(),
                        1e-10);
              EXPECT_LT((body.points.position[p] - body.initial.position[p] -
                         way)
                          .norm(),
                        1e-13);
            }
          EXPECT_EQ(body.points.scalar("undrained shear strength"),
                    body.initial.scalar("undrained shear strength"));
          EXPECT_EQ(body.points.scalar("plastic strain"),
                    body.initial.scalar("plastic strain"));
        }
    }


    template <int dim>
    void
    check_rotation(const Tensor<1, 3> &axis)
    {
      const Point<dim> centre(Lattice::Random(9).vector<dim>(0.9, 1.1));
      const double     degree = numbers::PI / 180.;
      Tensor<2, dim>   step   = Lattice::rotation<dim>(degree, axis);
      for (unsigned int d = 0; d < dim; ++d)
        step[d][d] -= 1.;

      Body<dim> body(/*objective=*/true), naive(/*objective=*/false);
      double    largest_stress = 0., largest_place = 0., largest_naive = 0.;
      for (unsigned int n = 1; n <= 90; ++n)
        {
          const StressReport report = body.move(step, {}, centre);
          EXPECT_EQ(report.plastic_strain, 0.) << n;
          const Tensor<2, dim>  R = Lattice::rotation<dim>(n * degree, axis);
          const Tensor<2, 3>    Q = Lattice::embedded(R);
          SymmetricTensor<2, 3> exact;
          for (unsigned int p = 0; p < body.points.n_points(); ++p)
            {
              exact = symmetrize(Q * Tensor<2, 3>(body.initial.stress[p]) *
                                 transpose(Q));
              largest_stress = std::max(largest_stress,
                                        (body.points.stress[p] - exact).norm());
              const Tensor<1, dim> place =
                R * (body.initial.position[p] - centre);
              largest_place =
                std::max(largest_place,
                         (body.points.position[p] - centre - place).norm());
            }
          naive.move(step, {}, centre);
          if (n % 30 == 0)
            Verification::row("patch_rotation_errors",
                              "dimension,degrees,largest stress error (kPa),"
                              "largest place error (m)",
                              dim,
                              n,
                              largest_stress,
                              largest_place);
          if (dim == 2)
            Verification::row(
              "patch_rotation_90",
              "degrees,exact xx-yy,exact xy,exact mean,objective xx-yy,"
              "objective xy,objective mean,small-strain xx-yy,small-strain xy,"
              "small-strain mean",
              n,
              exact[0][0] - exact[1][1],
              exact[0][1],
              trace(exact) / 3.,
              body.points.stress.back()[0][0] - body.points.stress.back()[1][1],
              body.points.stress.back()[0][1],
              trace(body.points.stress.back()) / 3.,
              naive.points.stress.back()[0][0] -
                naive.points.stress.back()[1][1],
              naive.points.stress.back()[0][1],
              trace(naive.points.stress.back()) / 3.);
        }
      // 13 kPa of shear stress and up to 50 kPa of pressure: round-off.
      EXPECT_LT(largest_stress, 1e-10);
      EXPECT_LT(largest_place, 1e-13);
      EXPECT_EQ(body.points.scalar("plastic strain"),
                body.initial.scalar("plastic strain"));

      // Without the objective rate each step strains the body by cos(1 deg) - 1
      // in the two directions of the rotation's plane: a false tension of
      // 2 * 90 * (cos - 1) K, and a deviator that does not turn.
      const double false_mean = 2. * 90. * (std::cos(degree) - 1.) * K;
      EXPECT_NEAR(false_mean, -91., 0.5);
      for (unsigned int p = 0; p < naive.points.n_points(); ++p)
        {
          EXPECT_NEAR(trace(naive.points.stress[p] - naive.initial.stress[p]) /
                        3.,
                      false_mean,
                      1e-8);
          largest_naive = std::max(
            largest_naive,
            deviator(naive.points.stress[p] - body.points.stress[p]).norm());
        }
      EXPECT_GT(largest_naive, 13.);
    }
  } // namespace


  TEST(Mechanics, translation_changes_nothing)
  {
    check_translation<2>();
    check_translation<3>();
  }


  TEST(Mechanics, ninety_degrees_in_steps_of_one)
  {
    check_rotation<2>(Tensor<1, 3>({0., 0., 1.}));
    check_rotation<3>(Tensor<1, 3>({0., 0., 1.}));
    check_rotation<3>(Tensor<1, 3>({0.3, -0.5, 0.8}));
  }
} // namespace mechanics_rigid_motion
