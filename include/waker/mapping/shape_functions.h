// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mapping_shape_functions_h
#define waker_mapping_shape_functions_h

#include <cmath>

namespace Waker
{
  /// The functions that tie material points to nodes.
  enum class ShapeFunctions
  {
    gimp,  // uGIMP: averages of hat functions over the point's support domain
    linear // standard MPM: the nodes' hat functions at the point
  };

  constexpr const char *
  name_of(const ShapeFunctions functions)
  {
    switch (functions)
      {
        case ShapeFunctions::gimp:
          return "GIMP";
        case ShapeFunctions::linear:
          return "linear";
      }
    return nullptr;
  }

  /**
   * One direction of the functions of one point: the values and gradients of
   * the three nodes that a support domain of at most one cell can reach,
   * starting from node `base`. Nodes out of reach have value and gradient 0.
   */
  struct Weights1D
  {
    int    base;
    double value[3];
    double gradient[3]; // 1/m
  };

  /// A domain that reaches less than this share of a cell into the next one
  /// does not touch it: round-off must not wake a node.
  constexpr double touch_tolerance = 1e-12;

  /**
   * Hat functions at x (m from node 0).
   */
  inline Weights1D
  linear_weights(const double x, const double inverse_h)
  {
    const double xi   = x * inverse_h;
    const double cell = std::floor(xi);
    const double t    = xi - cell;
    return {static_cast<int>(cell),
            {1. - t, t, 0.},
            {-inverse_h, inverse_h, 0.}};
  }

  /**
   * uGIMP functions of a support domain [x - l, x + l], x in m from node 0,
   * l <= h/2 its half-width (Bardenhagen & Kober 2004). Written as averages
   * over the two parts of the domain on either side of the one node that it
   * may hold: cheaper than the usual cases, and exact at their limits.
   */
  inline Weights1D
  gimp_weights(const double x, const double l, const double inverse_h)
  {
    const double left  = (x - l) * inverse_h; // in cells
    const double right = (x + l) * inverse_h;
    const double cell  = std::floor(left + touch_tolerance);
    const double a     = left - cell;  // >= 0 but for round-off
    const double b     = right - cell; // <= 2
    const double width = b - a;
    Weights1D    w;
    w.base = static_cast<int>(cell);
    if (b <= 1. + touch_tolerance)
      {
        const double t = 0.5 * (a + b);
        w.value[0]     = 1. - t;
        w.value[1]     = t;
        w.value[2]     = 0.;
        w.gradient[0]  = -inverse_h;
        w.gradient[1]  = inverse_h;
        w.gradient[2]  = 0.;
      }
    else
      {
        const double in_first  = 1. - a; // lengths, in cells
        const double in_second = b - 1.;
        const double first     = in_first / width; // shares
        const double second    = in_second / width;
        w.value[0]             = 0.5 * first * in_first;
        w.value[2]             = 0.5 * second * in_second;
        w.value[1]             = 1. - w.value[0] - w.value[2];
        w.gradient[0]          = -first * inverse_h;
        w.gradient[1]          = (first - second) * inverse_h;
        w.gradient[2]          = second * inverse_h;
      }
    return w;
  }
} // namespace Waker

#endif
