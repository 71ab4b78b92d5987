// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/mapping/transfer.h>
#include <waker/nodes/wall.h>
#include <waker/nodes/wall_spots.h>

#include "mapping_lattice.h"
#include "named.h"
#include "user_errors.h"
#include <algorithm>
#include <gtest/gtest.h>

namespace nodes_wall
{
  // Walls off the grid: their pieces, their contact, their forces.

  using namespace Waker;

  namespace
  {
    constexpr double h = 0.5, modulus = 100.;


    WallParameters
    wall(const std::string &line, const std::string &displacement = "")
    {
      WallParameters parameters;
      parameters.name           = "wall";
      parameters.line           = line;
      parameters.displacement   = displacement;
      parameters.penalty_factor = 10.;
      return parameters;
    }


    /// Nodal mass of a body that fills x < edge, y and z without end,
    /// density 1.
    template <int dim>
    std::vector<double>
    body(const BackgroundGrid<dim> &grid, const double edge)
    {
      std::vector<double> mass(grid.n_nodes());
      for (unsigned int i = 0; i < grid.n_nodes(); ++i)
        {
          // The integral of the hat function up to the edge.
          const double r = (edge - grid.node_position(i)[0]) / h;
          const double s = std::clamp(r, -1., 1.);
          mass[i]        = std::pow(h, dim) * (0.5 + s - 0.5 * s * std::abs(s));
        }
      return mass;
    }


    template <int dim>
    struct Fixture
    {
      Fixture(const WallParameters &parameters, const double edge)
        : grid(Lattice::grid<dim>(3., h))
        , walls(grid, {parameters}, modulus, std::pow(h, dim))
        , tractions(walls.n_spots())
      {
        walls.reinit(points, body(grid, edge), 0., tractions);
      }

      NodalVector
      force(const NodalVector &u)
      {
        NodalVector internal(grid.n_dofs());
        walls.add_force(u, internal);
        internal *= -1.;
        return internal;
      }

      const BackgroundGrid<dim>      grid;
      Walls<dim>                     walls;
      typename Walls<dim>::Tractions tractions;
      MaterialPoints<dim>            points; // none: a wall asks nodes
    };


    template <int dim>
    NodalVector
    random(const BackgroundGrid<dim> &grid, const unsigned int seed)
    {
      Lattice::Random random(seed);
      NodalVector     u(grid.n_dofs());
      for (double &entry : u)
        entry = random(-1., 1.);
      return u;
    }


    std::string
    problem(const WallParameters &parameters)
    {
      try
        {
          parameters.check(2);
          Fixture<2>(parameters, 1.);
        }
      catch (const UserError &error)
        {
          return error.where;
        }
      return "";
    }


    /// A linear displacement, as the nodes hold it.
    template <int dim>
    NodalVector
    linear(const BackgroundGrid<dim> &grid,
           const Tensor<1, dim>      &shift,
           const Tensor<2, dim>      &gradient)
    {
      NodalVector u(grid.n_dofs());
      for (unsigned int i = 0; i < grid.n_nodes(); ++i)
        {
          const Tensor<1, dim> value =
            shift + gradient * Tensor<1, dim>(grid.node_position(i));
          for (unsigned int c = 0; c < dim; ++c)
            u.begin()[dim * i + c] = value[c];
        }
      return u;
    }
  } // namespace


  TEST(BoundaryWall, PiecesOfALine)
  {
    const auto spots = make_wall_spots<2>("0, 0; 3, 4; 3, 5.1", 0.5, "Line");
    ASSERT_EQ(spots.size(), 13u);
    double length = 0.;
    for (const auto &spot : spots)
      length += spot.area;
    EXPECT_NEAR(length, 6.1, 1e-14);
    EXPECT_NEAR((spots[0].x - Point<2>(0.15, 0.2)).norm(), 0., 1e-14);
    // The soil lies on the left.
    EXPECT_NEAR((spots[0].normal - Tensor<1, 2>({-0.8, 0.6})).norm(),
                0.,
                1e-14);
    EXPECT_NEAR((spots[12].normal - Tensor<1, 2>({-1., 0.})).norm(), 0., 1e-14);
  }


  TEST(BoundaryWall, PiecesOfAPolygon)
  {
    // A triangle across the axes: area sqrt(3)/2 * 4, anticlockwise from above.
    const auto spots =
      make_wall_spots<3>("2, 0, 0; 0, 2, 0; 0, 0, 2", 0.11, "Line");
    double       area = 0.;
    Tensor<1, 3> moment;
    for (const auto &spot : spots)
      {
        area += spot.area;
        moment += spot.area * Tensor<1, 3>(spot.x);
        EXPECT_NEAR(spot.x[0] + spot.x[1] + spot.x[2], 2., 1e-12);
        EXPECT_NEAR(spot.normal[0], std::sqrt(1. / 3.), 1e-12);
      }
    EXPECT_NEAR(area, 2. * std::sqrt(3.), 1e-12);
    for (unsigned int d = 0; d < 3; ++d)
      EXPECT_NEAR(moment[d] / area, 2. / 3., 1e-12);
  }


  TEST(BoundaryWall, ContactIsWhereTheSoilIs)
  {
    for (const double edge : {1.5, 1.6, 1.75, 1.9})
      {
        const auto n_touching = [&](const double x) {
          const std::string X = std::to_string(x);
          const Fixture<2>  setup(wall(X + ", 0; " + X + ", 3"), edge);
          unsigned int      n = 0;
          for (const auto &spot : setup.walls.all_spots())
            n += spot.touches;
          return n;
        };
        EXPECT_EQ(n_touching(edge), 24u);
        EXPECT_EQ(n_touching(edge - 0.8), 24u);
        EXPECT_EQ(n_touching(edge + 0.1 * h), 24u);
        EXPECT_EQ(n_touching(edge + 0.7 * h), 0u);
      }
  }


  TEST(BoundaryWall, ForceStiffnessAndWorkBelongTogether)
  {
    for (const std::string type : {"rough", "smooth"})
      {
        auto parameters = wall("1.9, 0.2; 1.2, 2.7", "0.1*t; -0.2*t^2");
        parameters.type = Named{type};
        Fixture<2> setup(parameters, 1.63);
        setup.walls.set_step(1., 0.5);
        const NodalVector u = random(setup.grid, 1), du = random(setup.grid, 2);

        // The force is linear: K du is minus its difference.
        NodalVector moved = u, K_du(setup.grid.n_dofs());
        moved += du;
        setup.walls.vmult_add(K_du, du);
        NodalVector error = setup.force(moved);
        error -= setup.force(u);
        EXPECT_GT(K_du.linfty_norm(), 1.);
        error += K_du;
        EXPECT_LT(error.linfty_norm(), 1e-13 * K_du.linfty_norm());

        // Dof by dof: symmetric, with its diagonal, and no further than two
        // cells.
        const unsigned int       n = setup.grid.n_dofs();
        std::vector<NodalVector> columns(n, NodalVector(n));
        NodalVector              unit(n), diagonal(n);
        setup.walls.add_diagonal(diagonal);
        const double tiny      = 1e-13 * diagonal.linfty_norm();
        unsigned int n_entries = 0;
        for (unsigned int j = 0; j < n; ++j)
          {
            unit            = 0.;
            unit.begin()[j] = 1.;
            setup.walls.vmult_add(columns[j], unit);
          }
        for (unsigned int j = 0; j < n; ++j)
          {
            EXPECT_NEAR(columns[j].begin()[j], diagonal.begin()[j], tiny);
            for (unsigned int i = 0; i < n; ++i)
              if (columns[j].begin()[i] != 0.)
                {
                  ++n_entries;
                  EXPECT_NEAR(columns[j].begin()[i],
                              columns[i].begin()[j],
                              tiny);
                  const auto a = setup.grid.node_index(i / 2);
                  const auto b = setup.grid.node_index(j / 2);
                  for (unsigned int d = 0; d < 2; ++d)
                    EXPECT_LE(std::abs(a[d] - b[d]), 2);
                }
          }
        EXPECT_GT(n_entries, 50u);

        // Work: nothing at the start, force times displacement at the end.
        const auto work = setup.walls.work(u);
        EXPECT_EQ(work.start, 0.);
        EXPECT_NEAR(work.end, setup.force(u) * u, 1e-13 * std::abs(work.end));
      }
  }


  // With its memory a wall answers to two steps as to one.
  TEST(BoundaryWall, TractionsAreCarried)
  {
    Fixture<2>        setup(wall("1.7, 0; 1.7, 3", "0.1*t; 0"), 1.63);
    Tensor<1, 2>      shift({0.3, -0.2});
    Tensor<2, 2>      none;
    const NodalVector u = linear(setup.grid, shift, none);
    setup.walls.set_step(0., 2.);
    const Tensor<1, 2> force = setup.walls.accept(u, setup.points);
    // k = 10 * 100 / 0.5; g = (0.2, 0); 3 m of wall.
    EXPECT_NEAR(force[0], -2000. * 0.1 * 3., 1e-11);
    EXPECT_NEAR(force[1], 2000. * 0.2 * 3., 1e-11);
    EXPECT_NEAR((setup.walls.force(0, setup.tractions) - force).norm(),
                0.,
                1e-11);

    const auto mass = body(setup.grid, 1.83);
    setup.walls.reinit(setup.points, mass, 2., setup.tractions);
    EXPECT_NEAR(setup.walls.all_spots()[0].position[0], 1.9, 1e-14);
    // A second step that moves soil and wall alike changes nothing.
    setup.walls.set_step(2., 1.);
    shift               = Tensor<1, 2>({0.1, 0.});
    const NodalVector v = linear(setup.grid, shift, none);
    EXPECT_NEAR((setup.walls.accept(v, setup.points) - force).norm(),
                0.,
                1e-11);
    // Where the soil is gone, the traction is forgotten.
    setup.walls.reinit(setup.points, body(setup.grid, 1.), 3., setup.tractions);
    EXPECT_EQ(setup.walls.force(0, setup.tractions).norm(), 0.);
  }


  // Whatever the soil leaves of the last node, the springs see linear fields as
  // they are, and their forces have the resultant and the moment of the
  // tractions.
  TEST(BoundaryWall, LinearFieldsAreSeenExactly)
  {
    Lattice::Random random(3);
    for (unsigned int n = 0; n < 50; ++n)
      {
        const double      edge = random(1.3, 2.2);
        const double      x    = edge + random(-0.2, 0.15) * h;
        const double      y    = edge + random(-0.2, 0.15) * h;
        const std::string line =
          std::to_string(x) + ", 0.6; " + std::to_string(y) + ", 2.4";
        Fixture<2>         setup(wall(line), edge);
        const Tensor<1, 2> shift    = random.vector<2>(-1., 1.);
        const Tensor<2, 2> gradient = random.matrix<2>(-1., 1.);
        const NodalVector  u        = linear(setup.grid, shift, gradient);
        setup.walls.accept(u, setup.points);
        const auto  &spots = setup.walls.all_spots();
        Tensor<1, 2> resultant, nodal_resultant;
        double       moment = 0., nodal_moment = 0.;
        for (std::size_t q = 0; q < spots.size(); ++q)
          {
            ASSERT_TRUE(spots[q].touches);
            const Point<2>     place = spots[q].position;
            const Tensor<1, 2> expected =
              -2000. * (shift + gradient * Tensor<1, 2>(place));
            EXPECT_LT((setup.tractions[q] - expected).norm(), 1e-10);
            const Tensor<1, 2> f = spots[q].area * expected;
            resultant += f;
            moment += place[0] * f[1] - place[1] * f[0];
          }
        const NodalVector force = setup.force(u);
        for (unsigned int i = 0; i < setup.grid.n_nodes(); ++i)
          {
            const double fx      = force.begin()[2 * i],
                         fy      = force.begin()[2 * i + 1];
            const Point<2> place = setup.grid.node_position(i);
            nodal_resultant += Tensor<1, 2>({fx, fy});
            nodal_moment += place[0] * fy - place[1] * fx;
          }
        EXPECT_LT((resultant - nodal_resultant).norm(), 1e-10);
        EXPECT_NEAR(moment, nodal_moment, 1e-10);
      }
  }


  // Nodes of next to no mass hand their part on along the normal: to their own
  // row if the wall is nearly upright, obliquely if it leans by 45 degrees.
  TEST(BoundaryWall, WeakNodesHandTheirPartOnAlongTheNormal)
  {
    const auto highest_row = [](const std::string &line) {
      Fixture<2>        setup(wall(line), 1.5001);
      const NodalVector force = setup.force(
        linear(setup.grid, Tensor<1, 2>({0.1, 0.2}), Tensor<2, 2>()));
      double y = 0.;
      for (unsigned int i = 0; i < setup.grid.n_nodes(); ++i)
        if (std::abs(force.begin()[2 * i]) > 1e-12)
          y = std::max(y, setup.grid.node_position(i)[1]);
      return y;
    };
    // In the cell from (1.5, 1) on, of which the right nodes are all but empty.
    EXPECT_NEAR(highest_row("1.51, 1.1; 1.56, 1.4"), 1.5, 1e-12);
    EXPECT_NEAR(highest_row("1.51, 1.1; 1.56, 1.15"), 2., 1e-12);
  }


  TEST(BoundaryWall, ThreeDimensions)
  {
    Fixture<3> setup(wall("1.63, 0.5, 0.5; 1.63, 0.5, 2.5; 1.63, 2.5, 2.5; "
                          "1.63, 2.5, 0.5"),
                     1.63);
    EXPECT_NEAR(
      (setup.walls.all_spots()[0].normal - Tensor<1, 3>({-1., 0., 0.})).norm(),
      0.,
      1e-14);
    const NodalVector u =
      linear(setup.grid, Tensor<1, 3>({0.1, 0.2, 0.3}), Tensor<2, 3>());
    const Tensor<1, 3> force = setup.walls.accept(u, setup.points);
    for (unsigned int d = 0; d < 3; ++d)
      EXPECT_NEAR(force[d], -2000. * 0.1 * (d + 1) * 4., 1e-11);
  }


  TEST(BoundaryWall, BadInput)
  {
    EXPECT_EQ(problem(wall("1, 0; 1, 2")), "");
    EXPECT_EQ(problem(wall("1, 0; 1, 2", "t; 0")), "");
    for (const std::string line :
         {"", "1, 0", "1, 0; 1", "1, 0; 1, 0", "1, 0; one, 2", "1, 0; 1, 20"})
      EXPECT_EQ(problem(wall(line)), "Walls/wall/Line") << line;
    for (const std::string motion :
         {"t", "0; t; 0", "x*t; 0", "1; 0", "t +; 0"})
      EXPECT_EQ(problem(wall("1, 0; 1, 2", motion)), "Walls/wall/Displacement")
        << motion;
    auto parameters           = wall("1, 0; 1, 2");
    parameters.penalty_factor = 0.;
    EXPECT_EQ(problem(parameters), "Walls/wall/Penalty factor");

    EXPECT_USER_ERROR(make_wall_spots<3>("0,0,0; 1,0,0; 1,1,0; 0,1,0.1",
                                         0.1,
                                         "L"),
                      "L",
                      "off the plane of the others");
    EXPECT_USER_ERROR(make_wall_spots<3>("0,0,0; 2,2,0; 2,0,0; 0,1,0",
                                         0.1,
                                         "L"),
                      "L",
                      "cross or touch");
    EXPECT_USER_ERROR(make_wall_spots<3>("0,0,0; 1,1,0; 1,0,0; 0,1,0",
                                         0.1,
                                         "L"),
                      "L",
                      "no area"); // both halves cancel
  }
} // namespace nodes_wall
