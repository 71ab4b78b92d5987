// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/particles/feeder.h>
#include <waker/particles/removal.h>

#include "mapping_lattice.h"
#include "named.h"
#include "user_errors.h"
#include <algorithm>
#include <gtest/gtest.h>

namespace particles_flow
{
  // Points that leave the arrays and points that enter them.

  using namespace Waker;

  namespace
  {
    InflowParameters
    inflow(const std::string &face, const double velocity)
    {
      InflowParameters parameters;
      parameters.name     = "mouth";
      parameters.face     = Named{face};
      parameters.velocity = velocity;
      return parameters;
    }


    template <int dim>
    Feeder<dim>
    feeder(const InflowParameters &parameters)
    {
      static const auto grid = Lattice::grid<dim>(2., 0.5);
      return Feeder<dim>(grid, parameters, 2, 1, 1.5, {{"strength", 7.}});
    }


    /// Distance of the points from the face, ascending, without repetitions.
    template <int dim>
    std::vector<double>
    depths(const MaterialPoints<dim> &points,
           const unsigned int         d,
           const double               face,
           const double               inwards)
    {
      std::vector<double> result;
      for (const Point<dim> &x : points.position)
        result.push_back(inwards * (face - x[d]));
      std::sort(result.begin(), result.end());
      result.erase(std::unique(result.begin(),
                               result.end(),
                               [](const double a, const double b) {
                                 return std::abs(a - b) < 1e-12;
                               }),
                   result.end());
      return result;
    }


    std::string
    problem(const InflowParameters &parameters)
    {
      try
        {
          parameters.check(2);
          feeder<2>(parameters);
        }
      catch (const UserError &error)
        {
          return error.where;
        }
      return "";
    }
  } // namespace


  TEST(ParticlesFlow, RemovalKeepsTheOrderAndTheEmptyArrays)
  {
    MaterialPoints<2> points = Lattice::box(Point<2>(0., 0.), 3, 0.5);
    points.scalar("strength");
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        points.scalars[0].values[p] = 10. * p;
        points.stress[p][0][0]      = p;
      }
    points.load.resize(points.n_points());
    points.load[7][1] = 7.;
    remove_points({0, 4, 5, 8}, points);

    const std::vector<std::uint64_t> expected = {1, 2, 3, 6, 7};
    EXPECT_EQ(points.id, expected);
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        EXPECT_EQ(points.scalars[0].values[p], 10. * expected[p]);
        EXPECT_EQ(points.stress[p][0][0], expected[p]);
      }
    EXPECT_EQ(points.load.size(), 5u);
    EXPECT_EQ(points.load[4][1], 7.);
    EXPECT_TRUE(points.deformation.empty());
    remove_points({0, 1, 2, 3, 4}, points);
    EXPECT_EQ(points.n_points(), 0u);
  }


  TEST(ParticlesFlow, OnlyOpenFacesLetPointsOut)
  {
    const auto        grid = Lattice::grid<2>(2., 0.5);
    MaterialPoints<2> points;
    const double      beyond = 0.1;
    for (const auto &x : {Point<2>(grid.lower_corner()[0] - beyond, 1.),
                          Point<2>(1., 1.),
                          Point<2>(grid.upper_corner()[0] + beyond, 1.),
                          Point<2>(1., grid.lower_corner()[1] - beyond),
                          Point<2>(1., grid.upper_corner()[1] + beyond)})
      Lattice::add_point(points, x, 1., 0.1);
    for (unsigned int f = 0; f < 4; ++f)
      {
        OutletParameters whole;
        whole.face = static_cast<BoxFace>(f);
        Openings<2> open(grid);
        EXPECT_TRUE(open.empty());
        open.add(place_opening(grid, whole, "Outflow"));
        const auto expected = std::vector<std::size_t>{f < 1 ? 0u : f + 1};
        EXPECT_EQ(points_beyond(open, points), expected);
      }
  }


  // A part of the back face from x = 0.5 to the edge of the box, and of all
  // heights: what lies beside it stays, what is beyond the edge goes.
  TEST(ParticlesFlow, OnlyTheOpenPartOfAFaceLetsPointsOut)
  {
    const auto       grid  = Lattice::grid<3>(2., 0.5);
    const Point<3>   lower = grid.lower_corner(), upper = grid.upper_corner();
    const double     past = 0.1, x = lower[0] + 0.5, y = lower[1] + 1.;
    OutletParameters part;
    part.name = "part";
    part.face = BoxFace::back;
    part.from = {x, lower[1], 0.};
    Openings<3> open(grid);
    open.add(place_opening(grid, part, "Outflow/part"));

    MaterialPoints<3> points;
    const auto        add = [&](const double along, const double up) {
      Lattice::add_point(points, Point<3>(along, up, lower[2] - past), 1., 0.1);
    };
    add(x - 0.01, y);               // 0: beside the opening
    add(x + 0.01, y);               // 1
    add(upper[0] + past, y);        // 2: past two faces
    add(x + 0.01, lower[1] - past); // 3
    add(lower[0] - past, y);        // 4: past the other edge
    Lattice::add_point(points, Point<3>(x + 0.01, y, upper[2] + past), 1., 0.1);
    EXPECT_EQ(points_beyond(open, points), (std::vector<std::size_t>{1, 2, 3}));
    EXPECT_TRUE(open.is_open(4, points.position[1]));
    EXPECT_FALSE(open.is_open(4, points.position[0]));
    EXPECT_FALSE(open.is_open(5, points.position[1]));

    // Does another one have a part in common?
    OutletParameters other = part;
    other.from             = {};
    other.to               = {x, upper[1], 0.};
    EXPECT_FALSE(open.meets(place_opening(grid, other, "")));
    other.to[0] += 0.5;
    EXPECT_TRUE(open.meets(place_opening(grid, other, "")));
    other.face = BoxFace::front;
    EXPECT_FALSE(open.meets(place_opening(grid, other, "")));
  }


  // Wherever the strip is, its rows lie a sub-cell apart, the outermost one
  // less than a sub-cell from the end of the margin.
  TEST(ParticlesFlow, TheStripHasNoGaps)
  {
    for (const std::string face : {"left", "right", "bottom", "top"})
      {
        const auto         parameters = inflow(face, 0.3);
        const auto         strip      = feeder<2>(parameters);
        const unsigned int d          = parameters.face_number() / 2;
        const double inwards = parameters.face_number() % 2 == 0 ? 1. : -1.;
        const double x       = strip.mouth().lower[d];
        EXPECT_EQ(x, strip.mouth().upper[d]);

        MaterialPoints<2> points;
        std::uint64_t     next_id = 0, rows = 0;
        strip.fill(points, next_id);
        ASSERT_EQ(points.n_points(), 16u);
        double time = 0.;
        for (const double dt : {0.5, 0.33, 0.01, 2., 1e-9, 5. / 6.})
          {
            time += dt;
            for (Point<2> &y : points.position)
              y += dt * strip.velocity();
            const std::size_t before = points.n_points();
            const std::size_t n_new  = strip.feed(time, rows, points, next_id);
            EXPECT_EQ(n_new, points.n_points() - before);
            const std::vector<double> rows_at = depths(points, d, x, inwards);
            EXPECT_EQ(rows_at.size(), 2 + rows);
            EXPECT_EQ(points.n_points(), 8 * (2 + rows));
            EXPECT_EQ(next_id, points.n_points());
            for (std::size_t k = 1; k < rows_at.size(); ++k)
              EXPECT_NEAR(rows_at[k] - rows_at[k - 1], 0.25, 1e-9);
            EXPECT_LE(rows_at.back() + 0.125, 0.5 + 1e-9);
            EXPECT_GT(rows_at.back() + 0.125, 0.25);
          }
      }
  }


  TEST(ParticlesFlow, NewPointsAreWholeSubCellsOfTheirMaterial)
  {
    MaterialPoints<3> points;
    points.scalar("strength");
    points.scalar("plastic strain");
    std::uint64_t next_id    = 12;
    auto          parameters = inflow("front", 0.1);
    parameters.from          = {0.5, 0., 0.};
    parameters.to            = {1., 2., 0.};
    feeder<3>(parameters).fill(points, next_id);
    // 2 x 8 x 2 sub-cells.
    ASSERT_EQ(points.n_points(), 32u);
    EXPECT_EQ(points.id.front(), 12u);
    EXPECT_EQ(next_id, 44u);
    double volume = 0., mass = 0.;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        volume += points.volume[p];
        mass += points.mass[p];
        EXPECT_EQ(points.material[p], 1u);
        EXPECT_EQ(points.velocity[p], (Tensor<1, 3>({0., 0., -0.1})));
        EXPECT_EQ(points.half_size[p][1], 0.125);
        EXPECT_EQ(points.scalar("strength")[p], 7.);
        EXPECT_EQ(points.scalar("plastic strain")[p], 0.);
        EXPECT_GT(points.position[p][2], 2.);
        EXPECT_GT(points.position[p][0], 0.5);
        EXPECT_LT(points.position[p][0], 1.);
      }
    EXPECT_NEAR(volume, 0.5 * 2. * 0.5, 1e-14);
    EXPECT_NEAR(mass, 0.75, 1e-14);
  }


  TEST(ParticlesFlow, BadInput)
  {
    auto parameters = inflow("left", 0.1);
    EXPECT_EQ(problem(parameters), "");
    parameters.velocity = 0.;
    EXPECT_EQ(problem(parameters), "Inflow/mouth/Velocity");
    EXPECT_EQ(problem(inflow("back", 1.)), "Inflow/mouth/Face");
    parameters      = inflow("left", 0.1);
    parameters.from = {0., 0.6};
    EXPECT_EQ(problem(parameters), "Inflow/mouth/From"); // off the grid's lines
    parameters.from = {0.};
    EXPECT_EQ(problem(parameters), "Inflow/mouth/From");
    parameters.from = {0., 1.};
    parameters.to   = {0., 1.};
    EXPECT_EQ(problem(parameters), "Inflow/mouth/To");
    parameters.to = {0., 2.5};
    EXPECT_EQ(problem(parameters), "Inflow/mouth/To"); // beyond the box

    OutletParameters outlet;
    outlet.name = "gap";
    outlet.face = BoxFace::front;
    EXPECT_USER_ERROR(outlet.check(2), "Outflow/gap/Face", "\"front\" in 2D");
    EXPECT_NO_THROW(outlet.check(3));
    outlet.from = {1., 1., 1.};
    outlet.to   = {2., 1., 0.};
    EXPECT_USER_ERROR(outlet.check(3), "Outflow/gap/To", "direction y");
    outlet.to = {2., 2., 0.};
    EXPECT_NO_THROW(outlet.check(3));
    const auto cubes = Lattice::grid<3>(2., 0.5);
    EXPECT_NO_THROW(place_opening(cubes, outlet, "Outflow/gap"));
    outlet.to = {1.8, 2., 0.};
    EXPECT_USER_ERROR(place_opening(cubes, outlet, "Outflow/gap"),
                      "Outflow/gap/To",
                      "1.8 m in direction x");

    OutflowParameters outflow;
    outflow.faces = "right, top";
    EXPECT_EQ(outflow.open_faces(2),
              (std::vector<bool>{false, true, false, true}));
    outflow.faces = "front";
    EXPECT_USER_ERROR(outflow.open_faces(2),
                      "Outflow/Faces",
                      "no face \"front\" in 2D");
    EXPECT_NO_THROW(outflow.open_faces(3));
  }
} // namespace particles_flow
