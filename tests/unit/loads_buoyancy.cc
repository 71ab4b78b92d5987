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

namespace loads_buoyancy
{
  using namespace Waker;
  using namespace Buoyancy;

  namespace
  {
    // A ball of support domains on a lattice that lies anywhere.
    template <int dim>
    MaterialPoints<dim>
    ball(const double s, std::mt19937 &random)
    {
      std::uniform_real_distribution<double> uniform(-0.5, 0.5);
      Point<dim>                             shift;
      for (unsigned int d = 0; d < dim; ++d)
        shift[d] = uniform(random);
      const int           n     = std::ceil(1. / s) + 1;
      const int           n_all = std::lround(std::pow(2 * n + 1, dim));
      MaterialPoints<dim> points;
      for (int k = 0; k < n_all; ++k)
        {
          Point<dim>     x;
          Tensor<1, dim> half_size;
          int            rest = k;
          for (unsigned int d = 0; d < dim; ++d, rest /= 2 * n + 1)
            {
              x[d]         = s * (rest % (2 * n + 1) - n + shift[d]);
              half_size[d] = s / 2;
            }
          if (x.norm() > 1.)
            continue;
          points.id.push_back(points.id.size());
          points.position.push_back(x);
          points.half_size.push_back(half_size);
          points.volume.push_back(std::pow(s, dim));
        }
      return points;
    }


    template <int dim>
    void
    check_contour(const double h, const int n_positions)
    {
      Point<dim> lower, upper;
      for (unsigned int d = 0; d < dim; ++d)
        {
          lower[d] = -2.;
          upper[d] = 2.;
        }
      const BackgroundGrid<dim> grid(lower, upper, h, MPI_COMM_SELF);
      DomainContour<dim>        contour(grid, SurfaceParameters(), 0);
      WaterParameters           parameters;
      parameters.side        = WaterSide::right;
      parameters.unit_weight = gamma_w;

      std::mt19937                           random(dim);
      std::uniform_real_distribution<double> uniform(-0.7, 0.7);
      for (int k = 0; k < n_positions; ++k)
        {
          const auto points = ball<dim>(h / 2, random);
          for (const double level : {1.9, uniform(random)})
            {
              parameters.level = level;
              StandingWater<dim> load(grid, parameters);
              if constexpr (dim == 2)
                {
                  Surface surface;
                  contour.detect(points, surface);
                  load.find(surface);
                }
              else
                {
                  Facets<3> surface;
                  contour.detect(points, surface);
                  load.find(surface);
                }

              // What of the domains lies below the level.
              double       volume = 0.;
              Tensor<1, 3> moment;
              for (std::size_t p = 0; p < points.n_points(); ++p)
                {
                  const Point<dim> &x = points.position[p];
                  const double      s = 2. * points.half_size[p][1];
                  const double      share =
                    std::min(std::max(level - x[1] + s / 2, 0.), s) / s;
                  volume += share * points.volume[p];
                  moment += share * gamma_w * points.volume[p] *
                            cross_product_3d(
                              in_space(x[0], 0., dim == 3 ? x[dim - 1] : 0.),
                              in_space(0., 1.));
                }
              const Lift lift = exact_lift(load);
              ASSERT_NEAR(lift.force[1], gamma_w * volume, 1e-10);
              ASSERT_NEAR(lift.force[0], 0., 1e-10);
              ASSERT_NEAR(lift.force[2], 0., 1e-10);
              ASSERT_LT((lift.moment - moment).norm(), 1e-10);
            }
        }
    }
  } // namespace


  // On the contour of the support domains it is the weight of the water in the
  // place of the domains: exact.
  TEST(Loads, buoyancy_on_the_contour)
  {
    check_contour<2>(0.2, 50);
    check_contour<3>(0.25, 10);
  }
} // namespace loads_buoyancy
