// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/simulation/plausibility.h>

#include "campaign_random_dyke.h"
#include <gtest/gtest.h>

namespace simulation_strange_loads
{
  // Warnings of loads that are likely in another unit.

  namespace
  {
    using namespace Waker;

    std::vector<std::string>
    warnings_of_loads(std::vector<std::string> settings)
    {
      const auto               input = RandomDyke::coarse(std::move(settings));
      const Case<2>            the_case(input->simulation, MPI_COMM_SELF);
      std::vector<std::string> loads;
      for (const std::string &warning : strange_things(the_case))
        if (warning.find("Tractions/") == 0 ||
            warning.find("Point loads/") == 0)
          loads.push_back(warning);
      return loads;
    }


    std::vector<std::string>
    with_traction(const std::string &value,
                  const std::string &kind = "pressure")
    {
      return warnings_of_loads({"Tractions/Names=load",
                                "Tractions/load/Kind=" + kind,
                                "Tractions/load/Value=" + value,
                                "Tractions/load/Facing=0, 1"});
    }


    std::vector<std::string>
    with_force(const std::string &force)
    {
      return warnings_of_loads({"Point loads/Names=p",
                                "Point loads/p/Force=" + force,
                                "Point loads/p/From=14, 4"});
    }
  } // namespace


  TEST(StrangeLoads, water_on_nodes_without_soil)
  {
    const auto of = [](const std::string       &what,
                       std::vector<std::string> settings) {
      const auto    input = RandomDyke::coarse(std::move(settings));
      const Case<2> the_case(input->simulation, MPI_COMM_SELF);
      unsigned int  n = 0;
      for (const std::string &warning : strange_things(the_case))
        n += warning.find(what) == 0;
      return n;
    };
    const std::string support = "Water/Minimum support";
    EXPECT_EQ(of(support, {support + "=0"}), 1u);
    EXPECT_EQ(of(support, {support + "=0.001"}), 0u);
    EXPECT_EQ(of(support, {support + "=0", "Water/Side=none"}), 0u);

    const std::string strain = "Kinematics and mapping/Volumetric strain";
    const std::string all    = strain + "=B-bar in all cells";
    EXPECT_EQ(of(strain, {all}), 1u);
    EXPECT_EQ(of(strain, {strain + "=B-bar"}), 0u);
    // The soil begins at x = 0, and the roller stands there or beyond.
    EXPECT_EQ(of(strain, {all, "Water/Side=none"}), 0u);
    const std::string at_soil = "Grid/Lower corner=0, 0";
    EXPECT_EQ(of(strain, {all, "Water/Side=none", at_soil}), 1u);
    EXPECT_EQ(of(strain, {strain + "=B-bar", "Water/Side=none", at_soil}), 0u);
    EXPECT_EQ(of(strain,
                 {all,
                  "Water/Side=none",
                  at_soil,
                  "Boundary conditions/left side/Type=fixed"}),
              0u);

    // The coarse dyke has cells of 0.5 m.
    const std::string width = "Initial failure/Width change";
    EXPECT_EQ(of(width, {"Surface/Method=contour", width + "=0.49"}), 1u);
    EXPECT_EQ(of(width, {"Surface/Method=contour", width + "=0.5"}), 0u);
    EXPECT_EQ(of(width, {width + "=0.49"}), 0u);
  }


  TEST(StrangeLoads, above_1000_kPa)
  {
    EXPECT_TRUE(with_traction("15").empty());
    EXPECT_TRUE(with_traction("-15").empty());
    EXPECT_TRUE(with_traction("15*y").empty());
    const auto warnings = with_traction("15000");
    ASSERT_EQ(warnings.size(), 2u); // its resultant, too
    EXPECT_EQ(warnings[0].find(
                "Tractions/load/Value is 15000 kPa; loads on soil "
                "have up to 1000 kPa"),
              0u)
      << warnings[0];
    EXPECT_EQ(warnings[1].find("Tractions/load: its resultant at t = 0 is"), 0u)
      << warnings[1];
    // Also one that comes later, and a component of a vector.
    EXPECT_EQ(with_traction("min(t, 1)*2000").size(), 1u);
    EXPECT_EQ(with_traction("0; min(t, 1)*-2000", "vector").size(), 1u);
  }


  TEST(StrangeLoads, many_times_the_weight_of_the_soil)
  {
    EXPECT_TRUE(with_force("0, -100").empty());
    const auto warnings = with_force("0, -1e6");
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].find("Point loads/p/Force: its size is 1e+06 kN, "),
              0u)
      << warnings[0];
    EXPECT_NE(warnings[0].find("times the weight of all soil"),
              std::string::npos)
      << warnings[0];
  }
} // namespace simulation_strange_loads
