// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/statistics/failure_class.h>

#include "store_failed_dyke.h"
#include <cmath>
#include <gtest/gtest.h>

namespace statistics_failure_class
{
  namespace
  {
    using namespace Waker;

    FailureClass
    class_of(const Record &record)
    {
      return classify(record, find_slides(record, SlideParameters()), 0.);
    }

    const std::vector<TracePoint> one_slide  = {{0, 11, 5},
                                                {3, 11, 5},
                                                {4, 6, 5},
                                                {9, 6, 5}};
    const std::vector<TracePoint> two_slides = {{0, 11, 5},
                                                {3, 11, 5},
                                                {4, 6, 5},
                                                {6, 6, 5},
                                                {7, 2.5, 4.9},
                                                {9, 2.5, 4.9}};
  } // namespace


  TEST(FailureClasses, of_schematic_dykes)
  {
    Record record;
    EXPECT_EQ(class_of(record), FailureClass::none);

    record              = failed_dyke(one_slide);
    record.first_inward = {20., 0.8, -0.5};
    record.inward       = {45., 4., -0.9};
    EXPECT_EQ(class_of(record), FailureClass::initial_only);

    record              = failed_dyke(two_slides);
    record.first_inward = {20., 0.8, -0.5};
    record.inward       = {75., 5., -0.7}; // soft soil runs out far
    EXPECT_EQ(class_of(record), FailureClass::retrogressive);

    record              = failed_dyke({{0, 11, 5}, {3, 11, 5}, {4, 0, 4}});
    record.first_inward = record.inward = {60., 1.5, -0.8};
    EXPECT_EQ(class_of(record), FailureClass::initial_only);
  }


  TEST(FailureClasses, outer_slope)
  {
    // W grows, as W_1 + W_2 (fig. 5.2e); slides by displacement are not known
    Record record =
      failed_dyke({{0, 11, 5}, {2, 11, 5}, {3, 13, 5}, {9, 13, 5}});
    record.inner_slide.time = record.outer_slide.time = NAN;
    record.first_outward                              = {8., -1., -0.8};
    record.outward                                    = {10., -2., -1.};
    EXPECT_EQ(class_of(record), FailureClass::outer);
    // a retrogressive failure in the opposite direction does not change it
    record.inward = {40., 4., -1.};
    EXPECT_EQ(class_of(record), FailureClass::outer);
    // too slow to have moved by 0.5 m after one second
    record.first_outward = {};
    record.inward        = {};
    EXPECT_EQ(class_of(record), FailureClass::outer);
    record.outward = {};
    EXPECT_EQ(class_of(record), FailureClass::outer);
  }


  TEST(FailureClasses, outer_is_where_an_outer_slide_was_seen)
  {
    // The crest settles: W grows by 0.4 m, H falls by 0.15 m, no body moves.
    Record record =
      failed_dyke({{0, 11, 5}, {2, 11, 5}, {3, 11.4, 4.85}, {9, 11.4, 4.85}});
    EXPECT_TRUE(record.failed());
    EXPECT_EQ(class_of(record), FailureClass::settled);
    EXPECT_EQ(to_string(FailureClass::settled), "settled");
    Record old           = record;
    old.inner_slide.time = old.outer_slide.time = NAN;
    EXPECT_EQ(class_of(old), FailureClass::outer);

    Record outer           = record;
    outer.outer_slide.time = 2.5;
    EXPECT_EQ(class_of(outer), FailureClass::outer);
    Record inner           = record;
    inner.inner_slide.time = 2.5;
    EXPECT_EQ(class_of(inner), FailureClass::initial_only);
    Record moved = record; // a body that was not seen by displacement
    moved.inward = {20., 1., -0.5};
    EXPECT_EQ(class_of(moved), FailureClass::initial_only);

    Record both           = outer; // the first, or what moved more
    both.inner_slide.time = 3.;
    EXPECT_EQ(class_of(both), FailureClass::outer);
    both.inner_slide.time = 2.;
    EXPECT_EQ(class_of(both), FailureClass::initial_only);
    both.outward = {20., -1., -0.5};
    EXPECT_EQ(class_of(both), FailureClass::outer);
  }


  TEST(FailureClasses, water_over_a_dyke_that_stands_is_overflow)
  {
    Record record;
    record.initial_width = record.residual_width = 11.;
    record.initial_height = record.residual_height = 5.;
    record.outcome                                 = Outcome::flooding;
    record.flooding_time                           = 7.;
    EXPECT_EQ(class_of(record), FailureClass::overflow);
    record.inner_slide.time = 8.; // later
    EXPECT_EQ(class_of(record), FailureClass::overflow);
    record.inner_slide.time = 6.;
    EXPECT_EQ(class_of(record), FailureClass::initial_only);
  }


  TEST(FailureClasses, horizontal_slide)
  {
    // first a rotational slide, then the rest of the dyke is pushed away and
    // sinks until it floods, most of its width still there (fig. 5.5f)
    const std::vector<TracePoint> corners = {{0, 11, 5},
                                             {3, 11, 5},
                                             {4, 8, 5},
                                             {6, 8, 5},
                                             {7.5, 7.4, 4.76},
                                             {7.52, 0, 4.74}};
    Record                        record  = failed_dyke(corners);
    record.first_inward                   = {20., 0.8, -0.5};
    record.inward                         = {90., 4., -0.5};
    EXPECT_EQ(class_of(record), FailureClass::horizontal);

    Record lower    = record; // its soil falls as on a slope
    lower.inward.dy = -1.2;
    EXPECT_EQ(class_of(lower), FailureClass::retrogressive);

    Record smaller      = record; // only the slope has moved
    smaller.inward.area = 40.;
    EXPECT_EQ(class_of(smaller), FailureClass::retrogressive);

    // the width is eaten up before the height goes
    Record eaten       = failed_dyke({{0, 11, 5},
                                      {3, 11, 5},
                                      {4, 8, 5},
                                      {6, 8, 5},
                                      {7.5, 0.9, 4.9},
                                      {7.52, 0, 4.74}});
    eaten.first_inward = record.first_inward;
    eaten.inward       = record.inward;
    EXPECT_EQ(class_of(eaten), FailureClass::retrogressive);

    // fig. 5.2d: all at once, no flooding
    Record stays =
      failed_dyke({{0, 11, 5}, {3, 11, 5}, {5, 10.5, 4.85}, {9, 10.5, 4.85}});
    stays.first_inward = {80., 0.7, -0.05};
    stays.inward       = {95., 2., -0.15};
    EXPECT_EQ(class_of(stays), FailureClass::horizontal);
  }


  TEST(FailureClasses, do_not_depend_on_the_datum)
  {
    // the body moves as a whole, with all of W_i H_i and not more
    const std::vector<TracePoint> dam = {{0, 11, 5},
                                         {3, 11, 5},
                                         {4, 10.5, 4.8},
                                         {4.5, 0, 4}};
    for (const double shift : {-20., -6., 0., 10.})
      {
        Record record       = failed_dyke(dam);
        record.first_inward = {40., 1., -0.1};
        record.inward       = {60., 5., -0.3};
        record.initial_height += shift;
        record.residual_height += shift;
        for (TracePoint &point : record.trace)
          point.height += shift;
        const std::vector<Slide> slides =
          find_slides(record, SlideParameters());
        EXPECT_EQ(classify(record, slides, shift), FailureClass::horizontal)
          << shift;
        record.inward.area = 50.;
        EXPECT_NE(classify(record, slides, shift), FailureClass::horizontal)
          << shift;
      }
  }
} // namespace statistics_failure_class
