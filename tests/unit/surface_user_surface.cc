// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/nodes/nodal_state.h>
#include <waker/surface/user_surface.h>

#include "output_temporary_folder.h"
#include "user_errors.h"
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <random>
#include <sstream>

namespace surface_user_surface
{
  using namespace Waker;

  namespace
  {
    template <int dim>
    BackgroundGrid<dim>
    grid(const double h = 0.5)
    {
      Point<dim> upper;
      for (unsigned int d = 0; d < dim; ++d)
        upper[d] = 6.;
      return BackgroundGrid<dim>(Point<dim>(), upper, h, MPI_COMM_SELF);
    }


    const char *const square = "1 1\n4 1\n4 4\n1 4\n1 1\n";


    template <int dim>
    UserSurface<dim>
    read(const std::string &text)
    {
      const TemporaryFolder folder;
      const std::string     file = folder.file("surface");
      std::ofstream(file, std::ios::binary) << text;
      return read_user_surface<dim>(file,
                                    "Tractions/a/Surface file",
                                    grid<dim>());
    }


    template <int dim>
    std::string
    complaint(const std::string &text)
    {
      try
        {
          read<dim>(text);
        }
      catch (const UserError &error)
        {
          EXPECT_EQ(error.where, "Tractions/a/Surface file");
          return error.problem;
        }
      return "";
    }


    template <int dim>
    bool
    refuses(const std::string &text, const std::string &reason)
    {
      const std::string what = complaint<dim>(text);
      EXPECT_NE(what.find(reason), std::string::npos) << what;
      return !what.empty();
    }


    /// The faces of a box, outside out, as text.
    std::vector<std::array<Point<3>, 3>>
    box(const Point<3> &lower, const Point<3> &upper)
    {
      std::vector<std::array<Point<3>, 3>> triangles;
      for (unsigned int d = 0; d < 3; ++d)
        for (unsigned int side = 0; side < 2; ++side)
          {
            const unsigned int      s = (d + 1) % 3, t = (d + 2) % 3;
            std::array<Point<3>, 4> x;
            for (unsigned int k = 0; k < 4; ++k)
              {
                x[k][d] = side == 0 ? lower[d] : upper[d];
                x[k][s] = k == 0 || k == 3 ? lower[s] : upper[s];
                x[k][t] = k < 2 ? lower[t] : upper[t];
              }
            if (side == 0)
              std::swap(x[1], x[3]);
            triangles.push_back({{x[0], x[1], x[2]}});
            triangles.push_back({{x[0], x[2], x[3]}});
          }
      return triangles;
    }


    std::string
    stl(const std::vector<std::array<Point<3>, 3>> &triangles)
    {
      std::ostringstream text;
      text << "solid box\n";
      for (const auto &triangle : triangles)
        {
          text << " facet normal 0 0 0\n  outer loop\n";
          for (const Point<3> &x : triangle)
            text << "   vertex " << x << "\n";
          text << "  endloop\n endfacet\n";
        }
      text << "endsolid box\n";
      return text.str();
    }


    std::string
    binary_stl(const std::vector<std::array<Point<3>, 3>> &triangles)
    {
      std::string         text(80, ' ');
      const std::uint32_t n = triangles.size();
      text.append(reinterpret_cast<const char *>(&n), 4);
      for (const auto &triangle : triangles)
        {
          float numbers[12] = {0};
          for (unsigned int k = 0; k < 9; ++k)
            numbers[3 + k] = triangle[k / 3][k % 3];
          text.append(reinterpret_cast<const char *>(numbers), 48);
          text.append(2, '\0');
        }
      return text;
    }


    template <int dim>
    double
    volume(const UserSurface<dim>        &surface,
           const std::vector<Point<dim>> &vertices)
    {
      Facets<dim> facets;
      surface.to_facets(vertices, facets);
      return enclosed_volume<dim>(facets);
    }


    /// Carry a surface through a linear motion of the nodes in many steps, and
    /// compare with the motion itself.
    template <int dim>
    void
    carry(const std::function<Tensor<1, dim>(const Point<dim> &)> &increment,
          const unsigned int                                       n_steps,
          std::vector<Point<dim>>                                 &vertices)
    {
      const BackgroundGrid<dim> g = grid<dim>();
      NodalState                nodes(g);
      nodes.mass.assign(g.n_nodes(), 1.);
      for (unsigned int i = 0; i < g.n_nodes(); ++i)
        {
          const Tensor<1, dim> u = increment(g.node_position(i));
          for (unsigned int d = 0; d < dim; ++d)
            nodes.increment.begin()[dim * i + d] = u[d];
        }
      for (unsigned int step = 0; step < n_steps; ++step)
        carry_vertices(g, nodes.mass, 0., nodes.increment, vertices);
    }
  } // namespace


  TEST(Surface, user_surface_is_read_in_two_dimensions)
  {
    const UserSurface<2> plain = read<2>(square);
    ASSERT_EQ(plain.vertices.size(), 4u);
    ASSERT_EQ(plain.elements.size(), 4u);
    EXPECT_EQ(plain.elements[3][1], 0u);
    EXPECT_NEAR(volume(plain, plain.vertices), 9., 1e-14);

    // With a hole, commas, comments, blanks and Windows' ends of lines.
    const UserSurface<2> holed =
      read<2>("# a body\r\n1, 1\r\n 4,1 # corner\r\n4 4\r\n# no end\r\n1\t4\r\n"
              "1 1\r\n\r\n\r\n2 2\r\n2 3\r\n3 3\r\n3 2\r\n2 2");
    EXPECT_EQ(holed.vertices.size(), 8u);
    EXPECT_NEAR(volume(holed, holed.vertices), 8., 1e-14);
  }


  TEST(Surface, user_surface_is_refused_in_two_dimensions)
  {
    EXPECT_EQ(complaint<2>(square), "");
    EXPECT_EQ(complaint<2>("\xEF\xBB\xBF" + std::string(square)), "");
    EXPECT_TRUE(refuses<2>("1,5 1\n4 1\n4 4\n1,5 1\n", "line 1"));
    EXPECT_TRUE(refuses<2>("1;1\n4;1\n4;4\n1;1\n", "line 1"));
    EXPECT_TRUE(refuses<2>("x y\n1 1\n4 1\n4 4\n1 1\n", "line 1"));
    EXPECT_TRUE(refuses<2>("1 1\n4 1\n4 4\n1 4\n", "open"));
    EXPECT_TRUE(refuses<2>("1 1\n4 1\n1 1\n", "2 different vertices"));
    EXPECT_TRUE(refuses<2>("", "holds nothing"));
    EXPECT_TRUE(refuses<2>("1 1\n4 1\n4\n1 1\n", "line 3"));
    EXPECT_TRUE(refuses<2>("1 1\n4 1 0\n4 4\n1 1\n", "line 2"));
    EXPECT_TRUE(refuses<2>("1 1\n4 one\n4 4\n1 1\n", "line 2"));
    EXPECT_TRUE(refuses<2>("1 1\n4 1\n4 1\n4 4\n1 1\n", "twice"));
    EXPECT_TRUE(refuses<2>("1 1\n1 4\n4 4\n4 1\n1 1\n", "wrong side"));
    EXPECT_TRUE(refuses<2>("1 1\n7 1\n4 4\n1 4\n1 1\n", "outside the grid"));
    // A bow, a spike, a vertex on another side, chains that cross or touch.
    EXPECT_TRUE(refuses<2>("1 1\n4 1\n1 4\n4 4\n1 1\n", "crosses"));
    EXPECT_TRUE(refuses<2>("1 1\n4 1\n5 1\n4 1\n4 4\n1 4\n1 1\n", "crosses"));
    EXPECT_TRUE(refuses<2>("1 1\n4 1\n4 4\n2 1\n1 4\n1 1\n", "crosses"));
    EXPECT_TRUE(refuses<2>(std::string(square) + "\n3 3\n5 3\n5 5\n3 5\n3 3\n",
                           "crosses"));
    EXPECT_TRUE(refuses<2>(std::string(square) + "\n4 2\n5 2\n5 3\n4 3\n4 2\n",
                           "crosses"));
    EXPECT_USER_ERROR(read_user_surface<2>("/no/such/file", "a", grid<2>()),
                      "a",
                      "\"/no/such/file\" cannot be read: No such file");
    EXPECT_USER_ERROR(read_user_surface<2>("/", "a", grid<2>()),
                      "a",
                      "\"/\" cannot be read");
  }


  TEST(Surface, user_surface_is_read_in_three_dimensions)
  {
    const auto           triangles = box(Point<3>(1, 1, 1), Point<3>(3, 4, 5));
    const UserSurface<3> text      = read<3>(stl(triangles));
    EXPECT_EQ(text.vertices.size(), 8u);
    EXPECT_EQ(text.elements.size(), 12u);
    EXPECT_NEAR(volume(text, text.vertices), 24., 1e-12);
    const UserSurface<3> binary = read<3>(binary_stl(triangles));
    EXPECT_EQ(binary.vertices.size(), 8u);
    EXPECT_NEAR(volume(binary, binary.vertices), 24., 1e-12);

    auto open = triangles;
    open.pop_back();
    // Damaged: another number of facets, or of bytes.
    const std::string whole = binary_stl(triangles);
    for (const unsigned char n_facets : {0, 1, 200})
      {
        std::string damaged = whole;
        damaged[80]         = static_cast<char>(n_facets);
        damaged[81] = damaged[82] = damaged[83] = 0;
        EXPECT_TRUE(
          refuses<3>(damaged,
                     "damaged: it announces " + std::to_string(n_facets) +
                       (n_facets == 1 ? " facet, " : " facets, ") +
                       "with which it would have " +
                       std::to_string(84 + 50 * n_facets) +
                       " bytes, but it has " + std::to_string(whole.size())));
      }
    EXPECT_TRUE(refuses<3>(whole + "x", "damaged"));
    EXPECT_TRUE(refuses<3>("solid" + whole.substr(5) + "x", "damaged"));
    EXPECT_TRUE(refuses<3>(whole.substr(0, whole.size() - 1), "damaged"));
    EXPECT_TRUE(refuses<3>(stl(open), "open"));
    EXPECT_TRUE(refuses<3>(binary_stl(open), "open"));
    auto turned = triangles;
    std::swap(turned[0][0], turned[0][1]);
    EXPECT_TRUE(refuses<3>(stl(turned), "open or wrongly oriented"));
    for (auto &triangle : turned = triangles)
      std::swap(triangle[0], triangle[1]);
    EXPECT_TRUE(refuses<3>(stl(turned), "wrong side"));
    EXPECT_TRUE(refuses<3>(stl(box(Point<3>(1, 1, 1), Point<3>(3, 4, 7))),
                           "outside the grid"));
    EXPECT_TRUE(refuses<3>("1 1\n4 1\n", "no STL"));
    EXPECT_TRUE(refuses<3>("solid a\n facet normal 0 0 1\n vertex 1 1 1\n"
                           " vertex 1 2 1\n endfacet\n",
                           "no triangle"));
  }


  TEST(Surface, carried_surface_follows_a_linear_motion)
  {
    // A rotation in small steps and a stretch: vertices see the same map again
    // and again, applied here to the corners directly.
    UserSurface<2>     surface = read<2>("2 2\n4 2\n4 4\n2 4\n2 2\n");
    const double       angle   = 0.01;
    const unsigned int n       = 50;
    const Point<2>     centre(3., 3.);
    const auto         turn = [&](const Point<2> &x) {
      const Tensor<1, 2> r = x - centre;
      Tensor<1, 2>       u;
      u[0] = (std::cos(angle) - 1.) * r[0] - std::sin(angle) * r[1];
      u[1] = std::sin(angle) * r[0] + (std::cos(angle) - 1.) * r[1];
      return u;
    };
    std::vector<Point<2>> x = surface.vertices;
    carry<2>(turn, n, x);
    EXPECT_NEAR(volume(surface, x), 4., 1e-12);
    for (unsigned int k = 0; k < 4; ++k)
      {
        const Tensor<1, 2> r = surface.vertices[k] - centre;
        EXPECT_NEAR(x[k][0],
                    centre[0] + std::cos(n * angle) * r[0] -
                      std::sin(n * angle) * r[1],
                    1e-12);
        EXPECT_NEAR(x[k][1],
                    centre[1] + std::sin(n * angle) * r[0] +
                      std::cos(n * angle) * r[1],
                    1e-12);
      }

    UserSurface<3> body =
      read<3>(stl(box(Point<3>(2, 2, 2), Point<3>(3, 3, 3))));
    std::vector<Point<3>> y = body.vertices;
    carry<3>(
      [](const Point<3> &p) {
        Tensor<1, 3> u;
        u[0] = 0.01 * p[0];
        u[1] = -0.02 * p[1] + 0.005 * p[2];
        return u;
      },
      10,
      y);
    EXPECT_NEAR(volume(body, y), std::pow(1.01 * 0.98, 10), 1e-12);
  }


  TEST(Surface, carried_vertex_without_material_around_follows_the_closest)
  {
    const BackgroundGrid<2> g = grid<2>();
    NodalState              nodes(g);
    // Nodes with mass for x <= 3 only. They move by 0.1 along x.
    for (unsigned int i = 0; i < g.n_nodes(); ++i)
      if (g.node_position(i)[0] < 3.01)
        {
          nodes.mass[i]                  = 1.;
          nodes.increment.begin()[2 * i] = 0.1;
        }
    std::vector<Point<2>> x = {{2.75, 2.}, {3.2, 2.}, {3.8, 2.1}, {5.9, 2.}};
    carry_vertices(g, nodes.mass, 0., nodes.increment, x);
    EXPECT_NEAR(x[0][0], 2.85, 1e-14);
    EXPECT_NEAR(x[1][0], 3.3, 1e-14);
    EXPECT_NEAR(x[2][0], 3.9, 1e-14);
    EXPECT_EQ(x[2][1], 2.1);
    EXPECT_EQ(x[3][0], 5.9); // out of reach
  }
} // namespace surface_user_surface
