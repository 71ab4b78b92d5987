// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/campaign/campaign_text.h>
#include <waker/campaign/free_parameters.h>

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace campaign_text
{
  using namespace Waker;


  TEST(Campaign, pace_is_said_where_it_is_known)
  {
    EXPECT_EQ(pace_text(10, 10, 100.), "360 realisations an hour and core");
    EXPECT_EQ(pace_text(10, 16, 100.),
              "360 realisations an hour and core; at most " +
                work_time_text(60.) + " of one core to go");
    // A journal that was written by hand, or damaged.
    constexpr double inf = std::numeric_limits<double>::infinity();
    for (const double busy : {0., -1., std::nan(""), inf, 1e-320})
      EXPECT_EQ(pace_text(10, 16, busy), "") << busy;
    EXPECT_EQ(pace_text(0, 16, 0.), "");
    // More than an int holds.
    EXPECT_EQ(pace_text(1, 1, 1e-9),
              "3600000000000 realisations an hour and core");
  }


  TEST(Campaign, free_parameters_are_named)
  {
    const std::string text = free_in_campaigns();
    for (const std::string &section : sections_free_in_campaigns())
      EXPECT_NE(text.find(section + ", "), std::string::npos) << section;
    EXPECT_NE(text.find("of Campaign all but Seed and Attempts"),
              std::string::npos)
      << text;
  }
} // namespace campaign_text
