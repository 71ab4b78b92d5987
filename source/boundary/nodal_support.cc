// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/boundary/nodal_support.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace Waker
{
  namespace
  {
    // Do the first n nodes determine a linear function? Exact, in integers.
    bool
    determine_plane(const std::vector<SupportNode> &nodes, const std::size_t n)
    {
      // All lie on one line through the first if all cross products with the
      // first different direction vanish.
      for (std::size_t k = 2; k < n; ++k)
        {
          const long long ax = nodes[1].dx - nodes[0].dx;
          const long long ay = nodes[1].dy - nodes[0].dy;
          const long long bx = nodes[k].dx - nodes[0].dx;
          const long long by = nodes[k].dy - nodes[0].dy;
          if (ax * by != ay * bx)
            return true;
        }
      return false;
    }



    // Moving least squares at the origin with the first n nodes, sets their
    // weights.
    // @return the largest weight in size
    double
    set_weights(std::vector<SupportNode> &nodes, const std::size_t n)
    {
      double a00 = 0, a01 = 0, a02 = 0, a11 = 0, a12 = 0, a22 = 0;
      for (std::size_t k = 0; k < n; ++k)
        {
          const double x   = nodes[k].dx;
          const double y   = nodes[k].dy;
          const double phi = 1. / (nodes[k].distance * nodes[k].distance);
          a00 += phi;
          a01 += phi * x;
          a02 += phi * y;
          a11 += phi * x * x;
          a12 += phi * x * y;
          a22 += phi * y * y;
        }

      // First column of the inverse of the symmetric matrix.
      const double c0  = a11 * a22 - a12 * a12;
      const double c1  = a12 * a02 - a01 * a22;
      const double c2  = a01 * a12 - a11 * a02;
      const double det = a00 * c0 + a01 * c1 + a02 * c2;

      double largest = 0.;
      for (std::size_t k = 0; k < n; ++k)
        {
          const double phi = 1. / (nodes[k].distance * nodes[k].distance);
          nodes[k].weight =
            phi * (c0 + c1 * nodes[k].dx + c2 * nodes[k].dy) / det;
          largest = std::max(largest, std::abs(nodes[k].weight));
        }
      return largest;
    }
  } // namespace



  void
  find_support(const double                      *mass,
               const double                       minimum_mass,
               const std::array<unsigned int, 2> &n,
               const unsigned int                 node,
               std::vector<SupportNode>          &nodes)
  {
    constexpr double largest_weight = 2.;
    constexpr int    largest_radius = 4; // of a search for smaller weights

    nodes.clear();
    const int nx   = n[0];
    const int ny   = n[1];
    const int i0   = node % nx;
    const int j0   = node / nx;
    const int last = std::max({i0, nx - 1 - i0, j0, ny - 1 - j0});

    const auto consider = [&](const int i, const int j) {
      if (i < 0 || j < 0 || i >= nx || j >= ny)
        return;
      const unsigned int other = j * nx + i;
      if (mass[other] >= minimum_mass)
        nodes.push_back({other,
                         i - i0,
                         j - j0,
                         double(i - i0) * (i - i0) + double(j - j0) * (j - j0),
                         0.});
    };

    // Squares grow by rings, so a smaller square is a shorter part of `nodes`.
    std::size_t n_best = 0;
    double      best   = std::numeric_limits<double>::max();
    for (int r = 1; r <= last; ++r)
      {
        for (int i = i0 - r; i <= i0 + r; ++i)
          {
            consider(i, j0 - r);
            consider(i, j0 + r);
          }
        for (int j = j0 - r + 1; j < j0 + r; ++j)
          {
            consider(i0 - r, j);
            consider(i0 + r, j);
          }

        if (determine_plane(nodes, nodes.size()))
          {
            const double size = set_weights(nodes, nodes.size());
            if (size < best)
              {
                best   = size;
                n_best = nodes.size();
              }
            if (best <= largest_weight)
              break;
          }
        if (n_best > 0 && r >= largest_radius)
          break;
      }

    if (n_best > 0)
      {
        if (n_best < nodes.size())
          {
            nodes.resize(n_best);
            set_weights(nodes, n_best);
          }
        return;
      }

    // On one line, or none: the nearest.
    if (nodes.empty())
      return;
    const auto closer = [](const SupportNode &a, const SupportNode &b) {
      return a.distance < b.distance;
    };
    const double nearest =
      std::min_element(nodes.begin(), nodes.end(), closer)->distance;
    nodes.erase(std::remove_if(nodes.begin(),
                               nodes.end(),
                               [=](const SupportNode &s) {
                                 return s.distance > nearest;
                               }),
                nodes.end());
    for (SupportNode &s : nodes)
      s.weight = 1. / nodes.size();
  }
} // namespace Waker
