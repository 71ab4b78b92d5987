// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/mixed_cells.h>
#include <waker/simulation/plausibility.h>
#include <waker/simulation/run_to_end.h>

#include "named.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>

namespace mechanics_mixed_cells
{
  // A level column of two layers, 300 kPa over 1000 kPa, 6 m deep and 3 m wide,
  // with cells of 0.5 m: the joint lies at different heights of a cell.

  using namespace Waker;

  namespace
  {
    constexpr double unit_weight = 15.; // kN/m^3
    constexpr double height      = 6.;  // m


    MaterialParameters
    clay(const std::string &name, const double stiffness)
    {
      MaterialParameters material;
      material.name                        = name;
      material.unit_weight                 = unit_weight;
      material.elastic.youngs_modulus      = stiffness;
      material.elastic.poissons_ratio      = 0.45;
      material.von_mises.initial_strength  = "14";
      material.von_mises.residual_strength = "14";
      material.von_mises.softening_modulus = 0.;
      return material;
    }


    Parameters
    column(const double joint, const double ratio = 10. / 3.)
    {
      Parameters p;
      p.grid.lower_corner = {0., 0.};
      p.grid.upper_corner = {3., 6.5};
      p.grid.cell_size    = 0.5;
      p.materials         = {clay("lower", 300. * ratio), clay("upper", 300.)};
      const std::string y = std::to_string(joint);
      LayerParameters   lower, upper;
      lower.name     = "lower";
      lower.material = "lower";
      lower.polygon  = "0, 0; 3, 0; 3, " + y + "; 0, " + y;
      upper.name     = "upper";
      upper.material = "upper";
      upper.polygon  = "0, " + y + "; 3, " + y + "; 3, 6; 0, 6";
      p.layers       = {lower, upper};
      for (const char *const region : {"bottom", "left", "right"})
        {
          FixityParameters fixity;
          fixity.name   = region;
          fixity.region = Named{region};
          fixity.type   = std::string(region) == "bottom" ? FixityType::fixed
                                                          : FixityType::roller;
          p.fixities.push_back(fixity);
        }
      p.time.ramp_duration = 0.;
      return p;
    }


    double
    largest_error(const MaterialPoints<2> &points)
    {
      double largest = 0.;
      for (std::size_t q = 0; q < points.n_points(); ++q)
        {
          const double overburden =
            -unit_weight * (height - points.initial_position[q][1]);
          largest =
            std::max(largest, std::abs(points.stress[q][1][1] - overburden));
        }
      return largest;
    }
  } // namespace


  // Stiffnesses are no part of the in-situ stress of level ground: it is that
  // of a column of one material, wherever the joint lies.
  TEST(MixedCells, level_ground_starts_from_its_overburden)
  {
    const double uniform =
      largest_error(Case<2>(column(3., 1.), MPI_COMM_SELF).initial_points);
    // A cell has one stress: a quarter of its height is the least error.
    EXPECT_LT(uniform, 1.05 * unit_weight * 0.125);
    for (const double joint : {3., 3.125, 3.25, 3.375})
      {
        // A joint inside a sub-cell leaves points of parts of it whose support
        // domains are whole ones: what that does at equal stiffness is no
        // matter of mixing.
        const double equal = largest_error(
          Case<2>(column(joint, 1.), MPI_COMM_SELF).initial_points);
        EXPECT_LT(equal, 1.3 * unit_weight * 0.25) << joint;
        for (const double ratio : {1., 10. / 3., 100.})
          {
            const Case<2> the_case(column(joint, ratio), MPI_COMM_SELF);
            const double  error = largest_error(the_case.initial_points);
            // The stress of such points is not quite uniform, and the more
            // the stiffnesses differ, the more that counts.
            EXPECT_LT(error, (ratio < 10. ? 1.1 : 1.25) * equal)
              << joint << ", " << ratio;
          }
      }
  }


  // It is in balance: the column stays at rest, and nothing yields.
  TEST(MixedCells, level_ground_stays_at_rest)
  {
    for (const double joint : {3., 3.25})
      {
        Parameters p    = column(joint);
        p.time.end_time = 1.;
        p.stop.at_rest  = false;
        const Case<2>  the_case(p, MPI_COMM_SELF);
        State<2>       state = initial_state(the_case);
        Realisation<2> realisation(the_case, state);
        run_to_end(realisation);
        double furthest = 0., plastic = 0.;
        for (std::size_t q = 0; q < state.points.n_points(); ++q)
          furthest = std::max(furthest,
                              state.points.position[q].distance(
                                state.points.initial_position[q]));
        for (const double strain : state.points.scalar("plastic strain"))
          plastic = std::max(plastic, strain);
        EXPECT_LT(furthest, 1e-3) << joint;
        EXPECT_EQ(plastic, 0.) << joint;
      }
  }


  TEST(MixedCells, are_counted_with_their_ratio)
  {
    const Case<2>     aligned(column(3.), MPI_COMM_SELF);
    const MixedCells &none = aligned.gravity_report.mixed_cells;
    EXPECT_EQ(none.n_cells, 0u);
    EXPECT_EQ(none.n_points, 0u);
    EXPECT_EQ(none.ratio, 1.);
    EXPECT_TRUE(strange_things(aligned).empty());

    const Case<2>     crossed(column(3.25), MPI_COMM_SELF);
    const MixedCells &cells = crossed.gravity_report.mixed_cells;
    EXPECT_EQ(cells.n_cells, 6u);
    EXPECT_EQ(cells.n_points, 24u);
    EXPECT_NEAR(cells.ratio, 10. / 3., 1e-12);
    const auto warnings = strange_things(crossed);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find(
                "24 points lie in 6 cells of two stiffnesses, up "
                "to 3.33333 times apart"),
              std::string::npos)
      << warnings[0];
  }


  // Harmonic means by volume; the points' own materials stay what they are.
  TEST(MixedCells, get_the_stiffness_of_layers_in_series)
  {
    const Case<2> the_case(column(3.125), MPI_COMM_SELF);
    const double  K_lower = the_case.materials[0]->bulk_modulus();
    const double  K_upper = the_case.materials[1]->bulk_modulus();
    const double  K_mixed = 1. / (0.25 / K_lower + 0.75 / K_upper);
    for (const ShapeFunctions functions :
         {ShapeFunctions::linear, ShapeFunctions::gimp})
      {
        const ElasticMixture mixture = elastic_mixture(the_case.materials,
                                                       the_case.grid,
                                                       functions,
                                                       the_case.initial_points);
        for (std::size_t q = 0; q < the_case.initial_points.n_points(); ++q)
          {
            const double y = the_case.initial_points.position[q][1];
            EXPECT_EQ(the_case.initial_points.material[q], y < 3.125 ? 0u : 1u);
            // The lowest domain in the mixed cell, 0.25 m around 3.0625 m, lies
            // for a quarter in the cell below.
            const double below =
              functions == ShapeFunctions::gimp && y > 3. && y < 3.125 ? 0.25
                                                                       : 0.;
            const double expected =
              y < 3.    ? K_lower
              : y > 3.5 ? K_upper
                        : 1. / (below / K_lower + (1. - below) / K_mixed);
            EXPECT_NEAR(mixture.materials[mixture.of_point[q]]->bulk_modulus(),
                        expected,
                        1e-9 * K_lower)
              << y;
          }
      }
  }
} // namespace mechanics_mixed_cells
