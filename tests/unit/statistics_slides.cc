// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/statistics/slides.h>

#include "store_failed_dyke.h"
#include "user_errors.h"
#include <gtest/gtest.h>

namespace statistics_slides
{
  namespace
  {
    using namespace Waker;

    std::vector<Slide>
    slides_of(const std::vector<TracePoint> &corners,
              const SlideParameters         &parameters = SlideParameters())
    {
      return find_slides(failed_dyke(corners), parameters);
    }
  } // namespace


  TEST(Slides, two_with_a_rest_between_them)
  {
    const auto slides = slides_of({{0, 11, 5},
                                   {3, 11, 5},
                                   {4, 6, 5},
                                   {7, 6, 5},
                                   {8.5, 3, 4.9},
                                   {15, 3, 4.9}});
    ASSERT_EQ(slides.size(), 2U);
    EXPECT_NEAR(slides[0].start, 3., 0.05);
    EXPECT_NEAR(slides[0].end, 4., 0.05);
    EXPECT_NEAR(slides[0].width, 6., 0.051);
    EXPECT_NEAR(slides[1].start, 7., 0.05);
    EXPECT_NEAR(slides[1].end, 8.5, 0.05);
    EXPECT_NEAR(slides[1].width, 3., 0.051);
    EXPECT_NEAR(slides[1].height, 4.9, 0.051);
    EXPECT_FALSE(slides[0].floods || slides[1].floods);
  }


  TEST(Slides, width_may_grow_and_height_may_go_alone)
  {
    // outwards (fig. 5.2e), twice
    const auto outwards = slides_of(
      {{0, 11, 5}, {3, 11, 5}, {4, 13, 5}, {6, 13, 5}, {7, 15, 5}, {9, 15, 5}});
    ASSERT_EQ(outwards.size(), 2U);
    EXPECT_NEAR(outwards[0].width, 13., 0.051);
    EXPECT_NEAR(outwards[1].start, 6., 0.05);

    const auto down = slides_of({{0, 11, 6},
                                 {3, 11, 6},
                                 {4, 11, 5.5},
                                 {6, 11, 5.5},
                                 {7, 11, 5},
                                 {9, 11, 5}});
    ASSERT_EQ(down.size(), 2U);
    EXPECT_NEAR(down[0].height, 5.5, 0.051);
  }


  TEST(Slides, change_is_measured_from_the_previous_slide)
  {
    // after a large slide a small movement is none
    EXPECT_EQ(slides_of({{0, 11, 5},
                         {3, 11, 5},
                         {4, 6, 5},
                         {6, 6, 5},
                         {6.1, 5.85, 5},
                         {9, 5.85, 5}})
                .size(),
              1U);
  }


  TEST(Slides, a_short_rest_does_not_part_them)
  {
    const std::vector<TracePoint> corners = {
      {0, 11, 5}, {3, 11, 5}, {4, 6, 5}, {4.4, 6, 5}, {5, 3, 5}, {9, 3, 5}};
    EXPECT_EQ(slides_of(corners).size(), 1U);
    SlideParameters parameters;
    parameters.duration = 0.2;
    EXPECT_EQ(slides_of(corners, parameters).size(), 2U);
  }


  TEST(Slides, small_movements_add_up)
  {
    // 0.2 m each, at 1 m/s
    const auto slides = slides_of({{0, 11, 5},
                                   {3, 11, 5},
                                   {3.2, 10.8, 5},
                                   {6, 10.8, 5},
                                   {6.2, 10.6, 5},
                                   {12, 10.6, 5}});
    ASSERT_EQ(slides.size(), 1U);
    EXPECT_NEAR(slides[0].start, 3., 0.1);
    EXPECT_NEAR(slides[0].end, 6.2, 0.1);

    SlideParameters parameters;
    parameters.minimum_change = 0.15;
    EXPECT_EQ(slides_of({{0, 11, 5},
                         {3, 11, 5},
                         {3.2, 10.8, 5},
                         {6, 10.8, 5},
                         {6.2, 10.6, 5},
                         {12, 10.6, 5}},
                        parameters)
                .size(),
              2U);
  }


  TEST(Slides, breathing_surface_is_a_plateau)
  {
    // after the slide W goes up and down by 4 cm, at 4 m/s
    std::vector<TracePoint> corners = {{0, 11, 5}, {3, 11, 5}, {4, 6, 5}};
    for (double t = 4.5; t < 9.; t += 0.5)
      {
        corners.push_back({t, 6., 5});
        corners.push_back({t + 0.01, 6.04, 5});
        corners.push_back({t + 0.25, 6.04, 5});
        corners.push_back({t + 0.26, 6., 5});
      }
    EXPECT_EQ(slides_of(corners).size(), 1U);
  }


  TEST(Slides, last_one_floods_and_no_other)
  {
    const auto twice = slides_of({{0, 11, 5},
                                  {3, 11, 5},
                                  {4, 5, 5},
                                  {6, 5, 5},
                                  {7, 0.5, 4.8},
                                  {7.01, 0, 4.7},
                                  {12, 0, 3}});
    ASSERT_EQ(twice.size(), 2U);
    EXPECT_FALSE(twice[0].floods);
    EXPECT_TRUE(twice[1].floods);
    EXPECT_NEAR(twice[1].end, 7.01, 0.02); // what comes after does not count

    // a deep slide that floods directly
    const auto once = slides_of({{0, 11, 5}, {3, 11, 5}, {4, 0, 4}});
    ASSERT_EQ(once.size(), 1U);
    EXPECT_TRUE(once[0].floods);

    // creeping under the water from a plateau is a slide of its own
    const auto creep =
      slides_of({{0, 11, 5}, {3, 11, 5}, {4, 5, 5}, {12, 5, 4.7}});
    ASSERT_EQ(creep.size(), 2U);
    EXPECT_TRUE(creep[1].floods);
    EXPECT_NEAR(creep[1].start, creep[0].end, 1e-12);
  }


  TEST(Slides, every_failure_has_one_and_nothing_else_has)
  {
    // creeps by 1 m in 20 s
    const auto creep =
      slides_of({{0, 11, 5}, {3, 11, 5}, {23, 10, 5}, {25, 10, 5}});
    ASSERT_EQ(creep.size(), 1U);
    EXPECT_NEAR(creep[0].start, 9., 0.05); // W has changed by 0.3 m
    EXPECT_EQ(creep[0].end, 25.);

    Record bare; // the events are all that is known
    bare.initial_time = bare.flooding_time = bare.end_time = 4.;
    ASSERT_EQ(find_slides(bare, SlideParameters()).size(), 1U);
    EXPECT_TRUE(find_slides(bare, SlideParameters())[0].floods);

    Record stable = failed_dyke({{0, 11, 5}, {10, 10.8, 5}});
    EXPECT_TRUE(find_slides(stable, SlideParameters()).empty());
  }


  TEST(Slides, one_under_way_at_the_end_counts)
  {
    const auto slides = slides_of({{0, 11, 5}, {3, 11, 5}, {6, 4, 5}});
    ASSERT_EQ(slides.size(), 1U);
    EXPECT_NEAR(slides[0].width, 4., 1e-12);
    EXPECT_FALSE(slides[0].floods);
  }


  TEST(Slides, parameters_are_checked)
  {
    SlideParameters parameters;
    parameters.check();
    parameters.rate = 0.;
    EXPECT_USER_ERROR(parameters.check(), "Slides/Rate", "is 0");
  }
} // namespace statistics_slides
