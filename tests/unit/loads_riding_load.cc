// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/case/case.h>
#include <waker/case/scene.h>

#include "loaded_block.h"
#include <cmath>
#include <gtest/gtest.h>

namespace loads_riding_load
{
  using namespace Waker;

  namespace
  {
    template <int dim>
    std::string
    vector_value()
    {
      return dim == 2 ? "3; -25" : "3; -25; 1.5";
    }


    /// Sinks by about 0.4 m, unevenly, and is stirred a little.
    template <int dim>
    MaterialPoints<dim>
    sunk(MaterialPoints<dim> points)
    {
      for (std::size_t p = 0; p < points.n_points(); ++p)
        {
          Point<dim>  &x = points.position[p];
          const double X = x[0], Y = x[1];
          const double s = 0.03 * std::sin(37. * p);
          x[0] += 0.05 * std::sin(2. * X) + s;
          x[1] -= 0.3 + 0.1 * std::cos(3. * X) * Y / 3. - s;
          if (dim == 3)
            x[2] += 0.04 * std::cos(X + Y);
        }
      return points;
    }


    template <int dim>
    Tensor<1, dim>
    rotated(const Tensor<1, dim> &x, const double angle)
    {
      Tensor<1, dim> y = x;
      y[0]             = std::cos(angle) * x[0] - std::sin(angle) * x[1];
      y[1]             = std::sin(angle) * x[0] + std::cos(angle) * x[1];
      return y;
    }


    template <int dim>
    double
    difference(const NodalVector &a, const NodalVector &b)
    {
      double largest = 0.;
      for (unsigned int i = 0; i < a.locally_owned_size(); ++i)
        largest =
          std::max(largest, std::abs(a.local_element(i) - b.local_element(i)));
      return largest;
    }


    // The resultant stays, whatever the soil under it does, and acts on nodes
    // with mass.
    template <int dim>
    void
    test_sinking(const std::string &method, const double tolerance)
    {
      LoadedBlock<dim> block;
      block.load(method, vector_value<dim>());
      block.load(method, vector_value<dim>()).follows = TractionFollows::space;
      const Case<dim> the_case(block.parameters, MPI_COMM_SELF);
      const double    area = dim == 2 ? 1.2 : 1.2 * 1.5;
      Scene<dim>      scene(the_case);
      scene.set(the_case.initial_points);
      const auto start = scene.tractions.resultant(0);
      if (method == name_of(TractionMethod::contour))
        {
          EXPECT_NEAR(start.force[1], -25. * area, 1e-12 * 25. * area);
          EXPECT_NEAR(start.measure, area, 1e-12 * area);
        }

      const MaterialPoints<dim> points = sunk(the_case.initial_points);
      scene.set(points, 0., initial_vertices(the_case));
      const auto now = scene.tractions.resultant(0);
      EXPECT_LT((now.force - start.force).norm(),
                tolerance * start.force.norm())
        << method;
      EXPECT_NEAR(now.measure, start.measure, 1e-12 * start.measure);

      // In space it has sunk out of its box.
      EXPECT_EQ(scene.tractions.resultant(1).force.norm(), 0.);
      EXPECT_EQ(scene.tractions.resultant(1).measure, 0.);
      std::vector<TractionRecord> records;
      scene.tractions.record(3., records);
      scene.tractions.record(4., records);
      ASSERT_EQ(records.size(), 2u);
      EXPECT_EQ(records[0].empty_time, -1.);
      EXPECT_EQ(records[1].empty_time, 3.);
    }
  } // namespace


  TEST(Loads, a_riding_load_keeps_its_resultant_on_sinking_soil)
  {
    test_sinking<2>("contour", 1e-12);
    test_sinking<3>("contour", 1e-12);
  }


  // The detected surface is off the points: what it loads may have no mass, as
  // ever. With a minimum support it goes to nodes that have.
  TEST(Loads, a_riding_load_on_the_proximity_field)
  {
    for (const double support : {0., 0.01})
      {
        LoadedBlock<2> block;
        block.load("proximity field", "3; -25").minimum_support = support;
        const Case<2> the_case(block.parameters, MPI_COMM_SELF);
        Scene<2>      scene(the_case);
        scene.set(the_case.initial_points);
        const double length = scene.tractions.resultant(0).measure;
        EXPECT_NEAR(length, 1.2, 0.05);
        scene.set(sunk(the_case.initial_points),
                  0.,
                  initial_vertices(the_case));
        const auto now = scene.tractions.resultant(0);
        EXPECT_NEAR(now.measure, length, 1e-12);
        const double error = std::abs(now.force[1] / (-25. * length) - 1.);
        EXPECT_LT(error, support > 0. ? 1e-12 : 0.5);
      }
  }


  // Before anything moves, riding or not makes no difference.
  TEST(Loads, a_riding_load_at_rest_is_what_it_was)
  {
    const auto test = [](auto block, const std::vector<std::string> &methods) {
      constexpr int dim = decltype(block)::dimension;
      for (const std::string &method : methods)
        for (const std::string &value : {vector_value<dim>(),
                                         std::string("10"),
                                         std::string("4 + x + 2*y + t")})
          {
            LoadedBlock<dim> loaded;
            loaded.load(method, value).follows = TractionFollows::soil;
            loaded.load(method, value).follows = TractionFollows::space;
            const Case<dim> the_case(loaded.parameters, MPI_COMM_SELF);
            Scene<dim>      scene(the_case);
            scene.set(the_case.initial_points, 2., initial_vertices(the_case));
            const NodalVector &soil  = *scene.tractions.view(0).nodal_force;
            const NodalVector &space = *scene.tractions.view(1).nodal_force;
            EXPECT_GT(space.l2_norm(), 1.);
            EXPECT_LT(difference<dim>(soil, space), 1e-12 * space.l2_norm())
              << method << ", " << value;
            EXPECT_NEAR(scene.tractions.resultant(0).measure,
                        scene.tractions.resultant(1).measure,
                        1e-12);
          }
    };
    test(Point<2>(), {"contour", "proximity field", "user surface"});
    test(Point<3>(), {"contour", "proximity field"});
  }


  // A load on domains that stretch by a tenth along the surface has no gaps: it
  // is that of a tenth less on a longer part.
  TEST(Loads, a_riding_load_stretches_with_the_domains_of_its_points)
  {
    LoadedBlock<2> block;
    block.load("contour", "3; -25");
    TractionParameters &longer = block.load("contour", "3/1.1; -25/1.1");
    longer.follows             = TractionFollows::space;
    longer.from[0]             = 2.5 + 1.1 * (1.7 - 2.5);
    longer.to[0]               = 2.5 + 1.1 * (2.9 - 2.5);
    const Case<2>     the_case(block.parameters, MPI_COMM_SELF);
    MaterialPoints<2> points = the_case.initial_points;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        points.position[p][0] = 2.5 + 1.1 * (points.position[p][0] - 2.5);
        points.half_size[p][0] *= 1.1;
      }
    Scene<2> scene(the_case);
    scene.set(points, 0., initial_vertices(the_case));
    const NodalVector &soil  = *scene.tractions.view(0).nodal_force;
    const NodalVector &space = *scene.tractions.view(1).nodal_force;
    EXPECT_GT(space.l2_norm(), 1.);
    EXPECT_LT(difference<2>(soil, space), 1e-12 * space.l2_norm());
  }


  // A body that moves as a whole takes its load with it: as if the box had
  // moved, and an expression of the place belongs to the soil.
  TEST(Loads, a_riding_load_on_a_body_that_is_moved)
  {
    for (const double shift : {0.5, 0.613})
      for (const std::string method : {"contour", "user surface"})
        {
          LoadedBlock<2> block;
          block.load(method, "4 + x");
          TractionParameters &moved = block.load(method, "4 + x - 0.613");
          if (shift == 0.5)
            moved.value = "4 + x - 0.5";
          moved.follows = TractionFollows::space;
          for (unsigned int d = 0; d < 2; ++d)
            {
              moved.from[d] -= d == 0 ? 0. : 0.3;
              moved.to[d] += d == 0 ? shift : 0.;
            }
          moved.from[0] += shift;
          const Case<2>      the_case(block.parameters, MPI_COMM_SELF);
          MaterialPoints<2>  points   = the_case.initial_points;
          SurfaceVertices<2> vertices = initial_vertices(the_case);
          const Point<2>     by(shift, -0.2);
          for (Point<2> &x : points.position)
            x += by;
          for (auto &list : vertices)
            for (Point<2> &x : list)
              x += by;
          Scene<2> scene(the_case);
          scene.set(points, 0., vertices);
          const NodalVector &soil  = *scene.tractions.view(0).nodal_force;
          const NodalVector &space = *scene.tractions.view(1).nodal_force;
          EXPECT_GT(space.l2_norm(), 1.);
          EXPECT_LT(difference<2>(soil, space), 1e-12 * space.l2_norm())
            << method << ", " << shift;
        }
  }


  // A pressure turns with the soil, a vector does not. The vertices are carried
  // by the nodes.
  template <int dim>
  void
  test_rotation(const std::string &method)
  {
    LoadedBlock<dim> block;
    block.load(method, "10");
    block.load(method, vector_value<dim>());
    // The domains do not turn: a turned line may leave them.
    if (method == name_of(TractionMethod::user_surface))
      for (TractionParameters &t : block.parameters.tractions)
        t.minimum_support = 0.01;
    const Case<dim>      the_case(block.parameters, MPI_COMM_SELF);
    MaterialPoints<dim>  points   = the_case.initial_points;
    SurfaceVertices<dim> vertices = initial_vertices(the_case);
    Scene<dim>           scene(the_case);
    scene.set(points, 0., vertices);
    const Tensor<1, dim> pressure = scene.tractions.resultant(0).force;
    const Tensor<1, dim> vector   = scene.tractions.resultant(1).force;
    ASSERT_GT(pressure.norm(), 5.);

    const double angle = 0.7;
    Point<dim>   centre;
    for (unsigned int d = 0; d < dim; ++d)
      centre[d] = 2.5;
    const auto turned = [&](const Point<dim> &x) {
      return centre + rotated(Tensor<1, dim>(x - centre), angle);
    };
    NodalState nodes(the_case.grid);
    for (unsigned int i = 0; i < the_case.grid.n_nodes(); ++i)
      {
        nodes.mass[i]      = 1.;
        const Point<dim> x = the_case.grid.node_position(i);
        for (unsigned int d = 0; d < dim; ++d)
          nodes.increment.local_element(dim * i + d) = turned(x)[d] - x[d];
      }
    for (auto &list : vertices)
      carry_vertices(the_case.grid, nodes.mass, 0., nodes.increment, list);
    for (Point<dim> &x : points.position)
      x = turned(x);
    scene.set(points, 0., vertices);
    EXPECT_LT(
      (scene.tractions.resultant(0).force - rotated(pressure, angle)).norm(),
      1e-12 * pressure.norm())
      << method;
    EXPECT_LT((scene.tractions.resultant(1).force - vector).norm(),
              1e-12 * vector.norm())
      << method;
  }


  TEST(Loads, a_riding_pressure_turns_with_the_soil)
  {
    test_rotation<2>("contour");
    test_rotation<3>("contour");
    test_rotation<2>("user surface");
  }


  /// A domain that reaches a node by a hair gives it hardly any stiffness: what
  /// such a node does is no motion of the soil.
  TEST(Loads, what_is_carried_does_not_follow_nodes_with_hardly_any_mass)
  {
    const BackgroundGrid<2> grid(Point<2>(),
                                 Point<2>(4., 4.),
                                 1.,
                                 MPI_COMM_SELF);
    std::vector<double>     mass(grid.n_nodes(), 1.);
    NodalVector             increment(grid.n_dofs());
    for (unsigned int i = 0; i < grid.n_nodes(); ++i)
      {
        increment.begin()[2 * i] = 0.1;
        if (grid.node_position(i)[1] > 2.5)
          {
            mass[i]                      = 1e-12;
            increment.begin()[2 * i + 1] = 1e9;
          }
      }
    // By a hair above the nodes at y = 2, and above all that counts.
    const Point<2> hair(1.3, 2. + 1e-6), above(1.3, 3.2);
    for (const Point<2> &x : {hair, above})
      {
        std::vector<Point<2>> vertices = {x};
        carry_vertices(grid, mass, 1e-4, increment, vertices);
        EXPECT_NEAR(vertices[0][0] - x[0], 0.1, 1e-14);
        EXPECT_EQ(vertices[0][1], x[1]);
        carry_vertices(grid, mass, 0., increment, vertices);
        EXPECT_GT(vertices[0][1] - x[1], 900.);
      }
  }
} // namespace loads_riding_load
