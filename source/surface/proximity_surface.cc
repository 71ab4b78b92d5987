// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <waker/surface/proximity_field.h>
#include <waker/surface/proximity_surface.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace Waker
{
  namespace
  {
    /// What ranks tell each other.
    struct Triangle
    {
      std::uint64_t                        cell;
      std::int64_t                         on_face;
      std::array<std::array<double, 3>, 3> vertices; // m
    };

    struct TriangleInCell
    {
      std::uint64_t cell;
      std::size_t   number;

      bool
      operator<(const TriangleInCell &other) const
      {
        return cell != other.cell ? cell < other.cell : number < other.number;
      }
    };
  } // namespace


  ProximitySurface::ProximitySurface(const BackgroundGrid<3>     &grid,
                                     const SurfaceParameters     &parameters,
                                     const unsigned int           closed_faces,
                                     const std::array<double, 6> &setback)
    : radius(parameters.kernel_radius)
    , threshold(parameters.threshold)
    , h(grid.cell_size())
    , ranks(&grid.exchange())
    , inverse_h(grid.inverse_cell_size())
    , origin(grid.lattice_origin())
    , offset(grid.offset())
    , first_traced(0)
    , nodal_field(grid.n_nodes())
  {
    Assert(radius > 0 && radius <= 2, ExcMessage("Kernel radius: 0 to 2."));

    const double a = radius * h;
    factor         = 15. / (8. * numbers::PI * a * a * a);

    std::array<std::vector<double>, 3> window;
    for (unsigned int d = 0; d < 3; ++d)
      {
        const int  n     = grid.n_nodes_per_direction()[d];
        const bool lower = closed_faces >> (2 * d) & 1u;
        const bool upper = closed_faces >> (2 * d + 1) & 1u;
        n_nodes[d]       = n;
        // Nodes on the box's faces, which a window need not have.
        const int low = static_cast<int>(BackgroundGrid<3>::margin) - offset[d];
        const int high = static_cast<int>(std::lround(
                           (grid.upper_corner()[d] - origin[d]) * inverse_h)) -
                         offset[d];

        const double far = 1e6;
        mirrors[d]       = {
                {(lower && parameters.mirror) ? low + setback[2 * d] * inverse_h
                                              : -far,
           (upper && parameters.mirror) ? high - setback[2 * d + 1] * inverse_h
                                              : far}};

        // The contour is sought up to a closed face, else over the margin too.
        begin[d]      = lower ? std::max(low, 0) : 0;
        const int end = upper ? std::min(high + 1, n) : n;
        for (int i = begin[d]; i < end; ++i)
          window[d].push_back(origin[d] + h * (offset[d] + i));
        if (lower && low >= 0)
          window[d].front() = grid.lower_corner()[d] + setback[2 * d];
        if (upper && high < n)
          window[d].back() = grid.upper_corner()[d] - setback[2 * d + 1];
        first_traced += begin[d] * grid.stride(d);
      }

    std::vector<unsigned char> is_own;
    if (!ranks->is_one_rank())
      for (unsigned int k = 0; k < window[2].size(); ++k)
        for (unsigned int j = 0; j < window[1].size(); ++j)
          for (unsigned int i = 0; i < window[0].size(); ++i)
            is_own.push_back(ranks->owns(first_traced + k * grid.stride(2) +
                                         j * grid.stride(1) +
                                         i * grid.stride(0)));
    contour = MarchingCubes(window, closed_faces, is_own);
    for (unsigned int d = 0; d < 3; ++d)
      n_padded[d] = window[d].size() + 2;
  }


  template <int width>
  void
  ProximitySurface::add_kernels(const MaterialPoints<3> &points)
  {
    double *const values     = nodal_field.data();
    const auto    n          = n_nodes;
    const double  a          = radius;
    const double  inverse_a2 = 1. / (a * a);

    // x in cells from the origin.
    const auto add = [=](const std::array<double, 3> &x, const double c) {
      int    first[3];
      double u2[3][width];
      bool   is_within = true;
      for (unsigned int d = 0; d < 3; ++d)
        {
          // First node above x - a, also for x - a a little below zero.
          first[d] = static_cast<int>(x[d] - a + 8.) - 7;
          for (int i = 0; i < width; ++i)
            u2[d][i] =
              (first[d] + i - x[d]) * (first[d] + i - x[d]) * inverse_a2;
          is_within = is_within && first[d] >= 0 && first[d] + width <= n[d];
        }

      for (int k = 0; k < width; ++k)
        for (int j = 0; j < width; ++j)
          {
            const double t = 1. - u2[2][k] - u2[1][j];
            if (t <= 0.)
              continue;
            const int z = first[2] + k;
            const int y = first[1] + j;
            if (is_within)
              {
                double *const row = values + (z * n[1] + y) * n[0] + first[0];
                for (int i = 0; i < width; ++i)
                  row[i] += c * std::max(t - u2[0][i], 0.);
              }
            else if (z >= 0 && z < n[2] && y >= 0 && y < n[1])
              for (int i = 0; i < width; ++i)
                if (first[0] + i >= 0 && first[0] + i < n[0])
                  values[(z * n[1] + y) * n[0] + first[0] + i] +=
                    c * std::max(t - u2[0][i], 0.);
          }
    };

    const std::size_t n_points = points.n_points();
    for (std::size_t p = 0; p < n_points; ++p)
      {
        // In each direction the point itself and its images.
        double xs[3][3];
        int    n_xs[3];
        for (unsigned int d = 0; d < 3; ++d)
          {
            const double x =
              (points.position[p][d] - origin[d]) * inverse_h - offset[d];
            xs[d][0] = x;
            n_xs[d]  = 1;
            for (const double mirror : mirrors[d])
              if (std::abs(x - mirror) < a)
                xs[d][n_xs[d]++] = 2 * mirror - x;
          }
        const double c = points.volume[p] * factor;
        for (int k = 0; k < n_xs[2]; ++k)
          for (int j = 0; j < n_xs[1]; ++j)
            for (int i = 0; i < n_xs[0]; ++i)
              add({{xs[0][i], xs[1][j], xs[2][k]}}, c);
      }
  }


  const std::vector<double> &
  ProximitySurface::field(const Body<3> &body)
  {
    const MaterialPoints<3> &points = body.own();
    std::fill(nodal_field.begin(), nodal_field.end(), 0.);
    // An open interval of length 2a holds at most ceil(2a) nodes. A fixed
    // number lets the compiler unroll the loops.
    switch (static_cast<int>(std::ceil(2 * radius)))
      {
        case 1:
          add_kernels<1>(points);
          break;
        case 2:
          add_kernels<2>(points);
          break;
        case 3:
          add_kernels<3>(points);
          break;
        default:
          add_kernels<4>(points);
      }
    ranks->sum({{nodal_field.data(), 1}});
    return nodal_field;
  }


  void
  ProximitySurface::detect(const Body<3> &body, Facets<3> &facets)
  {
    field(body);
    const unsigned int row   = n_nodes[0];
    const unsigned int plane = n_nodes[0] * n_nodes[1];
    contour.trace(nodal_field.data() + first_traced,
                  {{row, plane}},
                  threshold,
                  mesh);
    to_facets(mesh, 1e-12 * h * h, facets, &cells);
    if (!ranks->is_one_rank())
      tell_all(facets);
  }


  void
  ProximitySurface::tell_all(Facets<3> &facets)
  {
    std::vector<Triangle> mine(facets.size());
    for (std::size_t f = 0; f < facets.size(); ++f)
      {
        // The cell's place in the whole lattice, in which the sum of the
        // window's place and its own is nowhere negative.
        std::uint64_t                cell = 0, rest = cells[f];
        std::array<std::uint64_t, 3> index;
        for (unsigned int d = 0; d < 3; ++d)
          {
            index[d] = rest % n_padded[d] + offset[d] + begin[d];
            rest /= n_padded[d];
          }
        for (int d = 2; d >= 0; --d)
          cell = cell << 21 | index[d];
        mine[f].cell    = cell;
        mine[f].on_face = facets[f].on_face;
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int d = 0; d < 3; ++d)
            mine[f].vertices[k][d] = facets[f].vertices[k][d];
      }
    const std::vector<Triangle> all = ranks->all_gather(mine);
    // Where one rank alone would have them: a cell is one rank's.
    std::vector<TriangleInCell> order(all.size());
    for (std::size_t f = 0; f < all.size(); ++f)
      order[f] = {all[f].cell, f};
    std::sort(order.begin(), order.end());
    facets.clear();
    for (const TriangleInCell &place : order)
      {
        const Triangle         &triangle = all[place.number];
        std::array<Point<3>, 3> vertices;
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int d = 0; d < 3; ++d)
            vertices[k][d] = triangle.vertices[k][d];
        facets.push_back(
          make_facet<3>(vertices, static_cast<int>(triangle.on_face)));
      }
  }
} // namespace Waker
