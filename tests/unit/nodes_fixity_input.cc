// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <waker/base/errors.h>
#include <waker/nodes/fixities.h>
#include <waker/nodes/fixity_conflicts.h>

#include "fixity_cases.h"
#include "named.h"
#include "user_errors.h"
#include "warnings.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace nodes_fixity_input
{
  using namespace Waker;
  using namespace FixityCases;

  TEST(Nodes, bad_fixities_are_named)
  {
    const auto        grid = small_grid();
    const std::string path = "Boundary conditions/base";
    const auto        bad  = [&](const FixityParameters &f) {
      return where_it_fails(grid, f);
    };
    EXPECT_EQ(bad(fixity("bottom")), "");
    EXPECT_EQ(bad(fixity("front")), path + "/Region"); // none in 2D
    EXPECT_EQ(bad(fixity("box", "roller")), path + "/Type");
    EXPECT_EQ(bad(fixity("box")), path + "/From");
    EXPECT_EQ(bad(fixity("left", "fixed", "t; t")), path + "/Displacement");
    for (const char *displacement : {"",
                                     "t",
                                     "t; t; t",
                                     "t; ",
                                     "free; free",
                                     "t; 2*(t",
                                     "t; z*t",
                                     "t; speed*t",
                                     "0.1; free", // never reached from 0
                                     "0/0*t; free"})
      {
        EXPECT_EQ(bad(fixity("left", "prescribed", displacement)),
                  path + "/Displacement")
          << displacement;
      }

    FixityParameters f = fixity("left");
    f.penalty_factor   = 0.;
    EXPECT_EQ(bad(f), path + "/Penalty factor");
    f      = fixity("left");
    f.from = {0.};
    EXPECT_EQ(bad(f), path + "/From");
    f.from = {0., 1.};
    f.to   = {3., 0.9};
    EXPECT_EQ(bad(f), path + "/To");
    f.from = {0., 1.1};
    f.to   = {3., 1.2}; // between two nodes
    EXPECT_EQ(bad(f), path);
  }


  TEST(Nodes, unknown_choices_of_fixities_throw)
  {
    EXPECT_USER_ERROR(choice_named<FixityRegion>("below", "Region"),
                      "Region",
                      "below");
    EXPECT_USER_ERROR(choice_named<FixityType>("glued", "Type"),
                      "Type",
                      "glued");
    EXPECT_USER_ERROR(choice_named<FixityMethod>("glue", "Method"),
                      "Method",
                      "glue");
    EXPECT_EQ(choice_named<FixityMethod>("penalty", "Method"),
              FixityMethod::penalty);
  }


  TEST(Nodes, fixity_parameters_are_read)
  {
    dealii::ParameterHandler prm;
    FixityParameters         f;
    f.add_parameters(prm);
    prm.parse_input_from_string("set Region = right\n"
                                "set From = 0, 1\n"
                                "set Type = prescribed\n"
                                "set Displacement = 0.1*t; free\n"
                                "set Method = penalty\n"
                                "set Penalty factor = 10\n");
    EXPECT_EQ(f.region, FixityRegion::right);
    EXPECT_EQ(f.from, (std::vector<double>{0., 1.}));
    EXPECT_TRUE(f.to.empty());
    EXPECT_EQ(f.displacement, "0.1*t; free");
    EXPECT_EQ(f.method, FixityMethod::penalty);
    EXPECT_EQ(f.penalty_factor, 10.);
  }


  TEST(Nodes, an_empty_region_is_told_with_the_lines_beside_it)
  {
    const auto       grid = small_grid(); // x from 0.5 to 3.5, y from -0.5 to 2
    FixityParameters f    = fixity("box");
    f.from                = {1.1, 0.};
    f.to                  = {1.2, 0.5};
    EXPECT_USER_ERROR(Fixities<2>(grid, {f}),
                      "Boundary conditions/base",
                      "no node of the grid in its region: along x it reaches "
                      "from 1.1 m to 1.2 m");
    const auto allowed = [&]() {
      try
        {
          const Fixities<2> fixities(grid, {f});
        }
      catch (const UserError &error)
        {
          return error.allowed;
        }
      return std::string();
    };
    EXPECT_NE(allowed().find("are at x = 1 and 1.5 m"), std::string::npos)
      << allowed();
    f.from = {1., 7.};
    f.to   = {1.2, 9.};
    EXPECT_NE(allowed().find("are at y = 2 m"), std::string::npos) << allowed();
    f.from = {-4., -4.};
    f.to   = {-3., -3.};
    EXPECT_NE(allowed().find("are at x = 0.5 m, and at y = -0.5 m"),
              std::string::npos)
      << allowed();
    f.to = {0.5, -0.5};
    EXPECT_EQ(allowed(), "");
    // Of a face only the other direction counts.
    f      = fixity("bottom");
    f.from = {1.6, 70.};
    f.to   = {1.9, 80.};
    EXPECT_NE(allowed().find("are at x = 1.5 and 2 m"), std::string::npos)
      << allowed();
    f.to = {2., 80.};
    EXPECT_EQ(allowed(), "");
  }


  TEST(Nodes, conditions_that_contradict_are_told)
  {
    const auto grid      = small_grid();
    const auto conflicts = [&](std::vector<FixityParameters> list) {
      for (unsigned int i = 0; i < list.size(); ++i)
        list[i].name = std::string(1, 'a' + i);
      return Warnings::joined(fixity_conflicts(grid, list));
    };
    const auto moved = fixity("bottom", "prescribed", "free; 0.1*t");
    // The same wishes.
    EXPECT_EQ(conflicts({fixity("bottom"), fixity("bottom", "roller")}), "");
    EXPECT_EQ(conflicts(
                {fixity("bottom"), fixity("bottom", "prescribed", "0; 0")}),
              "");
    EXPECT_EQ(conflicts({moved, moved}), "");
    // Other directions, and the corner of two faces.
    EXPECT_EQ(conflicts({moved, fixity("left", "roller")}), "");
    EXPECT_EQ(conflicts({moved, fixity("left")}), "");

    // 7 nodes along the base, two rows with the margin.
    EXPECT_EQ(
      conflicts({moved, fixity("bottom")}),
      "Boundary conditions: b overrules a on 14 nodes of both, where "
      "they want different movements (the later one in Names counts)\n");
    EXPECT_EQ(
      conflicts({fixity("bottom", "roller"), moved}),
      "Boundary conditions: b overrules a on 14 nodes of both, where "
      "they want different movements (the later one in Names counts)\n");
    FixityParameters spring = moved;
    spring.method           = Named{std::string("penalty")};
    EXPECT_EQ(conflicts({fixity("bottom"), spring}),
              "Boundary conditions: a overrules b on 14 nodes of both, where "
              "they want different movements (elimination counts before "
              "penalty)\n");
    // So it is in the fixities.
    EXPECT_TRUE(
      Fixities<2>(grid, {fixity("bottom"), moved}).has_prescribed_motion());
    EXPECT_FALSE(
      Fixities<2>(grid, {moved, fixity("bottom")}).has_prescribed_motion());
    EXPECT_FALSE(
      Fixities<2>(grid, {fixity("bottom"), spring}).has_prescribed_motion());

    // A few nodes, all of one of the two.
    FixityParameters few = fixity("box");
    few.from             = {1., 0.};
    few.to               = {1.5, 0.};
    EXPECT_NE(conflicts({moved, few}).find("on 2 nodes"), std::string::npos);
    few.to = {1.5, 1.};
    EXPECT_EQ(conflicts({moved, few}), "");
  }
} // namespace nodes_fixity_input
