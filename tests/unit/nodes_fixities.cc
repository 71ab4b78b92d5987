// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <waker/base/errors.h>
#include <waker/nodes/fixities.h>
#include <waker/nodes/fixity_conflicts.h>

#include "fixity_cases.h"
#include "named.h"
#include "user_errors.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace nodes_fixities
{
  using namespace Waker;
  using namespace FixityCases;

  TEST(Nodes, fixed_base_holds_the_margin)
  {
    const auto        grid = small_grid();
    const Fixities<2> fixities(grid, {fixity("bottom")});
    ASSERT_EQ(fixities.removed().size(), grid.n_dofs());
    for (unsigned int n = 0; n < grid.n_nodes(); ++n)
      for (unsigned int c = 0; c < 2; ++c)
        EXPECT_EQ(fixities.removed()[2 * n + c] == 1,
                  grid.node_position(n)[1] < 0.25);
    EXPECT_EQ(fixities.removed_list().size(), 2u * 2u * 7u);
    EXPECT_TRUE(std::is_sorted(fixities.removed_list().begin(),
                               fixities.removed_list().end()));
    EXPECT_TRUE(fixities.penalties().empty());
    EXPECT_EQ(fixities.closed_faces(), 4u);

    EXPECT_FALSE(fixities.has_prescribed_motion());
    std::vector<double> increments = {1., 2., 3.};
    fixities.removed_increments(1., 0.1, increments);
    EXPECT_EQ(increments, std::vector<double>(28, 0.));
  }


  TEST(Nodes, roller_holds_the_normal_component)
  {
    const auto        grid = small_grid();
    const Fixities<2> fixities(grid,
                               {fixity("right", "roller"),
                                fixity("top", "roller")});
    for (unsigned int n = 0; n < grid.n_nodes(); ++n)
      {
        EXPECT_EQ(fixities.removed()[2 * n] == 1,
                  grid.node_position(n)[0] > 2.75);
        EXPECT_EQ(fixities.removed()[2 * n + 1] == 1,
                  grid.node_position(n)[1] > 1.25);
      }
    EXPECT_EQ(fixities.closed_faces(), 2u | 8u);
  }


  TEST(Nodes, part_of_a_face)
  {
    const auto       grid = small_grid();
    FixityParameters f    = fixity("bottom");
    f.from                = {1.5 + 1e-8, 0.4}; // y does not count
    f.to                  = {2.5 - 1e-8, 1.};
    const Fixities<2> fixities(grid, {f});
    for (unsigned int n = 0; n < grid.n_nodes(); ++n)
      {
        const Point<2> x = grid.node_position(n);
        EXPECT_EQ(fixities.removed()[2 * n] == 1,
                  x[1] < 0.25 && x[0] > 1.25 && x[0] < 2.75);
      }
    EXPECT_EQ(fixities.closed_faces(), 0u);

    // Both parts together close the face; the margin beside it need not be
    // held.
    FixityParameters left = f, right = f;
    left.from  = {1., 0.};
    left.to    = {2., 0.};
    right.from = {2.5, 0.};
    right.to   = {3., 0.};
    EXPECT_EQ(Fixities<2>(grid, {left, right}).closed_faces(), 4u);
    right.to = {2.5, 0.};
    EXPECT_EQ(Fixities<2>(grid, {left, right}).closed_faces(), 0u);

    // Beside what is held an opening closes it, too: the soil does not end
    // there. A face that is open as a whole is not closed.
    OutletParameters outlet;
    outlet.face       = BoxFace::bottom;
    outlet.from       = {2.5, 0.};
    const auto opened = [&](const OutletParameters              &opening,
                            const std::vector<FixityParameters> &conditions) {
      Openings<2> openings(grid);
      openings.add(place_opening(grid, opening, ""));
      return Fixities<2>(grid, conditions, openings).closed_faces();
    };
    EXPECT_EQ(opened(outlet, {left, right}), 4u);
    outlet.from = {3., 0.};
    EXPECT_USER_ERROR(opened(outlet, {left}), "/To", "empty");
    outlet.from = {2., 0.};
    outlet.to   = {2.5, 0.};
    EXPECT_EQ(opened(outlet, {left}), 0u); // free from 2.5 m on
    outlet.from = outlet.to = {};
    EXPECT_EQ(opened(outlet, {}), 0u);
  }


  TEST(Nodes, box_of_nodes)
  {
    const auto       grid = small_grid();
    FixityParameters f    = fixity("box");
    f.from                = {1.5, 0.5};
    f.to                  = {2., 0.6};
    const Fixities<2> fixities(grid, {f});
    ASSERT_EQ(fixities.removed_list().size(), 4u);
    EXPECT_LT(grid.node_position(fixities.removed_list()[0] / 2)
                .distance(Point<2>(1.5, 0.5)),
              1e-12);
    EXPECT_LT(grid.node_position(fixities.removed_list()[3] / 2)
                .distance(Point<2>(2., 0.5)),
              1e-12);
  }


  TEST(Nodes, faces_in_3d)
  {
    const BackgroundGrid<3> grid(Point<3>(0., 0., 0.),
                                 Point<3>(2., 2., 1.),
                                 1.,
                                 MPI_COMM_SELF);
    const Fixities<3>       fixities(grid,
                               {fixity("bottom"),
                                      fixity("back", "roller"),
                                      fixity("front", "roller"),
                                      fixity("left", "roller")});
    for (unsigned int n = 0; n < grid.n_nodes(); ++n)
      {
        const Point<3> x    = grid.node_position(n);
        const bool     base = x[1] < 0.5;
        EXPECT_EQ(fixities.removed()[3 * n] == 1, base || x[0] < 0.5);
        EXPECT_EQ(fixities.removed()[3 * n + 1] == 1, base);
        EXPECT_EQ(fixities.removed()[3 * n + 2] == 1,
                  base || x[2] < 0.5 || x[2] > 0.5);
      }
    EXPECT_EQ(fixities.closed_faces(), 1u | 4u | 16u | 32u);
  }


  TEST(Nodes, penalty_gives_way_to_elimination)
  {
    const auto       grid   = small_grid();
    FixityParameters spring = fixity("left", "prescribed", "0.1*t; free");
    spring.method           = FixityMethod::penalty;
    spring.penalty_factor   = 500.;
    const Fixities<2> fixities(grid, {fixity("bottom"), spring});
    // Two columns of 6 nodes, less the two rows of the base.
    ASSERT_EQ(fixities.penalties().size(), 8u);
    for (const auto &p : fixities.penalties())
      {
        EXPECT_EQ(p.factor, 500.);
        EXPECT_EQ(p.dof % 2, 0u);
        EXPECT_EQ(fixities.removed()[p.dof], 0);
        const Point<2> x = grid.node_position(p.dof / 2);
        EXPECT_LT(x[0], 1.25);
        EXPECT_GT(x[1], 0.25);
      }
    EXPECT_EQ(fixities.closed_faces(), 4u);
    EXPECT_TRUE(fixities.has_prescribed_motion());

    // Springs at rest close a face as well, springs that move do not.
    FixityParameters base = fixity("bottom");
    base.method           = FixityMethod::penalty;
    EXPECT_EQ(Fixities<2>(grid, {base, spring}).closed_faces(), 4u);

    std::vector<double> increments;
    fixities.penalty_increments(2., 0.5, increments);
    ASSERT_EQ(increments.size(), 8u);
    for (const double u : increments)
      EXPECT_NEAR(u, 0.05, 1e-15);
    fixities.removed_increments(2., 0.5, increments);
    EXPECT_EQ(increments, std::vector<double>(28, 0.));
  }


  TEST(Nodes, prescribed_increments_follow_the_expression)
  {
    const auto        grid = small_grid();
    const Fixities<2> fixities(
      grid,
      {fixity("bottom"),
       fixity("top", "prescribed", "x*sin(pi*t); t^2 + y*t")});
    EXPECT_TRUE(fixities.has_prescribed_motion());
    EXPECT_EQ(fixities.closed_faces(), 4u); // the top moves

    const double        t = 0.3, dt = 0.2;
    std::vector<double> increments;
    fixities.removed_increments(t, dt, increments);
    ASSERT_EQ(increments.size(), fixities.removed_list().size());
    for (unsigned int i = 0; i < increments.size(); ++i)
      {
        const unsigned int dof = fixities.removed_list()[i];
        const Point<2>     x   = grid.node_position(dof / 2);
        double             u   = 0.;
        if (x[1] > 1.25 && dof % 2 == 0)
          u = x[0] * (std::sin(M_PI * (t + dt)) - std::sin(M_PI * t));
        if (x[1] > 1.25 && dof % 2 == 1)
          u = (t + dt) * (t + dt) - t * t + x[1] * dt;
        EXPECT_NEAR(increments[i], u, 1e-14);
      }
  }


  TEST(Nodes, later_condition_wins)
  {
    const auto             grid = small_grid();
    const FixityParameters slow = fixity("left", "prescribed", "t; 0");
    const FixityParameters fast = fixity("bottom", "prescribed", "2*t; 3*t");
    Fixities<2>            first(grid, {fast, slow});
    const Fixities<2>      fixities(std::move(first));
    std::vector<double>    increments;
    fixities.removed_increments(0., 1., increments);
    for (unsigned int i = 0; i < increments.size(); ++i)
      {
        const unsigned int dof  = fixities.removed_list()[i];
        const bool         left = grid.node_position(dof / 2)[0] < 1.25;
        EXPECT_NEAR(increments[i],
                    left ? (dof % 2 ? 0. : 1.) : (dof % 2 ? 3. : 2.),
                    1e-15);
      }

    // A displacement that never changes is no motion, and closes a face.
    const Fixities<2> still(grid, {fixity("left", "prescribed", "0; free")});
    EXPECT_FALSE(still.has_prescribed_motion());
    EXPECT_EQ(still.closed_faces(), 1u);
  }
} // namespace nodes_fixities
