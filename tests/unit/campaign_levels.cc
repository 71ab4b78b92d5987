// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/campaign/campaign.h>
#include <waker/program/parameter_reader.h>

#include <cmath>
#include <gtest/gtest.h>

namespace campaign_levels
{
  namespace
  {
    using namespace Waker;

    ScenarioInfo
    info_of(const std::vector<std::string> &overrides)
    {
      return campaign_info(
               read_scenarios(std::string(WAKER_SOURCE_DIRECTORY) +
                                "/parameters/chapter5/analysis1.prm",
                              overrides))
        .scenarios.at(0);
    }
  } // namespace


  TEST(Levels, crest_and_base_below_datum)
  {
    const ScenarioInfo info =
      info_of({"Grid/Lower corner=-6, -6",
               "Grid/Upper corner=42, 0",
               "Soil profile/dyke/Polygon=0, -6; 30, -6; 15, -1; 5, -1",
               "Water/Level=-1.25"});
    EXPECT_EQ(info.crest_level, -1.);
    EXPECT_EQ(info.base_level, -6.);
    EXPECT_EQ(info.water_level, -1.25);
    const ScenarioInfo base_case = info_of({});
    EXPECT_EQ(base_case.crest_level, 5.);
    EXPECT_EQ(base_case.base_level, 0.);
  }


  TEST(Levels, without_water_there_is_none)
  {
    EXPECT_TRUE(std::isnan(info_of({"Water/Side=none"}).water_level));
  }
} // namespace campaign_levels
