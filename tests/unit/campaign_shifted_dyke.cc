// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/campaign/realisation_runner.h>

#include "campaign_random_dyke.h"
#include <cmath>
#include <gtest/gtest.h>

namespace campaign_shifted_dyke
{
  // Nothing depends on where the datum lies: a dyke and the same dyke 10 m
  // lower.

  namespace
  {
    using namespace Waker;
    using namespace RandomDyke;

    std::string
    text(const double number)
    {
      std::ostringstream out;
      out << number;
      return out.str();
    }


    /// The random dyke of chapter 5, coarse, `shift` metres higher.
    std::unique_ptr<Input>
    shifted(const double shift, std::vector<std::string> more)
    {
      const std::string base = text(shift), crest = text(5. + shift);
      for (const std::string &setting :
           {"Grid/Lower corner=-6, " + base,
            "Grid/Upper corner=42, " + text(6. + shift),
            "Soil profile/dyke/Polygon=0, " + base + "; 30, " + base +
              "; 15, " + crest + "; 5, " + crest,
            "Water/Level=" + text(4.75 + shift),
            std::string("Time stepping/Time step=0.02"),
            // Round-off decides which of two iterates is good enough.
            std::string("Gravity/Tolerance=1e-12"),
            std::string("Newton/Tolerance=1e-10")})
        more.push_back(setting);
      return coarse(more);
    }


    Record
    run(const Input &input, const std::uint64_t realisation)
    {
      RealisationRunner<2> runner(input.simulation,
                                  input.reliability.fields,
                                  1,
                                  MPI_COMM_SELF);
      return *runner.run(1, realisation, nullptr);
    }


    std::string
    complaint(const std::vector<std::string> &settings,
              const bool                      with_advice = false)
    {
      try
        {
          const auto    input = coarse(settings);
          const Case<2> the_case(input->simulation, MPI_COMM_SELF);
        }
      catch (const UserError &error)
        {
          return error.where + ": " + error.problem +
                 (with_advice ? ": " + error.allowed : "");
        }
      return "";
    }


    TEST(RealisationRunner, a_dyke_below_datum_is_the_same_dyke)
    {
      bool failed = false, stood = false;
      for (const auto &[mean, realisation] :
           {std::make_pair("8.5", 0u), std::make_pair("16", 1u)})
        {
          const std::vector<std::string> settings = {
            field + "Mean=" + mean, "Time stepping/End time=5"};
          const Record high = run(*shifted(0., settings), realisation);
          const Record low  = run(*shifted(-10., settings), realisation);

          EXPECT_EQ(low.outcome, high.outcome);
          EXPECT_EQ(low.steps, high.steps);
          EXPECT_EQ(low.mean_strength, high.mean_strength);
          EXPECT_NEAR(low.initial_time, high.initial_time, 1e-9);
          for (const auto slide : {&Record::inner_slide, &Record::outer_slide})
            {
              const SlopeSlide &a = low.*slide, &b = high.*slide;
              EXPECT_NEAR(a.time, b.time, 1e-9);
              EXPECT_NEAR(a.body.area, b.body.area, 1e-9);
            }
          EXPECT_NEAR(low.initial_time_thesis, high.initial_time_thesis, 1e-9);
          EXPECT_NEAR(low.flooding_time, high.flooding_time, 1e-9);
          EXPECT_NEAR(low.end_time, high.end_time, 1e-9);
          EXPECT_NEAR(low.initial_width, high.initial_width, 1e-9);
          EXPECT_NEAR(low.initial_height, high.initial_height - 10., 1e-9);
          EXPECT_NEAR(low.residual_width, high.residual_width, 1e-9);
          EXPECT_NEAR(low.residual_height, high.residual_height - 10., 1e-9);
          EXPECT_NEAR(low.inward.area, high.inward.area, 1e-9);
          EXPECT_NEAR(low.inward.dy, high.inward.dy, 1e-9);

          failed = failed || high.failed();
          stood  = stood || !high.failed();
        }
      EXPECT_TRUE(failed);
      EXPECT_TRUE(stood);
    }


    TEST(Case, a_level_without_soil_is_refused)
    {
      const auto says = [](const std::vector<std::string> &settings,
                           const std::string              &part) {
        const std::string text = complaint(settings);
        return text.find(part) != std::string::npos
                 ? testing::AssertionSuccess()
                 : testing::AssertionFailure() << "it says: " << text;
      };
      // Below all soil, and above it.
      EXPECT_TRUE(
        says({"Water/Level=-1"},
             "Water/Level: is -1 m, below all soil, which begins at 0"));
      EXPECT_TRUE(says({"Water/Level=5"},
                       "Water/Level: is 5 m, not below the crest at 5 m"));
      EXPECT_TRUE(says({"Water/Rise=0.5"},
                       "Water/Rise: puts the water at 5.25 m at the start"));
      EXPECT_TRUE(says({"Water/Rise=0: 0.5, 2: 0"}, "Water/Rise"));
      // The level at t = 0 counts, however it is split.
      for (const char *const rise : {"1", "1.1", "1+t", "0: 1, 2: 0"})
        EXPECT_TRUE(says({"Water/Level=4", std::string("Water/Rise=") + rise},
                         "at the start, not below the crest at 5 m"))
          << rise;
      EXPECT_EQ(complaint({"Water/Level=4", "Water/Rise=0.75"}), "");
      EXPECT_EQ(complaint({"Water/Rise=0: 0, 2: 0.5"}), "");
      // Of the time only.
      for (const char *const wrong : {"0.1*x", "0.1*q", "2 +"})
        {
          const std::string text =
            complaint({std::string("Water/Rise=") + wrong}, true);
          EXPECT_NE(text.find("Water/Rise: "), std::string::npos) << text;
          EXPECT_EQ(text.find("x, y"), std::string::npos) << text;
        }
      // No level is no 0.
      EXPECT_TRUE(says({"Water/Level=none"},
                       "Water/Level: is none, but water stands on the left"));
      for (const char *const wrong : {"", "4,5", "high", "nan", "1e999", "4 m"})
        EXPECT_TRUE(says({std::string("Water/Level=") + wrong},
                         "Water/Level: \"" + std::string(wrong) + "\""))
          << wrong;
      EXPECT_EQ(complaint({"Water/Level=none", "Water/Side=none"}), "");
    }


    TEST(Case, without_a_level_there_is_no_width)
    {
      for (const char *const level : {"none", "7"})
        {
          const auto input =
            coarse({"Water/Side=none", std::string("Water/Level=") + level});
          const Case<2>  the_case(input->simulation, MPI_COMM_SELF);
          State<2>       state = initial_state(the_case);
          Realisation<2> realisation(the_case, state);
          EXPECT_EQ(realisation.look(), StopReason::none);
          realisation.advance();
          EXPECT_EQ(realisation.look(), StopReason::none);
          EXPECT_TRUE(std::isnan(state.failure.initial_width));
          EXPECT_TRUE(std::isnan(state.failure.geometry.width));
          EXPECT_NEAR(state.failure.geometry.height, 5., 0.3);
          EXPECT_FALSE(state.failure.failed());
          EXPECT_FALSE(state.failure.flooded());
        }
    }
  } // namespace
} // namespace campaign_shifted_dyke
