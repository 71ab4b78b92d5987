// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include "soil_profiles.h"
#include <gtest/gtest.h>

namespace particles_soil_profile_input
{
  using namespace Waker;
  using namespace SoilProfiles;

  TEST(Particles, bad_profiles_are_named)
  {
    const auto        grid    = dyke_grid();
    const std::string polygon = "Soil profile/layer/Polygon";
    for (const char *text : {"",
                             "0,0; 1,0",
                             "0,0; 1,0; 0,0",
                             "0,0; 1,0; 1",
                             "0,0; 1,0; 1,a",
                             "0,0; 1,0; 1,1,1",
                             "0,0; 1,0; ; 1,1",
                             "0,0; 1,0; 1,nan",
                             "0,0; 1,0; 1,1e999",
                             "0,0; 1,1; 2,2",           // no area
                             "0,0; 1,1; 1,0; 0,1",      // figure of eight
                             "0,0; 3,0; 3,1; 2,0; 1,1", // touches itself
                             "0,0; 3,0; 1,0; 1,1",      // folds back
                             "0,0; 1,0; 1,6.5",         // above the grid
                             "-6.1,0; 1,0; 1,1",        // in the margin
                             "0,0; 4,0; 4,-0.1"})
      {
        EXPECT_EQ(where_it_fails(grid, {layer(text)}), polygon) << text;
      }
    EXPECT_EQ(where_it_fails(grid, {layer("0,0; +1,0.; 1e0, 1 ;0,0;")}), "");
    EXPECT_EQ(where_it_fails(grid, {}), "Soil profile");
    EXPECT_EQ(where_it_fails(grid, {layer(dyke), layer("4,1; 5,1; 5,2")}),
              polygon);
    EXPECT_EQ(where_it_fails(grid, {layer(dyke), layer("30,0; 31,0; 31,1")}),
              "");

    LayerParameters l = layer(dyke, "peat");
    EXPECT_EQ(where_it_fails(grid, {l}), "Soil profile/layer/Material");
    try
      {
        make(grid, {l});
        FAIL();
      }
    catch (const UserError &e)
      {
        EXPECT_EQ(e.allowed, "clay, sand");
        EXPECT_NE(e.problem.find("peat"), std::string::npos);
      }
    l = layer(dyke);
    for (const char *velocity : {"1",
                                 "1; 2; 3",
                                 "1, 2, 3",
                                 "1;",
                                 "; 1",
                                 "x, atan2(x, y)", // commas: plain numbers only
                                 "1; two",
                                 "1; x*t",
                                 "1; 0/(x*0)"})
      {
        l.velocity = velocity;
        EXPECT_EQ(where_it_fails(grid, {l}), "Soil profile/layer/Velocity")
          << velocity;
      }
    l        = layer(dyke);
    l.extent = {0., 1.};
    EXPECT_EQ(where_it_fails(grid, {l}), "Soil profile/layer/Extent");

    const BackgroundGrid<3> block(Point<3>(0., 0., 0.),
                                  Point<3>(2., 2., 2.),
                                  1.,
                                  MPI_COMM_SELF);
    l = layer("0,0; 1,0; 1,1");
    for (const std::vector<double> &extent : {std::vector<double>{1.},
                                              {0., 1., 2.},
                                              {1., 1.},
                                              {1., 0.},
                                              {0., 2.1},
                                              {-1., 1.}})
      {
        l.extent = extent;
        EXPECT_EQ(where_it_fails(block, {l}), "Soil profile/layer/Extent");
      }
  }


  TEST(Particles, profile_parameters_are_read)
  {
    dealii::ParameterHandler prm;
    LayerParameters          l;
    MaterialPointParameters  m;
    l.add_parameters(prm);
    m.add_parameters(prm);
    prm.parse_input_from_string("set Material = clay\n"
                                "set Polygon = 0,0; 1,0; 1,1\n"
                                "set Velocity = 0.1*x; atan2(y, 2)\n"
                                "set Points per direction = 3\n"
                                "set Minimum cut = 0.1\n");
    EXPECT_EQ(l.material, "clay");
    EXPECT_EQ(l.corners().size(), 3u);
    EXPECT_TRUE(l.extent.empty());
    EXPECT_EQ(l.velocity_components(2),
              (std::vector<std::string>{"0.1*x", "atan2(y, 2)"}));
    EXPECT_EQ(m.points_per_direction, 3u);
    EXPECT_EQ(m.minimum_cut, 0.1);
  }
} // namespace particles_soil_profile_input
