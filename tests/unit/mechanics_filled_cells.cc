// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/mapping/centre_stencil.h>
#include <waker/materials/linear_elastic.h>
#include <waker/mechanics/step_motion.h>
#include <waker/mechanics/stress_update.h>

#include "mapping_lattice.h"
#include "mean_dilatation.h"
#include "user_errors.h"
#include <gtest/gtest.h>

namespace mechanics_filled_cells
{
  // Where B-bar acts: in cells that soil fills.

  using namespace Waker;
  using namespace MeanDilatation;

  namespace
  {
    /// Two cells a side that soil fills, and one point in the corner of the
    /// cell above: 1 / 2^dim of it.
    template <int dim>
    MaterialPoints<dim>
    block_with_crumb()
    {
      Point<dim> x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = h;
      MaterialPoints<dim> points = Lattice::box(x, 4, 0.5 * h);
      x                          = points.position[0];
      x[1] += 2. * h;
      Lattice::add_point(points, x, std::pow(0.5 * h, dim), 0.25 * h);
      return points;
    }


    template <int dim>
    void
    check_shares()
    {
      const BackgroundGrid<dim> grid(Lattice::grid<dim>(1.5, h));
      Weights<dim>              weights(grid, ShapeFunctions::gimp);
      MaterialPoints<dim>       points = block_with_crumb<dim>();
      const std::size_t         crumb  = points.n_points() - 1;
      FilledCells<dim>          share;
      weights.reinit(points);
      share.reinit(points, weights);
      for (std::size_t p = 0; p < crumb; ++p)
        EXPECT_NEAR(share[p], 1., 1e-12);
      EXPECT_EQ(share[crumb], 0.);
      FilledCells<dim> all(BBarCells::all);
      all.reinit(points, weights);
      EXPECT_EQ(all[crumb], 1.);

      // 7/16 of a cell, and a domain of which 3/4 are in a full cell below.
      points.volume[crumb] = 0.4375 * std::pow(h, dim);
      share.reinit(points, weights);
      EXPECT_NEAR(share[crumb], 0.5, 1e-12);
      points.volume[crumb] = std::pow(0.5 * h, dim);
      points.position[crumb][1] -= 0.375 * h;
      weights.reinit(points);
      share.reinit(points, weights);
      EXPECT_NEAR(share[crumb], 0.5, 1e-12);
    }


    /// The tests of forces and tangents need points with a part of B-bar.
    template <int dim>
    void
    check_shares_between(const ShapeFunctions functions)
    {
      const SampleBody<dim> body(functions, 0.3);
      FilledCells<dim>      share;
      share.reinit(body.points, body.weights);
      unsigned int between = 0, full = 0;
      for (std::size_t p = 0; p < share.size(); ++p)
        {
          between += share[p] > 0.01 && share[p] < 0.99;
          full += share[p] == 1.;
        }
      EXPECT_GT(between, 2u);
      EXPECT_GT(full, 2u);
    }


    /// At the upper corner of the grid stencils are moved by a node.
    template <int dim>
    void
    check_shares_in_the_corner(const ShapeFunctions functions)
    {
      const BackgroundGrid<dim> grid(Lattice::grid<dim>(1.5, h));
      Weights<dim>              weights(grid, functions);
      Point<dim>                x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = grid.origin()[d] + (grid.n_nodes_per_direction()[d] - 1 - 2) * h;
      const MaterialPoints<dim> points = Lattice::box(x, 4, 0.5 * h);
      FilledCells<dim>          share;
      weights.reinit(points);
      share.reinit(points, weights);
      for (std::size_t p = 0; p < points.n_points(); ++p)
        EXPECT_NEAR(share[p], 1., 1e-12);
    }


    /// A uniform pressure pushes on the nodes of a crumb as it does with the
    /// standard gradients: the surface's integral of S_i n, which is what water
    /// in front of it gives back.
    template <int dim>
    void
    check_crumb_under_water()
    {
      const BackgroundGrid<dim> grid(Lattice::grid<dim>(1.5, h));
      Weights<dim>              weights(grid, ShapeFunctions::gimp);
      MaterialPoints<dim>       points = block_with_crumb<dim>();
      weights.reinit(points);
      for (auto &stress : points.stress)
        stress = -30. * unit_symmetric_tensor<3>();
      NodalVector               b_bar(grid.n_dofs()), standard(grid.n_dofs());
      MeanDilatationMotion<dim> motion(false);
      motion.start(points, weights);
      motion.add_force_of_stress(points, weights, b_bar);
      StepMotion<dim>(false).add_force_of_stress(points, weights, standard);
      const double size = standard.linfty_norm();
      b_bar -= standard;
      EXPECT_LT(b_bar.linfty_norm(), 1e-12 * size);

      // In all cells it is not.
      MeanDilatationMotion<dim> thesis(false, BBarCells::all);
      thesis.start(points, weights);
      b_bar = 0.;
      thesis.add_force_of_stress(points, weights, b_bar);
      b_bar -= standard;
      EXPECT_GT(b_bar.linfty_norm(), 0.01 * size);
    }


    /// A block at the right face of the box that reaches beyond it by a part e
    /// of a cell, with a pressure that grows with depth. The largest force
    /// along their faces on nodes that only these cells have.
    template <int dim>
    double
    force_behind_the_face(const double e, const BBarCells cells)
    {
      const BackgroundGrid<dim> grid(Lattice::grid<dim>(3. * h, h));
      Weights<dim>              weights(grid, ShapeFunctions::gimp);
      Point<dim>                x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = h;
      MaterialPoints<dim> points = Lattice::box(x, 4, 0.5 * h);
      for (std::size_t p = 0; p < points.n_points(); ++p)
        {
          points.stress[p] =
            -10. * (4. - points.position[p][1]) * unit_symmetric_tensor<3>();
          points.position[p][0] += e * h;
        }
      weights.reinit(points);
      NodalVector               force(grid.n_dofs());
      MeanDilatationMotion<dim> motion(false, cells);
      motion.start(points, weights);
      motion.add_force_of_stress(points, weights, force);
      double largest = 0.;
      for (unsigned int i = 0; i < grid.n_nodes(); ++i)
        if (grid.node_position(i)[0] > 3.5 * h)
          for (unsigned int c = 1; c < dim; ++c)
            largest =
              std::max(largest, std::abs(force.local_element(dim * i + c)));
      return largest;
    }
  } // namespace


  TEST(Mechanics, b_bar_pushes_nodes_behind_a_face_no_more_than_their_mass)
  {
    // That mass is in proportion to the square of what reaches there.
    for (const double e : {1e-3, 1e-5})
      {
        EXPECT_LT(force_behind_the_face<2>(e, BBarCells::filled), 10. * e * e);
        EXPECT_LT(force_behind_the_face<3>(e, BBarCells::filled), 10. * e * e);
        // Everywhere it does.
        EXPECT_GT(force_behind_the_face<2>(e, BBarCells::all), 0.1 * e);
        EXPECT_GT(force_behind_the_face<3>(e, BBarCells::all), 0.1 * e);
      }
  }


  TEST(Mechanics, b_bar_at_a_free_surface_in_the_box_counts_its_centres)
  {
    // The block of before in a larger box: what is right of it is inside.
    const BackgroundGrid<2> grid(Lattice::grid<2>(2.5, h));
    Weights<2>              weights(grid, ShapeFunctions::gimp);
    MaterialPoints<2>       points = Lattice::box(Point<2>(h, h), 4, 0.5 * h);
    for (Point<2> &x : points.position)
      x[0] += 0.01 * h;
    weights.reinit(points);
    FilledCells<2> filled;
    filled.reinit(points, weights);
    unsigned int n_across = 0;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const auto plain = CentreWeights<2>::shares(weights[p], h);
        EXPECT_EQ(filled.first_shares(p), plain);
        n_across += plain[0] > 0. && plain[0] < 1.;
      }
    EXPECT_GT(n_across, 0u);
  }


  TEST(Mechanics, b_bar_acts_where_soil_fills_the_cells)
  {
    check_shares<2>();
    check_shares<3>();
    // With linear functions a point counts in one cell only.
    check_shares_between<2>(ShapeFunctions::gimp);
    check_shares_between<3>(ShapeFunctions::gimp);
    for (const auto functions : {ShapeFunctions::gimp, ShapeFunctions::linear})
      {
        check_shares_in_the_corner<2>(functions);
        check_shares_in_the_corner<3>(functions);
      }
  }


  TEST(Mechanics, b_bar_leaves_a_crumb_under_water_in_balance)
  {
    check_crumb_under_water<2>();
    check_crumb_under_water<3>();
  }
} // namespace mechanics_filled_cells
