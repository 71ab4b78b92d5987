// SPDX-License-Identifier: LGPL-2.1-or-later
// Water outside that is apt to give a failure that is none.
#include <waker/case/case.h>
#include <waker/program/parameter_reader.h>
#include <waker/simulation/plausibility.h>

#include "level_ground.h"
#include <gtest/gtest.h>
#include <memory>

namespace simulation_strange_water
{
  using namespace Waker;

  namespace
  {
    /// A bank of 3 m, 1:3, toe at x = 6 m: a core under a metre of cover, water
    /// outside at 2 m and in the soil. Its outer berm is level from x = `berm`
    /// to 15 m.
    std::unique_ptr<Parameters>
    bank(const std::vector<std::string> &more = {})
    {
      const std::string text = LevelGround::text_of(
        {23.,
         4.,
         {{"core", "sand", 0., 2.}, {"cover", "clay", 2., 3.}},
         R"(
subsection Materials
  set Names = sand, clay
  subsection sand
    set Model          = Mohr-Coulomb
    set Unit weight    = 18
    set Friction angle = 33
    set Cohesion       = 1
  end
  subsection clay
    set Unit weight       = 15
    set Initial strength  = 20
    set Residual strength = 20
  end
end
)",
         R"(
subsection Water
  set Side            = left
  set Level           = 2.2
  set Minimum support = 0
end
subsection Pore water
  set Phreatic line = 0, 2.2; 23, 2.2
end
subsection Surface
  set Method = contour
end
subsection Initial failure
  set Width change = 0.6
end
)"});
      return read_parameters(
        LevelGround::written(text),
        LevelGround::with(
          {"Soil profile/core/Polygon=9, 0; 23, 0; 23, 2; 15, 2",
           "Soil profile/cover/Polygon=6, 0; 9, 0; 15, 2; 23, 2; 23, 3; 15, 3"},
          more));
    }


    /// Of this path, each with an end of line.
    std::string
    warnings(const std::string &path, const std::vector<std::string> &more)
    {
      const auto    parameters = bank(more);
      const Case<2> the_case(*parameters, MPI_COMM_SELF);
      std::string   all;
      for (const std::string &text : strange_things(the_case))
        if (text.find(path + ": ") == 0)
          all += text + "\n";
      return all;
    }


    const std::string              support = "Water/Minimum support";
    const std::vector<std::string> swapped = {"Soil profile/core/Material=clay",
                                              "Soil profile/cover/Material="
                                              "sand"};
  } // namespace


  TEST(StrangeWater, on_soil_of_total_stress_without_a_support)
  {
    // Also with a phreatic line; once, with the material and no other.
    const std::string said = warnings(support, {});
    EXPECT_NE(said.find("(0), and it comes to soil of total stress (clay, "),
              std::string::npos)
      << said;
    EXPECT_EQ(said.find('\n'), said.size() - 1);
    // A cover that is drained is in balance with the water in it.
    EXPECT_EQ(warnings(support, {"Soil profile/cover/Material=sand"}), "");
    EXPECT_EQ(warnings(support, swapped), "");
    // Nor does the water come to clay deep below, though that ends at the grid.
    EXPECT_EQ(
      warnings(support,
               {"Soil profile/core/Polygon=0, 0; 23, 0; 23, 0.5; 0, "
                "0.5",
                "Soil profile/core/Material=clay",
                "Soil profile/cover/Polygon=0, 0.5; 23, 0.5; 23, 3; 15, "
                "3; 9, 1; 0, 1",
                "Soil profile/cover/Material=sand"}),
      "");
    // The water stands where there is drained soil alone.
    const std::vector<std::string> inner = {
      "Soil profile/cover/Polygon=15, 2; 23, 2; 23, 3; 15, 3",
      "Soil profile/core/Polygon=6, 0; 23, 0; 23, 2; 15, 2; 13, 2"};
    EXPECT_EQ(warnings(support,
                       LevelGround::with(inner,
                                         {"Water/Level=1",
                                          "Pore water/Phreatic line=0, 1; 23, "
                                          "1"})),
              "");
    // ... until it rises.
    for (const char *const rise : {"0: 0, 10: 1.9", "0.19*t"})
      EXPECT_NE(warnings(support,
                         LevelGround::with(inner,
                                           {"Water/Level=1",
                                            std::string("Water/Rise=") + rise,
                                            "Pore water/Phreatic line=0, 1; "
                                            "23, 1"})),
                "")
        << rise;

    // What lies below the feather edge of drained soil is not at the surface,
    // though its points are near.
    const auto on_ground = [](const std::string &toe) {
      return warnings(support,
                      {"Grid/Lower corner=0, -1",
                       "Soil profile/Layers=core, cover, ground, foreland",
                       "Soil profile/cover/Material=sand",
                       "Soil profile/cover/Polygon=" + toe +
                         ", 0; 9, 0; 15, 2; 23, 2; 23, 3; 15, 3",
                       "Soil profile/ground/Material=clay",
                       "Soil profile/ground/Polygon=6, -1; 23, -1; 23, 0; 6, 0",
                       "Soil profile/foreland/Material=sand",
                       "Soil profile/foreland/Polygon=0, -1; 6, -1; 6, 0; "
                       "0, 0"});
    };
    EXPECT_EQ(on_ground("6"), "");
    EXPECT_NE(on_ground("7"), "");
  }


  TEST(StrangeWater, the_width_is_measured_at_level_ground)
  {
    const auto with_berm = [](const std::string &y) {
      return std::vector<std::string>{"Soil profile/cover/Polygon=6, 0; 9, 0; "
                                      "15, 2; 23, 2; 23, 3; 15, 3; 14, " +
                                      y + "; 12, " + y};
    };
    const std::string at   = "Water/Level";
    const std::string said = warnings(at, with_berm("2.2"));
    EXPECT_NE(said.find("W is measured at 2.2 m, and the ground is level "
                        "there, at 2.2 m from x = "),
              std::string::npos)
      << said;
    // It rises by 1:3 at either end, so that it is a hair longer than 2 m.
    EXPECT_NE(said.find("W jumps by up to 2"), std::string::npos) << said;
    EXPECT_NE(warnings(at, with_berm("2.19")), "");
    // A slope; another height; a change that does not count.
    EXPECT_EQ(warnings(at, {}), "");
    EXPECT_EQ(warnings(at, with_berm("2.1")), "");
    EXPECT_EQ(warnings(at, with_berm("2.3")), "");
    std::vector<std::string> more = with_berm("2.2");
    more.push_back("Initial failure/Width change=2.5");
    EXPECT_EQ(warnings(at, more), "");
  }
} // namespace simulation_strange_water
