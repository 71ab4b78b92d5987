// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/measures/failure_record.h>

#include <gtest/gtest.h>
#include <limits>

namespace measures_failure_record
{
  using namespace Waker;

  namespace
  {
    constexpr double level = 4.75; // m
    // Half a metre and a quarter: sums and differences are exact in binary.
    const InitialFailureLimits limits = {0.5, 0.25};


    DykeGeometry
    dyke(const double width, const double height)
    {
      DykeGeometry geometry;
      geometry.width  = width;
      geometry.height = height;
      return geometry;
    }


    /// Two looks: a dyke of 11.25 x 5 m at t = 0, another one at t = 2.
    FailureRecord
    after(const double width, const double height, const bool has_water = true)
    {
      FailureRecord record;
      record.update(dyke(11.25, 5.), 0., level, has_water, limits);
      record.update(dyke(width, height), 2., level, has_water, limits);
      return record;
    }
  } // namespace


  TEST(Measures, the_first_look_is_the_reference)
  {
    FailureRecord record;
    EXPECT_FALSE(record.started);
    record.update(dyke(11.25, 5.), 0., level, true, limits);
    EXPECT_TRUE(record.started);
    EXPECT_EQ(record.initial_width, 11.25);
    EXPECT_EQ(record.initial_height, 5.);
    EXPECT_FALSE(record.failed());
    EXPECT_FALSE(record.flooded());
    EXPECT_EQ(record.initial_time_thesis, -1.);
    record.update(dyke(11., 4.9), 1., level, true, limits);
    EXPECT_EQ(record.initial_width, 11.25); // never moves
    EXPECT_EQ(record.geometry.width, 11.);  // the last one
    EXPECT_EQ(record.geometry.height, 4.9);
  }


  TEST(Measures, a_narrower_dyke_has_failed_in_both_readings)
  {
    EXPECT_FALSE(after(10.75, 5.).failed()); // exactly the limit
    EXPECT_EQ(after(10.75, 5.).initial_time_thesis, -1.);
    const FailureRecord record = after(10.7, 5.);
    EXPECT_EQ(record.initial_time, 2.);
    EXPECT_EQ(record.initial_time_thesis, 2.);
    EXPECT_FALSE(record.flooded());
  }


  TEST(Measures, a_wider_dyke_has_failed_in_the_default_reading_only)
  {
    EXPECT_FALSE(after(11.75, 5.).failed());
    const FailureRecord record = after(11.8, 5.);
    EXPECT_EQ(record.initial_time, 2.);
    EXPECT_EQ(record.initial_time_thesis, -1.);
  }


  TEST(Measures, a_lower_dyke_has_failed_in_the_default_reading_only)
  {
    FailureRecord record;
    record.update(dyke(11.25, 6.), 0., level, true, limits);
    record.update(dyke(11.25, 5.75), 1., level, true, limits);
    EXPECT_FALSE(record.failed());
    record.update(dyke(11.25, 5.7), 2., level, true, limits);
    EXPECT_EQ(record.initial_time, 2.);
    EXPECT_EQ(record.initial_time_thesis, -1.);
    // Higher is no failure.
    EXPECT_FALSE(after(11.25, 5.5).failed());
  }


  TEST(Measures, flooding_is_initial_failure)
  {
    // A crest below the water, or no soil at the water level.
    for (const FailureRecord &record : {after(11.25, 4.7), after(0., 5.)})
      {
        EXPECT_EQ(record.flooding_time, 2.);
        EXPECT_EQ(record.initial_time, 2.);
        EXPECT_EQ(record.initial_time_thesis, 2.);
      }
    EXPECT_FALSE(after(11.25, 4.75).flooded()); // a crest at the water level

    // Also where neither width nor height has changed by its limit.
    const InitialFailureLimits wide = {100., 100.};
    FailureRecord              record;
    record.update(dyke(0.2, 4.8), 0., level, true, wide);
    record.update(dyke(0., 4.7), 3., level, true, wide);
    EXPECT_EQ(record.flooding_time, 3.);
    EXPECT_EQ(record.initial_time, 3.);
    EXPECT_EQ(record.initial_time_thesis, 3.);
  }


  TEST(Measures, water_that_rises_over_a_dyke_is_no_initial_failure)
  {
    FailureRecord stands;
    stands.update(dyke(11.25, 6.), 0., level, true, limits);
    stands.update(dyke(11.25, 6.), 1., 6.5, true, limits);
    stands.update(dyke(11.25, 6.), 2., 6.5, true, limits);
    EXPECT_EQ(stands.flooding_time, 1.);
    EXPECT_EQ(stands.initial_time, -1.);
    EXPECT_EQ(stands.initial_time_thesis, -1.);

    // What it does beside that, counts.
    FailureRecord slides;
    slides.update(dyke(11.25, 6.), 0., level, true, limits);
    slides.update(dyke(10.7, 6.), 1., 6.5, true, limits);
    EXPECT_EQ(slides.flooding_time, 1.);
    EXPECT_EQ(slides.initial_time, 1.);
    EXPECT_EQ(slides.initial_time_thesis, 1.);
  }


  TEST(Measures, without_water_nothing_floods)
  {
    const FailureRecord low = after(11.25, 4., false);
    EXPECT_FALSE(low.flooded());
    EXPECT_TRUE(low.failed()); // it has sunk by a metre
    const FailureRecord none = after(0., 5., false);
    EXPECT_FALSE(none.flooded());
    EXPECT_TRUE(none.failed());
  }


  TEST(Measures, first_times_stay)
  {
    FailureRecord record = after(11.8, 5.); // outwards at t = 2
    record.update(dyke(10., 5.), 3., level, true, limits);
    EXPECT_EQ(record.initial_time, 2.);
    EXPECT_EQ(record.initial_time_thesis, 3.);
    record.update(dyke(11.25, 5.), 4., level, true, limits); // and back
    EXPECT_EQ(record.initial_time, 2.);
    EXPECT_EQ(record.initial_time_thesis, 3.);
    record.update(dyke(0., 4.), 5., level, true, limits);
    record.update(dyke(0., 3.), 6., level, true, limits);
    EXPECT_EQ(record.flooding_time, 5.);
    EXPECT_EQ(record.initial_time, 2.);
    EXPECT_EQ(record.initial_time_thesis, 3.);
  }


  TEST(Measures, no_soil_at_all_is_flooded_at_any_level)
  {
    for (const double h : {4.75, -4.75})
      {
        FailureRecord record;
        record.update(dyke(11.25, h + 0.25), 0., h, true, limits);
        DykeGeometry gone;
        gone.level = h;
        gone.width = 0.;
        record.update(gone, 2., h, true, limits);
        EXPECT_EQ(record.flooding_time, 2.);
        EXPECT_EQ(record.initial_time, 2.);
      }
  }


  TEST(Measures, a_crest_below_the_level_of_w_stands_above_water_that_has_sunk)
  {
    FailureRecord record;
    DykeGeometry  geometry = dyke(11.25, 5.);
    geometry.level         = level;
    record.update(geometry, 0., level, true, limits);
    geometry.width  = 0.;
    geometry.height = 4.5;
    record.update(geometry, 2., level - 2., true, limits);
    EXPECT_TRUE(record.failed());
    EXPECT_FALSE(record.flooded());
    record.update(geometry, 3., level, true, limits);
    EXPECT_EQ(record.flooding_time, 3.);
  }


  TEST(Measures, without_a_width_the_height_tells)
  {
    const double  none = std::numeric_limits<double>::quiet_NaN();
    FailureRecord record;
    record.update(dyke(none, 5.), 0., none, false, limits);
    record.update(dyke(none, 4.8), 1., none, false, limits);
    EXPECT_FALSE(record.failed());
    record.update(dyke(none, 4.7), 2., none, false, limits);
    EXPECT_EQ(record.initial_time, 2.);
    EXPECT_EQ(record.initial_time_thesis, -1.);
  }
} // namespace measures_failure_record
