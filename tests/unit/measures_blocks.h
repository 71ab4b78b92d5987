// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_measures_blocks_h
#define waker_tests_measures_blocks_h

#include <waker/measures/crest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace Waker
{
  /// Points of 0.25 m that fill a block from 0 to 10 m along x, 0 to 4 m in
  /// height, and in 3D 0 to 6 m along z: all numbers are exact.
  template <int dim>
  MaterialPoints<dim>
  block_of_points()
  {
    const unsigned int  nz = dim == 3 ? 24 : 1;
    MaterialPoints<dim> points;
    points.resize(40 * 16 * nz);
    for (std::size_t q = 0; q < points.n_points(); ++q)
      {
        Point<dim> x;
        x[0] = 0.125 + 0.25 * (q % 40);
        x[1] = 0.125 + 0.25 * (q / 40 % 16);
        if (dim == 3)
          x[dim - 1] = 0.125 + 0.25 * (q / 640);
        points.id[q]       = q;
        points.position[q] = points.initial_position[q] = x;
        points.volume[q]                                = std::pow(0.25, dim);
        for (unsigned int d = 0; d < dim; ++d)
          points.half_size[q][d] = 0.125;
      }
    return points;
  }


  /// The same points in another order.
  template <int dim>
  MaterialPoints<dim>
  shuffled(MaterialPoints<dim> points, const unsigned int seed)
  {
    std::vector<std::size_t> order(points.n_points());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    MaterialPoints<dim>::for_each_array(points, [&](const char *, auto &array) {
      if (array.empty())
        return;
      auto copy = array;
      for (std::size_t q = 0; q < order.size(); ++q)
        array[q] = copy[order[q]];
    });
    return points;
  }


  /// The crest of a block that falls towards +x.
  template <int dim>
  Crest<dim>
  crest_of(const MaterialPoints<dim> &points)
  {
    return Crest<dim>(points, 1, {});
  }
} // namespace Waker

#endif
