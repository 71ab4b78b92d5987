// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/case/case.h>
#include <waker/program/parameter_reader.h>
#include <waker/simulation/plausibility.h>

#include "output_temporary_folder.h"
#include <gtest/gtest.h>

namespace simulation_prismatic
{
  // Surface/Prismatic is for bodies that are the same at each z.

  using namespace Waker;

  namespace
  {
    /// What is said of Surface/Prismatic; "" is nothing. The slope of chapter
    /// 6, coarse: z from 0 to 8 m.
    std::string
    said(std::vector<std::string> overrides, const bool prismatic = true)
    {
      overrides.insert(overrides.end(),
                       {"Grid/Cell size=0.5",
                        "Material points/Placement=sub-cells",
                        "Gravity/Initial stress=false",
                        std::string("Surface/Prismatic=") +
                          (prismatic ? "true" : "false")});
      const Case<3> the_case(*read_parameters(WAKER_SOURCE_DIRECTORY
                                              "/parameters/chapter6/slope.prm",
                                              overrides),
                             MPI_COMM_SELF);
      std::string   all;
      for (const std::string &text : strange_things(the_case))
        if (text.find("Surface/Prismatic is true, but ") == 0)
          all += text;
      return all;
    }


    std::vector<std::string>
    two(const std::string &first,
        const std::string &second,
        const std::string &crest = "1")
    {
      return {"Soil profile/Layers=slope, other",
              "Soil profile/slope/Extent=" + first,
              "Soil profile/other/Extent=" + second,
              "Soil profile/other/Material=clay",
              "Soil profile/other/Polygon=0, 0; 3.5, 0; 2.5, " + crest +
                "; 0, " + crest};
    }


    void
    expect_said(const std::vector<std::string> &overrides,
                const std::string              &words)
    {
      EXPECT_NE(said(overrides).find(words), std::string::npos) << words;
    }
  } // namespace


  TEST(Prismatic, layers_span_all_z)
  {
    EXPECT_EQ(said({}), "");
    EXPECT_EQ(said({"Soil profile/slope/Extent=0, 8"}), "");
    expect_said({"Soil profile/slope/Extent=0, 7"},
                "slope/Extent reaches from 0 to 7 m, the box from 0 to 8");
    expect_said({"Soil profile/slope/Extent=1, 8"},
                "slope/Extent reaches from 1 to 8 m");
    EXPECT_EQ(said({"Soil profile/slope/Extent=1, 8"}, false), "");
    // Two that are one body behind each other.
    EXPECT_EQ(said(two("0, 3", "3, 8")), "");
    EXPECT_EQ(said(two("3, 8", "0, 3")), "");
    expect_said(two("0, 3", "4, 8"), "from 0 to 3 m");
    expect_said(two("0, 3", "3, 8", "0.9"), "from 0 to 3 m");
  }


  TEST(Prismatic, height_maps_do_not_vary_along_z)
  {
    const TemporaryFolder folder;
    const auto            with_map = [&](const std::string &heights,
                              const bool         prismatic) {
      put(folder.file("map.csv"), "x, z, y\n" + heights);
      return said({"Soil profile/slope/Top=" + folder.file("map.csv"),
                   "Soil profile/slope/Polygon=0, 0; 3.5, 0; 3.5, 1; 0, 1"},
                  prismatic);
    };
    const std::string varies = "0, 0, 1\n0, 8, 0.75\n3.5, 0, 1\n3.5, 8, 1\n";
    EXPECT_EQ(with_map("0, 0, 1\n0, 8, 1\n3.5, 0, 0.5\n3.5, 8, 0.5\n", true),
              "");
    EXPECT_EQ(with_map(varies, false), "");
    EXPECT_NE(
      with_map(varies, true).find("slope/Top varies by up to 0.25 m along z"),
      std::string::npos);
  }
} // namespace simulation_prismatic
