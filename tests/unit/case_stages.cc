// SPDX-License-Identifier: LGPL-2.1-or-later
// From the water of usual days to high water: what is carried, and how.
#include <waker/base/log.h>
#include <waker/case/state.h>
#include <waker/simulation/describe.h>
#include <waker/simulation/strengths.h>

#include "stress_in_ground.h"
#include <sstream>

namespace case_stages
{
  using namespace Waker;
  using namespace StressInGround;

  namespace
  {
    /// The level ground; daily water at 1 m, high water at 3 m.
    std::vector<std::string>
    staged(std::vector<std::string> more = {})
    {
      more.insert(more.begin(),
                  {"Initial stress/Daily stage=true",
                   "Pore water/Daily phreatic line=0, 1; 4, 1"});
      return more;
    }

    /// u (kPa) with the line at a height.
    double
    pressure(const double y, const double line)
    {
      return std::max(10. * (line - y), 0.);
    }

    /// The dyke of an example, coarse.
    std::unique_ptr<Parameters>
    dyke(const std::vector<std::string> &more = {})
    {
      return read_parameters(WAKER_SOURCE_DIRECTORY
                             "/parameters/verification/dyke_stages.prm",
                             more);
    }

    /// Takes seconds: one for several tests.
    const Case<2> &
    staged_dyke()
    {
      static const Case<2> the_case(*dyke(), MPI_COMM_SELF);
      return the_case;
    }
  } // namespace


  TEST(Stages, rising_water_under_level_ground_has_a_closed_form)
  {
    // Vertical stress is that of columns. Horizontally drained soil gets
    // nu/(1 - nu) of what its effective stress gains, and soil of total stress
    // of what its total stress gains.
    const double jaky = 1. - std::sin(33. * std::acos(-1.) / 180.);
    for (const unsigned int dim : {2u, 3u})
      {
        const auto check = [&](const auto &the_case) {
          const auto &points         = the_case.initial_points;
          double      worst_vertical = 0., worst_horizontal = 0.;
          for (std::size_t p = 0; p < points.n_points(); ++p)
            {
              const double y     = points.position[p][1];
              const bool   clay  = points.material[p] == 1;
              const double daily = vertical_stress(y, 1.),
                           now   = vertical_stress(y, 3.);
              const double k0    = clay ? 0.7 + 0.01 * y : jaky;
              const double nu    = clay ? 0.45 : 0.3;
              const double u_d   = clay ? pressure(y, 1.) : 0.,
                           u     = clay ? pressure(y, 3.) : 0.;
              const double gain  = now + u - daily - u_d;
              worst_vertical =
                std::max(worst_vertical,
                         std::abs(points.stress[p][1][1] + now + u));
              for (const unsigned int d : {0u, 2u})
                worst_horizontal =
                  std::max(worst_horizontal,
                           std::abs(points.stress[p][d][d] + k0 * daily + u_d +
                                    nu / (1. - nu) * gain));
            }
          // Of the second step the stress is that of a cell's centre: the soil
          // between the lines gains 2 kN/m^3, or 10 of water, over a quarter
          // of a cell.
          EXPECT_LT(worst_vertical, 1.3);
          EXPECT_LT(worst_horizontal, 1.3);
          EXPECT_GT(points.n_points(), 250u);
          double mean = 0.; // within each cell it is exact
          for (std::size_t p = 0; p < points.n_points(); ++p)
            {
              const double y = points.position[p][1];
              mean += points.stress[p][1][1] + vertical_stress(y, 3.) +
                      (points.material[p] == 1 ? pressure(y, 3.) : 0.);
            }
          EXPECT_NEAR(mean / points.n_points(), 0., 1e-5);
          ASSERT_EQ(the_case.stages.size(), 2u);
          EXPECT_LT(the_case.stages[0].imbalance, 1e-12); // K0 of level ground
          EXPECT_GT(the_case.stages[1].imbalance, 0.01);
          EXPECT_EQ(the_case.stages[0].name, "daily stage");
        };
        if (dim == 2)
          check(Case<2>(*read(level_ground, staged()), MPI_COMM_SELF));
        else
          check(
            Case<3>(*read(level_ground, in_space(staged())), MPI_COMM_SELF));
      }
  }


  TEST(Stages, without_a_change_of_the_water_nothing_changes)
  {
    for (const std::string laws : {"elastic", "plastic"})
      {
        const std::string setting = "Initial stress/Laws=" + laws;
        const Case<2>     once(*read(level_ground, {setting}), MPI_COMM_SELF);
        const Case<2>     twice(*read(level_ground,
                                  {setting, "Initial stress/Daily stage=true"}),
                            MPI_COMM_SELF);
        ASSERT_EQ(twice.stages.size(), 2u);
        EXPECT_LT(twice.stages[1].imbalance, 1e-12);
        for (std::size_t p = 0; p < once.initial_points.n_points(); ++p)
          EXPECT_LT((once.initial_points.stress[p] -
                     twice.initial_points.stress[p])
                      .norm(),
                    1e-9);
      }
  }


  TEST(Stages, sand_above_the_line_that_is_clay_below_carries_the_right_stress)
  {
    // Sand above the line (effective stress) is clay below (total stress), and
    // the daily line is the higher one, then the lower one.
    for (const double daily : {1., 3.75})
      {
        const std::string height = std::to_string(daily);
        const Case<2>     level(*read(level_ground,
                                  {"Initial stress/Daily stage=true",
                                       "Materials/sand/Below the line=clay",
                                       "Materials/clay/K0=0.6",
                                       "Pore water/Phreatic line=0, 2.5; 4, 2.5",
                                       "Pore water/Daily phreatic line=0, " +
                                         height + "; 4, " + height}),
                            MPI_COMM_SELF);
        const auto       &points    = level.initial_points;
        unsigned int      effective = 0, total = 0;
        double            worst = 0.;
        for (std::size_t p = 0; p < points.n_points(); ++p)
          {
            const Point<2> &x        = points.position[p];
            const bool      is_clay  = points.material[p] == 1;
            const double    pressure = std::max(10. * (2.5 - x[1]), 0.);
            EXPECT_EQ(is_clay, x[1] < 2.5);
            ++(is_clay ? total : effective);
            worst =
              std::max(worst,
                       std::abs(points.stress[p][1][1] +
                                points.scalar("initial vertical stress")[p] +
                                (is_clay ? pressure : 0.)));
          }
        EXPECT_GT(effective, 50u);
        EXPECT_GT(total, 50u);
        EXPECT_LT(worst, 2.); // a confusion of u leaves 12.5 kPa or more
      }
  }


  TEST(Stages, a_dyke_keeps_its_stress_within_the_strength_of_the_stage)
  {
    const Case<2> &staged = staged_dyke();
    ASSERT_EQ(staged.stages.size(), 2u);
    EXPECT_GT(staged.stages[0].imbalance, 0.02);
    EXPECT_GT(staged.stages[1].imbalance, 0.02);
    EXPECT_LT(largest_excess(staged), 1e-6);
    const auto &points = staged.initial_points;
    // Frozen: what SHANSEP says of columns, high water over daily.
    const auto  &ratio     = points.scalar("overconsolidation ratio");
    const auto  &strength  = points.scalar("undrained shear strength");
    unsigned int looked_at = 0;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const auto &material = staged.parameters.materials[points.material[p]];
        if (!material.strength_follows_stress())
          continue;
        const InGround in  = staged.ground.at(points.initial_position[p],
                                             staged.layers_of_points[p]);
        const double   pop = material.von_mises.strength.pop,
                     S     = material.von_mises.strength.ratio,
                     m     = material.von_mises.strength.exponent;
        const double ocr =
          (in.daily_vertical_stress + pop) / in.vertical_stress;
        EXPECT_NEAR(ratio[p], ocr, 1e-9 * ocr);
        EXPECT_NEAR(strength[p],
                    S * in.vertical_stress * std::pow(ocr, m),
                    1e-9 * strength[p]);
        EXPECT_EQ(points.scalar("initial vertical stress")[p],
                  in.vertical_stress);
        ++looked_at;
      }
    EXPECT_GT(looked_at, 1000u);
    // The same again, to the last bit: what a resumed run counts on.
    const Case<2> again(*dyke(), MPI_COMM_SELF);
    for (std::size_t p = 0; p < points.n_points(); ++p)
      EXPECT_EQ(points.stress[p], again.initial_points.stress[p]);
  }


  TEST(Stages, strengths_can_be_reduced_and_the_state_be_stored)
  {
    const Case<2> &staged   = staged_dyke();
    State<2>       state    = initial_state(staged);
    const auto    &strength = state.points.scalar("undrained shear strength");
    const auto     of_clay =
      std::max_element(strength.begin(), strength.end()) - strength.begin();
    const double before = strength[of_clay];
    ASSERT_GT(before, 0.);
    divide_strengths(staged.materials, 2., state.points);
    EXPECT_DOUBLE_EQ(strength[of_clay], before / 2.);
    State<2> restored;
    restored.read(state.write());
    EXPECT_EQ(restored.points.stress, state.points.stress);
    EXPECT_EQ(restored.points.scalar("initial vertical stress"),
              state.points.scalar("initial vertical stress"));
  }


  TEST(Stages, the_second_is_named_by_its_water)
  {
    const auto lines = [](const std::string &level) {
      // Of today's 3.5 m.
      const auto parameters = dyke(
        {"Initial stress/Daily level=" + level, "Initial stress/Laws=elastic"});
      const Case<2> the_case(*parameters, MPI_COMM_SELF);
      EXPECT_EQ(the_case.stages.size(), 2u);
      std::ostringstream out;
      Log                log(out, false);
      describe_case(the_case, log);
      return out.str();
    };
    for (const auto &[level, name] :
         std::vector<std::pair<std::string, std::string>>{
           {"none", "high water"}, {"3.5", "the start"}})
      {
        const std::string all = lines(level);
        EXPECT_NE(all.find("stress    " + name + ": of the daily stage, out"),
                  std::string::npos)
          << all;
        EXPECT_EQ(all.find("high water") != std::string::npos,
                  name == "high water");
      }
  }


  TEST(Stages, bad_input_is_refused)
  {
    const auto refused = [](const std::vector<std::string> &more,
                            const std::string              &where,
                            const std::string              &what) {
      expect_refused([&]() { Case<2>(*dyke(more), MPI_COMM_SELF); },
                     where,
                     what);
    };
    const std::string level = "Initial stress/Daily level";
    const std::string stage = "Initial stress/Daily stage";
    refused({level + "=nan"}, level, "nan");
    refused({level + "=1e999"}, level, "1e999");
    refused({level + "=high"}, level, "high");
    refused({level + "="}, level, "is empty");
    refused({level + "=7"}, level, "not below the crest");
    refused({level + "=-30"}, level, "below all soil");
    refused({"Water/Side=none", "Water/Level=none"}, level, "Side is none");
    refused({"Pore water/Phreatic line=",
             "Pore water/Daily phreatic line=",
             "Water/Side=none",
             "Water/Level=none",
             level + "="},
            stage,
            "no water");
    refused({level + "=low", stage + "=false"}, level, "low"); // unused, too
    refused({"Gravity/Initial stress=false"},
            "Gravity/Initial stress",
            "Daily stage = true");
    // Only in the daily stage does it float.
    expect_refused(
      [&]() {
        Case<2>(*read(level_ground,
                      {"Initial stress/Daily stage=true",
                       "Materials/sand/Unit weight=5",
                       "Materials/sand/Saturated unit weight=0",
                       "Pore water/Phreatic line=0, 0; 4, 0",
                       "Pore water/Daily phreatic line=0, 4; 4, 4"}),
                MPI_COMM_SELF);
      },
      stage,
      "in the daily stage Initial stress/From is K0");
    // The peat's K0 is borne by its strength of usual days; less is not. K0 is
    // named first, with the stage.
    refused({"Materials/peat/K0=0.01"},
            "Materials/peat/K0",
            "outside the yield surface, in the daily stage");
    EXPECT_NO_THROW(dyke({level + "=none"})->check());
  }
} // namespace case_stages
