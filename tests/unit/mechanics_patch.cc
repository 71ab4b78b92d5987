// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/linear_elastic.h>
#include <waker/mechanics/newton.h>
#include <waker/mechanics/soil.h>
#include <waker/mechanics/step_motion.h>
#include <waker/mechanics/stress_update.h>

#include "mapping_lattice.h"
#include "named.h"
#include "verification_data.h"
#include <gtest/gtest.h>

namespace mechanics_patch
{
  // The patch test: a linear displacement, prescribed on all nodes or solved
  // for from those at the edge, gives the exact, uniform stress in every point.

  using namespace Waker;

  namespace
  {
    constexpr double h = 0.25, E = 1000., nu = 0.3;
    constexpr double G      = E / (2. * (1. + nu));
    constexpr double lambda = E * nu / ((1. + nu) * (1. - 2. * nu));


    Materials
    elastic()
    {
      Materials materials;
      materials.push_back(std::make_unique<LinearElastic>(1.5, E, nu));
      return materials;
    }


    /// sym A by hand, in plane strain or 3D.
    template <int dim>
    SymmetricTensor<2, 3>
    exact_stress(const Tensor<2, dim> &A)
    {
      SymmetricTensor<2, 3> stress =
        lambda * trace(A) * unit_symmetric_tensor<3>();
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = i; j < dim; ++j)
          stress[i][j] += G * (A[i][j] + A[j][i]);
      return stress;
    }


    /// Is the support of this node inside the box [a, b]^dim?
    template <int dim>
    bool
    is_interior(const Point<dim> &x, const Point<dim> &a, const double size)
    {
      for (unsigned int d = 0; d < dim; ++d)
        if (x[d] - h < a[d] - 1e-10 || x[d] + h > a[d] + size + 1e-10)
          return false;
      return true;
    }


    struct Errors
    {
      double stress = 0.; // largest in a point, relative
      double force = 0.; // largest in an interior node, over |stress| h^(dim-1)
    };


    /// A body of n^dim points strained by a random linear field.
    template <int dim>
    Errors
    strain_body(const Point<dim>    &lower,
                const unsigned int   n,
                const double         spacing,
                const ShapeFunctions functions,
                Lattice::Random     &random)
    {
      const auto        grid      = Lattice::grid<dim>(2., h);
      auto              points    = Lattice::box(lower, n, spacing);
      const Materials   materials = elastic();
      Weights<dim>      weights(grid, functions);
      StressUpdate<dim> update(materials,
                               std::make_unique<StepMotion<dim>>(false));
      NodalVector       force(grid.n_dofs());
      weights.reinit(points);

      const auto A = random.matrix<dim>(-0.1, 0.1);
      const auto u =
        Lattice::linear_field(grid, A, random.vector<dim>(-1., 1.));
      update.begin(points, weights);
      update.evaluate(points, weights, u, force);
      update.accept(points);

      const auto exact = exact_stress(A);
      Errors     errors;
      for (const auto &stress : points.stress)
        errors.stress =
          std::max(errors.stress, (stress - exact).norm() / exact.norm());
      unsigned int n_interior = 0;
      for (unsigned int i = 0; i < grid.n_nodes(); ++i)
        if (is_interior(grid.node_position(i), lower, n * spacing))
          {
            ++n_interior;
            Tensor<1, dim> f;
            for (unsigned int c = 0; c < dim; ++c)
              f[c] = force.begin()[dim * i + c];
            errors.force =
              std::max(errors.force,
                       f.norm() / (exact.norm() * std::pow(h, dim - 1)));
          }
      EXPECT_GT(n_interior, 0u);
      return errors;
    }


    template <int dim>
    void
    check_prescribed()
    {
      Lattice::Random random(41);
      const auto      record =
        [](const char *functions, const char *points, const Errors &e) {
          Verification::row("patch_rotation_patch",
                            "dimension,functions,points,largest stress error,"
                            "largest interior force",
                            dim,
                            functions,
                            points,
                            e.stress,
                            e.force);
        };
      // GIMP: any offset, and sub-cells that fit the cells or not.
      Errors gimp;
      for (const double spacing : {0.5 * h, 0.37 * h, h})
        for (unsigned int offset = 0; offset < 30; ++offset)
          {
            const Point<dim> lower(random.vector<dim>(0., 0.25));
            const Errors     e =
              strain_body(lower,
                          static_cast<unsigned int>(5. * h / spacing),
                          spacing,
                          ShapeFunctions::gimp,
                          random);
            EXPECT_LT(e.stress, 1e-12) << lower;
            EXPECT_LT(e.force, 1e-12) << lower;
            gimp.stress = std::max(gimp.stress, e.stress);
            gimp.force  = std::max(gimp.force, e.force);
          }
      record("GIMP", "any offset", gimp);

      // Linear functions: exact stress anywhere, no force only where each cell
      // has the same points.
      const Errors aligned = strain_body(Point<dim>(random.vector<dim>(h, h)),
                                         8,
                                         0.5 * h,
                                         ShapeFunctions::linear,
                                         random);
      EXPECT_LT(aligned.stress, 1e-12);
      EXPECT_LT(aligned.force, 1e-12);
      record("linear", "aligned", aligned);
      const Errors crossing =
        strain_body(Point<dim>(random.vector<dim>(0., 0.25)),
                    10,
                    0.6 * h,
                    ShapeFunctions::linear,
                    random);
      EXPECT_LT(crossing.stress, 1e-12);
      EXPECT_GT(crossing.force, 0.1); // what the test must be able to see
      record("linear", "stretched lattice", crossing);
    }


    /// Nodes outside the inner box are held at the linear field; the equations
    /// find the others.
    template <int dim>
    void
    check_solved(const std::string &tangent, const ShapeFunctions functions)
    {
      const auto grid = Lattice::grid<dim>(1.5, h); // 6 cells
      // The body covers all nodes that are free, at an offset for GIMP.
      const double offset = functions == ShapeFunctions::gimp ? 0.083 : 0.;
      Point<dim>   lower;
      for (unsigned int d = 0; d < dim; ++d)
        lower[d] = offset * (d + 1) / 3.;
      auto            points    = Lattice::box(lower, 11, 0.5 * h);
      const Materials materials = elastic();
      Weights<dim>    weights(grid, functions);
      weights.reinit(points);

      // Free: the nodes from 2 h to 4 h; their supports end inside the body.
      std::vector<FixityParameters> held;
      const std::string expression[3] = {"(0.02*x - 0.05*y + 0.01)*t",
                                         "(0.03*x + 0.04*y)*t",
                                         "(-0.02*x + 0.03*y - 0.01*z)*t"};
      Tensor<2, dim>    A;
      A[0][0] = 0.02, A[0][1] = -0.05, A[1][0] = 0.03, A[1][1] = 0.04;
      if constexpr (dim == 3)
        A[2][0] = -0.02, A[2][1] = 0.03, A[2][2] = -0.01;
      for (unsigned int d = 0; d < dim; ++d)
        for (const bool upper : {false, true})
          {
            FixityParameters f;
            f.region = FixityRegion::box;
            f.from.assign(dim, -h);
            f.to.assign(dim, 1.5 + h);
            if (upper)
              f.from[d] = 4.5 * h;
            else
              f.to[d] = 1.5 * h;
            f.type         = FixityType::prescribed;
            f.displacement = expression[0] + "; " + expression[1];
            if (dim == 3)
              f.displacement += "; " + expression[2];
            f.name = std::to_string(held.size());
            held.push_back(f);
          }
      const Fixities<dim> fixities(grid, held);
      ASSERT_EQ(grid.n_dofs() - fixities.removed_list().size(),
                dim == 2 ? 18u : 81u);

      NewtonParameters newton;
      newton.tangent          = Named{tangent};
      newton.tolerance        = 1e-13;
      newton.linear_tolerance = 1e-12;
      newton.maximum_iterations =
        tangent == name_of(Tangent::consistent) ? 3 : 100;
      newton.maximum_linear_iterations = 1000;
      NewtonSolver<dim> solver(grid, fixities, newton, 1.5 * std::pow(h, dim));
      NodalState        nodes(grid);
      for (unsigned int p = 0; p < points.n_points(); ++p)
        Stencil<dim>(grid).for_each_node(
          weights[p],
          [&](const unsigned int node, const double S, const auto &) {
            nodes.mass[node] += points.mass[p] * S;
          });
      std::vector<double> increments;
      fixities.removed_increments(0., 1., increments);
      for (std::size_t k = 0; k < increments.size(); ++k)
        nodes.increment.begin()[fixities.removed_list()[k]] = increments[k];

      Soil<dim> soil(
        weights,
        StressUpdate<dim>(materials, std::make_unique<StepMotion<dim>>(false)),
        newton.tangent);
      soil.begin(points, nodes, 0., 1.);
      const NewtonReport report = solver.solve({&soil}, {}, nodes);
      EXPECT_TRUE(report.converged) << tangent << ' ' << dim;
      soil.accept(nodes.increment, points);
      const auto exact = exact_stress(A);
      for (const auto &stress : points.stress)
        ASSERT_LT((stress - exact).norm() / exact.norm(), 1e-10);
    }
  } // namespace


  TEST(Mechanics, patch_test_prescribed)
  {
    check_prescribed<2>();
    check_prescribed<3>();
  }


  TEST(Mechanics, patch_test_solved)
  {
    for (const std::string tangent : {"consistent", "double mapping"})
      {
        check_solved<2>(tangent, ShapeFunctions::gimp);
        check_solved<3>(tangent, ShapeFunctions::gimp);
        check_solved<2>(tangent, ShapeFunctions::linear);
      }
  }
} // namespace mechanics_patch
