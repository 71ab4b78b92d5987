// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/campaign/input.h>
#include <waker/campaign/realisation_runner.h>
#include <waker/program/parameter_reader.h>

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace campaign_three_dimensions
{
  namespace
  {
    using namespace Waker;


    TEST(RandomProperties, vary_along_the_dyke_in_three_dimensions)
    {
      const auto scenarios = read_scenarios(
        WAKER_SOURCE_DIRECTORY "/parameters/chapter5/analysis1.prm",
        {"Dimension=3",
         "Grid/Lower corner=-6, 0, 0",
         "Grid/Upper corner=42, 6, 4",
         "Grid/Cell size=1",
         "Surface/Prismatic=true",
         "Random fields/strength/Scales of fluctuation=8, 1, 2",
         "Random fields/strength/Correlation function=separable Markov",
         "Time stepping/End time=0.05"});
      RealisationRunner<3> runner(scenarios[0]->simulation,
                                  scenarios[0]->reliability.fields,
                                  1,
                                  MPI_COMM_SELF);

      // Neighbours differ less along x than along z, and there less than
      // upwards: mean squared differences against the exact correlation.
      double       squared[3] = {0., 0., 0.};
      unsigned int count[3]   = {0, 0, 0};
      for (std::uint64_t i = 0; i < 40; ++i)
        {
          const std::vector<double> noise =
            realisation_noise(1, i, runner.n_noise());
          const State<3>             state  = runner.initial(noise.data());
          const MaterialPoints<3>   &points = state.points;
          const std::vector<double> &strength =
            points.scalars[points.find_scalar("undrained shear strength")]
              .values;
          for (std::size_t p = 0; p < points.n_points(); p += 7)
            for (std::size_t q = 0; q < points.n_points(); ++q)
              for (unsigned int d = 0; d < 3; ++d)
                {
                  Tensor<1, 3> lag = points.position[q] - points.position[p];
                  lag[d] -= 0.5;
                  if (lag.norm() < 1e-9)
                    {
                      const double z = (strength[q] - strength[p]) / 2.6;
                      squared[d] += z * z;
                      ++count[d];
                    }
                }
        }
      const Correlation correlation(Correlation::Function::separable_markov,
                                    {8., 1., 2.});
      const std::array<double, 3> cell{{0.5, 0.5, 0.5}};
      const double variance = correlation.between_cells(cell, {{0, 0, 0}});
      for (unsigned int d = 0; d < 3; ++d)
        {
          std::array<int, 3> lag{{0, 0, 0}};
          lag[d]           = 1;
          const double rho = correlation.between_cells(cell, lag) / variance;
          ASSERT_GT(count[d], 2000u);
          // Ten other seeds scatter by less than 6 %.
          EXPECT_NEAR(squared[d] / count[d], 2. * (1. - rho), 0.2 * (1. - rho))
            << d;
        }

      const auto record = runner.run(1, 3, nullptr);
      ASSERT_TRUE(record);
      EXPECT_EQ(record->outcome, Outcome::still_moving); // so early
      EXPECT_GT(record->steps, 0u);
      EXPECT_EQ(record->unconverged_steps, 0u);
      EXPECT_NEAR(record->end_time, 0.05, 1e-12);
    }
  } // namespace
} // namespace campaign_three_dimensions
