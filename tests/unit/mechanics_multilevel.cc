// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/lac/solver_cg.h>

#include <waker/mechanics/ghost_stiffness.h>
#include <waker/mechanics/multilevel.h>
#include <waker/mechanics/node_matrix.h>
#include <waker/nodes/wall.h>

#include "box_of_soil.h"
#include <gtest/gtest.h>
#include <tuple>

namespace mechanics_multilevel
{
  // What static steps in space are preconditioned with: the matrix, and its
  // levels.

  using namespace Waker;
  using namespace BoxOfSoil;
  using BoxOfSoil::Body;
  using BoxOfSoil::Box;

  namespace
  {
    /// All rows times a vector, on one rank.
    template <int dim>
    NodalVector
    product(const NodeMatrix<dim> &matrix, const NodalVector &x)
    {
      NodalVector                   y(x);
      typename NodeMatrix<dim>::Row row;
      const auto                   &own = matrix.own_nodes();
      y                                 = 0.;
      for (unsigned int k = 0; k < own.size(); ++k)
        for (unsigned int c = 0; c < dim; ++c)
          {
            matrix.get_row(k, c, row);
            for (std::size_t l = 0; l < row.columns.size(); ++l)
              y.begin()[dim * own[k] + c] +=
                row.values[l] * x.begin()[dim * own[row.columns[l] / dim] +
                                          row.columns[l] % dim];
          }
      return y;
    }


    template <int dim>
    void
    check_matrix(const Kind &kind, const bool is_exact)
    {
      const Body<dim> body({{3, 3, 3}}, kind);
      NodalVector     diagonal(body.grid.n_dofs()), x(diagonal), y(diagonal);
      body.system->add_diagonal(diagonal);
      std::vector<unsigned char> is_equation(x.size());
      Lattice::Random            random(3);
      for (unsigned int dof = 0; dof < x.size(); ++dof)
        {
          is_equation[dof] = diagonal.begin()[dof] != 0.;
          x.begin()[dof]   = is_equation[dof] ? random(-1., 1.) : 0.;
        }
      NodeMatrix<dim> matrix(body.grid, is_equation);
      body.system->add_entries(matrix);
      matrix.compress();
      body.system->vmult(y, x);
      NodalVector  z      = product(matrix, x);
      const double energy = x * y, of_matrix = x * z;
      EXPECT_GT(energy, 10.);
      z -= y;
      if (is_exact)
        {
          // In 3D products are of single precision.
          EXPECT_LT(z.linfty_norm(),
                    (dim == 2 ? 1e-12 : 1e-6) * y.linfty_norm());
        }
      else
        {
          EXPECT_GT(z.linfty_norm(), 0.01 * y.linfty_norm());
          EXPECT_GT(of_matrix, 0.5 * energy);
          EXPECT_LT(of_matrix, 2. * energy);
        }
    }


    /// The tangent of domains that lie in one cell each; near it otherwise.
    TEST(Multilevel, MatrixIsNearTheTangent)
    {
      for (const VolumetricStrain strain :
           {VolumetricStrain::standard, VolumetricStrain::b_bar_everywhere})
        {
          check_matrix<2>({0., 0.45, 0.5, strain}, true);
          check_matrix<3>({0., 0.45, 0.5, strain}, true);
        }
      check_matrix<2>({0.2, 0.3, 1.}, false);
      check_matrix<3>({0.2, 0.3, 1.}, false);
    }


    /// Of a uniform strain also the energy is that of the tangent, wherever the
    /// domains lie.
    TEST(Multilevel, MatrixHasTheEnergyOfUniformStrain)
    {
      const Body<3>              body(Box{{3, 3, 3}}, {0.37, 0.3, 1.});
      std::vector<unsigned char> all(body.grid.n_dofs(), 1);
      NodeMatrix<3>              matrix(body.grid, all);
      body.soil->add_entries(matrix);
      matrix.compress();
      Lattice::Random   random(9);
      const NodalVector x = Lattice::linear_field(body.grid,
                                                  random.matrix<3>(-1., 1.),
                                                  random.vector<3>(-1., 1.));
      NodalVector       y(x);
      y = 0.;
      body.soil->vmult_add(y, x);
      EXPECT_GT(x * y, 10.);
      // Products are of single precision.
      EXPECT_NEAR(x * product(matrix, x), x * y, 1e-6 * (x * y));
    }


    /// Entries of other resistances, which reach over two cells, are theirs.
    TEST(Multilevel, MatrixOfGhostStiffness)
    {
      const Body<3>     body({{3, 3, 3}}, {1e-3, 0.3, 1.});
      GhostStiffness<3> ghost(body.grid,
                              body.fixities,
                              3.,
                              density * std::pow(h, 3));
      ghost.begin(body.points, body.nodes, 0., 1.);
      NodeMatrix<3> matrix(body.grid,
                           std::vector<unsigned char>(body.grid.n_dofs(), 1));
      ghost.add_entries(matrix);
      matrix.compress();
      NodalVector     x(body.grid.n_dofs()), y(x);
      Lattice::Random random(5);
      for (double &value : x)
        value = random(-1., 1.);
      ghost.vmult_add(y, x);
      EXPECT_GT(y.linfty_norm(), 1.);
      y -= product(matrix, x);
      EXPECT_LT(y.linfty_norm(), 1e-12);
    }


    /// Those of a wall off the grid: stiff across it, or in all directions.
    template <int dim>
    void
    check_wall(const WallType type)
    {
      Box cells = {{1, 1, 1}};
      for (unsigned int d = 0; d < dim; ++d)
        cells[d] = 4;
      const Body<dim> body(cells);
      WallParameters  wall;
      wall.name           = "wall";
      wall.type           = type;
      wall.line           = dim == 2 ? "0.4, 0.1; 0.8, 0.9"
                                     : "0.4, 0.1, 0.3; 0.4, 0.1, 0.9; "
                                       "0.8, 0.9, 0.9; 0.8, 0.9, 0.3";
      wall.penalty_factor = 10.;
      Walls<dim> walls(body.grid, {wall}, 1000., density * std::pow(h, dim));
      typename Walls<dim>::Tractions tractions(walls.n_spots());
      walls.reinit(body.points, body.nodes.mass, 0., tractions);
      NodalVector     x(body.grid.n_dofs()), y(x);
      Lattice::Random random(13);
      for (double &value : x)
        value = random(-1., 1.);
      walls.add_force(x, y);
      walls.linearise();
      y = 0.;
      walls.vmult_add(y, x);
      NodeMatrix<dim> matrix(body.grid,
                             std::vector<unsigned char>(x.size(), 1));
      walls.add_entries(matrix);
      matrix.compress();
      EXPECT_GT(y.linfty_norm(), 1.);
      const double size = y.linfty_norm();
      y -= product(matrix, x);
      EXPECT_LT(y.linfty_norm(), 1e-13 * size);
    }


    TEST(Multilevel, MatrixOfWalls)
    {
      for (const WallType type : {WallType::rough, WallType::smooth})
        {
          check_wall<2>(type);
          check_wall<3>(type);
        }
    }


    /// Conjugate gradients to 1e-6, as in a gravity step.
    template <int dim, typename M>
    unsigned int
    solve(const Body<dim> &body,
          const Operator  &A,
          const M         &preconditioner,
          NodalVector     &x)
    {
      const NodalVector b = body.weight();
      x                   = 0.;
      ReductionControl      control(5000, 1e-300, 1e-6, false, false);
      SolverCG<NodalVector> cg(control);
      cg.solve(A, x, b, preconditioner);
      return control.last_step();
    }


    struct Iterations
    {
      double diagonal, multilevel;
    };

    /// Of both preconditioners, whose solutions are the same.
    Iterations
    iterations(const Box &cells, const Kind &kind = Kind())
    {
      const Body<3>        body(cells, kind);
      const StaticOperator A(*body.system, body.weight(), 1e-7);
      Multilevel<3>        multilevel(body.grid);
      EXPECT_TRUE(multilevel.reinit(A));
      DiagonalMatrix<NodalVector> jacobi;
      jacobi.get_vector().reinit(body.grid.n_dofs());
      body.system->add_diagonal(jacobi.get_vector());
      for (double &entry : jacobi.get_vector())
        entry = entry != 0. ? 1. / entry : 0.;
      NodalVector      x(body.grid.n_dofs()), y(x);
      const Iterations n = {static_cast<double>(solve(body, A, jacobi, x)),
                            static_cast<double>(solve(body, A, multilevel, y))};
      // Of displacements; the residuals are 1e-6.
      y -= x;
      EXPECT_LT(y.l2_norm(), 1e-4 * x.l2_norm());
      return n;
    }


    /// Cells of 1/3, 1/6 and 1/12: measured are 9, 12 and 13 iterations with
    /// the levels.
    TEST(Multilevel, IterationsHardlyGrowWithTheCells)
    {
      const Iterations coarse = iterations({{8, 8, 8}}),
                       middle = iterations({{12, 12, 12}}),
                       fine   = iterations({{20, 20, 20}});

      EXPECT_LT(fine.multilevel, 1.5 * coarse.multilevel);
      EXPECT_LT(fine.multilevel, 1.25 * middle.multilevel);
      EXPECT_LT(fine.multilevel, 15.);
      EXPECT_GT(fine.diagonal, 2. * coarse.diagonal);
    }


    /// What is hard: layers of 1 and 100, nearly incompressible soil, a tower.
    /// Measured are 30, 51 and 10, instead of 230, 254 and 69.
    TEST(Multilevel, HardBodies)
    {
      for (const auto &[cells, kind, limit] :
           {std::tuple<Box, Kind, double>{{{10, 10, 10}}, {0., 0.3, 0.01}, 50.},
            {{{10, 10, 10}},
             {0., 0.495, 1., VolumetricStrain::b_bar_everywhere},
             80.},
            {{{4, 40, 4}}, {}, 20.}})
        {
          const Iterations n = iterations(cells, kind);
          EXPECT_LT(n.multilevel, limit);
          EXPECT_LT(n.multilevel, 0.5 * n.diagonal);
        }
    }
  } // namespace
} // namespace mechanics_multilevel
