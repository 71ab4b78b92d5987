// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/mapping/transfer.h>
#include <waker/materials/linear_elastic.h>
#include <waker/mechanics/direct_solver.h>
#include <waker/mechanics/ghost_stiffness.h>
#include <waker/mechanics/logarithmic_motion.h>
#include <waker/mechanics/newton.h>
#include <waker/mechanics/soil.h>

#include "mapping_lattice.h"
#include "named.h"
#include <gtest/gtest.h>
#include <string>

namespace mechanics_ghost_stiffness
{
  // Nodes that support domains hardly touch, and the direct solver.

  using namespace Waker;

  namespace
  {
    constexpr double h = 0.25, density = 1.5;


    /// A block whose domains reach a hair into the next cells above and right.
    template <int dim>
    struct Block
    {
      explicit Block(const double reach)
        : grid(Lattice::grid<dim>(2., h))
        , fixities(grid, {FixityParameters()})
        , weights(grid, ShapeFunctions::gimp)
        , nodes(grid)
      {
        Point<dim> lower;
        for (unsigned int d = 0; d < dim; ++d)
          lower[d] = (d == 1 ? 0. : 0.5) + reach * h;
        points = Lattice::box(lower, 4, 0.5 * h, density);
        materials.push_back(
          std::make_unique<LinearElastic>(density, 1000., 0.3));
        weights.reinit(points);
        to_nodes(points, weights, nodes);
      }

      double
      full_mass() const
      {
        return density * std::pow(h, dim);
      }

      BackgroundGrid<dim> grid;
      Fixities<dim>       fixities;
      Weights<dim>        weights;
      NodalState          nodes;
      MaterialPoints<dim> points;
      Materials           materials;
    };


    template <int dim>
    void
    check_operator()
    {
      Block<dim>          block(1e-3);
      GhostStiffness<dim> ghost(block.grid,
                                block.fixities,
                                3.,
                                block.full_mass());
      ghost.begin(block.points, block.nodes, 0., 1.);
      const unsigned int n = block.grid.n_dofs();
      Lattice::Random    random(7);

      // Linear fields cost nothing; others do, in balance.
      NodalVector force(n);
      const auto  linear = Lattice::linear_field(block.grid,
                                                random.matrix<dim>(-1., 1.),
                                                random.vector<dim>(-1., 1.));
      ghost.vmult_add(force, linear);
      EXPECT_LT(force.linfty_norm(), 1e-12);
      NodalVector u(n), v(n), other(n);
      for (double &value : u)
        value = random(-1., 1.);
      for (double &value : v)
        value = random(-1., 1.);
      force = 0.;
      ghost.vmult_add(force, u);
      ghost.vmult_add(other, v);
      EXPECT_GT(u * force, 1.);
      EXPECT_NEAR(u * other, v * force, 1e-12);
      EXPECT_NEAR(linear * force, 0., 1e-12);

      NodalVector diagonal(n), unit(n);
      ghost.add_diagonal(diagonal);
      for (unsigned int i = 0; i < n; ++i)
        {
          unit            = 0.;
          unit.begin()[i] = 1.;
          force           = 0.;
          ghost.vmult_add(force, unit);
          ASSERT_NEAR(diagonal.begin()[i], force.begin()[i], 1e-12);
        }

      // What it takes is the work of the force at the end.
      force = 0.;
      ghost.add_force(u, force);
      const ResistanceWork work = ghost.work(u);
      EXPECT_EQ(work.start, 0.);
      EXPECT_NEAR(work.end, -(u * force), 1e-13 * (u * force));

      // A body that fills its cells has none.
      Block<dim> full(0.);
      ghost.begin(full.points, full.nodes, 0., 1.);
      force = 0.;
      ghost.vmult_add(force, u);
      EXPECT_EQ(force.linfty_norm(), 0.);
    }


    TEST(GhostStiffness, Operator)
    {
      check_operator<2>();
      check_operator<3>();
    }


    /// How many second differences there are: each adds 1 + 4 + 1 times a
    /// spring's stiffness, modulus times h^(dim - 2), to the diagonal.
    template <int dim>
    double
    n_differences(const double reach)
    {
      constexpr double    modulus = 3.; // kPa
      Block<dim>          block(reach);
      GhostStiffness<dim> ghost(block.grid,
                                block.fixities,
                                modulus,
                                block.full_mass());
      ghost.begin(block.points, block.nodes, 0., 1.);
      NodalVector diagonal(block.grid.n_dofs());
      ghost.add_diagonal(diagonal);
      double sum = 0.;
      for (const double entry : diagonal)
        sum += entry;
      return sum / (6. * modulus * std::pow(h, dim - 2));
    }


    // The block has 4 nodes in each direction, the last of them hardly touched,
    // the first one along y held. Two differences along each line of nodes: the
    // second one has a node of the last layer, the first one only if the line
    // lies in it. None where all that is hardly touched is held, nor where one
    // of several is.
    TEST(GhostStiffness, ActsOnFreeNodesThatAreHardlyTouched)
    {
      // Along x in rows 1, 2 and 3 above the base, and along y, in which the
      // first difference has a held node where it is hardly touched.
      EXPECT_NEAR(n_differences<2>(1e-3), 2 * ((1 + 1 + 2) + 4), 1e-11);
      // Along x and along z: rows 1 and 2 with 3 and 2 times 1, row 3.
      EXPECT_NEAR(n_differences<3>(1e-3),
                  3 * (2 * (2 * (3 + 2) + 4 * 2) + 16),
                  1e-10);
      // The last layer has 0.3^2 / 2 of a full node's mass, 4.5 %: more than 1
      // %. Its corner has 0.2 %, one more in either direction.
      EXPECT_NEAR(n_differences<2>(0.3), 2 * 2, 1e-11);
    }


    /// The factorised matrix is that of the operator, with nodes of next to no
    /// stiffness in it.
    template <int dim>
    void
    check_direct_solver(const double reach)
    {
      Block<dim> block(reach);
      Soil<dim>  soil(
        block.weights,
        StressUpdate<dim>(block.materials,
                          std::make_unique<LogarithmicMotion<dim>>()),
        Tangent::consistent);
      NodalVector     u(block.grid.n_dofs()), force(u);
      Lattice::Random random(11);
      for (double &value : u)
        value = random(-0.02, 0.02) * h;
      soil.begin(block.points, block.nodes, 0., 1.);
      soil.add_force(u, force);
      soil.linearise();
      const Resistances<dim> resistances = {&soil};
      ReachedNodes           reached(block.grid);
      reached.reinit(block.nodes.mass);
      const SystemOperator<dim> system(resistances,
                                       1.,
                                       0.,
                                       block.nodes.mass,
                                       reached,
                                       block.fixities.removed_list());
      DirectSolver<dim>         solver(block.grid);
      solver.factorise(system, 1e-10);
      // Whatever the solution: its force is solved for.
      NodalVector b(force), x(force), product(force);
      for (const unsigned int dof : block.fixities.removed_list())
        u.begin()[dof] = 0.;
      system.vmult(b, u);
      const NodalVector original = b;
      solver.solve(x, b);
      system.vmult(product, x);
      product -= original;
      EXPECT_GT(original.linfty_norm(), 0.01);
      // In 3D the soil's products are of single precision: 2e-7 is met.
      const double tolerance = dim == 2 ? 2e-9 : 1e-6;
      EXPECT_LT(product.linfty_norm(), tolerance * original.linfty_norm());
      b -= original;
      EXPECT_LT(b.linfty_norm(), tolerance * original.linfty_norm());
    }


    TEST(DirectSolver, SolvesForTheOperator)
    {
      for (const double reach : {0., 0.3, 1e-3})
        {
          check_direct_solver<2>(reach);
          check_direct_solver<3>(reach);
        }
    }


    /// How Newton's method ends for a block under its weight, held at a face.
    std::string
    end_of_newton(const std::string &held)
    {
      Block<2>    block(0.3);
      NodalState &nodes = block.nodes;
      set_gravity<2>(10., nodes);
      FixityParameters support;
      support.region = Named{held};
      const Fixities<2> fixities(block.grid, {support});
      NewtonParameters  parameters;
      parameters.tolerance = 1e-6;
      NewtonSolver<2> newton(block.grid,
                             fixities,
                             parameters,
                             block.full_mass(),
                             LinearMethod::direct);
      Soil<2>         soil(block.weights,
                   StressUpdate<2>(block.materials,
                                   std::make_unique<LogarithmicMotion<2>>()),
                   parameters.tangent);
      soil.begin(block.points, nodes, 0., 1.);
      try
        {
          const NewtonReport report = newton.solve({&soil}, {}, nodes);
          EXPECT_EQ(report.converged,
                    report.residuals.back() <= parameters.tolerance);
          return report.converged ? "converged" : "not converged";
        }
      catch (const NumericalFailure &failure)
        {
          return failure.what();
        }
    }


    /// A force on a body that nothing holds is not solved for, and not hidden:
    /// the factorisation meets a pivot of 0, or round-off in its place, with
    /// which no residual becomes small.
    TEST(DirectSolver, AFreeBodyDoesNotConverge)
    {
      EXPECT_EQ(end_of_newton("bottom"), "converged");
      // Holds nodes that the body does not touch.
      const std::string end = end_of_newton("left");
      EXPECT_TRUE(end == "not converged" ||
                  end.rfind("the stiffness is singular", 0) == 0)
        << end;
    }
  } // namespace
} // namespace mechanics_ghost_stiffness
