// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/particles/height_map.h>

#include "output_temporary_folder.h"
#include "user_errors.h"
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace particles_height_map
{
  // Height maps: files, and what is no height over each place.

  using namespace Waker;

  namespace
  {
    using dealii::Point;

    /// Heights at 3 x 3 places of [0, 2] x [0, 4]; `skip`: one without its
    /// line.
    std::string
    table(const int skip = -1, const std::string &titles = "x, z, y")
    {
      std::ostringstream text;
      text << "# a hill\n" << titles << "\n";
      for (int n = 0; n < 9; ++n)
        if (n != skip)
          text << n % 3 << ", " << 2 * (n / 3) << ", " << (n == 4 ? 2 : 1)
               << "\n";
      return text.str();
    }


    std::shared_ptr<const HeightMap>
    read(const std::string           &text,
         const std::string           &name  = "map.csv",
         const std::array<double, 2> &upper = {{2., 4.}})
    {
      TemporaryFolder   folder;
      const std::string path = folder.path + "/" + name;
      std::ofstream(path) << text;
      return read_height_map(path, {{0., 0.}}, upper, 1e-6, "Soil/Top");
    }


    std::string
    stl(const std::vector<StlTriangle> &triangles)
    {
      std::ostringstream text;
      text.precision(17);
      text << "solid\n";
      for (const StlTriangle &triangle : triangles)
        {
          text << "facet normal 0 1 0\nouter loop\n";
          for (const Point<3> &x : triangle)
            text << "vertex " << x << "\n";
          text << "endloop\nendfacet\n";
        }
      text << "endsolid\n";
      return text.str();
    }


    /// Two triangles over [0, 2] x [0, 4], one of each orientation: y = 1 + x.
    std::vector<StlTriangle>
    slope()
    {
      const Point<3> a(0, 1, 0), b(2, 3, 0), c(2, 3, 4), d(0, 1, 4);
      return {{{a, b, c}}, {{a, d, c}}};
    }
  } // namespace


  TEST(HeightMap, ATableHasItsHeights)
  {
    const auto map = read(table());
    EXPECT_DOUBLE_EQ(*map->at(1., 2.), 2.);
    EXPECT_DOUBLE_EQ(*map->at(0., 4.), 1.);
    // In the middle of four places: their mean.
    EXPECT_DOUBLE_EQ(*map->at(0.5, 1.), 1.25);
    EXPECT_DOUBLE_EQ(*map->at(0.25, 0.), 1.);
    EXPECT_FALSE(map->at(2.1, 0.).has_value());
    EXPECT_DOUBLE_EQ(map->range()[0], 1.);
    EXPECT_DOUBLE_EQ(map->range()[1], 2.);
    // Columns in another order, lines with units, blanks between.
    std::string turned = "y (m), x (m), z (m)\n";
    for (int n = 8; n >= 0; --n)
      turned += std::to_string(n == 4 ? 2 : 1) + "," + std::to_string(n % 3) +
                "," + std::to_string(2 * (n / 3)) + "\n\n";
    EXPECT_DOUBLE_EQ(*read(turned)->at(0.5, 1.), 1.25);
    EXPECT_DOUBLE_EQ(*read(turned)->at(0.9, 1.9), *map->at(0.9, 1.9));
  }


  TEST(HeightMap, AnStlSurfaceHasItsHeights)
  {
    const auto map = read(stl(slope()), "map.STL");
    for (const double x : {0., 0.3, 2.})
      for (const double z : {0., 1.7, 4.})
        EXPECT_NEAR(*map->at(x, z), 1. + x, 1e-15);
    const HeightMap scaled = map->scaled({{1., 2., 0.5}}, 4.);
    EXPECT_NEAR(*scaled.at(2., 6.), 4. * (1. + 1.5 - 2.), 1e-14);
  }


  TEST(HeightMap, HolesOverhangsAndOtherMistakesAreRefused)
  {
    EXPECT_NO_THROW(read(table()));
    const auto refuses = [](const std::string &text,
                            const std::string &what,
                            const std::string &name = "map.csv") {
      EXPECT_USER_ERROR(read(text, name), "Soil/Top", what);
    };
    refuses(table(5), "hole: no height at (x, z) = (2, 2)");
    refuses(table(8), "hole: no height at (x, z) = (2, 4)");
    refuses(table() + "1, 2, 3\n", "two heights at (x, z) = (1, 2)");
    refuses(table(-1, "a, b, c"), "begins with \"a, b, c\"");
    refuses("0, 0, 1\n1, 0, 1\n", "begins with \"0, 0, 1\"");
    refuses(table() + "1; 2; 3\n", "in line 12");
    refuses(table() + "1, 2, nan\n", "in line 12");
    refuses("x, z, y\n", "no places");
    refuses("x, z, y\n0, 0, 1\n1, 0, 1\n", "only one z");
    refuses("", "holds nothing");
    EXPECT_USER_ERROR(
      read_height_map("", {{0., 0.}}, {{1., 1.}}, 0., "Soil/Top"),
      "Soil/Top",
      "is empty");
    EXPECT_USER_ERROR(
      read_height_map("none.csv", {{0., 0.}}, {{1., 1.}}, 0., "Soil/Top"),
      "Soil/Top",
      "\"none.csv\"");
    // Smaller than the layer.
    EXPECT_NO_THROW(read(table(), "map.csv", {{1.7, 3.}}));
    EXPECT_USER_ERROR(read(table(), "map.csv", {{2.5, 4.}}),
                      "Soil/Top",
                      "ends at (x, z) = (2, 1)");
    EXPECT_USER_ERROR(read(table(), "map.csv", {{2., 4.001}}),
                      "Soil/Top",
                      "inside the layer");
    refuses(table(), "no STL", "map.stl");

    const auto refuses_stl = [&](const std::vector<StlTriangle> &triangles,
                                 const std::string              &what) {
      refuses(stl(triangles), what, "map.stl");
    };
    auto triangles = slope();
    EXPECT_NO_THROW(read(stl(triangles), "map.stl"));
    triangles.pop_back();
    refuses_stl(triangles, "ends at (x, z) = (1, 2)"); // along the diagonal
    // An upright wall.
    triangles = slope();
    const Point<3> b(2, 3, 0), c(2, 3, 4), above(2, 5, 4);
    triangles.push_back({{b, c, above}});
    EXPECT_NO_THROW(read(stl(triangles), "map.stl")); // at the layer's edge
    const Point<3> up(0, 7, 0), d(0, 1, 4), a(0, 1, 0);
    triangles.push_back({{a, c, Point<3>(1, 9, 2)}});
    refuses_stl(triangles, "stands upright");
    // A fold: an edge with both of its triangles on one side.
    triangles = slope();
    triangles.push_back({{a, Point<3>(2, 3, 4), Point<3>(0.5, 5, 3)}});
    refuses_stl(triangles, "folds back");
    // Two sheets, one over the other.
    triangles = slope();
    for (const StlTriangle &triangle : slope())
      {
        triangles.push_back(triangle);
        for (Point<3> &x : triangles.back())
          x[1] += 1.;
      }
    refuses_stl(triangles, "covers 16 m^2");
    // Elsewhere.
    triangles = slope();
    for (StlTriangle &triangle : triangles)
      for (Point<3> &x : triangle)
        x[0] += 5.;
    refuses_stl(triangles, "does not reach");
  }


  // Vertices that single precision keeps off the edges of the layer.
  TEST(HeightMap, RoundOffAtTheEdgesCountsForNothing)
  {
    auto triangles = slope();
    for (StlTriangle &triangle : triangles)
      for (Point<3> &x : triangle)
        {
          x[0] -= x[0] > 1. ? 1e-7 : -1e-7;
          x[2] -= x[2] > 1. ? 1e-7 : 0.;
        }
    EXPECT_NEAR(*read(stl(triangles), "map.stl")->at(2., 4.), 3., 1e-6);
  }
} // namespace particles_height_map
