// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/mapping/transfer.h>
#include <waker/nodes/wall.h>
#include <waker/nodes/wall_spots.h>
#include <waker/particles/sub_cells.h>

#include "mapping_lattice.h"
#include "user_errors.h"
#include "verification_data.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace nodes_wall_gaps
{
  // Where the soil ends, seen from a frictional wall.

  using namespace Waker;

  namespace
  {
    constexpr double h = 0.5, l = 0.25; // cells, sub-cells


    /// The points of a polygon, as the soil profile makes them.
    MaterialPoints<2>
    soil(const Polygon &corners)
    {
      Polygon scaled = corners;
      for (auto &corner : scaled)
        for (double &x : corner)
          x /= l;
      MaterialPoints<2> points;
      for (const SubCellPart &part :
           merge_small_parts(cut_sub_cells(scaled), 0.25))
        Lattice::add_point(points,
                           Point<2>(l * part.centroid[0], l * part.centroid[1]),
                           part.share * l * l,
                           0.5 * l);
      return points;
    }


    template <int dim>
    std::vector<double>
    gaps(const BackgroundGrid<dim>     &grid,
         const MaterialPoints<dim>     &points,
         const std::vector<Point<dim>> &places,
         const Tensor<1, dim>          &normal)
    {
      WallGaps<dim> finder(grid);
      finder.set_places(places,
                        std::vector<Tensor<1, dim>>(places.size(), normal));
      std::vector<double> result;
      finder.find(points, result);
      return result;
    }


    /// The share of a full node's mass at a place.
    double
    mass_share(const BackgroundGrid<2> &grid,
               const MaterialPoints<2> &points,
               const Point<2>          &x)
    {
      Weights<2> weights(grid, ShapeFunctions::gimp);
      NodalState nodes(grid);
      weights.reinit(points);
      to_nodes(points, weights, nodes);
      const auto   cell  = grid.cell_index(x);
      const double along = (x[0] - grid.origin()[0]) / h - cell[0];
      const double up    = (x[1] - grid.origin()[1]) / h - cell[1];
      const auto   node  = grid.node(cell);
      const auto   at    = [&](const unsigned int i) {
        return std::min(1., nodes.mass[i] / (h * h));
      };
      return (1. - up) * ((1. - along) * at(node) + along * at(node + 1)) +
             up * ((1. - along) * at(node + grid.stride(1)) +
                   along * at(node + grid.stride(1) + 1));
    }
  } // namespace


  // On a wall along the grid the gap is exact, wherever the soil ends; the mass
  // share, by which rough walls know the soil, is not, and of a thin layer it
  // says that there is none.
  TEST(NodesWallGaps, FlatSoilEndsWhereItEnds)
  {
    const auto         grid = Lattice::grid<2>(6., h);
    const Tensor<1, 2> up({0., 1.});
    unsigned int       n = 0;
    for (const double thickness : {0.125, 0.25, 1.})
      for (const double bottom : {2., 2.1, 2.25, 2.3, 2.45})
        for (const double gap : {-0.05, 0.03, 0.1, 0.2})
          {
            const auto     points = soil({{{1., bottom}},
                                          {{4., bottom}},
                                          {{4., bottom + thickness}},
                                          {{1., bottom + thickness}}});
            const Point<2> place(2.31, bottom - gap);
            const double   found = gaps<2>(grid, points, {place}, up)[0];
            EXPECT_NEAR(found, gap > 0.15 * l ? gap : std::min(gap, 0.), 1e-12);
            ++n;
            if (gap == 0.1)
              Verification::row("contact_gap",
                                "thickness_m,bottom_m,gap_m,found_m,share",
                                thickness,
                                bottom,
                                gap,
                                found,
                                mass_share(grid, points, place));
          }
    EXPECT_EQ(n, 60u);
    // Beside the soil, and far from it, there is none.
    const auto points = soil({{{1., 2.}}, {{4., 2.}}, {{4., 3.}}, {{1., 3.}}});
    for (const Point<2> &x :
         {Point<2>(0.95, 2.), Point<2>(4.05, 1.9), Point<2>(2., 0.9)})
      EXPECT_EQ(gaps<2>(grid, points, {x}, up)[0],
                std::numeric_limits<double>::infinity());
    EXPECT_EQ(gaps<2>(grid, points, {Point<2>(3.99, 2.)}, up)[0], 0.);
    // What is behind it is no matter of it.
    EXPECT_EQ(gaps<2>(grid, points, {Point<2>(2., 3.6)}, up)[0],
              std::numeric_limits<double>::infinity());
  }


  // Soil cut by an inclined line: on that line the gap is a tenth of a domain
  // or so, and most places are touched.
  TEST(NodesWallGaps, InclinedSoilEndsNearTheLine)
  {
    const auto   grid = Lattice::grid<2>(6., h);
    unsigned int n = 0, n_touch = 0;
    double       deepest = 0., widest = 0., sum = 0.;
    for (const double angle : {5., 10., 20., 26.565, 30.})
      for (const double shift : {0., 0.07, 0.13, 0.19})
        {
          const double       b = angle * numbers::PI / 180.;
          const Tensor<1, 2> along({std::cos(b), std::sin(b)});
          const Tensor<1, 2> normal({-std::sin(b), std::cos(b)});
          const Point<2>     corner(1.5, 1.2 + shift);
          const auto         vertex = [&](const double t, const double s) {
            const Point<2> x = corner + t * along + s * normal;
            return std::array<double, 2>{{x[0], x[1]}};
          };
          const auto points = soil(
            {vertex(0., 0.), vertex(3., 0.), vertex(3., 1.), vertex(0., 1.)});
          std::vector<Point<2>> places;
          for (double t = 0.3; t < 2.71; t += 0.1)
            places.push_back(corner + t * along);
          for (const double gap : gaps<2>(grid, points, places, normal))
            {
              ++n;
              n_touch += gap <= 0.;
              deepest = std::min(deepest, gap);
              if (std::isfinite(gap))
                widest = std::max(widest, gap);
              sum += std::isfinite(gap) ? gap : 0.;
            }
        }
    EXPECT_EQ(n, 500u);
    EXPECT_GT(n_touch, 0.95 * n);
    EXPECT_GT(deepest, -0.15 * l);
    EXPECT_LT(widest, 0.15 * l);
    Verification::row("contact_inclined",
                      "places,touched,deepest_over_l,widest_over_l,mean_over_l",
                      n,
                      n_touch,
                      deepest / l,
                      widest / l,
                      sum / n / l);
  }


  TEST(NodesWallGaps, ThreeDimensions)
  {
    const auto grid   = Lattice::grid<3>(3., h);
    auto       points = Lattice::box<3>(Point<3>(0.75, 1., 0.75), 4, l);
    std::vector<Point<3>> places = {Point<3>(1., 0.9, 1.1),
                                    Point<3>(0.7, 0.9, 1.1)};
    const auto            found =
      gaps<3>(grid, points, places, Tensor<1, 3>({0., 1., 0.}));
    EXPECT_NEAR(found[0], 0.1, 1e-12);
    EXPECT_EQ(found[1], std::numeric_limits<double>::infinity());
    // Along the diagonal a cube of edge l has the extent l / sqrt(3).
    Tensor<1, 3> diagonal({1., 1., 1.});
    diagonal /= diagonal.norm();
    const Point<3> corner = points.position[0];
    EXPECT_NEAR(gaps<3>(grid, points, {corner - 0.2 * diagonal}, diagonal)[0],
                0.2 - 0.5 * l / std::sqrt(3.),
                1e-12);
  }


  namespace
  {
    WallParameters
    base(const std::string &line)
    {
      WallParameters wall;
      wall.name                 = "base";
      wall.line                 = line;
      wall.type                 = WallType::frictional;
      wall.friction_coefficient = 0.5;
      wall.penalty_factor       = 10.;
      return wall;
    }


    /// A block on a wall.
    struct Block
    {
      explicit Block(const WallParameters &wall)
        : grid(Lattice::grid<2>(6., h))
        , points(soil({{{1.25, 2.}}, {{4., 2.}}, {{4., 3.}}, {{1.25, 3.}}}))
        , walls(grid, {wall}, 100., h * h)
        , tractions(walls.n_spots())
        , nodes(grid)
      {
        Weights<2> weights(grid, ShapeFunctions::gimp);
        weights.reinit(points);
        to_nodes(points, weights, nodes);
        walls.reinit(points, nodes.mass, 0., tractions);
      }

      BackgroundGrid<2>   grid;
      MaterialPoints<2>   points;
      Walls<2>            walls;
      Walls<2>::Tractions tractions;
      NodalState          nodes;
    };
  } // namespace


  // Forces and derivative of a whole wall, at a motion in which some spots
  // open, some slide and some stick.
  TEST(NodesWallGaps, ForceAndDerivativeOfAWall)
  {
    Block           block(base("0.1, 2; 5.9, 2"));
    Lattice::Random random(5);
    NodalVector     press(block.grid.n_dofs()), u(press), du(press);
    for (unsigned int i = 0; i < block.grid.n_nodes(); ++i)
      {
        press.begin()[2 * i + 1] = -0.1;
        u.begin()[2 * i]         = random(-0.06, 0.06);
        u.begin()[2 * i + 1]     = random(-0.1, 0.15);
        for (unsigned int c = 0; c < 2; ++c)
          du.begin()[2 * i + c] = random(-1., 1.);
      }
    block.walls.accept(press, block.points);
    // k = 10 * 100 / 0.5 over 2.75 m, to a spot
    EXPECT_NEAR(block.walls.force(0, block.tractions)[1],
                2000. * 0.1 * 2.75,
                2000. * 0.1 * h / 4.);
    block.walls.reinit(block.points, block.nodes.mass, 0., block.tractions);
    const auto force = [&](const double eps) {
      NodalVector moved = du, internal(block.grid.n_dofs());
      moved *= eps;
      moved += u;
      block.walls.add_force(moved, internal);
      return internal;
    };
    constexpr double eps   = 1e-8;
    NodalVector      slope = force(eps), K_du(block.grid.n_dofs());
    slope -= force(-eps);
    slope *= 0.5 / eps;
    force(0.);
    block.walls.linearise();
    block.walls.vmult_add(K_du, du);
    EXPECT_FALSE(block.walls.is_symmetric());
    EXPECT_TRUE(block.walls.has_corners());
    EXPECT_GT(K_du.linfty_norm(), 10.);
    slope -= K_du;
    EXPECT_LT(slope.linfty_norm(), 1e-6 * K_du.linfty_norm()); // 1e-8 or so

    // The diagonal, dof by dof.
    NodalVector diagonal(block.grid.n_dofs());
    block.walls.add_diagonal(diagonal);
    for (unsigned int dof = 0; dof < block.grid.n_dofs(); ++dof)
      {
        NodalVector unit(block.grid.n_dofs()), column(unit);
        unit.begin()[dof] = 1.;
        block.walls.vmult_add(column, unit);
        EXPECT_NEAR(column.begin()[dof],
                    diagonal.begin()[dof],
                    1e-12 * diagonal.linfty_norm());
      }

    // No spot pulls, nor has more shear than friction allows.
    block.walls.accept(u, block.points);
    unsigned int n_open = 0, n_sliding = 0, n_stuck = 0;
    for (std::size_t q = 0; q < block.tractions.size(); ++q)
      if (block.walls.all_spots()[q].touches)
        {
          const Tensor<1, 2> &t = block.tractions[q];
          EXPECT_GE(t[1], 0.);
          EXPECT_LE(std::abs(t[0]), 0.5 * t[1] + 1e-10);
          ++(t[1] == 0.                            ? n_open
             : std::abs(t[0]) > 0.5 * t[1] - 1e-10 ? n_sliding
                                                   : n_stuck);
        }
    EXPECT_GT(n_open, 0u);
    EXPECT_GT(n_sliding, 0u);
    EXPECT_GT(n_stuck, 0u);
  }


  TEST(NodesWallGaps, SoilBehindAFrictionalWallIsRefused)
  {
    EXPECT_TRUE(Block(base("0.1, 2; 5.9, 2")).walls.idle().empty());
    EXPECT_NO_THROW(Block(base("0.1, 2; 5.9, 2")).walls.check_start());
    EXPECT_USER_ERROR(Block(base("5.9, 2; 0.1, 2")).walls.check_start(),
                      "Walls/base/Line",
                      "soil behind it");
    EXPECT_USER_ERROR(Block(base("0.1, 2.4; 5.9, 2.4")).walls.check_start(),
                      "Walls/base/Line",
                      "soil behind it");
    EXPECT_EQ(Block(base("0.1, 1.5; 5.9, 1.5")).walls.idle().size(), 1u);
  }


  TEST(NodesWallGaps, BadInput)
  {
    const auto check = [](const double mu, const double phi, const double a) {
      WallParameters wall       = base("0, 1; 2, 1");
      wall.friction_coefficient = mu;
      wall.friction_angle       = phi;
      wall.adhesion             = a;
      wall.check(2);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    EXPECT_NO_THROW(check(0.5, 0., 3.));
    EXPECT_NO_THROW(check(0., 30., 0.));
    for (const double bad : {-0.1, nan, inf, 1e308})
      {
        EXPECT_USER_ERROR(check(bad, 0., 0.),
                          "Walls/base/Friction coefficient",
                          "is ");
        EXPECT_USER_ERROR(check(0., bad, 0.),
                          "Walls/base/Friction angle",
                          "is ");
        EXPECT_USER_ERROR(check(0., 0., bad), "Walls/base/Adhesion", "is ");
      }
    EXPECT_USER_ERROR(check(0., 89.9, 0.),
                      "Walls/base/Friction angle",
                      "is 89.9");
    EXPECT_USER_ERROR(check(0.5, 30., 0.),
                      "Walls/base/Friction angle",
                      "but Friction coefficient is 0.5");
    WallParameters wall = base("0, 1; 2, 1");
    EXPECT_EQ(wall.friction(), 0.5);
    wall.friction_coefficient = 0.;
    wall.friction_angle       = 30.;
    EXPECT_NEAR(wall.friction(), std::sqrt(1. / 3.), 1e-14);
  }


  TEST(NodesWallGaps, AWallAlongAWholeFaceClosesIt)
  {
    const auto grid  = Lattice::grid<2>(6., h);
    const auto faces = [&](const std::string &line,
                           const std::string &displacement = "") {
      WallParameters wall = base(line);
      wall.displacement   = displacement;
      return faces_along_walls(grid, {wall}).closed;
    };
    const Point<2> low = grid.lower_corner(), high = grid.upper_corner();
    const auto     line =
      [](const double x0, const double y0, const double x1, const double y1) {
        return std::to_string(x0) + ", " + std::to_string(y0) + "; " +
               std::to_string(x1) + ", " + std::to_string(y1);
      };
    EXPECT_EQ(faces(line(low[0], low[1], high[0], low[1])), 4u);
    EXPECT_EQ(faces(line(high[0], high[1], low[0], high[1])), 8u);
    EXPECT_EQ(faces(line(low[0], high[1], low[0], low[1])), 1u);
    // The other way round, in a part, inside, moving: no.
    EXPECT_EQ(faces(line(high[0], low[1], low[0], low[1])), 0u);
    EXPECT_EQ(faces(line(low[0], low[1], high[0] - h, low[1])), 0u);
    EXPECT_EQ(faces(line(low[0], low[1] + h, high[0], low[1] + h)), 0u);
    EXPECT_EQ(faces(line(low[0], low[1], high[0], low[1]), "0; t"), 0u);
    // Less than a cell inside it closes the face, from where it is.
    const double at = low[1] + 0.4 * h;
    EXPECT_EQ(faces(line(low[0], at, high[0], at)), 4u);
    EXPECT_NEAR(
      faces_along_walls(grid, {base(line(low[0], at, high[0], at))}).setback[2],
      0.4 * h,
      1e-12);
    // Along a line of the grid, or not.
    const auto on_line = [&](const double x, const double y) {
      return is_along_grid_line(grid, base(line(low[0], x, high[0], y)));
    };
    EXPECT_TRUE(on_line(low[1], low[1]));
    EXPECT_TRUE(on_line(low[1] + h, low[1] + h));
    EXPECT_FALSE(on_line(at, at));
    EXPECT_FALSE(on_line(low[1], low[1] + h));
  }
} // namespace nodes_wall_gaps
