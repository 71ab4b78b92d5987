// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/measures/moved_soil.h>
#include <waker/particles/material_points.h>

#include <algorithm>
#include <limits>

namespace Waker
{
  namespace
  {
    /// Soil has moved when it is further from its place than this (m).
    constexpr double moved_distance = 0.5;


    /// Of the body along z (m); 1 in 2D, where volumes are per metre.
    template <int dim>
    double
    body_length(const MaterialPoints<dim> &points)
    {
      if constexpr (dim == 2)
        return 1.;
      else
        {
          double first = std::numeric_limits<double>::max(), last = -first;
          for (std::size_t q = 0; q < points.n_points(); ++q)
            {
              const double z    = points.initial_position[q][2];
              const double half = points.half_size[q][2];
              first             = std::min(first, z - half);
              last              = std::max(last, z + half);
            }
          return last - first;
        }
    }
  } // namespace


  template <int dim>
  MovedSoil
  moved_soil(const MaterialPoints<dim> &points, const bool positive)
  {
    MovedSoil    moved;
    double       volume = 0.;
    const double sign   = positive ? 1. : -1.;
    for (std::size_t q = 0; q < points.n_points(); ++q)
      {
        const Tensor<1, dim> u =
          points.position[q] - points.initial_position[q];
        if (sign * u[0] > moved_distance)
          {
            volume += points.volume[q];
            moved.dx += points.volume[q] * u[0];
            moved.dy += points.volume[q] * u[1];
          }
      }
    if (volume > 0.)
      {
        moved.area = volume / body_length(points);
        moved.dx /= volume;
        moved.dy /= volume;
      }
    return moved;
  }


  template MovedSoil
  moved_soil(const MaterialPoints<2> &, const bool);
  template MovedSoil
  moved_soil(const MaterialPoints<3> &, const bool);
} // namespace Waker
