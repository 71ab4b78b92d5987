// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/campaign/input.h>
#include <waker/campaign/realisation_runner.h>
#include <waker/case/cross_section.h>
#include <waker/program/parameter_reader.h>

#include "user_errors.h"
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <utility>
#include <vector>

namespace campaign_cross_section
{
  // The section of a case in space as a case in plane strain.

  using namespace Waker;

  namespace
  {
    const char *const analysis =
      WAKER_SOURCE_DIRECTORY "/parameters/chapter6/analysis1.prm";


    std::vector<std::unique_ptr<Input>>
    read(std::vector<std::string> overrides)
    {
      overrides.push_back("Grid/Cell size=0.5");
      return read_scenarios(analysis, overrides);
    }
  } // namespace


  TEST(CrossSection, has_the_random_fields_of_the_case_in_space)
  {
    const auto           space = read({});
    RealisationRunner<3> in_space(space[0]->simulation,
                                  space[0]->reliability.fields,
                                  1,
                                  MPI_COMM_SELF);
    // In the middle of a layer of points (cells of 0.25 m), and between two of
    // them: then it is the one above.
    for (const char *const z : {"2.3", "4"})
      {
        const auto plane = read({std::string("Cross-section=") + z});
        ASSERT_EQ(plane[0]->simulation.dimension, 2u);
        RealisationRunner<2> in_plane(plane[0]->simulation,
                                      plane[0]->reliability.fields,
                                      1,
                                      MPI_COMM_SELF);
        ASSERT_EQ(in_plane.n_noise(), in_space.n_noise());
        const double layer = z[0] == '4' ? 4.125 : 2.375; // z of its points

        const auto noise = realisation_noise(1, 5, in_space.n_noise());
        const auto body  = in_space.initial(noise.data()).points;
        const auto twin  = in_plane.initial(noise.data()).points;
        std::map<std::pair<long, long>, std::pair<double, double>> there;
        const auto key = [](const double x, const double y) {
          return std::make_pair(std::lround(1000. * x), std::lround(1000. * y));
        };
        const auto &c_i = body.scalar("undrained shear strength");
        const auto &c_r = body.scalar("residual strength");
        for (std::size_t p = 0; p < body.n_points(); ++p)
          if (std::abs(body.position[p][2] - layer) < 1e-9)
            there[key(body.position[p][0], body.position[p][1])] = {c_i[p],
                                                                    c_r[p]};
        ASSERT_EQ(there.size(), twin.n_points());
        double least = 100., largest = 0.;
        for (std::size_t p = 0; p < twin.n_points(); ++p)
          {
            const auto found =
              there.find(key(twin.position[p][0], twin.position[p][1]));
            ASSERT_NE(found, there.end());
            const double c = twin.scalar("undrained shear strength")[p];
            EXPECT_EQ(c, found->second.first);
            EXPECT_EQ(twin.scalar("residual strength")[p],
                      found->second.second);
            least   = std::min(least, c);
            largest = std::max(largest, c);
          }
        EXPECT_GT(largest - least, 0.5); // they vary
      }
  }


  TEST(CrossSection, leaves_away_what_lies_along_z)
  {
    const auto        scenarios = read({"Cross-section=4"});
    const Parameters &p         = scenarios[0]->simulation;
    EXPECT_EQ(p.grid.upper_corner, (std::vector<double>{6., 1.5}));
    std::vector<std::string> conditions;
    for (const FixityParameters &condition : p.fixities)
      conditions.push_back(condition.name);
    EXPECT_EQ(conditions,
              (std::vector<std::string>{"base", "rear", "behind the rear"}));
    EXPECT_EQ(p.outflow.faces, "right");
    EXPECT_TRUE(p.outlets.empty());
    ASSERT_EQ(p.load_programmes.size(), 1u);
    EXPECT_EQ(p.load_programmes[0].weight.from, std::vector<double>{1.5});
    ASSERT_TRUE(p.in_space);
    EXPECT_EQ(p.in_space->dimension, 3u);
    EXPECT_EQ(p.section_z, 4.);

    // Beside the load; the hash is another one.
    const auto beside = read({"Cross-section=1"});
    EXPECT_TRUE(beside[0]->simulation.load_programmes.empty());
    EXPECT_NE(beside[0]->campaign_hash, scenarios[0]->campaign_hash);
  }


  TEST(CrossSection, is_refused_where_there_is_none)
  {
    EXPECT_NO_THROW(read({"Cross-section=0"}));
    EXPECT_USER_ERROR(read({"Cross-section=8"}),
                      "--set Cross-section",
                      "is 8 m");
    EXPECT_USER_ERROR(read({"Cross-section=-0.1"}),
                      "--set Cross-section",
                      "-0.1");
    EXPECT_USER_ERROR(read(
                        {"Cross-section=4", "Soil profile/slope/Extent=0, 2"}),
                      "--set Cross-section",
                      "where no layer is");
    // The last plane of a layer is no part of it.
    EXPECT_USER_ERROR(read(
                        {"Cross-section=4", "Soil profile/slope/Extent=0, 4"}),
                      "--set Cross-section",
                      "where no layer is");
    EXPECT_NO_THROW(
      read({"Cross-section=4", "Soil profile/slope/Extent=4, 8"}));
    // Several sections are one campaign, but not one beside its case.
    EXPECT_EQ(
      read({"Sweep/Parameter=Cross-section", "Sweep/Values=1; 4"}).size(), 2u);
    EXPECT_USER_ERROR(read({"Sweep/Parameter=Cross-section",
                            "Sweep/Values=none; 4"}),
                      "--set Sweep/Parameter",
                      "makes some scenarios plane");
    EXPECT_USER_ERROR(read_scenarios(WAKER_SOURCE_DIRECTORY
                                     "/parameters/chapter5/dyke.prm",
                                     {"Cross-section=4"}),
                      "--set Cross-section",
                      "Dimension is 2");
    EXPECT_USER_ERROR(
      read_scenarios(WAKER_SOURCE_DIRECTORY "/parameters/chapter6/dyke_3d.prm",
                     {"Cross-section=4",
                      "Soil profile/dyke/Top=" WAKER_SOURCE_DIRECTORY
                      "/parameters/chapter6/dyke_3d.csv"}),
      "--set Cross-section",
      "height map");
  }
} // namespace campaign_cross_section
