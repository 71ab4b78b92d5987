// SPDX-License-Identifier: LGPL-2.1-or-later
// A toe under water that ends in a feather edge on a firm base.
#include <waker/case/case.h>
#include <waker/program/parameter_reader.h>
#include <waker/simulation/plausibility.h>
#include <waker/simulation/run_to_end.h>

#include "level_ground.h"
#include <algorithm>
#include <gtest/gtest.h>
#include <memory>

namespace simulation_toe_warnings
{
  using namespace Waker;

  namespace
  {
    /// A bank of 3 m, 1:3, toe at x = 6 m, water at 2.5 m; of cells of half a
    /// metre whose lines lie `shift` cells beside those of half metres.
    std::unique_ptr<Parameters>
    bank(const double shift, const std::vector<std::string> &more = {})
    {
      const std::string text = LevelGround::text_of({23.,
                                                     4.,
                                                     {{"bank", "clay", 0., 3.}},
                                                     R"(
subsection Materials
  set Names = clay
  subsection clay
    set Unit weight       = 18
    set Young's modulus   = 1000
    set Poisson's ratio   = 0.45
    set Initial strength  = 4
    set Residual strength = 4
  end
end
)",
                                                     R"(
subsection Water
  set Side  = left
  set Level = 2.5
end
subsection Surface
  set Method = contour
end
subsection Initial failure
  set Width change = 0.6
end
)"});
      const auto        x    = [&](const double at) {
        return std::to_string(at - 0.5 * shift);
      };
      const std::vector<std::string> settings = {
        "Grid/Lower corner=" + x(0.) + ", 0",
        "Grid/Upper corner=" + x(23.) + ", 4",
        "Soil profile/bank/Polygon=6, 0; " + x(23.) + ", 0; " + x(23.) +
          ", 3; 15, 3"};
      return read_parameters(LevelGround::written(text),
                             LevelGround::with(settings, more));
    }


    template <int dim = 2>
    std::string
    warning(const double shift, const std::vector<std::string> &more = {})
    {
      const auto      parameters = bank(shift, more);
      const Case<dim> the_case(*parameters, MPI_COMM_SELF);
      for (const std::string &text : strange_things(the_case))
        if (text.find("feather edge") != std::string::npos)
          return text;
      return "";
    }
  } // namespace


  TEST(Toe, feather_edge_under_water_is_told_with_its_numbers)
  {
    // Half a cell of it is 1/12 m thick at most: 1/24 of the cell. Of 25 kPa a
    // little less, as its middle lies 1/36 m above the base.
    const std::string said = warning(0.5);
    EXPECT_NE(said.find("fills 0.0417 of its cell under 24.7 kPa, 6.18 times "
                        "its strength, 4 kPa"),
              std::string::npos)
      << said;
    EXPECT_NE(warning(0.75), "");
    const std::string space =
      warning<3>(0.5,
                 {"Dimension=3",
                  "Grid/Lower corner=-0.25, 0, 0",
                  "Grid/Upper corner=22.75, 4, 1",
                  "Boundary conditions/Names=base, left side, right side, "
                  "rear, near",
                  "Boundary conditions/rear/Region=back",
                  "Boundary conditions/rear/Type=roller",
                  "Boundary conditions/near/Region=front",
                  "Boundary conditions/near/Type=roller"});
    EXPECT_NE(space.find("fills 0.0417 of its cell"), std::string::npos)
      << space;
    // A sixth of the cell; the water on the other side; strong soil; a support
    // of 0; no dynamics; ground in front of it.
    EXPECT_EQ(warning(0.), "");
    EXPECT_EQ(warning(0.5, {"Water/Side=right"}), "");
    EXPECT_EQ(warning(0.25), "");
    EXPECT_EQ(warning(0.5, {"Materials/clay/Initial strength=12"}), "");
    EXPECT_NE(warning(0.5, {"Materials/clay/Initial strength=8"}), "");
    EXPECT_EQ(warning(0.5, {"Water/Minimum support=0"}), "");
    EXPECT_EQ(warning(0.5,
                      {"Time stepping/Scheme=quasi-static",
                       "Time stepping/Ramp duration=0"}),
              "");
    EXPECT_EQ(
      warning(0.5,
              {"Grid/Lower corner=-0.25, -1",
               "Soil profile/Layers=bank, ground",
               "Soil profile/ground/Material=clay",
               "Soil profile/ground/Polygon=-0.25, -1; 22.75, -1; 22.75, "
               "0; -0.25, 0"}),
      "");
  }


  // The soil that moves fastest after four seconds: where it is warned of,
  // 0.6 m/s, and more every second; else it has come to rest.
  TEST(Toe, what_is_warned_of_boils_and_the_rest_does_not)
  {
    const auto fastest = [](const double shift, std::vector<std::string> more) {
      more.push_back("Time stepping/End time=4");
      more.push_back("Stop rules/At rest=false");
      const auto     parameters = bank(shift, more);
      const Case<2>  the_case(*parameters, MPI_COMM_SELF);
      State<2>       state = initial_state(the_case);
      Realisation<2> realisation(the_case, state);
      run_to_end(realisation);
      double largest = 0.;
      for (const Tensor<1, 2> &v : state.points.velocity)
        largest = std::max(largest, v.norm());
      return largest;
    };
    EXPECT_GT(fastest(0.5, {}), 0.3);
    EXPECT_LT(fastest(0.25, {}), 0.1);
    EXPECT_LT(fastest(0.5,
                      {"Materials/clay/Initial strength=12",
                       "Materials/clay/Young's modulus=3000"}),
              0.1);
  }
} // namespace simulation_toe_warnings
