// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/particles/layer_gaps.h>

#include <gtest/gtest.h>

namespace particles_layer_gaps
{
  namespace
  {
    using namespace Waker;


    LayerParameters
    layer(const std::string &name, const std::string &polygon)
    {
      LayerParameters result;
      result.name    = name;
      result.polygon = polygon;
      return result;
    }


    TEST(LayerGaps, layers_that_touch_have_none)
    {
      EXPECT_TRUE(
        layer_gaps({layer("base", "0, 0; 20, 0; 20, 2; 0, 2")}, 0.5).empty());
      // A dyke on a base, of two zones with a sloping joint.
      EXPECT_TRUE(layer_gaps({layer("base", "0, 0; 20, 0; 20, 2; 0, 2"),
                              layer("core", "5, 2; 10, 2; 8, 4; 7, 4"),
                              layer("cover", "10, 2; 14, 2; 9, 4; 8, 4")},
                             0.5)
                    .empty());
    }


    TEST(LayerGaps, a_slot_between_two_layers_is_found)
    {
      const auto gaps =
        layer_gaps({layer("base", "0, 0; 20, 0; 20, 2; 0, 2"),
                    layer("dyke", "5, 2.1; 15, 2.1; 12, 5; 8, 5")},
                   0.5);
      ASSERT_EQ(gaps.size(), 1u);
      EXPECT_EQ(gaps[0].one, "base");
      EXPECT_EQ(gaps[0].other, "dyke");
      EXPECT_NEAR(gaps[0].width, 0.1, 1e-12);
      EXPECT_NEAR(gaps[0].length, 10., 1e-12);
      EXPECT_NEAR(gaps[0].middle[0], 10., 1e-12);
      EXPECT_NEAR(gaps[0].middle[1], 2.05, 1e-12);
    }


    TEST(LayerGaps, a_wedge_and_an_upright_slot_are_found)
    {
      // The upper layer's left corner is 0.2 m too high.
      auto gaps = layer_gaps({layer("a", "0, 0; 10, 0; 10, 2; 0, 2"),
                              layer("b", "0, 2.2; 10, 2; 10, 4; 0, 4")},
                             0.5);
      ASSERT_EQ(gaps.size(), 1u);
      EXPECT_NEAR(gaps[0].width, 0.1, 1e-3);
      gaps = layer_gaps({layer("a", "0, 0; 10, 0; 10, 2; 0, 2"),
                         layer("b", "10.3, 0; 20, 0; 20, 2; 10.3, 2")},
                        0.5);
      ASSERT_EQ(gaps.size(), 1u);
      EXPECT_NEAR(gaps[0].width, 0.3, 1e-12);
      EXPECT_NEAR(gaps[0].length, 2., 1e-12);
    }


    TEST(LayerGaps, what_is_meant_to_be_apart_is_not_found)
    {
      // A ditch of two metres between two dykes.
      EXPECT_TRUE(layer_gaps({layer("a", "0, 0; 10, 0; 10, 2; 0, 2"),
                              layer("b", "12, 0; 20, 0; 20, 2; 12, 2")},
                             0.5)
                    .empty());
      // A third layer fills the slot.
      EXPECT_TRUE(layer_gaps({layer("a", "0, 0; 10, 0; 10, 2; 0, 2"),
                              layer("c", "0, 2; 10, 2; 10, 2.1; 0, 2.1"),
                              layer("b", "0, 2.1; 10, 2.1; 10, 4; 0, 4")},
                             0.5)
                    .empty());
      // One behind the other.
      LayerParameters front = layer("a", "0, 0; 10, 0; 10, 2; 0, 2");
      LayerParameters back  = layer("b", "0, 2.1; 10, 2.1; 10, 4; 0, 4");
      front.extent          = {0., 1.};
      back.extent           = {1., 2.};
      EXPECT_TRUE(layer_gaps({front, back}, 0.5).empty());
      back.extent = {0.5, 2.};
      EXPECT_EQ(layer_gaps({front, back}, 0.5).size(), 1u);
    }


    TEST(LayerGaps, soil_that_hangs_above_soil_is_found_at_any_distance)
    {
      const auto gaps = layer_gaps({layer("a", "0, 0; 10, 0; 10, 2; 0, 2"),
                                    layer("b", "2, 5; 8, 5; 8, 6; 2, 6")},
                                   0.5);
      ASSERT_EQ(gaps.size(), 1u);
      EXPECT_NEAR(gaps[0].width, 3., 1e-12);
      EXPECT_NEAR(gaps[0].length, 6., 1e-12);
    }
  } // namespace
} // namespace particles_layer_gaps
