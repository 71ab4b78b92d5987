// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/case/scene.h>

#include "loaded_bar.h"
#include "named.h"
#include "user_errors.h"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace loads_tractions
{
  using namespace Waker;

  namespace
  {
    /// F on the nodes of the row y = 0 along x (kN), from x = 0 m on.
    double
    force_at(const Scene<2> &scene, const std::size_t i, const double x)
    {
      const BackgroundGrid<2> &grid = scene.weights.background_grid();
      const auto               node =
        grid.node({{static_cast<int>(std::lround(x - grid.origin()[0])), 1}});
      return scene.tractions.view(i).nodal_force->begin()[2 * node];
    }
  } // namespace


  // Section 3.4 of Remmerswaal 2023: which methods fit the internal force. The
  // surface lies at a distance r in front of the node ahead, 0 < r <= 1.
  TEST(Loads, tractions_on_a_bar_of_gimp)
  {
    for (unsigned int k = 0; k <= 40; ++k)
      {
        const double x = 1. + k / 40.;
        const double a = x - std::floor(x);
        LoadedBar    bar(x);
        for (const char *const method : {"contour",
                                         "user surface",
                                         "surface nodes",
                                         "updated points",
                                         "fixed points",
                                         "proximity field"})
          bar.load(method);
        const Case<2> the_case(bar.parameters, MPI_COMM_SELF);
        Scene<2>      scene(the_case);
        scene.set(the_case.initial_points);
        scene.set_internal_force(the_case.initial_points);
        const std::vector<double> error = inconsistency(scene);
        EXPECT_LT(error[0], 1e-13) << "contour, " << x;
        EXPECT_LT(error[1], 1e-13) << "user surface, " << x;
        // The others are off as drawn. Half of what acts goes to each of the
        // two rows of nodes; the other end lies 1 - a before its surface nodes.
        EXPECT_NEAR(error[2], a > 0. ? 0.5 * std::max(a, 1. - a) : 0., 1e-13)
          << "surface nodes, " << x;
        // The points are 0.25 m inside: N = (1 - a) - 0.25.
        const double ahead = std::max(0., 0.75 - a);
        EXPECT_NEAR(force_at(scene, 3, std::floor(x)), 0.5 * ahead, 1e-13) << x;
        EXPECT_NEAR(force_at(scene, 4, std::floor(x)), 0.5 * ahead, 1e-13) << x;
        EXPECT_GT(error[3], 0.05);
        EXPECT_NEAR(error[3], error[4], 1e-13);
        EXPECT_LT(error[5], 0.06) << "proximity field, " << x;
      }
  }


  TEST(Loads, tractions_on_a_bar_of_standard_material_points)
  {
    double worst_surface = 0.;
    for (unsigned int k = 0; k <= 40; ++k)
      {
        const double x = 1. + k / 40. + 1e-6; // points on no line of the grid
        LoadedBar    bar(x, ShapeFunctions::linear);
        for (const char *const method :
             {"volume", "user surface", "surface nodes"})
          bar.load(method);
        const Case<2> the_case(bar.parameters, MPI_COMM_SELF);
        Scene<2>      scene(the_case);
        scene.set(the_case.initial_points);
        scene.set_internal_force(the_case.initial_points);
        const std::vector<double> error = inconsistency(scene);
        EXPECT_LT(error[0], 1e-13) << "volume, " << x;
        worst_surface = std::max(worst_surface, error[1]);
        // Consistent while the cell behind the surface holds all its points:
        // from the offset at which the next is empty to that at which one has
        // left.
        const double a = x - std::floor(x);
        EXPECT_NEAR(error[2], a > 0.25 && a < 0.75 ? 0.25 : 0., 1e-13) << x;
      }
    EXPECT_NEAR(worst_surface, 0.125, 5e-6);
  }


  // The same in space: a block anywhere on the grid, under 1 kPa from all
  // sides.
  TEST(Loads, tractions_on_a_block_in_three_dimensions)
  {
    for (const double x : {1., 1.2, 1.5, 1.83})
      for (const auto functions :
           {ShapeFunctions::gimp, ShapeFunctions::linear})
        {
          Parameters p;
          p.dimension         = 3;
          p.grid.lower_corner = {0., 0., 0.};
          p.grid.upper_corner = {5., 5., 5.};
          p.grid.cell_size    = 1.;
          // A surface by volume fits across itself, and where the sides along
          // it lie on the grid: a layer of points is not where its volume is
          // put.
          const double y = functions == ShapeFunctions::gimp ? x + 0.11 : 1.;
          const double z = functions == ShapeFunctions::gimp ? 0.95 * x : 1.;
          p.mapping.functions    = functions;
          p.gravity.acceleration = 0.;
          p.materials.resize(1);
          p.materials[0].name  = "soil";
          p.materials[0].model = MaterialModel::linear_elastic;
          p.layers.resize(1);
          p.layers[0].name     = "block";
          p.layers[0].material = "soil";
          // Made on the sub-cells, and then moved.
          p.layers[0].polygon = "1, 1; 3, 1; 3, 3; 1, 3";
          p.layers[0].extent  = {1., 3.};

          std::vector<std::string> methods = {functions == ShapeFunctions::gimp
                                                ? "contour"
                                                : "volume",
                                              "surface nodes",
                                              "updated points"};
          for (const std::string &method : methods)
            {
              TractionParameters traction;
              traction.name   = method;
              traction.method = Named{method};
              traction.value  = "1";
              p.tractions.push_back(traction);
            }
          p.gravity.initial_stress = false;

          const Case<3>     the_case(p, MPI_COMM_SELF);
          MaterialPoints<3> points = the_case.initial_points;
          for (std::size_t q = 0; q < points.n_points(); ++q)
            {
              points.position[q] += Point<3>(x, y, z) - Point<3>(1, 1, 1);
              points.stress[q] = -unit_symmetric_tensor<3>();
            }
          Scene<3> scene(the_case);
          scene.set(points);
          scene.set_internal_force(points);
          double largest[3] = {0., 0., 0.}, total = 0.;
          for (unsigned int i = 0; i < the_case.grid.n_dofs(); ++i)
            {
              if (functions == ShapeFunctions::linear && i % 3 != 0)
                continue;
              const double f = scene.nodes.internal_force.local_element(i);
              total += std::abs(f);
              for (unsigned int k = 0; k < 3; ++k)
                largest[k] = std::max(
                  largest[k],
                  std::abs(
                    f - scene.tractions.view(k).nodal_force->local_element(i)));
            }
          EXPECT_GT(total, 5.);
          EXPECT_LT(largest[0], 1e-12) << methods[0] << ", " << x;
          EXPECT_GT(largest[2], 0.05) << x;
          if (functions == ShapeFunctions::gimp)
            {
              EXPECT_GT(largest[1], 0.04) << x;
            }
        }
  }


  // The loads of fixed points are those of the start; updated ones follow.
  TEST(Loads, fixed_and_updated_point_loads)
  {
    LoadedBar bar(1.3);
    bar.load("fixed points");
    bar.load("updated points");
    bar.parameters.tractions[1].value = "1 + t";
    bar.parameters.tractions[0].value = "1";
    const Case<2>     the_case(bar.parameters, MPI_COMM_SELF);
    Scene<2>          scene(the_case);
    MaterialPoints<2> points = the_case.initial_points;
    const auto        total  = [&](const std::size_t i) {
      double sum = 0.;
      for (const Tensor<1, 2> &f : *scene.tractions.view(i).point_loads)
        sum += std::abs(f[0]);
      return sum;
    };
    EXPECT_GE(points.find_scalar("load_fixed points_x"), 0);
    scene.set(points, 0., initial_vertices(the_case));
    EXPECT_NEAR(total(0), 2., 1e-13);
    EXPECT_NEAR(total(1), 2., 1e-13);
    EXPECT_TRUE(scene.loads_move());
    scene.set(points, 2., initial_vertices(the_case));
    EXPECT_NEAR(total(0), 2., 1e-13);
    EXPECT_NEAR(total(1), 6., 1e-13);

    // A point that overtakes the first: it is the surface now, but the fixed
    // load stays where it was.
    std::size_t first = 0, second = 0;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      if (points.position[p][1] < 0.5)
        {
          if (points.position[p][0] < 1.6)
            first = p;
          else if (points.position[p][0] < 2.1)
            second = p;
        }
    std::swap(points.position[first], points.position[second]);
    scene.set(points, 0., initial_vertices(the_case));
    EXPECT_NEAR((*scene.tractions.view(0).point_loads)[first][0], 0.5, 1e-13);
    EXPECT_NEAR((*scene.tractions.view(0).point_loads)[second][0], 0., 1e-13);
    EXPECT_NEAR((*scene.tractions.view(1).point_loads)[first][0], 0., 1e-13);
    EXPECT_NEAR((*scene.tractions.view(1).point_loads)[second][0], 0.5, 1e-13);
  }


  // Pieces of any facet go to the point that is closest to each of their
  // places.
  TEST(Loads, surface_is_split_between_the_closest_points)
  {
    const BackgroundGrid<2>                grid2(Point<2>(0, 0),
                                  Point<2>(4, 4),
                                  1.,
                                  MPI_COMM_SELF);
    const BackgroundGrid<3>                grid3(Point<3>(0, 0, 0),
                                  Point<3>(4, 4, 4),
                                  1.,
                                  MPI_COMM_SELF);
    std::mt19937                           random(3);
    std::uniform_real_distribution<double> uniform(0.1, 3.9);
    const auto                             test = [&](const auto &grid) {
      constexpr int dim =
        std::decay_t<decltype(grid.lower_corner())>::dimension;
      MaterialPoints<dim> points;
      points.resize(60);
      for (Point<dim> &x : points.position)
        for (unsigned int d = 0; d < dim; ++d)
          x[d] = uniform(random);
      PointShares<dim> shares(grid);
      shares.sort(points.position);
      for (unsigned int k = 0; k < 50; ++k)
        {
          std::array<Point<dim>, dim> x;
          for (Point<dim> &v : x)
            for (unsigned int d = 0; d < dim; ++d)
              v[d] = uniform(random);
          const Facet<dim> facet = make_facet<dim>(x);
          double           total = 0.;
          shares.split(
            facet, [&](const Facet<dim> &piece, const std::uint32_t p) {
              total += piece.measure();
              Point<dim> middle;
              for (const Point<dim> &v : piece.vertices)
                middle += v / dim;
              double closest = 1e9;
              for (const Point<dim> &y : points.position)
                closest = std::min(closest, y.distance(middle));
              ASSERT_NEAR(points.position[p].distance(middle), closest, 1e-12);
              for (const Point<dim> &v : piece.vertices)
                {
                  double least = 1e9;
                  for (const Point<dim> &y : points.position)
                    least = std::min(least, y.distance(v));
                  ASSERT_NEAR(points.position[p].distance(v), least, 1e-12);
                }
            });
          ASSERT_NEAR(total, facet.measure(), 1e-12 * facet.measure());
        }
    };
    test(grid2);
    test(grid3);
  }


  TEST(Loads, a_traction_that_loads_nothing_is_a_mistake)
  {
    const auto complaint =
      [](const std::function<void(TractionParameters &)> &f) {
        LoadedBar bar(1.3);
        bar.load("contour");
        f(bar.parameters.tractions[0]);
        try
          {
            const Case<2> the_case(bar.parameters, MPI_COMM_SELF);
          }
        catch (const UserError &error)
          {
            return error.where;
          }
        return std::string();
      };
    EXPECT_EQ(complaint([](TractionParameters &) {}), "");
    EXPECT_EQ(complaint([](TractionParameters &t) {
                t.facing = {0., 1.};
              }),
              "Tractions/contour/Facing");
    EXPECT_EQ(complaint([](TractionParameters &t) {
                t.from = {-9., -9.};
                t.to   = {-8., -8.};
              }),
              "Tractions/contour/From");
    EXPECT_EQ(complaint([](TractionParameters &t) {
                t.kind  = TractionKind::hydrostatic;
                t.level = "-0.5";
              }),
              "Tractions/contour/Level");
    // It may rise to the surface later.
    EXPECT_EQ(complaint([](TractionParameters &t) {
                t.kind  = TractionKind::hydrostatic;
                t.level = "-0.5 + t";
              }),
              "");
    EXPECT_EQ(complaint([](TractionParameters &t) {
                t.method       = TractionMethod::user_surface;
                t.surface_file = "/no/such/file";
              }),
              "Tractions/contour/Surface file");
  }


  TEST(Loads, point_loads_ride_on_the_points)
  {
    LoadedBar           bar(1.3);
    PointLoadParameters tip, whole;
    tip.name                   = "tip";
    tip.from                   = {4.3, 0.};
    tip.force                  = {3., -2.};
    whole.name                 = "whole";
    whole.from                 = {1., 0.};
    whole.to                   = {5., 0.5};
    whole.force                = {0., 6.};
    bar.parameters.point_loads = {tip, whole};
    const Case<2>            the_case(bar.parameters, MPI_COMM_SELF);
    const MaterialPoints<2> &points = the_case.initial_points;
    unsigned int             n      = 0;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const bool is_tip =
          points.position[p].distance(Point<2>(4.05, 0.25)) < 1e-9;
        const bool   low = points.position[p][1] < 0.5;
        Tensor<1, 2> f;
        f[0] = is_tip ? 3. : 0.;
        f[1] = (is_tip ? -2. : 0.) + (low ? 1. : 0.);
        n += is_tip;
        EXPECT_LT((points.load[p] - f).norm(), 1e-13);
      }
    EXPECT_EQ(n, 1u);

    Scene<2> scene(the_case);
    scene.set(points);
    Tensor<1, 2> sum;
    double       moment = 0.;
    for (unsigned int i = 0; i < the_case.grid.n_nodes(); ++i)
      {
        const Point<2>      x = the_case.grid.node_position(i);
        const double *const f = scene.nodes.external_force.begin() + 2 * i;
        sum[0] += f[0];
        sum[1] += f[1];
        moment += x[0] * f[1] - x[1] * f[0];
      }
    EXPECT_NEAR(sum[0], 3., 1e-13);
    EXPECT_NEAR(sum[1], 4., 1e-13);
    EXPECT_NEAR(moment, 6. * 2.8 - 2. * 4.05 - 3. * 0.25, 1e-12);

    bar.parameters.point_loads[1].from = {5., 0.};
    EXPECT_USER_ERROR(Case<2>(bar.parameters, MPI_COMM_SELF),
                      "Point loads/whole/From",
                      "no point in the box");
    EXPECT_USER_ERROR(tip.check(3), "Point loads/tip/From", "has 2 numbers");
    whole.to = {1., -1.};
    EXPECT_USER_ERROR(whole.check(2),
                      "Point loads/whole/To",
                      "below From in direction y");
  }
} // namespace loads_tractions
