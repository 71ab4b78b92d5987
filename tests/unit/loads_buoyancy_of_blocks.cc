// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/surface/domain_contour.h>
#include <waker/surface/proximity_field.h>

#include "buoyancy.h"
#include "standing_water.h"
#include "verification_data.h"
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace loads_buoyancy_of_blocks
{
  using namespace Waker;
  using namespace Buoyancy;

  namespace
  {
    // A block 1.6 x 1 (x 1.3) of points at a place and turned by an angle, in
    // 3D about a random axis; its points lie on its own lattice.
    MaterialPoints<2>
    turned_block(const Point<2> &centre, const double s, std::mt19937 &random)
    {
      const double angle =
        std::uniform_real_distribution<double>(0., 2 * numbers::PI)(random);
      MaterialPoints<2> points;
      for (double y = -0.5 + s / 2; y < 0.5; y += s)
        for (double x = -0.8 + s / 2; x < 0.8; x += s)
          {
            points.id.push_back(points.id.size());
            points.position.emplace_back(centre[0] + std::cos(angle) * x -
                                           std::sin(angle) * y,
                                         centre[1] + std::sin(angle) * x +
                                           std::cos(angle) * y);
            points.volume.push_back(s * s);
          }
      return points;
    }


    MaterialPoints<3>
    turned_block(const Point<3> &centre, const double s, std::mt19937 &random)
    {
      std::normal_distribution<double> normal;
      const Eigen::Matrix3d            R = Eigen::Quaterniond(normal(random),
                                                   normal(random),
                                                   normal(random),
                                                   normal(random))
                                  .normalized()
                                  .toRotationMatrix();
      MaterialPoints<3> points;
      for (double z = -0.65 + s / 2; z < 0.65; z += s)
        for (double y = -0.5 + s / 2; y < 0.5; y += s)
          for (double x = -0.8 + s / 2; x < 0.8; x += s)
            {
              const Eigen::Vector3d r = R * Eigen::Vector3d(x, y, z);
              points.id.push_back(points.id.size());
              points.position.emplace_back(centre[0] + r[0],
                                           centre[1] + r[1],
                                           centre[2] + r[2]);
              points.volume.push_back(s * s * s);
            }
      return points;
    }


    // Mass of the nodes, with linear functions.
    template <int dim>
    std::vector<double>
    masses(const BackgroundGrid<dim> &grid, const MaterialPoints<dim> &points)
    {
      std::vector<double> mass(grid.n_nodes(), 0.);
      for (std::size_t p = 0; p < points.n_points(); ++p)
        {
          const auto cell = grid.cell_index(points.position[p]);
          for (unsigned int i = 0; i < (1u << dim); ++i)
            {
              auto   index = cell;
              double N     = 1.;
              for (unsigned int d = 0; d < dim; ++d)
                {
                  index[d] += i >> d & 1u;
                  N *=
                    1. - std::abs((points.position[p][d] - grid.origin()[d]) /
                                    grid.cell_size() -
                                  index[d]);
                }
              mass[grid.node(index)] += N * points.volume[p];
            }
        }
      return mass;
    }


    // @param rms root mean square error of the detected volume
    template <int dim>
    void
    check_blocks(const double h, const int n_positions, double &rms)
    {
      Point<dim> lower, upper;
      for (unsigned int d = 0; d < dim; ++d)
        {
          lower[d] = -2.;
          upper[d] = 2.;
        }
      const BackgroundGrid<dim> grid(lower, upper, h, MPI_COMM_SELF);
      ProximityField<dim>       field(grid, SurfaceParameters(), 0);
      WaterParameters           parameters;
      parameters.side        = WaterSide::left;
      parameters.unit_weight = gamma_w;

      std::mt19937                           random(dim);
      std::uniform_real_distribution<double> uniform(-1., 1.);
      NodalVector                            force(grid.n_dofs());
      double                                 mean = 0., square = 0.;
      unsigned int                           n_floating = 0;
      for (int k = 0; k < n_positions; ++k)
        {
          Point<dim> centre;
          for (unsigned int d = 0; d < dim; ++d)
            centre[d] = h * uniform(random);
          const auto points = turned_block(centre, h / 2, random);

          // Under water, then floating.
          for (const double level : {1.9, 0.6 * uniform(random)})
            {
              parameters.level = level;
              StandingWater<dim> load(grid, parameters);
              Displaced          displaced;
              double             detected_volume;
              if constexpr (dim == 2)
                {
                  Surface surface;
                  field.detect(points, surface);
                  load.find(surface);
                  displaced       = displaced_by(load.segments());
                  detected_volume = surface.chains[0].area();
                }
              else
                {
                  Facets<3> surface;
                  field.detect(points, surface);
                  load.find(surface);
                  displaced       = displaced_by(load.facets());
                  detected_volume = enclosed_volume(surface);
                }
              const double weight = gamma_w * displaced.volume;
              if (level == 1.9)
                {
                  ASSERT_NEAR(displaced.volume, detected_volume, 1e-12);
                  double volume = 0.;
                  for (const double v : points.volume)
                    volume += v;
                  const double error = detected_volume / volume - 1.;
                  mean += error / n_positions;
                  square += error * error / n_positions;
                }
              else
                {
                  ASSERT_LE(displaced.volume, detected_volume + 1e-12);
                  n_floating +=
                    std::abs(displaced.volume / detected_volume - 0.5) < 0.45;
                }

              // Upwards, through the centre of what is displaced.
              const Lift lift = exact_lift(load);
              const auto moment =
                gamma_w * cross_product_3d(displaced.first, in_space(0., 1.));
              ASSERT_NEAR(lift.force[1], weight, 1e-11);
              ASSERT_NEAR(lift.force[0], 0., 1e-11);
              ASSERT_NEAR(lift.force[2], 0., 1e-11);
              ASSERT_LT((lift.moment - moment).norm(), 1e-11);

              force = 0.;
              load.add_nodal_forces(masses(grid, points),
                                    std::pow(h, dim),
                                    force);
              const Lift nodal = nodal_lift(grid, force);
              ASSERT_LT((nodal.force - lift.force).norm(), 1e-10);
              ASSERT_LT((nodal.moment - lift.moment).norm(), 1e-10);
            }
        }
      rms = std::sqrt(square);
      EXPECT_GT(n_floating, n_positions / 2u);
      Verification::row("surface_3d_block",
                        "dim,h_m,positions,mean,rms",
                        dim,
                        h,
                        n_positions,
                        mean,
                        rms);
    }
  } // namespace


  // Floating or submerged, anywhere and turned by any angle: the lift is the
  // weight of the water that the detected body displaces, through its centre.
  // The detected volume is that of the points within an error of second order:
  // edges and corners are rounded.
  TEST(Loads, buoyancy_of_turned_blocks)
  {
    double errors[2][3];
    double h = 0.25;
    for (int k = 0; k < 3; ++k, h /= 2)
      {
        check_blocks<2>(h, 100, errors[0][k]);
        check_blocks<3>(h, k < 2 ? 30 : 10, errors[1][k]);
      }
    for (const auto &error : errors)
      for (int k = 0; k < 2; ++k)
        EXPECT_NEAR(std::log2(error[k] / error[k + 1]), 2., 0.2);
    EXPECT_LT(errors[0][2], 0.004);
    EXPECT_LT(errors[1][2], 0.009);
  }
} // namespace loads_buoyancy_of_blocks
