// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/transfer.h>
#include <waker/materials/von_mises_softening.h>
#include <waker/mechanics/newton.h>
#include <waker/mechanics/soil.h>
#include <waker/mechanics/step_motion.h>

#include "mapping_lattice.h"
#include "named.h"
#include "verification_data.h"
#include <gtest/gtest.h>

namespace mechanics_newton
{
  // How Newton's method converges in single steps that are hard on purpose,
  // with the consistent tangent and with double mapping.

  using namespace Waker;

  namespace
  {
    constexpr double h = 0.25, density = 1.5, gravity = 9.81;


    struct Outcome
    {
      std::vector<double> residuals;
      NodalVector         increment;
      double              mean_plastic_strain = 0.;
      unsigned int        n_softening         = 0;
      unsigned int        n_points            = 0;
    };


    struct Problem
    {
      std::string name;
      bool        softening; // else elastic, in a large rotation
      double      dt;        // s
      bool        aligned;   // all cells full, else some have slivers
    };


    /// A block of 1 m (0.5 m in 3D) on the grid. Elastic: in free flight,
    /// spinning by 0.5 rad in the step. Softening: on a fixed base, with its
    /// weight applied at once, twice what it can carry.
    template <int dim>
    Outcome
    solve(const Problem &problem, const std::string &tangent)
    {
      const auto grid = Lattice::grid<dim>(2., h);
      Point<dim> lower;
      for (unsigned int d = 0; d < dim; ++d)
        lower[d] = problem.aligned ? 0.5 : 0.43;
      if (problem.softening)
        lower[1] = 0.;
      const double size = dim == 2 ? 1. : 0.5;
      const double c_i  = size; // kPa
      auto points = Lattice::box(lower, dim == 2 ? 8 : 4, 0.5 * h, density);
      Materials materials;
      if (problem.softening)
        materials.push_back(std::make_unique<VonMisesSoftening>(
          density, 1000., 0.45, c_i, 0.3 * c_i, -50.));
      else
        materials.push_back(
          std::make_unique<LinearElastic>(density, 1000., 0.45));
      declare_material_variables(materials, points);

      std::vector<FixityParameters> supports;
      if (problem.softening)
        {
          supports.emplace_back();
          supports.back().name = "base";
        }
      const Fixities<dim> fixities(grid, supports);
      Weights<dim>        weights(grid, ShapeFunctions::gimp);
      NodalState          nodes(grid);
      weights.reinit(points);
      Point<dim>     centre;
      Tensor<2, dim> spin;
      for (unsigned int d = 0; d < dim; ++d)
        centre[d] = lower[d] + 0.5 * size;
      if (!problem.softening)
        {
          spin[0][1] = -0.5 / problem.dt;
          spin[1][0] = 0.5 / problem.dt;
        }
      for (unsigned int p = 0; p < points.n_points(); ++p)
        points.velocity[p] = spin * (points.position[p] - centre);
      to_nodes(points, weights, nodes);
      set_gravity<dim>(problem.softening ? gravity : 0., nodes);

      NodalVector history = nodes.velocity;
      history *= 4. / problem.dt;
      for (const unsigned int dof : fixities.removed_list())
        history.begin()[dof] = 0.;

      NewtonParameters parameters;
      parameters.tangent = Named{tangent};
      parameters.tolerance =
        tangent == name_of(Tangent::consistent) ? 3e-14 : 1e-10;
      parameters.linear_tolerance          = 1e-12;
      parameters.maximum_linear_iterations = 3000;
      parameters.maximum_iterations =
        tangent == name_of(Tangent::consistent) ? 20 : 400;
      NewtonSolver<dim>                         newton(grid,
                               fixities,
                               parameters,
                               density * std::pow(h, dim));
      typename NewtonSolver<dim>::ResidualTerms terms;
      terms.factor  = 4. / (problem.dt * problem.dt);
      terms.history = &history;
      Soil<dim> soil(weights,
                     StressUpdate<dim>(materials,
                                       std::make_unique<StepMotion<dim>>(true)),
                     parameters.tangent);
      soil.begin(points, nodes, 0., problem.dt);
      const NewtonReport report = newton.solve({&soil}, terms, nodes);
      soil.accept(nodes.increment, points);

      Outcome outcome;
      outcome.residuals           = report.residuals;
      outcome.increment           = nodes.increment;
      outcome.mean_plastic_strain = soil.report().plastic_strain;
      outcome.n_points            = points.n_points();
      if (problem.softening)
        for (const double c : points.scalar("undrained shear strength"))
          outcome.n_softening += c < c_i;
      return outcome;
    }


    /// Solves needed to come below `tolerance`; -1: never.
    int
    n_iterations(const std::vector<double> &residuals, const double tolerance)
    {
      for (unsigned int k = 0; k < residuals.size(); ++k)
        if (residuals[k] <= tolerance)
          return k;
      return -1;
    }


    template <int dim>
    void
    record(const Problem     &problem,
           const std::string &tangent,
           const Outcome     &outcome)
    {
      const std::string step =
        problem.name + (problem.aligned ? ", full cells" : ", cut cells");
      const auto &e = outcome.residuals;
      if (dim == 2)
        for (unsigned int k = 0; k < std::min<std::size_t>(e.size(), 101); ++k)
          Verification::row("newton",
                            "step,tangent,iteration,residual",
                            '"' + step + '"',
                            tangent,
                            k,
                            e[k]);
      Verification::row("newton_iterations",
                        "step,dimension,tangent,to 1e-3,to 1e-6,to 1e-10,"
                        "points softening,points",
                        '"' + step + '"',
                        dim,
                        tangent,
                        n_iterations(e, 1e-3),
                        n_iterations(e, 1e-6),
                        n_iterations(e, 1e-10),
                        outcome.n_softening,
                        outcome.n_points);
    }


    template <int dim>
    void
    check_convergence(const Problem &problem)
    {
      const Outcome newton = solve<dim>(problem, "consistent");
      const auto   &e      = newton.residuals;
      SCOPED_TRACE(problem.name + ' ' + std::to_string(problem.aligned) + ' ' +
                   std::to_string(dim));

      // Quadratic: once below 1e-2, e_{k+1} <= C e_k^2 until round-off.
      const double C = 10., round_off = 1e-13;
      unsigned int n_quadratic = 0;
      for (unsigned int k = 0; k + 1 < e.size(); ++k)
        if (e[k] < 1e-2 && e[k] > round_off)
          {
            EXPECT_LE(e[k + 1], std::max(C * e[k] * e[k], round_off))
              << "iteration " << k;
            ++n_quadratic;
          }
      EXPECT_GE(n_quadratic, 2u);
      EXPECT_LT(e.back(), round_off);
      EXPECT_LE(e.size(), 9u);
      if (problem.softening)
        {
          EXPECT_GT(newton.n_softening, newton.n_points / 2);
          EXPECT_GT(newton.mean_plastic_strain, 1e-3);
        }

      // Double mapping: linear at best, but the same answer where it gets
      // there.
      const Outcome mapped = solve<dim>(problem, "double mapping");
      const int     last   = n_iterations(mapped.residuals, 1e-10);
      EXPECT_TRUE(last < 0 || last >= 2 * n_iterations(e, 1e-10)) << last;
      EXPECT_LT(mapped.residuals.back(), 1e-3);
      if (problem.aligned)
        {
          EXPECT_LE(mapped.residuals.back(), 1e-10);
          NodalVector difference = mapped.increment;
          difference -= newton.increment;
          EXPECT_LT(difference.linfty_norm(),
                    1e-6 * newton.increment.linfty_norm());
        }
      record<dim>(problem, "consistent", newton);
      record<dim>(problem, "double mapping", mapped);
    }
  } // namespace


  TEST(Mechanics, newton_is_quadratic_in_an_elastic_large_rotation)
  {
    for (const bool aligned : {true, false})
      {
        const Problem problem = {"elastic rotation", false, 0.02, aligned};
        check_convergence<2>(problem);
        check_convergence<3>(problem);
      }
  }


  TEST(Mechanics, newton_is_quadratic_in_softening)
  {
    for (const bool aligned : {true, false})
      {
        const Problem problem = {"softening", true, 0.1, aligned};
        check_convergence<2>(problem);
        check_convergence<3>(problem);
      }
  }


  TEST(Mechanics, newton_sees_convergence_without_load)
  {
    // Supports that stretch a body uniformly, and nothing else: at the solution
    // no free node has any force, and a norm relative to the forces of free
    // nodes alone would divide round-off by round-off.
    const auto grid   = Lattice::grid<2>(1.5, h);
    auto       points = Lattice::box(Point<2>(), 12, 0.5 * h, density);
    Materials  materials;
    materials.push_back(std::make_unique<LinearElastic>(density, 1000., 0.3));
    FixityParameters left, right;
    left.name    = "left";
    left.region  = FixityRegion::left;
    right.name   = "right";
    right.region = FixityRegion::right;
    left.type = right.type = FixityType::prescribed;
    left.displacement      = "0; 0";
    right.displacement     = "0.01*t; 0";
    FixityParameters middle;
    middle.region       = FixityRegion::box;
    middle.name         = "middle";
    middle.from         = {-1., -1.};
    middle.to           = {3., 3.};
    middle.type         = FixityType::prescribed;
    middle.displacement = "free; 0";
    const Fixities<2> fixities(grid, {middle, left, right});
    Weights<2>        weights(grid, ShapeFunctions::gimp);
    NodalState        nodes(grid);
    weights.reinit(points);
    to_nodes(points, weights, nodes);
    std::vector<double> increments;
    fixities.removed_increments(0., 1., increments);
    for (unsigned int k = 0; k < increments.size(); ++k)
      nodes.increment.begin()[fixities.removed_list()[k]] = increments[k];

    NewtonParameters parameters;
    parameters.tolerance        = 1e-8;
    parameters.linear_tolerance = 1e-12;
    NewtonSolver<2> newton(grid, fixities, parameters, density * h * h);
    Soil<2>         soil(weights,
                 StressUpdate<2>(materials,
                                 std::make_unique<StepMotion<2>>(false)),
                 parameters.tangent);
    soil.begin(points, nodes, 0., 1.);
    const NewtonReport report = newton.solve({&soil}, {}, nodes);
    soil.accept(nodes.increment, points);
    EXPECT_TRUE(report.converged) << report.residuals.back();
    EXPECT_LE(report.iterations, 2u);
    // At first only the last column of cells is strained: its forces along x
    // pull at free nodes and, of half their mass, at supports. The latter
    // count, too.
    EXPECT_LT(report.residuals.front(), std::sqrt(1. / 1.5) + 1e-12);
    EXPECT_GT(report.residuals.front(), 0.5);
    const double M = 1000. * 0.7 / (1.3 * 0.4); // kPa, uniaxial strain
    for (const auto &stress : points.stress)
      EXPECT_NEAR(stress[0][0], M * 0.01 / 1.5, 1e-6);
  }


  TEST(Mechanics,
       newton_counts_nodes_by_their_mass_and_the_difference_of_inertia)
  {
    const auto                              grid      = Lattice::grid<2>(2., h);
    const double                            full_mass = density * h * h;
    const Fixities<2>                       fixities(grid, {});
    NodalState                              nodes(grid);
    NodalVector                             history(grid.n_dofs());
    typename NewtonSolver<2>::ResidualTerms terms;
    terms.factor  = 100.;
    terms.history = &history;
    // In balance: 3 kN on what 5 kN of inertia less 2 kN of history need. More
    // than the mass of a full node counts as that.
    const unsigned int a = grid.node({{3, 3}}), b = grid.node({{5, 5}});
    nodes.mass[a]                       = 2. * full_mass;
    nodes.external_force.begin()[2 * a] = 3.;
    nodes.increment.begin()[2 * a]      = 5. / (nodes.mass[a] * terms.factor);
    history.begin()[2 * a]              = 2. / nodes.mass[a];
    // Out of balance by 4 kN.
    nodes.mass[b]                           = 0.01 * full_mass;
    nodes.external_force.begin()[2 * b + 1] = 4.;

    NewtonParameters parameters;
    parameters.maximum_iterations = 0;
    NewtonSolver<2>    newton(grid, fixities, parameters, full_mass);
    const NewtonReport report = newton.solve({}, terms, nodes);
    EXPECT_FALSE(report.converged);
    ASSERT_EQ(report.residuals.size(), 1u);
    EXPECT_NEAR(report.residuals[0],
                std::sqrt(0.01 * 16. / (9. + 9. + 0.01 * 16.)),
                1e-14);
  }


  TEST(Mechanics, newton_never_takes_what_is_not_a_number_for_converged)
  {
    const auto grid   = Lattice::grid<2>(2., h);
    auto       points = Lattice::box(Point<2>(0.5, 0.5), 4, 0.5 * h, density);
    Materials  materials;
    materials.push_back(std::make_unique<LinearElastic>(density, 1000., 0.3));
    declare_material_variables(materials, points);
    const Fixities<2> fixities(grid, {});
    Weights<2>        weights(grid, ShapeFunctions::gimp);
    weights.reinit(points);
    NewtonParameters parameters;
    NewtonSolver<2>  newton(grid, fixities, parameters, density * h * h);

    // The last one's square overflows.
    for (const double bad : {std::nan(""), HUGE_VAL, 1e200, 0.})
      {
        NodalState nodes(grid);
        to_nodes(points, weights, nodes);
        NodalVector                             history = nodes.velocity;
        typename NewtonSolver<2>::ResidualTerms terms;
        terms.factor  = 1e4;
        terms.history = &history;
        for (unsigned int i = 0; i < nodes.mass.size(); ++i)
          if (nodes.mass[i] > 0.1 * density * h * h)
            {
              nodes.external_force.begin()[2 * i] = bad;
              break;
            }
        Soil<2> soil(weights,
                     StressUpdate<2>(materials,
                                     std::make_unique<StepMotion<2>>(false)),
                     parameters.tangent);
        soil.begin(points, nodes, 0., 1.);
        const NewtonReport report = newton.solve({&soil}, terms, nodes);
        EXPECT_EQ(report.converged, bad == 0.) << bad;
        EXPECT_EQ(report.residuals.back(), bad == 0. ? 0. : HUGE_VAL) << bad;
      }
  }
} // namespace mechanics_newton
