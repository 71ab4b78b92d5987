// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/surface/marching_squares.h>

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace surface_marching_squares
{
  using namespace Waker;

  namespace
  {
    double
    total_area(const Surface &surface)
    {
      double area = 0.;
      for (const SurfaceChain &chain : surface.chains)
        area += chain.area();
      return area;
    }

    // Contour of values at the nodes of a lattice with unit cells.
    Surface
    contour(const std::vector<std::vector<double>> &rows,
            const unsigned int                      closed_faces = 0,
            const double                            threshold    = 0.5)
    {
      std::array<std::vector<double>, 2> x;
      std::vector<double>                values;
      for (unsigned int i = 0; i < rows[0].size(); ++i)
        x[0].push_back(i);
      for (unsigned int j = 0; j < rows.size(); ++j)
        {
          x[1].push_back(j);
          values.insert(values.end(), rows[j].begin(), rows[j].end());
        }
      MarchingSquares squares(x, closed_faces);
      Surface         surface;
      squares.trace(values.data(), rows[0].size(), threshold, surface);
      return surface;
    }
  } // namespace



  TEST(Surface, saddles_are_decided_by_their_mean)
  {
    const auto mirrored = [](std::vector<std::vector<double>> rows) {
      for (auto &row : rows)
        std::reverse(row.begin(), row.end());
      return rows;
    };
    // Two diagonal blobs: apart for the lower value, joined for the higher.
    for (const double value : {0.9, 1.1})
      {
        const std::vector<std::vector<double>> rows = {{0, 0, 0, 0},
                                                       {0, value, 0, 0},
                                                       {0, 0, value, 0},
                                                       {0, 0, 0, 0}};

        const Surface a = contour(rows);
        const Surface b = contour(mirrored(rows));
        EXPECT_EQ(a.chains.size(), value < 1 ? 2u : 1u);
        EXPECT_EQ(b.chains.size(), a.chains.size());
        EXPECT_DOUBLE_EQ(total_area(a), total_area(b));
        // A blob is a square with half diagonal d; the joined one has the
        // hexagon of the saddle too.
        const double d = (value - 0.5) / value;
        if (value < 1)
          {
            EXPECT_NEAR(total_area(a), 4 * d * d, 1e-14);
          }
        else
          {
            EXPECT_NEAR(total_area(a),
                        3 * d * d + 1 - (1 - d) * (1 - d),
                        1e-14);
          }
      }
  }



  TEST(Surface, nodes_at_the_threshold_make_no_empty_segments)
  {
    // Alone and in a row they have no area; three of a cell are a triangle.
    EXPECT_TRUE(contour({{0, 0, 0}, {0, 0.5, 0}, {0, 0, 0}}).chains.empty());
    EXPECT_TRUE(contour({{0.5, 0.5, 0.5}, {0, 0, 0}}).chains.empty());
    EXPECT_DOUBLE_EQ(total_area(contour({{0.5, 0.5}, {0.5, 0}})), 0.5);

    // A square of them is inside, with its edges; along closed faces too.
    for (const unsigned int closed : {0u, 15u})
      {
        const Surface surface = contour({{0.5, 0.5}, {0.5, 0.5}}, closed);
        ASSERT_EQ(surface.chains.size(), 1u);
        EXPECT_EQ(surface.chains[0].vertices.size(), 4u);
        EXPECT_DOUBLE_EQ(surface.chains[0].area(), 1.);
        for (const int face : surface.chains[0].on_face)
          EXPECT_EQ(face >= 0, closed > 0);
      }

    // Closed on the left only: cut there, open elsewhere (half a cell beyond).
    const Surface surface = contour({{1, 1}, {1, 1}}, 1u);
    ASSERT_EQ(surface.chains.size(), 1u);
    EXPECT_DOUBLE_EQ(surface.chains[0].area(), 1.5 * 2 - 2 * 0.125);
    double length = 0.;
    for (std::size_t k = 0; k < surface.chains[0].vertices.size(); ++k)
      if (surface.chains[0].on_face[k] == 0)
        length += surface.chains[0].vertices[k].distance(
          surface.chains[0].vertices[(k + 1) % 6]);
    EXPECT_EQ(surface.chains[0].vertices.size(), 6u);
    EXPECT_DOUBLE_EQ(length, 2.);
  }
} // namespace surface_marching_squares
