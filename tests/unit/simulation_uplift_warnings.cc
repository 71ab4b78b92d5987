// SPDX-License-Identifier: LGPL-2.1-or-later
// Uplift that water outside will bring, told before the run.
#include "polder.h"

namespace simulation_uplift_warnings
{
  using namespace Polder;

  namespace
  {
    /// Of a polder whose aquifer follows the water outside: its head is 3 m at
    /// the level 2 m, and 7 m at 4 m. The last setting of a parameter counts.
    std::string
    warnings_of(const std::vector<std::string> &more)
    {
      const std::vector<std::string> settings = {
        "Water/Side=left",
        "Water/Level=2",
        "Water/Minimum support=0",
        "Surface/Method=contour",
        "Time stepping/End time=20",
        "Head lines/deep/Line=",
        "Head lines/deep/Lines by level=2: 0, 3; 3, 3 | 4: 0, 7; 3, 7"};
      return all_warnings(LevelGround::with(settings, more));
    }


    /// The same, of water that a load programme raises.
    std::string
    driven(std::vector<std::string> more)
    {
      for (const char *const setting : {"Load programmes/river/Drives=water",
                                        "Load programmes/Names=river"})
        more.insert(more.begin(), setting);
      return warnings_of(more);
    }

    const std::string river = "Load programmes/river/";
  } // namespace


  // By hand: the head is 3 m at the level 2 m, and 7 m at 4 m, which the water
  // reaches after 10 s. At the points an eighth of a metre below the clay 62.5
  // kPa of soil lie: from a head of 6.125 m on, 7.8 s, they are lifted up. The
  // first of 24 moments after that is 8.33 s, at 3.667 m.
  TEST(Uplift, that_comes_with_the_storm_is_told_beforehand)
  {
    const auto with = [](const std::string &more) {
      return warnings_of({"Water/Rise=0: 0, 10: 2, 20: 2", more});
    };
    const std::string said = with("Time stepping/End time=20");
    EXPECT_TRUE(has(said,
                    "by t = 8.33333 s, at the level 3.66667 m, the water in "
                    "the ground has come to carry more"))
      << said;
    EXPECT_TRUE(has(said, "s, at the level 4 m, ")) << said;
    EXPECT_TRUE(has(said,
                    "where Head lines/deep makes a pressure of 71.25 kPa and "
                    "an effective vertical stress of -8.75 kPa: uplift"))
      << said;
    // Less water, water that has no time to get there, or heavier soil.
    for (const char *const less : {"Water/Rise=0: 0, 10: 1.5, 20: 1.5",
                                   "Head lines/deep/Delay=1000",
                                   "Materials/clay/Unit weight=17.3"})
      EXPECT_FALSE(has(with(less), "uplift")) << less;
    EXPECT_TRUE(has(with("Materials/clay/Unit weight=17"), "uplift"));
  }


  TEST(Uplift, that_a_growing_load_programme_can_bring)
  {
    // As fast as in the storm, to the same level.
    const std::string said = driven({river + "Rate=0.2", river + "Up to=2"});
    EXPECT_TRUE(
      has(said,
          "Load programmes/river: by t = 8.33333 s, at the level "
          "3.66667 m, the water in the ground has come to carry more"))
      << said;
    EXPECT_TRUE(has(said, "at the level 4 m, ") &&
                has(said, "an effective vertical stress of -8.75 kPa: uplift"))
      << said;
    // It begins at 5 s, and is at 4 m at 15 s; at the soonest.
    const std::string later = driven({river + "Rate=0.2",
                                      river + "Start time=5",
                                      river + "Up to=2",
                                      river + "Held by=largest settlement rate",
                                      river + "Hold above=0.1"});
    EXPECT_TRUE(has(later, "by t = 13.3333 s, at the level 3.66667 m"))
      << later;
    EXPECT_TRUE(has(later, "at t = 15 s, at the level 4 m")) << later;
    EXPECT_TRUE(
      has(later, "-8.75 kPa, unless it waits or stops before: uplift"))
      << later;
    // Too slow, not far enough, downwards; a head that takes its time.
    EXPECT_FALSE(has(driven({river + "Rate=0.07"}), "uplift"));
    EXPECT_FALSE(
      has(driven({river + "Rate=0.2", river + "Up to=1.5"}), "uplift"));
    EXPECT_FALSE(has(driven({river + "Rate=-0.2"}), "uplift"));
    EXPECT_FALSE(has(driven({river + "Rate=0.2",
                             river + "Up to=2",
                             "Head lines/deep/Delay=1000"}),
                     "uplift"));
    // Above the ground, at 4 m, the run is over.
    const std::string higher =
      "Head lines/deep/Lines by level=2: 0, 3; 3, 3 | 5: 0, 9; 3, 9";
    EXPECT_TRUE(has(driven({river + "Rate=0.2", higher}), "at the level 4 m"));
    EXPECT_TRUE(
      has(driven({river + "Rate=0.2", higher, "Stop rules/On flooding=false"}),
          "at the level 5 m"));
  }


  TEST(Uplift, that_a_table_and_a_rise_bring_together)
  {
    const std::string said = driven({river + "Kind=table of time",
                                     river + "Table=0: 0, 11: 1, 12: 0",
                                     "Water/Rise=0: 0, 10: 1"});
    EXPECT_TRUE(has(said, "Water/Rise and Load programmes/river: by t = "))
      << said;
    EXPECT_TRUE(has(said, "at t = 11 s, at the level 4 m")) << said;
    // Neither alone.
    EXPECT_FALSE(has(driven({river + "Kind=table of time",
                             river + "Table=0: 0, 11: 1, 12: 0"}),
                     "uplift"));
    EXPECT_FALSE(has(warnings_of({"Water/Rise=0: 0, 10: 1"}), "uplift"));
  }


  TEST(Uplift, that_a_table_of_a_quantity_can_bring)
  {
    const std::string kind = "Kind=table of a quantity",
                      what = "Quantity=largest settlement";
    const std::string said =
      driven({river + kind, river + what, river + "Table=0: 0, 0.1: 2"});
    EXPECT_TRUE(has(said,
                    "-8.75 kPa, if its table comes to its largest factor: "
                    "uplift"))
      << said;
    EXPECT_FALSE(
      has(driven({river + kind, river + what, river + "Table=0: 0, 0.1: 1.5"}),
          "uplift"));
  }
} // namespace simulation_uplift_warnings
