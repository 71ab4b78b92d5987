// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/measures/sliding_masses.h>
#include <waker/particles/removal.h>

#include "measures_blocks.h"
#include <gtest/gtest.h>
#include <limits>

namespace measures_sliding_masses
{
  using namespace Waker;

  namespace
  {
    constexpr double limit = 0.25; // m


    /// A block, watched.
    template <int dim>
    struct Watched
    {
      Watched()
        : points(block_of_points<dim>())
        , finder(points, crest_of(points), limit)
      {
        finder.start(points);
        look(0.);
      }

      /// Put the soil for which `where` is true this far from its place.
      template <typename Where>
      void
      put(const Where &where, const double dx, const double dy)
      {
        for (std::size_t q = 0; q < points.n_points(); ++q)
          if (where(points.initial_position[q]))
            {
              points.position[q] = points.initial_position[q];
              points.position[q][0] += dx;
              points.position[q][1] += dy;
            }
      }

      void
      look(const double time)
      {
        finder.update(time, points, sliding);
      }

      /// Volume at t = 0 of the points of a mass; 0: of what is stable.
      double
      volume(const unsigned int mass) const
      {
        double sum = 0.;
        for (std::size_t q = 0; q < points.n_points(); ++q)
          if (points.scalar("slide")[q] == mass)
            sum += points.scalar("initial volume")[q];
        return sum;
      }

      MaterialPoints<dim>    points;
      SlidingMassFinder<dim> finder;
      SlidingMasses          sliding;
    };


    template <int dim>
    void
    expect_same(const SlidingMasses &a, const SlidingMasses &b)
    {
      std::vector<double> numbers[2];
      for (const SlidingMasses *const s : {&a, &b})
        {
          const auto add = [&](const char *, double number, SlidingQuantity) {
            numbers[s == &b].push_back(std::isnan(number) ? -1e300 : number);
          };
          SlidingMasses::for_each_number(*s, add);
          for (const SlidingMass &mass : s->masses)
            SlidingMass::for_each_number(mass, add);
        }
      ASSERT_EQ(numbers[0].size(), numbers[1].size());
      for (std::size_t i = 0; i < numbers[0].size(); ++i)
        EXPECT_EQ(numbers[0][i], numbers[1][i]) << i;
    }
  } // namespace


  TEST(Measures, two_blocks_are_split_into_stable_soil_and_a_sliding_mass)
  {
    Watched<2> block;
    EXPECT_EQ(block.sliding.whole_volume, 40.);
    EXPECT_EQ(block.sliding.stable_volume(), 40.);
    block.put([](const Point<2> &x) { return x[0] < 7.; }, 0.03, -0.04);
    block.put([](const Point<2> &x) { return x[0] > 7. && x[1] > 1.; },
              0.3,
              -0.4);
    block.look(1.5);
    const SlidingMasses &sliding = block.sliding;
    ASSERT_EQ(sliding.masses.size(), 1u);
    const SlidingMass &mass = sliding.masses[0];
    EXPECT_EQ(mass.time, 1.5);
    EXPECT_EQ(mass.volume, 9.); // 3 by 3 m
    EXPECT_EQ(mass.centre[0], 8.5);
    EXPECT_EQ(mass.centre[1], 2.5);
    EXPECT_EQ(mass.lower[0], 7.);
    EXPECT_EQ(mass.upper[0], 10.);
    EXPECT_EQ(mass.lower[1], 1.);
    EXPECT_EQ(mass.upper[1], 4.);
    EXPECT_TRUE(std::isnan(mass.width) && std::isnan(mass.centre[2]));
    EXPECT_EQ(sliding.stable_volume(), 31.);
    EXPECT_EQ(sliding.relative_failure_volume(), 9. / 40.);
    EXPECT_EQ(sliding.retrogression, 3.);
    EXPECT_TRUE(std::isnan(sliding.damaged_crest_width));
    EXPECT_NEAR(sliding.largest_displacement, 0.05, 1e-15);
    for (std::size_t q = 0; q < block.points.n_points(); ++q)
      {
        const Point<2> &x = block.points.initial_position[q];
        EXPECT_EQ(block.points.scalar("slide")[q], x[0] > 7. && x[1] > 1.) << x;
      }
  }


  TEST(Measures, a_sliding_mass_in_space_has_a_width_and_a_place_along_z)
  {
    Watched<3> block;
    EXPECT_EQ(block.sliding.damaged_crest_width, 0.);
    // Two bodies, which slide at once, are one mass.
    block.put(
      [](const Point<3> &x) {
        return x[0] > 8. && ((x[2] > 1. && x[2] < 2.) || x[2] > 5.5);
      },
      1.,
      0.);
    block.look(2.);
    ASSERT_EQ(block.sliding.masses.size(), 1u);
    const SlidingMass &mass = block.sliding.masses[0];
    EXPECT_EQ(mass.volume, 2. * 4. * 1.5);
    EXPECT_EQ(mass.width, 1.5);
    EXPECT_EQ(mass.lower[2], 1.);
    EXPECT_EQ(mass.upper[2], 6.);
    EXPECT_EQ(mass.centre[2], (1. * 1.5 + 0.5 * 5.75) / 1.5);
    EXPECT_EQ(block.sliding.damaged_crest_width, 1.5);
    EXPECT_EQ(block.sliding.retrogression, 2.);
  }


  TEST(Measures, soil_is_stable_up_to_the_limit_and_not_beyond)
  {
    Watched<2>   block;
    const double beyond = std::nextafter(8.25, 9.) - 8.;
    for (const double dx : {limit, beyond})
      {
        // All one row of it: from x = 8.125 to 8.125 + dx is exact.
        block.put([](const Point<2> &x) { return x[0] == 8.125; }, dx, 0.);
        block.look(1.);
        EXPECT_EQ(block.sliding.masses.size(), dx == limit ? 0u : 1u);
      }
    EXPECT_EQ(block.sliding.masses.at(0).volume, 1.); // 0.25 by 4 m
  }


  TEST(Measures, a_sliding_mass_stays_what_it_was)
  {
    Watched<2> block;
    const auto front = [](const Point<2> &x) { return x[0] > 8.; };
    const auto next  = [](const Point<2> &x) { return x[0] > 5. && x[0] < 8.; };
    block.put(front, 0.3, 0.);
    block.look(1.);
    const SlidingMass first = block.sliding.masses.at(0);
    block.look(1.); // again at the same moment: nothing new
    EXPECT_EQ(block.sliding.masses.size(), 1u);

    // The first goes on, and a part of it lies back where it was.
    block.put(front, 3., 0.);
    block.put([](const Point<2> &x) { return x[0] > 9.; }, 0., 0.);
    block.put(next, 0.2, 0.);
    block.look(2.);
    EXPECT_EQ(block.sliding.masses.size(), 1u);
    block.put(next, 0.26, 0.);
    block.look(3.);
    ASSERT_EQ(block.sliding.masses.size(), 2u);
    EXPECT_EQ(block.sliding.masses[0].time, first.time);
    EXPECT_EQ(block.sliding.masses[0].volume, first.volume);
    EXPECT_EQ(block.sliding.masses[0].centre[0], first.centre[0]);
    EXPECT_EQ(block.sliding.masses[1].time, 3.);
    EXPECT_EQ(block.sliding.masses[1].volume, 12.);
    EXPECT_EQ(block.volume(1), 8.);
    EXPECT_EQ(block.volume(2), 12.);
    EXPECT_EQ(block.volume(0), block.sliding.stable_volume());
    EXPECT_EQ(block.sliding.retrogression, 5.);
  }


  TEST(Measures, no_stable_soil_has_moved_further_than_the_limit)
  {
    // Of 0, 1 and 10 m the best two parts are 10 m and the rest.
    Watched<2> block;
    block.put([](const Point<2> &x) { return x[0] > 5.; }, 1., 0.);
    block.put([](const Point<2> &x) { return x[0] > 9.; }, 10., 0.);
    block.look(1.);
    ASSERT_EQ(block.sliding.masses.size(), 2u);
    EXPECT_EQ(block.sliding.masses[0].volume, 4.);
    EXPECT_EQ(block.sliding.masses[1].volume, 16.);
    EXPECT_EQ(block.sliding.largest_displacement, 0.);

    // What has moved as one is one; then nothing is stable any more.
    block.put([](const Point<2> &x) { return x[0] < 5.; }, -0.5, 0.);
    block.look(2.);
    ASSERT_EQ(block.sliding.masses.size(), 3u);
    EXPECT_EQ(block.sliding.masses[2].volume, 20.);
    EXPECT_EQ(block.sliding.stable_volume(), 0.);
    EXPECT_EQ(block.sliding.relative_failure_volume(), 1.);
    EXPECT_EQ(block.sliding.retrogression, 10.);
    block.look(3.);
    EXPECT_EQ(block.sliding.masses.size(), 3u);
  }


  TEST(Measures, sliding_masses_are_weighted_by_the_volume_at_the_start)
  {
    // By numbers of points 0.3 m belongs to 0 m (0.045 against 0.245), by
    // volumes of 100, 10 and 1 to 1 m (0.818 against 0.445).
    MaterialPoints<2> points;
    points.resize(3);
    for (unsigned int q = 0; q < 3; ++q)
      {
        points.id[q] = q;
        for (unsigned int d = 0; d < 2; ++d)
          points.half_size[q][d] = 0.5;
        points.initial_position[q] = points.position[q] = Point<2>(q, 0.);
      }
    points.volume = {100., 10., 1.};
    const SlidingMassFinder<2> finder(points, crest_of(points), limit);
    finder.start(points);
    points.volume = {1., 1., 1.}; // whatever it becomes later
    points.position[1][1] += 0.3;
    points.position[2][1] += 1.;
    SlidingMasses sliding;
    finder.update(1., points, sliding);
    EXPECT_EQ(sliding.whole_volume, 111.);
    ASSERT_EQ(sliding.masses.size(), 1u);
    EXPECT_EQ(sliding.masses[0].volume, 11.);
  }


  TEST(Measures, sliding_masses_do_not_depend_on_the_order_of_the_points)
  {
    std::mt19937                           generator(5);
    std::uniform_real_distribution<double> random(0., 1.);
    Watched<3>                             block;
    for (double &volume : block.points.volume)
      volume = 0.01 + random(generator); // sums are rounded
    const MaterialPoints<3> start = block.points;

    SlidingMasses       results[2];
    std::vector<double> numbers[2];
    for (const bool is_shuffled : {false, true})
      {
        MaterialPoints<3> points = is_shuffled ? shuffled(start, 1) : start;
        const SlidingMassFinder<3> finder(points, crest_of(points), limit);
        finder.start(points);
        for (unsigned int step = 1; step <= 4; ++step)
          {
            if (is_shuffled)
              points = shuffled(points, 1 + step); // sorted anew, as it runs
            for (std::size_t q = 0; q < points.n_points(); ++q)
              {
                // Many points have the same displacement: ties.
                const Point<3> &x = points.initial_position[q];
                const double    u = std::max(0., x[0] - 10. + step * x[2] / 4.);
                points.position[q] = x;
                points.position[q][0] += 0.25 * u;
              }
            finder.update(step, points, results[is_shuffled]);
          }
        numbers[is_shuffled].resize(points.n_points());
        for (std::size_t q = 0; q < points.n_points(); ++q)
          numbers[is_shuffled][points.id[q]] = points.scalar("slide")[q];
      }
    EXPECT_GE(results[0].masses.size(), 3u);
    expect_same<3>(results[0], results[1]);
    EXPECT_EQ(numbers[0], numbers[1]);
  }


  TEST(Measures, soil_that_flows_in_is_no_sliding_mass_and_soil_that_left_stays)
  {
    Watched<2> block;
    block.put([](const Point<2> &x) { return x[0] > 8.; }, 1., 0.);
    block.look(1.);
    // The feeder's way: every array grows, with zeros.
    MaterialPoints<2> &points = block.points;
    const std::size_t  n      = points.n_points();
    MaterialPoints<2>::for_each_array(points, [&](const char *, auto &array) {
      if (!array.empty())
        array.resize(n + 1);
    });
    points.id[n]       = n;
    points.volume[n]   = 1.;
    points.position[n] = Point<2>(0., 7.); // far from its initial position
    std::vector<std::size_t> gone;
    for (std::size_t q = 0; q < n; ++q)
      if (points.position[q][0] > 10.)
        gone.push_back(q);
    ASSERT_EQ(gone.size(), 64u); // 1 m of it
    remove_points(gone, points);
    block.look(2.);
    EXPECT_EQ(block.sliding.masses.size(), 1u);
    EXPECT_EQ(block.sliding.whole_volume, 40.);
    EXPECT_EQ(block.sliding.stable_volume(), 32.);
    EXPECT_EQ(block.sliding.largest_displacement, 0.);

    // What is left slides: the crest of what is gone has failed, too.
    block.put([](const Point<2> &x) { return x[0] > 6. && x[0] < 8.; }, 1., 0.);
    block.look(3.);
    ASSERT_EQ(block.sliding.masses.size(), 2u);
    EXPECT_EQ(block.sliding.masses[1].volume, 8.);
    EXPECT_EQ(block.sliding.retrogression, 4.);
    EXPECT_EQ(points.scalar("slide").back(), 0.);
  }
} // namespace measures_sliding_masses
