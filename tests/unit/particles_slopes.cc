// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/particles/layer.h>
#include <waker/particles/soil_depths.h>
#include <waker/particles/soil_profile.h>

#include "output_temporary_folder.h"
#include "user_errors.h"
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <numeric>

namespace particles_slopes
{
  // Slopes in 3D: the slope of chapter 6, cut or in stairs, drawn as a prism or
  // as a height map; layers below and above a height map.

  using namespace Waker;

  namespace
  {
    LayerParameters
    layer(const std::string &name, const std::string &polygon)
    {
      LayerParameters result;
      result.name     = name;
      result.material = "clay";
      result.polygon  = polygon;
      return result;
    }


    BackgroundGrid<3>
    chapter_6_grid(const double h)
    {
      return BackgroundGrid<3>(Point<3>(0., 0., 0.),
                               Point<3>(6., 1.5, 8.),
                               h,
                               MPI_COMM_SELF);
    }


    MaterialPoints<3>
    make(const BackgroundGrid<3>            &grid,
         const std::vector<LayerParameters> &layers,
         const Placement                     placement = Placement::sub_cells,
         std::vector<unsigned int>          *layers_of_points = nullptr)
    {
      MaterialPointParameters parameters;
      parameters.placement = placement;
      return make_material_points(
        grid, layers, parameters, {"clay"}, {2.}, layers_of_points);
    }


    double
    volume(const MaterialPoints<3> &points)
    {
      return std::accumulate(points.volume.begin(), points.volume.end(), 0.);
    }


    Tensor<1, 3>
    first_moment(const MaterialPoints<3> &points)
    {
      Tensor<1, 3> sum;
      for (std::size_t p = 0; p < points.n_points(); ++p)
        sum += points.volume[p] * (points.position[p] - Point<3>());
      return sum;
    }


    const LayerParameters slope = layer("slope", "0, 0; 3.5, 0; 2.5, 1; 0, 1");


    /// A table of heights over [0, 6] x [0, 8], a place each half metre.
    template <typename Function>
    std::string
    write_map(const TemporaryFolder &folder, const Function &height)
    {
      const std::string path = folder.file("map.csv");
      std::ofstream     file(path);
      file.precision(17);
      file << "x, z, y\n";
      for (int i = 0; i <= 12; ++i)
        for (int k = 0; k <= 16; ++k)
          file << i / 2. << ", " << k / 2. << ", " << height(i / 2., k / 2.)
               << "\n";
      return path;
    }
  } // namespace


  // Section 6.2: of the 8 points of each cell on the slope 6 are left.
  TEST(Slopes, chapter_6_has_its_points)
  {
    const auto grid   = chapter_6_grid(0.125);
    const auto points = make(grid, {slope}, Placement::whole_sub_cells);
    EXPECT_EQ(points.n_points(), 99328u);
    EXPECT_NEAR(volume(points), 24.25, 1e-11);
    // Points per cell: 160 full cells under the crest, 28 under the slope, 8
    // cells of 6 on it, in each of 64 slices.
    std::map<unsigned int, unsigned int> points_in;
    for (const Point<3> &x : points.position)
      ++points_in[grid.node(grid.cell_index(x))];
    std::map<unsigned int, unsigned int> cells_with;
    for (const auto &cell : points_in)
      ++cells_with[cell.second];
    EXPECT_EQ(cells_with,
              (std::map<unsigned int, unsigned int>{{8, 188 * 64},
                                                    {6, 8 * 64}}));
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        ASSERT_DOUBLE_EQ(points.volume[p], std::pow(0.0625, 3));
        // The surface cuts domains in the middle.
        ASSERT_LE(points.position[p][0] + points.position[p][1], 3.5 + 1e-12);
      }
  }


  // The same cut: as many points, all of the volume and its first moment.
  TEST(Slopes, cut_cells_keep_volume_and_first_moment)
  {
    const auto points = make(chapter_6_grid(0.125), {slope});
    EXPECT_EQ(points.n_points(), 99328u);
    EXPECT_NEAR(volume(points), 24., 1e-11);
    // 2.5 x 1 with its centre at 1.25, and a triangle of 0.5 with its
    // at 2.8333.
    const auto moment = first_moment(points);
    EXPECT_NEAR(moment[0], 8. * (2.5 * 1.25 + 0.5 * (2.5 + 1. / 3.)), 1e-10);
    EXPECT_NEAR(moment[1], 8. * (2.5 * 0.5 + 0.5 / 3.), 1e-10);
    EXPECT_NEAR(moment[2], 24. * 4., 1e-10);
  }


  // As a height map over a block it is the same soil.
  TEST(Slopes, a_height_map_makes_the_same_points)
  {
    TemporaryFolder folder;
    LayerParameters block = layer("block", "0, 0; 6, 0; 6, 1.5; 0, 1.5");
    block.top             = write_map(folder, [](const double x, double) {
      return std::min(1., 3.5 - x);
    });
    const auto grid       = chapter_6_grid(0.25);
    for (const Placement placement :
         {Placement::sub_cells, Placement::whole_sub_cells})
      {
        const auto expected = make(grid, {slope}, placement);
        const auto points   = make(grid, {block}, placement);
        ASSERT_EQ(points.n_points(), expected.n_points());
        for (std::size_t p = 0; p < points.n_points(); ++p)
          {
            ASSERT_NEAR(points.volume[p], expected.volume[p], 1e-15);
            ASSERT_LT((points.position[p] - expected.position[p]).norm(),
                      1e-12);
          }
      }
    EXPECT_NEAR(profile_volume(grid, {block}), 24., 1e-11);

    // Depths are below the map.
    const SoilDepths<3> depths(grid, {block});
    EXPECT_NEAR(depths.at(Point<3>(3., 0.2, 4.), 0).below_surface, 0.3, 1e-12);
    EXPECT_NEAR(depths.at(Point<3>(1., 0.2, 8.), 0).in_layer, 0.8, 1e-12);
    EXPECT_FALSE(depths.holds(Point<3>(3., 0.6, 4.), 0));
    EXPECT_TRUE(depths.holds(Point<3>(3., 0.5, 0.), 0));
    EXPECT_FALSE(depths.holds(Point<3>(4., 0.2, 4.), 0));
  }


  // As high as its lowest section.
  TEST(Slopes, the_drawn_crest_is_that_of_the_lowest_section)
  {
    TemporaryFolder folder;
    LayerParameters block = layer("block", "0, 0; 6, 0; 6, 1.5; 0, 1.5");
    const auto      crest = [](const std::vector<LayerParameters> &layers) {
      return drawn_crest(layers, 3, 0., 8., 0.25);
    };
    EXPECT_EQ(crest({block}), 1.5);
    EXPECT_EQ(crest({slope}), 1.);
    block.top = write_map(folder, [](const double x, const double z) {
      return std::min(1., 3.5 - x) - 0.4 * std::max(0., 1. - std::abs(z - 4.));
    });
    EXPECT_NEAR(crest({block}), 0.6, 1e-12);
    EXPECT_NEAR(level_range(block, 0., 8.)[1], 1., 1e-12);
    // Another layer fills the dip, but for its ends.
    LayerParameters fill = layer("fill", "0, 0; 6, 0; 6, 1.5; 0, 1.5");
    fill.extent          = {3.25, 4.75};
    EXPECT_NEAR(crest({block, fill}), 1. - 0.4 * 0.125, 1e-12);
    // A roof that falls, cut off by a map that rises: they meet at x = 3.
    LayerParameters wedge = layer("wedge", "0, 0; 6, 0; 0, 6");
    wedge.top =
      write_map(folder, [](const double x, double) { return x + 0.1; });
    EXPECT_NEAR(crest({wedge}), 3.05, 1e-12);
  }


  // A hill on a hollow: small parts are given away, nothing is lost; the
  // layers touch, and together they are the block.
  TEST(Slopes, layers_that_share_a_map_fill_the_block)
  {
    TemporaryFolder folder;
    LayerParameters lower = layer("lower", "0, 0; 6, 0; 6, 1; 0, 1");
    LayerParameters upper = lower;
    upper.name            = "upper";
    lower.top             = upper.bottom =
      write_map(folder, [](const double x, const double z) {
        return 0.5 + 0.3 * std::sin(1.7 * x) * std::cos(1.1 * z);
      });
    const auto                grid = chapter_6_grid(0.25);
    std::vector<unsigned int> layers;
    const auto                points =
      make(grid, {lower, upper}, Placement::sub_cells, &layers);
    EXPECT_NEAR(volume(points), 48., 1e-10);
    const auto         moment = first_moment(points);
    const Tensor<1, 3> block({48. * 3., 48. * 0.5, 48. * 4.});
    EXPECT_LT((moment - block).norm(), 1e-9);
    double of_lower = 0.;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      of_lower += layers[p] == 0 ? points.volume[p] : 0.;
    EXPECT_NEAR(of_lower, profile_volume(grid, {lower}), 1e-10);
    EXPECT_GT(of_lower, 20.);
    double least = 1.;
    for (const double v : points.volume)
      least = std::min(least, v / std::pow(0.125, 3));
    EXPECT_GE(least, 0.25 - 1e-12);

    // Stairs: each sub-cell once, of the layer that has most of it.
    const auto stairs =
      make(grid, {lower, upper}, Placement::whole_sub_cells, &layers);
    EXPECT_EQ(stairs.n_points(), 48u * 8u * 64u);
    unsigned int n_lower = 0;
    for (const unsigned int l : layers)
      n_lower += l == 0;
    EXPECT_NEAR(n_lower * std::pow(0.125, 3), of_lower, 0.2);
  }


  TEST(Slopes, what_cannot_be_is_refused)
  {
    TemporaryFolder folder;
    const auto      grid  = chapter_6_grid(0.25);
    LayerParameters lower = layer("lower", "0, 0; 6, 0; 6, 1; 0, 1");
    LayerParameters upper = layer("upper", "0, 0; 6, 0; 6, 1.5; 0, 1.5");
    lower.top = write_map(folder, [](double, double) { return 0.5; });
    EXPECT_NO_THROW(make(grid, {lower}));
    upper.bottom = lower.top;
    EXPECT_NO_THROW(make(grid, {lower, upper}));
    EXPECT_USER_ERROR(make(grid, {lower}, Placement::rows),
                      "Material points/Placement",
                      "is rows, but Soil profile/lower");

    TemporaryFolder other;
    upper.bottom = write_map(other, [](double, double) { return 0.4; });
    EXPECT_USER_ERROR(make(grid, {lower, upper}),
                      "Soil profile/upper/Bottom",
                      "overlaps \"Soil profile/lower\" over 4.8 m^3");
    lower.top = write_map(folder, [](double, double) { return -0.1; });
    EXPECT_USER_ERROR(make(grid, {lower}),
                      "Soil profile/lower/Top",
                      "leaves nothing");

    // Stairs that are not the soil that was drawn: 0.06 m in cells of 0.125 m.
    EXPECT_USER_ERROR(make(grid,
                           {layer("film", "0, 0; 6, 0; 6, 0.05; 0, 0.05")},
                           Placement::whole_sub_cells),
                      "Soil profile/film/Polygon",
                      "too thin");
    EXPECT_USER_ERROR(make(grid,
                           {layer("film", "0, 0; 6, 0; 6, 0.09; 0, 0.09")},
                           Placement::whole_sub_cells),
                      "Material points/Placement",
                      "have 6 m^3, the soil profile 4.32");
    EXPECT_NO_THROW(
      make(grid, {layer("film", "0, 0; 6, 0; 6, 0.09; 0, 0.09")}));

    const BackgroundGrid<2> plane(Point<2>(0., 0.),
                                  Point<2>(6., 1.5),
                                  0.25,
                                  MPI_COMM_SELF);
    lower.top = upper.bottom;
    EXPECT_USER_ERROR(make_material_points(plane,
                                           {lower},
                                           MaterialPointParameters(),
                                           {"clay"},
                                           {2.}),
                      "Soil profile/lower/Top",
                      "the case is 2D");
  }
} // namespace particles_slopes
