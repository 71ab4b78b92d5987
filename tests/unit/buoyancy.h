// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_buoyancy_h
#define waker_tests_buoyancy_h

#include <waker/surface/domain_contour.h>
#include <waker/surface/proximity_field.h>

#include "standing_water.h"
#include "verification_data.h"
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

/// The lift of bodies in water, and what they displace.
namespace Buoyancy
{
  using namespace Waker;

  constexpr double gamma_w = 9.81;


  inline Tensor<1, 3>
  in_space(const double x, const double y, const double z = 0.)
  {
    Tensor<1, 3> a;
    a[0] = x;
    a[1] = y;
    a[2] = z;
    return a;
  }


  // Volume and first moment of what lies below the water, not from the
  // formula of the pressure: div (x, 0, 0) = 1. The water's surface has n_x =
  // 0.
  struct Displaced
  {
    double       volume = 0.;
    Tensor<1, 3> first;
  };


  inline Displaced
  displaced_by(const Facets<2> &wetted)
  {
    Displaced sum;
    for (const Facet<2> &s : wetted)
      {
        // Simpson's rule, exact for the quadratics.
        const Point<2> &from = s.vertices[0];
        const Point<2> &to   = s.vertices[1];
        const double    n    = s.normal[0] * from.distance(to);
        for (const auto &[t, w] : {std::pair<double, double>(0., 1. / 6),
                                   std::pair<double, double>(0.5, 4. / 6),
                                   std::pair<double, double>(1., 1. / 6)})
          {
            const Point<2> x = from + t * (to - from);
            sum.volume += w * n * x[0];
            sum.first += w * n * in_space(x[0] * x[0] / 2, x[0] * x[1]);
          }
      }
    return sum;
  }


  inline Displaced
  displaced_by(const Facets<3> &wetted)
  {
    Displaced sum;
    for (const Facet<3> &facet : wetted)
      for (unsigned int k = 0; k < 3; ++k)
        {
          // The mid-points of the sides, exact for the quadratics.
          const Point<3> x =
            facet.vertices[k] +
            0.5 * (facet.vertices[(k + 1) % 3] - facet.vertices[k]);
          const double n = facet.normal[0] * facet.measure() / 3.;
          sum.volume += n * x[0];
          sum.first += n * in_space(x[0] * x[0] / 2, x[0] * x[1], x[0] * x[2]);
        }
    return sum;
  }


  // The whole lift, and the moments.
  struct Lift
  {
    Tensor<1, 3> force, moment;
  };


  inline Lift
  exact_lift(const StandingWater<2> &load)
  {
    const WaterResultant r = load.resultant();
    return {in_space(r.force[0], r.force[1]), in_space(0., 0., r.moment)};
  }


  inline Lift
  exact_lift(const StandingWater<3> &load)
  {
    const SpatialResultant r = load.spatial_resultant();
    return {r.force, r.moment};
  }


  template <int dim>
  inline Lift
  nodal_lift(const BackgroundGrid<dim> &grid, const NodalVector &force)
  {
    Lift sum;
    for (unsigned int i = 0; i < grid.n_nodes(); ++i)
      {
        Tensor<1, 3> x, f;
        for (unsigned int d = 0; d < dim; ++d)
          {
            x[d] = grid.node_position(i)[d];
            f[d] = force.begin()[dim * i + d];
          }
        sum.force += f;
        sum.moment += cross_product_3d(x, f);
      }
    return sum;
  }
} // namespace Buoyancy

#endif
