// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/case/case.h>
#include <waker/program/parameter_reader.h>

#include "output_temporary_folder.h"
#include "user_errors.h"
#include <gtest/gtest.h>

namespace case_prismatic
{
  // Surface/Prismatic is for bodies that are the same at each z.

  using namespace Waker;

  namespace
  {
    /// The slope of chapter 6, coarse: z from 0 to 8 m.
    std::unique_ptr<Parameters>
    slope(std::vector<std::string> overrides, const bool prismatic = true)
    {
      overrides.insert(overrides.end(),
                       {"Grid/Cell size=0.5",
                        std::string("Surface/Prismatic=") +
                          (prismatic ? "true" : "false")});
      return read_parameters(WAKER_SOURCE_DIRECTORY
                             "/parameters/chapter6/slope.prm",
                             overrides);
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
  } // namespace


  TEST(Prismatic, layers_span_all_z)
  {
    const std::string where = "--set Surface/Prismatic";
    EXPECT_NO_THROW(slope({}));
    EXPECT_NO_THROW(slope({"Soil profile/slope/Extent=0, 8"}));
    EXPECT_USER_ERROR(
      slope({"Soil profile/slope/Extent=0, 7"}),
      where,
      "slope/Extent reaches from 0 to 7 m, the box from 0 to 8");
    EXPECT_USER_ERROR(slope({"Soil profile/slope/Extent=1, 8"}),
                      where,
                      "slope/Extent reaches from 1 to 8 m");
    EXPECT_NO_THROW(slope({"Soil profile/slope/Extent=1, 8"}, false));
    // Two that are one body behind each other.
    EXPECT_NO_THROW(slope(two("0, 3", "3, 8")));
    EXPECT_NO_THROW(slope(two("3, 8", "0, 3")));
    EXPECT_USER_ERROR(slope(two("0, 3", "4, 8")), where, "from 0 to 3 m");
    EXPECT_USER_ERROR(slope(two("0, 3", "3, 8", "0.9")),
                      where,
                      "from 0 to 3 m");
  }


  TEST(Prismatic, height_maps_do_not_vary_along_z)
  {
    const TemporaryFolder folder;
    const auto            with_map = [&](const std::string &heights,
                              const std::string &prismatic) {
      put(folder.file("map.csv"), "x, z, y\n" + heights);
      const auto p = slope({"Soil profile/slope/Top=" + folder.file("map.csv"),
                            "Soil profile/slope/Polygon=0, 0; 3.5, 0; 3.5, 1; "
                                       "0, 1"});
      Parameters changed             = *p;
      changed.surface.prismatic      = prismatic == "true";
      changed.gravity.initial_stress = false;
      const Case<3> the_case(changed, MPI_COMM_SELF);
      return the_case.initial_points.n_points();
    };
    const std::string varies = "0, 0, 1\n0, 8, 0.75\n3.5, 0, 1\n3.5, 8, 1\n";
    EXPECT_GT(with_map("0, 0, 1\n0, 8, 1\n3.5, 0, 0.5\n3.5, 8, 0.5\n", "true"),
              0u);
    EXPECT_GT(with_map(varies, "false"), 0u);
    EXPECT_USER_ERROR(with_map(varies, "true"),
                      "Surface/Prismatic",
                      "slope/Top varies by up to 0.25 m along z");
  }
} // namespace case_prismatic
