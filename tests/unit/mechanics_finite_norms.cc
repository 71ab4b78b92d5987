// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/case/scene.h>
#include <waker/mechanics/gmres.h>
#include <waker/simulation/realisation.h>

#include "campaign_random_dyke.h"
#include <gtest/gtest.h>
#include <limits>

namespace mechanics_finite_norms
{
  // Infinity and what is not a number never pass for convergence or rest.

  using namespace Waker;

  namespace
  {
    constexpr double infinity  = std::numeric_limits<double>::infinity();
    constexpr double no_number = std::numeric_limits<double>::quiet_NaN();


    class Twice : public Operator
    {
    public:
      void
      vmult(NodalVector &dst, const NodalVector &src) const override
      {
        dst = src;
        dst *= 2.;
      }

      void
      add_diagonal(NodalVector &diagonal) const override
      {
        for (double &entry : diagonal)
          entry += 2.;
      }

      bool
      is_symmetric() const override
      {
        return true;
      }
    };


    std::unique_ptr<Input>
    dyke(std::vector<std::string> overrides)
    {
      overrides.push_back("Grid/Cell size=1");
      overrides.push_back("Time stepping/Maximum halvings=1");
      return std::move(read_scenarios(RandomDyke::base_case, overrides)[0]);
    }
  } // namespace


  TEST(FiniteNorms, gmres_does_not_converge_to_infinity)
  {
    NodalVector b(10), x(10), inverse_diagonal(10);
    inverse_diagonal = 0.5;
    const NodeExchange one_rank(0);
    Gmres              gmres(one_rank);
    gmres.prepare(inverse_diagonal);
    b = 1.;
    ASSERT_TRUE(gmres.solve(Twice(), x, b, 1e-6, 100).converged);
    EXPECT_NEAR(x.begin()[3], 0.5, 1e-6);
    for (const double bad :
         {infinity, no_number, 1e200}) // the square of 1e200 is one
      {
        b            = 1.;
        b.begin()[3] = bad;
        EXPECT_FALSE(gmres.solve(Twice(), x, b, 1e-6, 100).converged) << bad;
      }
  }


  TEST(FiniteNorms, gravity_step_does_not_converge_to_infinity)
  {
    const auto    input = dyke({});
    const Case<2> the_case(input->simulation, MPI_COMM_SELF);
    EXPECT_TRUE(the_case.gravity_report.converged);
    for (const double load : {1e200, infinity, no_number})
      {
        MaterialPoints<2> points = the_case.initial_points;
        Scene<2>          scene(the_case);
        scene.set(points);
        scene.nodes.external_force = load;
        const GravityReport report = gravity_step(the_case.materials,
                                                  scene.weights,
                                                  the_case.fixities,
                                                  the_case.full_node_mass,
                                                  1e-6,
                                                  the_case.parameters.mapping,
                                                  scene.nodes,
                                                  points);
        EXPECT_FALSE(report.converged) << load;
        ASSERT_FALSE(report.residuals.empty());
        EXPECT_EQ(report.residuals.back(), infinity) << load;
      }
  }


  TEST(FiniteNorms, loads_without_end_are_a_numerical_failure)
  {
    // A program may set what the reader refuses.
    const auto water                    = dyke({});
    water->simulation.water.unit_weight = 1e300;
    EXPECT_THROW(Case<2>(water->simulation, MPI_COMM_SELF), NumericalFailure);
    const auto load = dyke({"Point loads/Names=p",
                            "Point loads/p/From=15, 4",
                            "Point loads/p/Force=0, -1"});
    EXPECT_NO_THROW(Case<2>(load->simulation, MPI_COMM_SELF));
    load->simulation.point_loads[0].force = {0., -1e200};
    EXPECT_THROW(Case<2>(load->simulation, MPI_COMM_SELF), NumericalFailure);
  }


  TEST(FiniteNorms, a_step_that_gives_no_numbers_is_a_numerical_failure)
  {
    for (const char *const scheme : {"Newmark", "explicit", "quasi-static"})
      for (const double bad : {no_number, infinity, 1e200})
        {
          const auto input =
            dyke({std::string("Time stepping/Scheme=") + scheme,
                  "Time stepping/Ramp duration=0"});
          const Case<2>  the_case(input->simulation, MPI_COMM_SELF);
          State<2>       state = initial_state(the_case);
          Realisation<2> realisation(the_case, state);
          ASSERT_EQ(realisation.look(), StopReason::none);
          state.points.stress[7][0][0] = bad;
          EXPECT_THROW(
            {
              // A motion that is infinite shows in the next step at the latest.
              for (unsigned int step = 0; step < 3; ++step)
                {
                  realisation.advance();
                  realisation.look();
                }
            },
            NumericalFailure)
            << scheme << ", " << bad;
        }
  }
} // namespace mechanics_finite_norms
