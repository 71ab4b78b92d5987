// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/system_operator.h>
#include <waker/nodes/springs.h>

#include "mapping_lattice.h"
#include <gtest/gtest.h>

namespace nodes_springs
{
  // Penalty supports as a resistance: force, product, diagonal and work belong
  // together; without soil they do not act; the ramp is not theirs.

  using namespace Waker;

  namespace
  {
    constexpr double h = 0.5;


    template <int dim>
    struct Base
    {
      explicit Base(const std::string &displacement)
        : grid(Lattice::grid<dim>(2., h))
        , fixities(grid, {parameters(displacement)})
        , springs(fixities, /*modulus=*/100., h)
        , nodes(grid)
        , u(grid.n_dofs())
      {
        // Soil in one half.
        for (unsigned int i = 0; i < grid.n_nodes(); ++i)
          nodes.mass[i] = grid.node_position(i)[0] > 1. ? 0. : 1.;
        Lattice::Random random(5);
        for (double &entry : u)
          entry = random(-1., 1.);
        springs.begin(points, nodes, 1., 0.5);
      }

      static FixityParameters
      parameters(const std::string &displacement)
      {
        FixityParameters base;
        base.name           = "base";
        base.type           = FixityType::prescribed;
        base.displacement   = displacement;
        base.method         = FixityMethod::penalty;
        base.penalty_factor = 3.;
        return base;
      }

      BackgroundGrid<dim> grid;
      Fixities<dim>       fixities;
      Springs<dim>        springs;
      NodalState          nodes;
      MaterialPoints<dim> points;
      NodalVector         u;
    };


    template <int dim>
    void
    check(const std::string &displacement)
    {
      Base<dim>    base(displacement);
      const double k = 3. * 100. * std::pow(h, dim - 2);
      NodalVector  force(base.u), product(base.u), diagonal(base.u);
      force = product = diagonal = 0.;
      base.springs.add_force(base.u, force);
      base.springs.vmult_add(product, base.u);
      base.springs.add_diagonal(diagonal);

      unsigned int   n_held = 0, n_without_soil = 0;
      double         work = 0.;
      Tensor<1, dim> reaction;
      for (const auto &penalty : base.fixities.penalties())
        {
          const unsigned int dof = penalty.dof, c = dof % dim;
          const bool         soil = base.nodes.mass[dof / dim] > 0.;
          const double       g = c == 0 ? 0.2 * 0.5 : 0.; // of 0.2 m/s in 0.5 s
          const double       u = base.u.begin()[dof];
          EXPECT_NEAR(force.begin()[dof], soil ? k * (u - g) : 0., 1e-12 * k);
          EXPECT_NEAR(product.begin()[dof], k * u, 1e-12 * k);
          EXPECT_NEAR(diagonal.begin()[dof], k, 1e-12 * k);
          reaction[c] -= force.begin()[dof];
          work -= force.begin()[dof] * u;
          ++(soil ? n_held : n_without_soil);
          force.begin()[dof] = product.begin()[dof] = diagonal.begin()[dof] =
            0.;
        }
      EXPECT_GT(n_held, 4u);
      EXPECT_GT(n_without_soil, 4u);
      for (const NodalVector *const rest : {&force, &product, &diagonal})
        EXPECT_EQ(rest->linfty_norm(), 0.);

      const Tensor<1, dim> accepted = base.springs.accept(base.u, base.points);
      EXPECT_NEAR((accepted - reaction).norm(), 0., 1e-11 * k);
      EXPECT_NEAR(base.springs.work(base.u).mean(), work, 1e-11 * k);
      EXPECT_EQ(base.springs.work(base.u).start, base.springs.work(base.u).end);
    }
  } // namespace


  TEST(Nodes, springs_hold_what_has_soil)
  {
    check<2>("0.2*t; 0");
    check<3>("0.2*t; 0; free");
  }


  TEST(Nodes, the_ramp_spares_supports)
  {
    Base<2>                 base("0; 0");
    const Resistances<2>    resistances = {&base.springs};
    ReachedNodes            reached(base.grid);
    const double            ramp = 0.25;
    std::vector<double>     none(base.grid.n_nodes(), 0.);
    const SystemOperator<2> system(
      resistances, ramp, 0., none, reached, base.fixities.removed_list());
    NodalVector product(base.u), expected(base.u), diagonal(base.u);
    expected = diagonal = 0.;
    system.vmult(product, base.u);
    base.springs.vmult_add(expected, base.u);
    EXPECT_GT(expected.linfty_norm(), 100.);
    product -= expected;
    EXPECT_EQ(product.linfty_norm(), 0.);
    expected = 0.;
    base.springs.add_diagonal(expected);
    system.add_diagonal(diagonal);
    diagonal -= expected;
    EXPECT_EQ(diagonal.linfty_norm(), 0.);
    EXPECT_TRUE(system.is_symmetric());
  }
} // namespace nodes_springs
