// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/von_mises_softening.h>
#include <waker/mechanics/kinematics.h>
#include <waker/mechanics/step_motion.h>
#include <waker/mechanics/stress_update.h>

#include "mapping_lattice.h"
#include <gtest/gtest.h>

namespace mechanics_stress_update
{
  // The stress update works on blocks of points of one material: it must give
  // what the laws give point by point.

  using namespace Waker;

  namespace
  {
    constexpr double h = 0.25;


    /// Linear elastic, but updated by the default block loop, with a variable.
    class Counter : public LinearElastic
    {
    public:
      Counter()
        : LinearElastic(1.5, 300., 0.1)
      {}

      std::vector<MaterialVariable>
      variables() const override
      {
        return {{"count", "-", 3., MaterialVariable::Role::history}};
      }

      double
      update(const SymmetricTensor<2, 3> &strain,
             SymmetricTensor<2, 3>       &stress,
             double                      *variables,
             SymmetricTensor<4, 3>       *tangent) const override
      {
        variables[0] += 1.;
        return LinearElastic::update(strain, stress, nullptr, tangent);
      }
    };


    Materials
    three_materials()
    {
      Materials materials;
      materials.push_back(
        std::make_unique<VonMisesSoftening>(1.5, 1000., 0.45, 13., 5., -50.));
      materials.push_back(std::make_unique<Counter>());
      materials.push_back(
        std::make_unique<VonMisesSoftening>(1.5, 700., 0.3, 8., 0., -90.));
      return materials;
    }


    template <int dim>
    void
    check_point_by_point(const bool objective)
    {
      const auto      grid      = Lattice::grid<dim>(1., h);
      const Materials materials = three_materials();
      const auto      functions = ShapeFunctions::gimp;
      Lattice::Random random(111 + dim);
      auto points = Lattice::box(Point<dim>(random.vector<dim>(0.1, 0.2)),
                                 dim == 2 ? 14 : 6,
                                 dim == 2 ? 0.2 * h : 0.45 * h);
      // Runs of 1 to 40 points of a material: blocks of every length.
      unsigned int material = 0, rest = 0;
      for (unsigned int p = 0; p < points.n_points(); ++p, --rest)
        {
          if (rest == 0)
            {
              rest     = static_cast<unsigned int>(random(1., 40.));
              material = (material + 1) % 3;
            }
          points.material[p] = material;
          points.volume[p] *= random(0.5, 1.5);
          points.stress[p] =
            random.stress<dim>(4.) - 20. * unit_symmetric_tensor<3>();
        }
      declare_material_variables(materials, points);
      for (unsigned int p = 0; p < points.n_points(); ++p)
        EXPECT_EQ(points.scalar("count")[p], points.material[p] == 1 ? 3. : 0.);
      Weights<dim> weights(grid, functions);
      weights.reinit(points);
      NodalVector u(grid.n_dofs()), force(grid.n_dofs()),
        expected(grid.n_dofs());
      for (double &entry : u)
        entry = random(-0.07, 0.07) * h;
      force = 1e9; // what was there must not matter

      StressUpdate<dim>  update(materials,
                               std::make_unique<StepMotion<dim>>(objective));
      const Stencil<dim> stencil(grid);
      auto               reference = points;
      StressReport       sums;
      unsigned int       n_yielding = 0;
      for (unsigned int p = 0; p < points.n_points(); ++p)
        {
          const unsigned int    m = points.material[p];
          const double          V = points.volume[p];
          const auto            H = stencil.gradient(weights[p], u.begin());
          const Kinematics<dim> motion(H, objective);
          double                variables[3] = {};
          const auto            declared     = materials[m]->variables();
          for (unsigned int v = 0; v < declared.size(); ++v)
            variables[v] = points.scalar(declared[v].name)[p];
          auto         stress = motion.turn(points.stress[p]);
          const double energy =
            materials[m]->update(motion.strain(), stress, variables, nullptr);
          for (unsigned int v = 0; v < declared.size(); ++v)
            {
              if (declared[v].name == "plastic strain")
                sums.plastic_strain += variables[v] / points.n_points();
              reference.scalar(declared[v].name)[p] = variables[v];
            }
          reference.stress[p] = stress;
          n_yielding += energy > 0.;
          sums.dissipation += V * energy;
          Tensor<2, dim> P;
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = 0; j < dim; ++j)
              {
                P[i][j] = V * stress[i][j];
                sums.work_start += V * points.stress[p][i][j] * H[i][j];
                sums.work_end += P[i][j] * H[i][j];
              }
          stencil.scatter_gradient(weights[p], P, expected.begin());
        }
      sums.elastic_energy = elastic_energy(reference, materials);
      EXPECT_GT(n_yielding, points.n_points() / 8);
      EXPECT_LT(n_yielding, points.n_points() * 4 / 5);

      // Twice: an evaluation starts from the points, not from the last one. And
      // another one in between.
      const auto  untouched = points;
      NodalVector other     = u;
      other *= -3.;
      EXPECT_THROW(update.evaluate(points, weights, u, force), std::exception);
      update.begin(points, weights);
      for (const NodalVector *field : {&u, &other, &u})
        update.evaluate(points, weights, *field, force);
      EXPECT_EQ(points.scalar("plastic strain"),
                untouched.scalars[points.find_scalar("plastic strain")].values);
      const double size = expected.linfty_norm();
      force -= expected;
      EXPECT_LT(force.linfty_norm(), 1e-12 * size);

      const StressReport report = update.accept(points);
      for (unsigned int p = 0; p < points.n_points(); ++p)
        ASSERT_LT((points.stress[p] - reference.stress[p]).norm(), 1e-11) << p;
      ASSERT_EQ(points.scalars.size(), reference.scalars.size());
      for (unsigned int s = 0; s < points.scalars.size(); ++s)
        for (unsigned int p = 0; p < points.n_points(); ++p)
          ASSERT_NEAR(points.scalars[s].values[p],
                      reference.scalars[s].values[p],
                      1e-13)
            << points.scalars[s].name << ' ' << p;
      const auto near = [](const double a, const double b) {
        EXPECT_NEAR(a, b, 1e-12 * std::abs(b));
        EXPECT_NE(b, 0.);
      };
      near(report.dissipation, sums.dissipation);
      near(report.plastic_strain, sums.plastic_strain);
      near(report.work_start, sums.work_start);
      near(report.work_end, sums.work_end);
      near(report.elastic_energy, sums.elastic_energy);
    }
  } // namespace


  TEST(Mechanics, stress_update_is_the_laws_point_by_point)
  {
    for (const bool objective : {true, false})
      {
        check_point_by_point<2>(objective);
        check_point_by_point<3>(objective);
      }
  }


  TEST(Mechanics, elastic_energy_is_the_work_of_stretching)
  {
    // Half of stress times strain, and none lost on the way back.
    Materials materials;
    materials.push_back(std::make_unique<LinearElastic>(1.5, 1000., 0.3));
    Lattice::Random       random(121);
    SymmetricTensor<2, 3> strain = random.stress<3>(0.01), stress;
    MaterialPoints<3>     points;
    Lattice::add_point(points, Point<3>(), 0.7, 0.1);
    materials[0]->update(strain, points.stress[0], nullptr, nullptr);
    EXPECT_NEAR(elastic_energy(points, materials),
                0.7 * 0.5 * (points.stress[0] * strain),
                1e-14);
  }
} // namespace mechanics_stress_update
