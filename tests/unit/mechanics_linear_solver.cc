// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/multilevel.h>
#include <waker/mechanics/system_operator.h>

#include "box_of_soil.h"
#include <gtest/gtest.h>

namespace mechanics_linear_solver
{
  // When the linear solver takes the levels, and the levels on several ranks.
  // Of one rank and, by tests/cases/ranks.py, of three.

  using namespace Waker;
  using namespace BoxOfSoil;
  using BoxOfSoil::Body;
  using BoxOfSoil::Box;

  namespace
  {
    /// A preconditioner that cannot be set up.
    struct Hopeless : public Preconditioner
    {
      explicit Hopeless(unsigned int &n_trials)
        : n_trials(n_trials)
      {}

      bool
      reinit(const Operator &) override
      {
        ++n_trials;
        return false;
      }

      void
      clear() override
      {}

      void
      vmult(NodalVector &, const NodalVector &) const override
      {
        FAIL() << "it has been refused";
      }

      unsigned int &n_trials;
    };


    constexpr double linear_tolerance = 1e-6;

    LinearReport
    solve_twice(const Body<3> &body, LinearSolver &solver, NodalVector &x)
    {
      const StaticOperator A(*body.system, body.weight(), 1e-7);
      solver.prepare(A);
      LinearReport report =
        solver.solve(A, x, body.weight(), linear_tolerance, 5000);
      EXPECT_TRUE(report.converged);
      const LinearReport second =
        solver.solve(A, x, body.weight(), linear_tolerance, 5000);
      EXPECT_TRUE(second.converged);
      report.iterations += second.iterations;
      report.strong_iterations += second.strong_iterations;
      return report;
    }


    /// Nearly incompressible soil takes 254 iterations with the diagonal, 94
    /// are expected: the levels come after 200 of them, and stay. They do not
    /// for a body with which the diagonal is content.
    TEST(LinearSolver, TakesTheLevelsWhereTheDiagonalTakesLong)
    {
      const Kind    hard = {0., 0.495, 1., VolumetricStrain::b_bar_everywhere};
      const Body<3> body({{10, 10, 10}}, hard);
      const auto   &grid = body.grid;
      NodalVector   x(grid.n_dofs()), y(x), z(x);
      LinearSolver  plain(grid.n_dofs(), grid.exchange());
      const auto    of_diagonal = solve_twice(body, plain, x);
      EXPECT_EQ(of_diagonal.strong_iterations, 0u);
      EXPECT_GT(of_diagonal.iterations, 400u);

      LinearSolver both(grid.n_dofs(),
                        grid.exchange(),
                        std::make_unique<Multilevel<3>>(grid));
      const auto   of_both = solve_twice(body, both, y);
      EXPECT_GT(of_both.strong_iterations, 20u);
      EXPECT_LT(of_both.iterations, 300u);
      EXPECT_EQ(of_both.iterations - of_both.strong_iterations, 200u);
      EXPECT_FALSE(of_both.strong_failed);

      unsigned int n_trials = 0;
      LinearSolver hopeless(grid.n_dofs(),
                            grid.exchange(),
                            std::make_unique<Hopeless>(n_trials));
      const auto   of_hopeless = solve_twice(body, hopeless, z);
      EXPECT_TRUE(of_hopeless.strong_failed);
      EXPECT_EQ(n_trials, 1u); // not again in the same step
      EXPECT_EQ(of_hopeless.strong_iterations, 0u);

      // Displacements; the residuals are 1e-6.
      y -= x;
      z -= x;
      EXPECT_LT(y.l2_norm(), 1e-4 * x.l2_norm());
      EXPECT_LT(z.l2_norm(), 1e-4 * x.l2_norm());

      const Body<3> easy(Box{{8, 8, 8}});
      LinearSolver  content(easy.grid.n_dofs(),
                           easy.grid.exchange(),
                           std::make_unique<Multilevel<3>>(easy.grid));
      NodalVector   w(easy.grid.n_dofs());
      EXPECT_EQ(solve_twice(easy, content, w).strong_iterations, 0u);
    }


    /// Of what one rank has found, and several have.
    double
    relative_difference(const Body<3>     &alone,
                        const NodalVector &x,
                        const Body<3>     &shared,
                        const NodalVector &of_shared)
    {
      NodalVector difference = x;
      if (shared.window)
        {
          std::vector<double> all(shared.whole.n_dofs());
          shared.partition.gather(*shared.window,
                                  of_shared.begin(),
                                  3,
                                  all.data());
          for (std::size_t dof = 0; dof < all.size(); ++dof)
            difference.begin()[dof] -= all[dof];
        }
      else
        difference -= of_shared;
      // Nodes that soil hardly touches have motions without stiffness, which
      // the round-off of single precision moves: their mass is small.
      double square = 0., of_difference = 0.;
      for (unsigned int dof = 0; dof < x.size(); ++dof)
        {
          const double mass = alone.nodes.mass[dof / 3];
          square += mass * std::pow(x.begin()[dof], 2);
          of_difference += mass * std::pow(difference.begin()[dof], 2);
        }
      return std::sqrt(of_difference / square);
    }


    /// The same body as one rank has it, whatever the rank, also if some have
    /// next to nothing of it.
    void
    check_ranks(const Kind &kind, const double reduction)
    {
      const Box     cells = {{12, 12, 12}};
      const Body<3> alone(cells, kind), shared(cells, kind, MPI_COMM_WORLD);
      std::vector<NodalVector> x;
      unsigned int             n_iterations[2];
      for (const Body<3> *body : {&alone, &shared})
        {
          LinearSolver         solver(body->grid.n_dofs(),
                              body->grid.exchange(),
                              std::make_unique<Multilevel<3>>(body->grid));
          const StaticOperator A(*body->system, body->weight(), 1e-7);
          solver.prepare(A);
          x.emplace_back(body->grid.n_dofs());
          const LinearReport report =
            solver.solve(A, x.back(), body->weight(), reduction, 1000);
          EXPECT_TRUE(report.converged);
          EXPECT_EQ(report.iterations, report.strong_iterations);
          n_iterations[x.size() - 1] = report.iterations;
        }
      EXPECT_GT(x[0].linfty_norm(), 1e-3);
      EXPECT_LT(relative_difference(alone, x[0], shared, x[1]), 1e-5);
      EXPECT_NEAR(n_iterations[1], n_iterations[0], 5);
    }


    TEST(Ranks, LevelsOnSeveralRanks)
    {
      check_ranks(Kind(), 1e-12);
      // Domains that stick out, of soils of two stiffnesses.
      check_ranks({0.2, 0.3, 0.1}, 1e-12);
    }


    /// What diffuses and is carried along each direction of the lattice, in
    /// double precision: not symmetric.
    struct Convection : public Operator
    {
      explicit Convection(const BackgroundGrid<3> &grid)
        : grid(grid)
      {}

      void
      vmult(NodalVector &dst, const NodalVector &src) const override
      {
        NodalVector x(src);
        grid.exchange().send_to_others({{x.begin(), 3}});
        dst = 0.;
        for (unsigned int node = 0; node < grid.n_nodes(); ++node)
          if (grid.exchange().owns(node))
            for (unsigned int c = 0; c < 3; ++c)
              dst.begin()[3 * node + c] = row(x, node, c);
      }

      double
      row(const NodalVector &x,
          const unsigned int node,
          const unsigned int c) const
      {
        const auto index = grid.node_index(node);
        double     sum   = diagonal * x.begin()[3 * node + c];
        for (unsigned int d = 0; d < 3; ++d)
          {
            const unsigned int stride = grid.stride(d);
            if (index[d] > 0)
              sum -= (1. + carried) * x.begin()[3 * (node - stride) + c];
            if (index[d] + 1 <
                static_cast<int>(grid.n_nodes_per_direction()[d]))
              sum -= (1. - carried) * x.begin()[3 * (node + stride) + c];
          }
        return sum;
      }

      void
      add_diagonal(NodalVector &values) const override
      {
        for (unsigned int dof = 0; dof < values.size(); ++dof)
          if (grid.exchange().owns(dof / 3))
            values.begin()[dof] += diagonal;
      }

      bool
      is_symmetric() const override
      {
        return false;
      }

      static constexpr double  diagonal = 6.01, carried = 0.5;
      const BackgroundGrid<3> &grid;
    };


    /// GMRES, which takes the parts of a vector along its basis by one sum over
    /// all ranks, with so many iterations that it begins anew.
    TEST(Ranks, GmresOnSeveralRanks)
    {
      const Box                 cells = {{12, 12, 12}};
      const Body<3>             alone(cells), shared(cells, {}, MPI_COMM_WORLD);
      std::vector<NodalVector>  x;
      std::vector<unsigned int> n_iterations;
      for (const Body<3> *body : {&alone, &shared})
        {
          const Convection A(body->grid);
          LinearSolver     solver(body->grid.n_dofs(), body->grid.exchange());
          solver.prepare(A);
          x.emplace_back(body->grid.n_dofs());
          const NodalVector  b      = body->weight();
          const LinearReport report = solver.solve(A, x.back(), b, 1e-12, 1000);
          EXPECT_TRUE(report.converged);
          n_iterations.push_back(report.iterations);

          NodalVector residual(x.back());
          A.vmult(residual, x.back());
          residual -= b;
          EXPECT_LT(body->norm(residual), 2e-12 * body->norm(b));
        }
      EXPECT_LT(relative_difference(alone, x[0], shared, x[1]), 1e-10);
      EXPECT_NEAR(n_iterations[1], n_iterations[0], 1);
      EXPECT_GT(n_iterations[0], 40u);
    }


    /// A rank may have no soil, one that has some a slice of it.
    TEST(Ranks, LevelsWhereARankHasNothing)
    {
      Kind low;
      low.height = 2 * h;
      const Body<3> body(Box{{12, 24, 12}}, low, MPI_COMM_WORLD);
      Multilevel<3> levels(body.grid);
      ASSERT_TRUE(levels.reinit(*body.system));
      NodalVector x(body.grid.n_dofs());
      levels.vmult(x, body.weight());
      EXPECT_GT(body.grid.exchange().sum(x * body.weight()), 1e-3);
      const NodeExchange &ranks   = body.grid.exchange();
      const double        n_empty = ranks.sum(body.points.n_points() == 0);
      const unsigned int  n_ranks =
        Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
      EXPECT_LT(n_empty, n_ranks);
      EXPECT_EQ(n_empty > 0., n_ranks > 1);
    }


    /// Realisations side by side: one sets up its levels, others do not.
    TEST(Ranks, LevelsOfOneRankAlone)
    {
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        {
          const Body<3> body(Box{{8, 8, 8}});
          Multilevel<3> first(body.grid), second(body.grid);
          ASSERT_TRUE(first.reinit(*body.system));
          ASSERT_TRUE(second.reinit(*body.system));
          // Nothing in it is by chance.
          NodalVector x(body.grid.n_dofs()), y(x);
          first.vmult(x, body.weight());
          second.vmult(y, body.weight());
          EXPECT_GT(x.linfty_norm(), 1e-3);
          y -= x;
          EXPECT_EQ(y.linfty_norm(), 0.);
        }
      MPI_Barrier(MPI_COMM_WORLD);
    }
  } // namespace
} // namespace mechanics_linear_solver
