// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <waker/particles/soil_depths.h>

#include <cmath>
#include <gtest/gtest.h>

namespace particles_soil_depths
{
  namespace
  {
    using namespace Waker;

    LayerParameters
    layer(const std::string &polygon, const std::vector<double> &extent = {})
    {
      LayerParameters l;
      l.name    = "layer";
      l.polygon = polygon;
      l.extent  = extent;
      return l;
    }


    template <int dim>
    SoilDepths<dim>
    depths(const std::vector<LayerParameters> &layers)
    {
      Point<dim> lower, upper;
      for (unsigned int d = 0; d < dim; ++d)
        upper[d] = 10.;
      return SoilDepths<dim>(
        BackgroundGrid<dim>(lower, upper, 0.5, MPI_COMM_SELF), layers);
    }


    void
    expect(const Depths &depths, const double surface, const double in_layer)
    {
      EXPECT_NEAR(depths.below_surface, surface, 1e-12);
      EXPECT_NEAR(depths.in_layer, in_layer, 1e-12);
    }


    TEST(SoilDepths, a_slope_and_a_layer_under_it)
    {
      // Foundation 0 to 2 m; a dyke on it, slope 1:2 from (2, 2) to (6, 4).
      const auto d = depths<2>(
        {layer("0,0; 10,0; 10,2; 0,2"), layer("2,2; 10,2; 10,4; 6,4")});
      expect(d.at({1., 0.5}, 0), 1.5, 1.5);
      expect(d.at({4., 0.5}, 0), 2.5, 1.5);
      expect(d.at({4., 2.25}, 1), 0.75, 0.75);
      expect(d.at({8., 3.}, 1), 1., 1.);
      // At corners and on edges.
      expect(d.at({6., 4.}, 1), 0., 0.);
      expect(d.at({10., 2.}, 1), 2., 2.);
      expect(d.at({10., 2.}, 0), 2., 0.);
      expect(d.at({0., 0.}, 0), 2., 2.);
      EXPECT_TRUE(d.holds({4., 2.25}, 1));
      EXPECT_TRUE(d.holds({10., 3.}, 1));
      EXPECT_FALSE(d.holds({4., 2.25}, 0));
      EXPECT_FALSE(d.holds({3., 3.}, 1));
    }


    TEST(SoilDepths, an_overhang_has_a_top_for_each_of_its_limbs)
    {
      // A C: limbs from y = 0 to 1 and from 3 to 5, joined on the left; in its
      // mouth a second layer, 1 to 2 m.
      const auto d = depths<2>({layer("0,0; 8,0; 8,1; 2,1; 2,3; 8,3; 8,5; 0,5"),
                                layer("2,1; 8,1; 8,2; 2,2")});
      expect(d.at({5., 0.25}, 0), 4.75, 0.75);
      expect(d.at({5., 3.5}, 0), 1.5, 1.5);
      expect(d.at({1., 0.25}, 0), 4.75, 4.75);
      expect(d.at({5., 1.5}, 1), 3.5, 0.5);
      EXPECT_FALSE(d.holds({5., 2.5}, 0));
      EXPECT_FALSE(d.holds({5., 2.5}, 1));
    }


    TEST(SoilDepths, a_place_outside_its_layer_is_not_deep_in_it)
    {
      const auto d = depths<2>({layer("0,0; 4,0; 4,2; 0,2")});
      expect(d.at({2., 2.1}, 0), 0., 0.);
      expect(d.at({5., 1.}, 0), 0., 0.);
      const Depths none = d.at({2., 1.}, 1); // no such layer
      EXPECT_TRUE(std::isnan(none.below_surface));
      EXPECT_TRUE(std::isnan(none.in_layer));
    }


    TEST(SoilDepths, only_layers_whose_extent_reaches_there_cover_it)
    {
      const auto d = depths<3>({layer("0,0; 10,0; 10,2; 0,2"),
                                layer("0,2; 10,2; 10,5; 0,5", {4., 6.})});
      expect(d.at({3., 1., 2.}, 0), 1., 1.);
      expect(d.at({3., 1., 5.}, 0), 4., 1.);
      expect(d.at({3., 4., 5.}, 1), 1., 1.);
      EXPECT_TRUE(d.holds({3., 4., 5.}, 1));
      EXPECT_FALSE(d.holds({3., 4., 7.}, 1));
    }
  } // namespace
} // namespace particles_soil_depths
