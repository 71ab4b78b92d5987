// SPDX-License-Identifier: LGPL-2.1-or-later
// A phreatic line that takes its time to follow the water outside.
#include <waker/base/errors.h>
#include <waker/case/case.h>
#include <waker/case/scene.h>
#include <waker/case/state.h>
#include <waker/loads/following_line.h>
#include <waker/loads/pore_water.h>
#include <waker/program/parameter_reader.h>
#include <waker/simulation/plausibility.h>
#include <waker/simulation/realisation.h>

#include "output_temporary_folder.h"
#include "user_errors.h"
#include <cmath>
#include <gtest/gtest.h>

namespace loads_line_delay
{
  using namespace Waker;

  namespace
  {
    /// A drained dyke of 2 m beside water that rises from 0.5 to 1 m in a
    /// second.
    std::unique_ptr<Parameters>
    dyke(const std::vector<std::string> &more)
    {
      const std::string path = put_for_process("line_delay.prm", R"(
subsection Grid
  set Lower corner = -1, 0
  set Upper corner = 13, 3
  set Cell size    = 0.5
end
subsection Materials
  set Names = clay
  subsection clay
    set Model           = Mohr-Coulomb
    set Unit weight     = 18
    set Young's modulus = 10000
    set Poisson's ratio = 0.3
    set Cohesion        = 10
  end
end
subsection Soil profile
  set Layers = dyke
  subsection dyke
    set Material = clay
    set Polygon  = 0, 0; 12, 0; 7, 2; 5, 2
  end
end
subsection Boundary conditions
  set Names = base
  subsection base
    set Region = bottom
    set Type   = fixed
  end
end
subsection Water
  set Side            = left
  set Level           = 0.5
  set Rise            = 0: 0, 1: 0.5
  set Minimum support = 0
end
subsection Pore water
  set Lines by level = 0: 0, 0; 12, 0 | 2: 0, 2; 5, 2; 12, 0
  set Delay          = 0: 0, 5: 2
end
subsection Surface
  set Method = contour
end
subsection Initial failure
  set Width change = 0.6
end
subsection Time stepping
  set Time step     = 0.05
  set End time      = 30
  set Ramp duration = 1
end
)");
      return read_parameters(path, more);
    }
  } // namespace


  // dL/dt = (h - L)/T in closed form: after a step of h from 0 to 1 the level
  // is 1 - exp(-t/T), behind a level that rises by r it lags r (t - T (1 -
  // exp(-t/T))), whatever the steps.
  TEST(LineDelay, the_level_follows_as_the_exponential)
  {
    constexpr double T = 3., rate = 0.25;
    const LineDelay  delay("3", "path");
    for (const double dt : {1e-6, 0.01, 0.5, 40.})
      {
        std::vector<double> jump = delay.start(0.), ramp = delay.start(0.);
        double              t = 0.;
        for (unsigned int i = 0; i < 7; ++i)
          {
            delay.follow(1., 1., dt, jump);
            delay.follow(rate * t, rate * (t + dt), dt, ramp);
            t += dt;
            const double in = -std::expm1(-t / T);
            EXPECT_NEAR(jump[0], in, 1e-13 * in);
            // Nearly all of it cancels for short times.
            EXPECT_NEAR(ramp[0],
                        rate * (t - T * in),
                        1e-13 * rate * t + 1e-9 * ramp[0]);
          }
      }
    // None at all, and one that is hardly there.
    std::vector<double> at_once = LineDelay().start(1.), soon = at_once;
    LineDelay().follow(1., 4., 0.01, at_once);
    LineDelay("1e-12", "").follow(1., 4., 0.01, soon);
    EXPECT_EQ(at_once[0], 4.);
    EXPECT_NEAR(soon[0], 4., 1e-9);
  }


  TEST(LineDelay, short_steps_lose_no_digits)
  {
    // Ten thousand steps of a billionth of the delay: L = r t^2 / (2 T).
    const LineDelay     delay("1000", "");
    std::vector<double> level = delay.start(0.);
    const double        dt    = 1e-6;
    for (unsigned int i = 0; i < 10000; ++i)
      delay.follow(i * dt, (i + 1) * dt, dt, level);
    const double t = 1e-2;
    EXPECT_NEAR(level[0], t * t / 2e3, 1e-5 * t * t / 2e3);
  }


  TEST(LineDelay, a_constant_level_has_none_to_the_last_digit)
  {
    const double        level = 0.1 + 0.2;
    const LineDelay     delay("0: 1, 5: 7", "");
    std::vector<double> arrived = delay.start(level);
    for (unsigned int i = 0; i < 100; ++i)
      delay.follow(level, level, 0.0137 * i, arrived);
    for (const double l : arrived)
      EXPECT_EQ(l, level);
  }


  TEST(LineDelay, it_grows_into_the_dyke)
  {
    const LineDelay     delay("0: 0, 5: 2, 10: 8", "");
    std::vector<double> arrived = delay.start(1.);
    delay.follow(1., 1., 0., arrived);
    delay.follow(3., 3., 2., arrived);
    EXPECT_EQ(delay.largest(), 8.);
    const double at_5  = 3. - 2. * std::exp(-1.),
                 at_10 = 3. - 2. * std::exp(-0.25);
    EXPECT_NEAR(delay.level_at(-4., arrived), 3., 1e-14);
    EXPECT_NEAR(delay.level_at(5., arrived), at_5, 1e-14);
    EXPECT_NEAR(delay.level_at(7.5, arrived), 0.5 * (at_5 + at_10), 1e-14);
    EXPECT_NEAR(delay.level_at(99., arrived), at_10, 1e-14);
    // The line is that of the level that has arrived, at its corners.
    const PhreaticLines lines("0: 0, 0; 20, 0 | 4: 0, 4; 20, 0", "");
    const PhreaticLine  now      = FollowingLine(lines, delay).at(arrived);
    const auto          expected = [](const double x, const double level) {
      return level * (1. - x / 20.);
    };
    EXPECT_NEAR(now.height(0.), expected(0., 3.), 1e-14);
    EXPECT_NEAR(now.height(5.), expected(5., at_5), 1e-14);
    EXPECT_NEAR(now.height(10.), expected(10., at_10), 1e-14);
    EXPECT_NEAR(now.height(20.), 0., 1e-14);
  }


  TEST(LineDelay, what_is_no_delay)
  {
    for (const auto &[text, problem] :
         std::vector<std::pair<std::string, std::string>>{
           {"", "is empty"},
           {"-1", "is -1 s"},
           {"nan", "no place and delay"},
           {"inf", "no place and delay"},
           {"0: 1, 0: 2", "x = 0 m after x = 0 m"},
           {"0: 1, 5: -2", "is -2 s"},
           {"0: 1, 5", "\"5\""},
           {"0: 1: 2", "\"0: 1: 2\""}})
      EXPECT_USER_ERROR(LineDelay(text, "Pore water/Delay"),
                        "Pore water/Delay",
                        problem);
    EXPECT_NO_THROW(LineDelay("1e308", ""));
    EXPECT_USER_ERROR(dyke({"Pore water/Delay=-3"}),
                      "--set Pore water/Delay",
                      "is -3 s");
  }


  TEST(LineDelay, the_pressure_in_a_dyke_comes_after_the_water)
  {
    const auto     parameters = dyke({});
    const Case<2>  the_case(*parameters, MPI_COMM_SELF);
    State<2>       state = initial_state(the_case);
    Realisation<2> realisation(the_case, state);
    for (unsigned int i = 0; i < 40; ++i)
      {
        ASSERT_EQ(realisation.look(), StopReason::none);
        realisation.advance();
      }
    realisation.look();
    EXPECT_NEAR(state.time, 2., 1e-12);
    // 0.5 m in a second, and a second more: at x = 5 m and beyond.
    const double after_one = 0.5 * (1. - 2. * -std::expm1(-0.5));
    const double level     = 1. - (0.5 - after_one) * std::exp(-0.5);
    ASSERT_EQ(state.pore_water.arrived.size(), 1u);
    EXPECT_NEAR(state.pore_water.arrived[0][0], 1., 1e-14);
    EXPECT_NEAR(state.pore_water.arrived[0][1], level, 1e-13);
    const auto  &u = state.points.scalar("pore pressure");
    unsigned int n = 0;
    for (std::size_t p = 0; p < state.points.n_points(); ++p)
      if (const Point<2> x = state.points.position[p]; x[0] > 5.)
        {
          n += u[p] > 0. ? 1 : 0;
          EXPECT_NEAR(u[p],
                      std::max(10. * (level * (12. - x[0]) / 7. - x[1]), 0.),
                      1e-11);
        }
    EXPECT_GT(n, 30u);
    // Until a thousandth is left of it the loads change.
    EXPECT_EQ(the_case.pore_water.time_to_settle(), 14.);
    EXPECT_EQ(the_case.last_load_change, 15.);
    EXPECT_TRUE(realisation.unrest().loads_change);
    const auto    at_once = dyke({"Pore water/Delay=0"});
    const Case<2> soon(*at_once, MPI_COMM_SELF);
    EXPECT_EQ(soon.last_load_change, 1.);
  }


  TEST(LineDelay, a_checkpoint_has_what_has_arrived)
  {
    const auto     parameters = dyke({});
    const Case<2>  the_case(*parameters, MPI_COMM_SELF);
    State<2>       state = initial_state(the_case), other;
    Realisation<2> realisation(the_case, state);
    const auto     go = [](Realisation<2> &r, const unsigned int n) {
      for (unsigned int i = 0; i < n; ++i)
        {
          r.look();
          r.advance();
        }
    };
    go(realisation, 10);
    other.read(state.write());
    go(realisation, 15);
    Realisation<2> resumed(the_case, other);
    go(resumed, 15);
    EXPECT_EQ(other.pore_water.arrived, state.pore_water.arrived);
    EXPECT_EQ(other.pore_water.level, state.pore_water.level);
    EXPECT_EQ(other.points.scalar("pore pressure"),
              state.points.scalar("pore pressure"));
    EXPECT_TRUE(other.write() == state.write());
  }


  TEST(LineDelay, constant_water_is_that_without_delay)
  {
    std::vector<std::string> bytes;
    for (const char *const delay : {"0", "0: 0, 5: 2", "100"})
      {
        const auto parameters =
          dyke({std::string("Pore water/Delay=") + delay, "Water/Rise=0"});
        const Case<2>  the_case(*parameters, MPI_COMM_SELF);
        State<2>       state = initial_state(the_case);
        Realisation<2> realisation(the_case, state);
        for (unsigned int i = 0; i < 10; ++i)
          {
            realisation.look();
            realisation.advance();
          }
        state.pore_water = PoreWaterRecord(); // of another length
        bytes.push_back(state.write());
      }
    EXPECT_TRUE(bytes[0] == bytes[2]);
    // Lines with more corners are the same up to round-off.
    State<2> two, one;
    one.read(bytes[0]);
    two.read(bytes[1]);
    for (std::size_t p = 0; p < one.points.n_points(); ++p)
      ASSERT_NEAR(one.points.scalar("pore pressure")[p],
                  two.points.scalar("pore pressure")[p],
                  1e-9);
  }


  TEST(LineDelay, what_is_strange_is_said)
  {
    const auto said = [](const std::vector<std::string> &more,
                         const std::string              &words) {
      for (const std::string &text : strange_parameters(*dyke(more)))
        if (text.find(words) != std::string::npos)
          return true;
      return false;
    };
    EXPECT_TRUE(said({"Pore water/Delay=3"}, "is 3 s on the outer side"));
    EXPECT_FALSE(said({}, "on the outer side"));
    EXPECT_TRUE(said({"Pore water/Lines by level=",
                      "Pore water/Phreatic line=0, 0; 12, 0"},
                     "Pore water/Delay is not used"));
  }
} // namespace loads_line_delay
