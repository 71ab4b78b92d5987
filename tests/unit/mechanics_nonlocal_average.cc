// SPDX-License-Identifier: LGPL-2.1-or-later
// Averages over surroundings: against sums over all pairs, closed forms, and
// what must not change.
#include <waker/base/choice.h>
#include <waker/mechanics/nonlocal_average.h>

#include "mapping_lattice.h"
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace mechanics_nonlocal_average
{
  using namespace Waker;

  namespace
  {
    template <int dim>
    struct Cloud
    {
      std::vector<Point<dim>>    positions;
      std::vector<double>        volumes, values;
      std::vector<std::uint32_t> members;

      void
      add(const Point<dim> &x, const double volume, const double value)
      {
        members.push_back(positions.size());
        positions.push_back(x);
        volumes.push_back(volume);
        values.push_back(value);
      }

      /// In the order of the points.
      std::vector<double>
      averages(const double length, const NeighbourWeight weight) const
      {
        NonlocalAverage<dim> average(length, weight);
        average.reinit(members, positions, volumes, values);
        std::vector<double> result(positions.size(), -1.);
        for (unsigned int k = 0; k < average.order().size(); ++k)
          result[average.order()[k]] = average.at(k);
        return result;
      }
    };


    double
    weight_of(const NeighbourWeight weight, const double x)
    {
      return (weight == NeighbourWeight::gaussian ? 1. : x) * std::exp(-x * x);
    }


    /// Points here and there, of different volumes, with gaps between them.
    template <int dim>
    Cloud<dim>
    scattered(const unsigned int n, const double size)
    {
      Lattice::Random random(71 + dim);
      Cloud<dim>      cloud;
      for (unsigned int p = 0; p < n; ++p)
        {
          Point<dim> x(random.vector<dim>(0., size));
          x[0] += p % 7 == 0 ? 2. * size : -size;
          cloud.add(x, random(0.2, 1.), p % 5 < 2 ? random(0., 1.) : 0.);
        }
      return cloud;
    }


    template <int dim>
    void
    check_all_pairs(const unsigned int n, const double size, const double l)
    {
      Cloud<dim> cloud = scattered<dim>(n, size);
      cloud.members.erase(cloud.members.begin() + n / 2,
                          cloud.members.begin() + n / 2 + 10);
      for (const auto weight : all_choices<NeighbourWeight>())
        {
          const auto   averages  = cloud.averages(l, weight);
          unsigned int n_between = 0;
          for (const std::uint32_t p : cloud.members)
            {
              double weights = 0., contents = 0.;
              bool   at_the_edge = false; // of the reach, to round-off
              for (const std::uint32_t q : cloud.members)
                {
                  const double x =
                    cloud.positions[p].distance(cloud.positions[q]) / l;
                  at_the_edge    = at_the_edge || std::abs(x - 2.5) < 1e-5;
                  const double w = x < 2.5 ? weight_of(weight, x) : 0.;
                  weights += w * cloud.volumes[q];
                  contents += w * cloud.volumes[q] * cloud.values[q];
                }
              // A weight is exact to 2e-6 of itself, and places to 1e-7 of the
              // body, which is some 40 l long: 3e-6 or so.
              if (at_the_edge)
                continue;
              EXPECT_NEAR(averages[p], contents / weights, 1e-5) << p;
              n_between += averages[p] > 0.01 && averages[p] < 0.5;
            }
          EXPECT_GT(n_between, n / 2);
          EXPECT_EQ(averages[n / 2], -1.); // no member
        }
    }
  } // namespace


  TEST(Mechanics, averages_over_surroundings_are_sums_over_all_pairs)
  {
    check_all_pairs<2>(600, 5., 0.5);
    check_all_pairs<3>(900, 3., 0.6);
  }


  TEST(Mechanics, constants_keep_their_value_beside_free_surfaces)
  {
    for (const auto weight : all_choices<NeighbourWeight>())
      {
        Cloud<2> cloud = scattered<2>(500, 4.);
        cloud.values.assign(500, 0.37);
        for (const double l : {0.05, 0.3, 2., 50.})
          for (const double average : cloud.averages(l, weight))
            EXPECT_NEAR(average, 0.37, 1e-6);
      }
  }


  TEST(Mechanics, a_lone_point_is_its_own_surroundings)
  {
    for (const auto weight : all_choices<NeighbourWeight>())
      {
        Cloud<3> cloud;
        cloud.add(Point<3>(0., 0., 0.), 0.1, 0.02);
        cloud.add(Point<3>(5., 0., 0.), 0.1, 0.);
        cloud.add(Point<3>(5.1, 0., 0.), 0.1, 0.);
        const auto averages = cloud.averages(0.5, weight);
        EXPECT_NEAR(averages[0], 0.02, 1e-8);
        EXPECT_EQ(averages[1], 0.);
      }
  }


  TEST(Mechanics, averages_of_waves_have_their_closed_form)
  {
    // In the plane <1 + cos(kx)> = 1 + f(k l) cos(kx): with a Gaussian weight
    // f = exp(-k^2 l^2/4); with r exp(-r^2/l^2) it is Kummer's function
    // 1F1(3/2, 1, -k^2 l^2/4). What lies beyond 2.5 l is missing, of its
    // integral 0.2 % and 0.7 %.
    const double l = 0.5, spacing = 0.1, k = 2.5;
    Cloud<2>     cloud;
    for (unsigned int i = 0; i < 50; ++i)
      for (unsigned int j = 0; j < 40; ++j)
        {
          const Point<2> x((i + 0.5) * spacing, (j + 0.5) * spacing);
          cloud.add(x, spacing * spacing, 1. + std::cos(k * x[0]));
        }
    for (const auto weight : all_choices<NeighbourWeight>())
      {
        const double z = -0.25 * k * k * l * l;
        double       f = 0., term = 1.;
        for (unsigned int m = 0; m < 40; ++m)
          {
            f += term;
            term *= (1.5 + m) / (1. + m) * z / (m + 1.);
          }
        if (weight == NeighbourWeight::gaussian)
          f = std::exp(z);
        const auto   averages = cloud.averages(l, weight);
        unsigned int n_inside = 0;
        for (unsigned int p = 0; p < cloud.positions.size(); ++p)
          if (const Point<2> &x = cloud.positions[p];
              x[0] > 1.3 && x[0] < 3.7 && x[1] > 1.3 && x[1] < 2.7)
            {
              EXPECT_NEAR(averages[p] - 1., f * std::cos(k * x[0]), 0.012);
              ++n_inside;
            }
        EXPECT_GT(n_inside, 200u);
        EXPECT_LT(f, 0.7); // it does smooth
      }
  }
} // namespace mechanics_nonlocal_average
