// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/centre_stencil.h>
#include <waker/mapping/group_stencil.h>

#include "mapping_lattice.h"
#include <gtest/gtest.h>
#include <set>
#include <utility>

namespace mapping_point_groups
{
  // Groups of points around a node, and what is done with them, against the
  // same point by point.

  using namespace Waker;

  namespace
  {
    constexpr double h = 0.25;


    /// Points in disorder: groups of one to more than eight.
    struct Body
    {
      explicit Body(const ShapeFunctions functions)
        : grid(Lattice::grid<3>(1., h))
        , weights(grid, functions)
      {
        Lattice::Random random(7);
        points = Lattice::box(Point<3>(random.vector<3>(0.1, 0.2)), 5, 0.12);
        for (auto &x : points.position)
          x += random.vector<3>(-0.05, 0.05);
        // A heap of points around one node.
        for (unsigned int k = 0; k < 19; ++k)
          points.position[6 * k] =
            Point<3>(0.5, 0.5, 0.5) + random.vector<3>(-0.02, 0.02);
        weights.reinit(points);
        for (unsigned int dof = 0; dof < grid.n_dofs(); ++dof)
          u.push_back(random(-1., 1.));
      }

      BackgroundGrid<3>   grid;
      MaterialPoints<3>   points;
      Weights<3>          weights;
      std::vector<double> u;
    };


    template <typename Lanes>
    constexpr double epsilon =
      std::numeric_limits<typename LaneTraits<Lanes>::Number>::epsilon();


    template <typename Lanes>
    void
    check_partition(const ShapeFunctions functions)
    {
      constexpr unsigned int n = LaneTraits<Lanes>::n;
      const Body             body(functions);
      PointGroups<Lanes>     groups;
      groups.reinit(body.weights);
      std::set<std::pair<std::size_t, unsigned int>> places;
      for (std::size_t p = 0; p < body.points.n_points(); ++p)
        {
          const auto  lane  = groups.lane_of(p);
          const auto &group = groups[groups.group_of(p)];
          ASSERT_LT(groups.group_of(p), groups.size());
          ASSERT_LT(lane, group.n_points);
          places.emplace(groups.group_of(p), lane);
          EXPECT_EQ(group.base, body.weights[p].base);
          for (unsigned int d = 0; d < 3; ++d)
            for (unsigned int i = 0; i < 3; ++i)
              {
                EXPECT_NEAR(group.value[d][i][lane],
                            body.weights[p].value[d][i],
                            epsilon<Lanes>);
                EXPECT_NEAR(group.gradient[d][i][lane],
                            body.weights[p].gradient[d][i],
                            epsilon<Lanes> / h);
              }
        }
      EXPECT_EQ(places.size(), body.points.n_points());
      unsigned int n_full = 0, n_points = 0, n_empty_lanes = 0;
      for (std::size_t g = 0; g < groups.size(); ++g)
        {
          n_full += groups[g].n_points == n;
          n_points += groups[g].n_points;
          for (unsigned int lane = groups[g].n_points; lane < n; ++lane)
            {
              ++n_empty_lanes;
              EXPECT_EQ(groups[g].value[0][1][lane], 0.);
              EXPECT_EQ(groups[g].gradient[2][0][lane], 0.);
            }
        }
      EXPECT_EQ(n_points, body.points.n_points());
      EXPECT_GE(n_full, 2u);
      EXPECT_GT(n_empty_lanes, 10u);
    }


    template <typename Lanes>
    void
    check_stencil(const ShapeFunctions functions)
    {
      using Number                = typename LaneTraits<Lanes>::Number;
      constexpr unsigned int    n = LaneTraits<Lanes>::n;
      const Body                body(functions);
      const GroupStencil<Lanes> stencil(body.grid);
      const CentreStencil<3>    one(body.grid);
      PointGroups<Lanes>        groups;
      groups.reinit(body.weights);
      const std::vector<Number> u(body.u.begin(), body.u.end());

      // Any shares will do.
      Lattice::Random                    number(4);
      std::vector<std::array<double, 3>> first(body.points.n_points());
      std::vector<std::array<Lanes, 3>>  all_first(groups.size());
      for (std::size_t p = 0; p < first.size(); ++p)
        for (unsigned int d = 0; d < 3; ++d)
          {
            first[p][d] = number(0., 1.);
            all_first[groups.group_of(p)][d][groups.lane_of(p)] = first[p][d];
          }
      const auto centre_of = [&](const std::size_t g) {
        return GroupCentreWeights<Lanes>(all_first[g]);
      };

      // Gradients and mean dilatations.
      const double tolerance = 10. * epsilon<Lanes> / h;
      double       H[3][3];
      for (std::size_t p = 0; p < body.points.n_points(); ++p)
        {
          const auto            &w = body.weights[p];
          const CentreWeights<3> centre(first[p]);
          const double mean  = one.gradient(w, centre, body.u.data(), H);
          const auto  &group = groups[groups.group_of(p)];
          const auto   lane  = groups.lane_of(p);
          Lanes        all[9];
          stencil.gradient(group, u.data(), all);
          for (unsigned int a = 0; a < 9; ++a)
            EXPECT_NEAR(all[a][lane], H[a / 3][a % 3], tolerance);
          EXPECT_NEAR(stencil.mean_dilatation(group,
                                              centre_of(groups.group_of(p)),
                                              u.data())[lane],
                      mean,
                      tolerance);
        }

      // The forces of random stresses, with and without a mean part.
      Lattice::Random           random(8);
      std::vector<Tensor<2, 3>> P;
      std::vector<double>       q;
      for (std::size_t p = 0; p < body.points.n_points(); ++p)
        {
          P.push_back(random.matrix<3>(-1., 1.));
          q.push_back(random(-1., 1.));
        }
      for (const double share : {0., 1.})
        {
          std::vector<double> expected(u.size());
          for (std::size_t p = 0; p < P.size(); ++p)
            one.scatter(body.weights[p],
                        CentreWeights<3>(first[p]),
                        P[p],
                        share * q[p],
                        expected.data());
          std::vector<Number> force(u.size());
          for (std::size_t g = 0; g < groups.size(); ++g)
            {
              Lanes P_g[9] = {}, q_g = {};
              for (std::size_t p = 0; p < P.size(); ++p)
                if (groups.group_of(p) == g)
                  {
                    const auto lane = groups.lane_of(p);
                    for (unsigned int a = 0; a < 9; ++a)
                      P_g[a][lane] = P[p][a / 3][a % 3];
                    q_g[lane] = q[p];
                  }
              if (share == 0.)
                stencil.scatter(groups[g], P_g, force.data());
              else
                stencil.scatter(
                  groups[g], centre_of(g), P_g, q_g, force.data());
            }
          double largest = 0.;
          for (std::size_t dof = 0; dof < u.size(); ++dof)
            {
              EXPECT_NEAR(force[dof], expected[dof], 5. * tolerance) << dof;
              largest = std::max(largest, std::abs(expected[dof]));
            }
          EXPECT_GT(largest, 1. / h);
        }

      // Sums over the lanes, each where it belongs.
      Lanes v[n];
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int lane = 0; lane < n; ++lane)
          v[i][lane] = 1 << (i == lane ? i : 0);
      const Lanes sums = sums_over_lanes(v);
      for (unsigned int i = 0; i < n; ++i)
        EXPECT_EQ(sums[i], n - 1 + (1 << i));
    }
  } // namespace


  TEST(PointGroups, hold_every_point_once_with_its_weights)
  {
    for (const auto functions : {ShapeFunctions::gimp, ShapeFunctions::linear})
      {
        check_partition<SingleLanes>(functions);
        check_partition<DoubleLanes>(functions);
      }
  }


  TEST(PointGroups, gather_and_scatter_as_single_points_do)
  {
    for (const auto functions : {ShapeFunctions::gimp, ShapeFunctions::linear})
      {
        check_stencil<SingleLanes>(functions);
        check_stencil<DoubleLanes>(functions);
      }
  }


  TEST(PointGroups, follow_points_that_move_away)
  {
    Body                     body(ShapeFunctions::gimp);
    PointGroups<SingleLanes> groups;
    groups.reinit(body.weights);
    const std::size_t before = groups.size();
    // All in one cell, and fewer of them.
    MaterialPoints<3> few = Lattice::box(Point<3>(0.52, 0.52, 0.52), 2, 0.05);
    body.weights.reinit(few);
    groups.reinit(body.weights);
    EXPECT_GT(before, 10u);
    ASSERT_EQ(groups.size(), 1u);
    EXPECT_EQ(groups[0].n_points, 8u);
  }
} // namespace mapping_point_groups
