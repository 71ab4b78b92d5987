// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/mapping/centre_stencil.h>
#include <waker/materials/linear_elastic.h>
#include <waker/mechanics/step_motion.h>
#include <waker/mechanics/stress_update.h>

#include "mapping_lattice.h"
#include "mean_dilatation.h"
#include "user_errors.h"
#include <gtest/gtest.h>

namespace mechanics_mean_dilatation
{
  // B-bar: the dilatation of the cells' centres.

  using namespace Waker;
  using namespace MeanDilatation;

  namespace
  {
    /// Against the definition: sum over cells of the domain's share times the
    /// gradient of N at the cell's centre.
    template <int dim>
    void
    check_centre_functions(const ShapeFunctions functions)
    {
      const SampleBody<dim>    body(functions, 0.3);
      const CentreStencil<dim> stencil(body.grid);
      Lattice::Random          random(3);
      const auto               A = random.matrix<dim>(-1., 1.);
      const NodalVector        u = random_field(body.grid, random);
      const NodalVector        linear =
        Lattice::linear_field(body.grid, A, random.vector<dim>(-1., 1.));
      double differ = 0.;
      for (std::size_t p = 0; p < body.points.n_points(); ++p)
        {
          const PointWeights<dim> &w = body.weights[p];
          const CentreWeights<dim> c(CentreWeights<dim>::shares(w, h));
          double                   H[dim][dim];
          EXPECT_NEAR(stencil.gradient(w, c, linear.begin(), H),
                      trace(A),
                      1e-12);
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = 0; j < dim; ++j)
              EXPECT_NEAR(H[i][j], A[i][j], 1e-12);

          Tensor<1, dim> sum;
          stencil.for_each_node(w,
                                c,
                                [&](const unsigned int,
                                    const Tensor<1, dim> &,
                                    const Tensor<1, dim> &g) { sum += g; });
          EXPECT_LT(sum.norm(), 1e-12);

          // By sampling cells: 8 midpoints in each direction of the domain tell
          // the shares when it ends on eighths, else to a part of them.
          const double half     = functions == ShapeFunctions::gimp
                                    ? body.points.half_size[p][0]
                                    : 0.;
          double       expected = 0.;
          for (unsigned int cell = 0; cell < (1u << dim); ++cell)
            {
              double share = 1.;
              for (unsigned int d = 0; d < dim; ++d)
                {
                  const double x =
                    body.points.position[p][d] - body.grid.origin()[d];
                  const double first =
                    (std::floor((x - half) / h + 1e-12) + (cell >> d & 1)) * h;
                  const double covered =
                    std::max(0.,
                             std::min(x + half, first + h) -
                               std::max(x - half, first));
                  share *= half > 0. ? covered / (2. * half)
                                     : (first <= x && x < first + h ? 1. : 0.);
                }
              if (share == 0.)
                continue;
              unsigned int node = 0;
              for (unsigned int d = 0; d < dim; ++d)
                node += (static_cast<unsigned int>(
                           std::floor((body.points.position[p][d] -
                                       body.grid.origin()[d] - half) /
                                        h +
                                      1e-12)) +
                         (cell >> d & 1)) *
                        body.grid.stride(d);
              double dilatation = 0.; // of Q1 at the centre
              for (unsigned int v = 0; v < (1u << dim); ++v)
                {
                  unsigned int corner = node;
                  for (unsigned int d = 0; d < dim; ++d)
                    corner += (v >> d & 1) * body.grid.stride(d);
                  for (unsigned int d = 0; d < dim; ++d)
                    dilatation += u.begin()[dim * corner + d] *
                                  ((v >> d & 1) ? 1. : -1.) /
                                  (h * (1 << (dim - 1)));
                }
              expected += share * dilatation;
            }
          const double mean = stencil.gradient(w, c, u.begin(), H);
          EXPECT_NEAR(mean, expected, 1e-12);
          double own = 0.;
          for (unsigned int d = 0; d < dim; ++d)
            own += H[d][d];
          differ = std::max(differ, std::abs(mean - own));
        }
      EXPECT_GT(differ, 0.01); // another dilatation than the point's own
    }


    /// A linear field has the same stress as without, in plane strain also zz.
    template <int dim>
    void
    check_linear_field(const ShapeFunctions functions, const bool objective)
    {
      SampleBody<dim>   body(functions, 0.3);
      auto              points = body.points, other = body.points;
      Lattice::Random   random(5);
      const auto        A = random.matrix<dim>(-0.2, 0.2);
      const NodalVector u =
        Lattice::linear_field(body.grid, A, random.vector<dim>(-1., 1.));
      NodalVector force(body.grid.n_dofs());
      auto        update = body.update(objective);
      update.begin(points, body.weights);
      update.evaluate(points, body.weights, u, force);
      update.accept(points);
      StressUpdate<dim> standard(body.materials,
                                 std::make_unique<StepMotion<dim>>(objective));
      standard.begin(other, body.weights);
      standard.evaluate(other, body.weights, u, force);
      standard.accept(other);
      for (std::size_t p = 0; p < points.n_points(); ++p)
        EXPECT_LT((points.stress[p] - other.stress[p]).norm(),
                  1e-11 * other.stress[p].norm());
      EXPECT_GT(other.stress[0].norm(), 10.);
    }


    /// The force is the derivative of the elastic energy: its work on the
    /// increment is twice that, and it is symmetric.
    template <int dim>
    void
    check_energy(const ShapeFunctions functions)
    {
      SampleBody<dim>   body(functions, 0.45);
      Lattice::Random   random(11);
      const NodalVector u = random_field(body.grid, random);
      const NodalVector v = random_field(body.grid, random);
      NodalVector       f_u(body.grid.n_dofs()), f_v(body.grid.n_dofs());
      auto              update = body.update();
      update.begin(body.points, body.weights);
      update.evaluate(body.points, body.weights, v, f_v);
      update.begin(body.points, body.weights);
      update.evaluate(body.points, body.weights, u, f_u);
      EXPECT_NEAR(f_u * v, f_v * u, 1e-12 * std::abs(f_u * v));
      auto               after  = body.points;
      const StressReport report = update.accept(after);
      EXPECT_NEAR(report.work_end, f_u * u, 1e-12 * (f_u * u));
      EXPECT_NEAR(report.elastic_energy, 0.5 * (f_u * u), 1e-12 * (f_u * u));
      EXPECT_GT(report.elastic_energy, 0.1);

      // The points' own stresses have the same force, at rest.
      NodalVector at_rest(body.grid.n_dofs());
      update.point_motion().add_force_of_stress(after, body.weights, at_rest);
      at_rest -= f_u;
      EXPECT_LT(at_rest.linfty_norm(), 1e-12 * f_u.linfty_norm());
    }


    /// Bending of a cell: no dilatation at its centre, so no pressure; without
    /// B-bar it would be K times that at the point.
    template <int dim>
    void
    check_bending()
    {
      SampleBody<dim> body(ShapeFunctions::linear, 0.4999);
      NodalVector     u(body.grid.n_dofs()), force(body.grid.n_dofs());
      // u_x = x y about the centre of each cell: saw teeth over the nodes.
      for (unsigned int i = 0; i < body.grid.n_nodes(); ++i)
        {
          const auto index   = body.grid.node_index(i);
          u.begin()[dim * i] = 1e-3 * ((index[0] + index[1]) % 2 ? 1. : -1.);
        }
      auto update = body.update();
      update.begin(body.points, body.weights);
      update.evaluate(body.points, body.weights, u, force);
      auto after = body.points;
      update.accept(after);
      StressUpdate<dim> standard(body.materials,
                                 std::make_unique<StepMotion<dim>>(false));
      standard.begin(body.points, body.weights);
      standard.evaluate(body.points, body.weights, u, force);
      auto locked = body.points;
      standard.accept(locked);
      FilledCells<dim> share;
      share.reinit(body.points, body.weights);
      double pressure = 0., other = 0.;
      for (std::size_t p = 0; p < after.n_points(); ++p)
        {
          if (share[p] < 1.)
            continue;
          pressure = std::max(pressure, std::abs(trace(after.stress[p])));
          other    = std::max(other, std::abs(trace(locked.stress[p])));
        }
      EXPECT_GT(other, 1e4);
      EXPECT_LT(pressure, 1e-10 * other);
    }


    /// A rotation by any angle strains nothing, and turns the stress.
    template <int dim>
    void
    check_rotation()
    {
      SampleBody<dim> body(ShapeFunctions::gimp, 0.3);
      Tensor<2, dim>  A =
        Lattice::rotation<dim>(0.7, Tensor<1, 3>({0., 0., 1.}));
      for (unsigned int d = 0; d < dim; ++d)
        A[d][d] -= 1.;
      Lattice::Random random(13);
      for (auto &stress : body.points.stress)
        stress = random.stress<dim>(10.);
      const auto  before = body.points.stress;
      NodalVector force(body.grid.n_dofs());
      auto        update = body.update(/*objective=*/true);
      update.begin(body.points, body.weights);
      update.evaluate(body.points,
                      body.weights,
                      Lattice::linear_field(body.grid, A, Tensor<1, dim>()),
                      force);
      update.accept(body.points);
      for (std::size_t p = 0; p < before.size(); ++p)
        {
          const auto &s = body.points.stress[p];
          EXPECT_NEAR(s.norm(), before[p].norm(), 1e-11);
          EXPECT_NEAR(trace(s), trace(before[p]), 1e-11);
          EXPECT_GT((s - before[p]).norm(), 0.1);
        }
    }
  } // namespace


  TEST(Mechanics, centre_functions_are_those_of_the_cells)
  {
    for (const auto functions : {ShapeFunctions::gimp, ShapeFunctions::linear})
      {
        check_centre_functions<2>(functions);
        check_centre_functions<3>(functions);
      }
  }


  TEST(Mechanics, mean_dilatation_leaves_linear_fields_alone)
  {
    for (const auto functions : {ShapeFunctions::gimp, ShapeFunctions::linear})
      for (const bool objective : {false, true})
        {
          check_linear_field<2>(functions, objective);
          check_linear_field<3>(functions, objective);
        }
  }


  TEST(Mechanics, force_of_mean_dilatation_is_conjugate)
  {
    for (const auto functions : {ShapeFunctions::gimp, ShapeFunctions::linear})
      {
        check_energy<2>(functions);
        check_energy<3>(functions);
      }
  }


  TEST(Mechanics, bending_has_no_pressure_with_mean_dilatation)
  {
    check_bending<2>();
    check_bending<3>();
  }


  TEST(Mechanics, mean_dilatation_turns_with_the_body)
  {
    check_rotation<2>();
    check_rotation<3>();
  }


  TEST(Mechanics, b_bar_is_not_for_logarithmic_strain)
  {
    MappingParameters mapping;
    mapping.volumetric_strain = VolumetricStrain::b_bar;
    mapping.check();
    mapping.strain = StrainMeasure::logarithmic;
    EXPECT_USER_ERROR(mapping.check(),
                      "Kinematics and mapping/Volumetric strain",
                      "not for logarithmic strain");
  }
} // namespace mechanics_mean_dilatation
