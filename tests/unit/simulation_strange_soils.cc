// SPDX-License-Identifier: LGPL-2.1-or-later
// Parameters of soils, springs and water that are far from usual, or have no
// effect: each with its number.
#include <waker/simulation/plausibility.h>

#include "program_case.h"
#include "stress_in_ground.h"
#include "warnings.h"

namespace simulation_strange_soils
{
  using namespace Waker;
  using namespace ProgramCase;
  using namespace StressInGround;
  using namespace Warnings;

  namespace
  {
    const std::string clay = "Materials/clay/";


    /// What is said of the dyke of clay without water.
    std::string
    said(std::vector<std::string> settings)
    {
      settings.insert(settings.begin(), "Water/Side=none");
      return joined(
        strange_parameters(*read_parameters(write_case(good_case), settings)));
    }


    /// Of sand; the strength of clay is left as it is by default.
    std::string
    said_of_sand(std::vector<std::string> settings)
    {
      settings.insert(settings.begin(),
                      {clay + "Model=Mohr-Coulomb",
                       clay + "Initial strength=13",
                       clay + "Residual strength=5"});
      return said(settings);
    }


    /// Of sand on clay, whose points are looked at.
    std::string
    said_of_ground(const std::vector<std::string> &settings)
    {
      return joined(
        strange_things(Case<2>(*read(level_ground, settings), MPI_COMM_SELF)));
    }


    void
    expect_said(const std::string &all, const std::string &text)
    {
      EXPECT_TRUE(has(all, text)) << "\"" << text << "\" is not in: " << all;
    }
  } // namespace


  TEST(Plausibility, angles_and_cohesions_that_soils_do_not_have)
  {
    EXPECT_EQ(said_of_sand({}), "");
    expect_said(said_of_sand({clay + "Friction angle=0"}),
                clay + "Friction angle is 0 degrees; clay without drainage is "
                       "Model = von Mises softening");
    expect_said(said_of_sand({clay + "Friction angle=3"}),
                "is 3 degrees; soils have 10 to 50 degrees");
    expect_said(said_of_sand({clay + "Cohesion=5000"}),
                clay + "Cohesion is 5000 kPa; soils have 0.1 to 200 kPa");
    expect_said(said_of_sand({clay + "Cohesion=0.01"}),
                "is 0.01 kPa; slopes of less shed their skin");
    // At points, too.
    expect_said(said_of_ground({"Materials/sand/Cohesion=4000 + 0*x"}),
                "Materials/sand/Cohesion is 4000 kPa; soils have");
  }


  TEST(Plausibility, what_another_law_knows_is_not_used)
  {
    EXPECT_EQ(said({}), "");
    const std::string of_clay = " is not used with Model = von Mises softening";
    for (const std::string name : {"Cohesion=7",
                                   "Friction angle=25",
                                   "Dilatancy angle=5",
                                   "Tensile strength=1",
                                   "Residual cohesion=1",
                                   "Residual friction angle=20",
                                   "Residual dilatancy angle=1",
                                   "Softening strain=5",
                                   "Lambda=0.3",
                                   "OCR=3"})
      expect_said(said({clay + name}),
                  clay + name.substr(0, name.find('=')) + of_clay);
    for (const std::string name : {"Initial strength=9",
                                   "Residual strength=2",
                                   "Softening modulus=-20",
                                   "Plastic strain invariant=half",
                                   "POP=5",
                                   "Strength ratio=0.3",
                                   "Strength exponent=0.8",
                                   "Strength at top=3",
                                   "Strength growth=1",
                                   "Strength table=0: 1, 10: 5"})
      expect_said(said({clay + "Model=Mohr-Coulomb", clay + name}),
                  clay + name.substr(0, name.find('=')) +
                    " is not used with Model = Mohr-Coulomb");
    const std::string cam = said({clay + "Model=modified Cam clay",
                                  clay + "Lambda=0.3",
                                  clay + "Kappa=0.03",
                                  clay + "Void ratio=1",
                                  clay + "Initial strength=13",
                                  clay + "Residual strength=5",
                                  clay + "POP=5",
                                  clay + "Friction angle=25"});
    EXPECT_EQ(cam.find("not used"), std::string::npos) << cam;
  }


  TEST(Plausibility, choices_that_leave_values_without_effect)
  {
    const std::string soft = clay + "Softening strain=0.5";
    expect_said(said_of_sand({soft}),
                clay + "Softening strain is not used with residual values");
    EXPECT_EQ(said_of_sand({soft, clay + "Residual cohesion=1"}), "");
    const std::string no = clay + "Softening modulus=0";
    expect_said(said({no}),
                clay + "Residual strength is not used with Softening "
                       "modulus = 0");
    EXPECT_EQ(said({no, clay + "Residual strength=10"}), ""); // the same
    expect_said(said({no, clay + "Softening length=1"}),
                clay + "Softening length is not used with soil that does not "
                       "soften");
    expect_said(said({"Water/Rise=0: 0, 10: 1"}),
                "Water/Rise is not used with Side = none");
    expect_said(said({"Boundary conditions/base/Penalty factor=100"}),
                "Boundary conditions/base/Penalty factor is not used with "
                "Method = elimination");
  }


  TEST(Plausibility, springs_and_tables_that_are_strange)
  {
    const auto wall = [](const std::string &factor) {
      return said({"Walls/Names=w",
                   "Walls/w/Line=0, -0.1; 30, -0.1",
                   "Walls/w/Penalty factor=" + factor});
    };
    EXPECT_EQ(wall("100"), "");
    expect_said(wall("1e-3"),
                "Walls/w/Penalty factor is 0.001; softer springs give way");
    expect_said(wall("1e8"), "Penalty factor is 1e+08; usual is 10 to 1e+06");
    expect_said(said({"Boundary conditions/base/Method=penalty",
                      "Boundary conditions/base/Penalty factor=1"}),
                "Boundary conditions/base/Penalty factor is 1;");

    const auto table = [](const std::string &entries) {
      return said({clay + "Initial strength=13",
                   clay + "Residual strength=initial_strength/2",
                   "Pore water/Phreatic line=-6, 0; 42, 0",
                   clay + "Strength from=table",
                   clay + "Strength table=" + entries});
    };
    EXPECT_EQ(table("0: 2, 50: 12, 60: 12"), "");
    expect_said(table("0: 5, 50: 2"),
                clay + "Strength table falls from 5 to 2 kPa as the stress "
                       "grows from 0 to 50 kPa; soils have");
  }


  TEST(Plausibility, what_softening_leaves_of_clay)
  {
    const std::string c_r = "Materials/clay/Residual strength";
    EXPECT_EQ(said_of_ground({}), "");
    EXPECT_EQ(said_of_ground({c_r + "=2.6"}), ""); // of 40 kPa
    expect_said(said_of_ground({c_r + "=0.4"}),
                c_r + " leaves 0.4 kPa of 40 kPa, a sensitivity of 100; clay "
                      "and peat have 1 to 16");
    expect_said(said_of_ground({c_r + "=initial_strength/100"}),
                "a sensitivity of 100;");
    expect_said(said_of_ground({c_r + "=0"}), "a sensitivity without a limit");
    // Without softening nothing is lost.
    const std::string firm =
      said_of_ground({c_r + "=0.4", "Materials/clay/Softening modulus=0"});
    EXPECT_EQ(firm.find("sensitivity"), std::string::npos) << firm;
  }


  TEST(Plausibility, a_tensile_strength_beyond_the_apex)
  {
    // c cot(phi) of the sand: 0.5 cot(33 degrees) = 0.769932 kPa.
    const std::string t = "Materials/sand/Tensile strength";
    EXPECT_EQ(said_of_ground({t + "=0.7"}), "");
    EXPECT_EQ(said_of_ground({t + "=apex"}), "");
    expect_said(said_of_ground({t + "=1e6"}),
                t + " is 1e+06 kPa, at 128 of 128 points more than c cot(phi), "
                    "to which it is cut: 0.769932 kPa");
    // Where it is an expression: from 2 to 4 m, 0.2 to 0.4 kPa of cohesion.
    const std::string some =
      said_of_ground({t + "=0.5", "Materials/sand/Cohesion=0.1*y"});
    expect_said(some, t + " is 0.5 kPa, at ");
    expect_said(some, "to which it is cut: 0.3");
    EXPECT_EQ(some.find(" 128 of 128"), std::string::npos) << some;
    const std::string of_table =
      said_of_ground({t + "=5",
                      "Materials/sand/K0=0.5",
                      "Materials/sand/Shear strength table=0: 1, 10: 8.5"});
    expect_said(of_table, "to which it is cut: 1.33333 kPa");
  }


  TEST(Plausibility, a_stress_at_rest_that_soils_do_not_have)
  {
    const std::string k0 = "Materials/sand/K0";
    expect_said(said_of_ground({k0 + "=3"}), k0 + " is 3; soils have 0.3 to 2");
    expect_said(said_of_ground({"Materials/clay/K0=2 + 0.1*y"}),
                "Materials/clay/K0 is 2.1");
    // Unused without it.
    expect_said(said_of_ground({k0 + "=3", "Initial stress/From=gravity"}),
                k0 + " is not used with");
    expect_said(said_of_ground({k0 + "=3",
                                "Initial stress/Daily stage=true",
                                "Pore water/Daily phreatic line=0, 1; 4, 1"}),
                k0 + " is 3; soils have 0.3 to 2");
  }


  TEST(Plausibility, a_stress_at_rest_that_follows_the_stress)
  {
    // In the sand sigma'_v goes from 4.5 to some 22 kPa.
    const std::string k0 = "Materials/sand/K0";
    expect_said(said_of_ground({k0 + "=0.5 + 0.08*vertical_stress"}),
                "; soils have 0.3 to 2");
    EXPECT_EQ(said_of_ground({k0 + "=0.5 + 0.001*vertical_stress"}), "");
    // With a daily stage it is made of the daily stress, which is not that of
    // now: of what cannot be known nothing is said.
    const std::vector<std::string> daily = {
      "Initial stress/Daily stage=true",
      "Pore water/Daily phreatic line=0, 1; 4, 1"};
    const auto said_by_day = [&](const std::string &setting) {
      std::vector<std::string> settings = daily;
      settings.push_back(setting);
      return said_of_ground(settings);
    };
    EXPECT_FALSE(has(said_by_day(k0 + "=0.5 + 0.08*vertical_stress"), k0));
    // The control: a K0 of the place is known.
    EXPECT_TRUE(has(said_by_day(k0 + "=3 + 0*y"), k0 + " is 3"));
  }
} // namespace simulation_strange_soils
