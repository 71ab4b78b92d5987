// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <waker/surface/proximity_field.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  template <int dim>
  ProximityField<dim>::ProximityField(
    const BackgroundGrid<dim>         &grid,
    const SurfaceParameters           &parameters,
    const unsigned int                 closed_faces,
    const std::array<double, 2 * dim> &setback)
    : radius(parameters.kernel_radius)
    , threshold(parameters.threshold)
    , inverse_h(grid.inverse_cell_size())
    , origin(grid.origin()[0], grid.origin()[1])
    , n_x(grid.n_nodes_per_direction()[0])
    , n_y(grid.n_nodes_per_direction()[1])
    , nodal_field(std::size_t(n_x) * n_y)
  {
    Assert(radius > 0 && radius <= 2, ExcMessage("Kernel radius: 0 to 2."));

    const double h = grid.cell_size();
    const double a = radius * h;
    factor         = 2. / (numbers::PI * a * a);
    if (dim == 3)
      factor /= grid.upper_corner()[2] - grid.lower_corner()[2];

    std::array<std::vector<double>, 2> window;
    first_traced = 0;
    for (unsigned int d = 0; d < 2; ++d)
      {
        const int  n     = grid.n_nodes_per_direction()[d];
        const bool lower = closed_faces >> (2 * d) & 1u;
        const bool upper = closed_faces >> (2 * d + 1) & 1u;
        const int  m     = BackgroundGrid<dim>::margin;

        const double far = 1e6;
        mirrors[2 * d] =
          (lower && parameters.mirror) ? m + setback[2 * d] * inverse_h : -far;
        mirrors[2 * d + 1] = (upper && parameters.mirror)
                               ? n - 1 - m - setback[2 * d + 1] * inverse_h
                               : far;

        // The contour is sought up to a closed face, else over the margin too.
        const int begin = lower ? m : 0;
        const int end   = upper ? n - m : n;
        for (int i = begin; i < end; ++i)
          window[d].push_back(origin[d] + h * i);
        if (lower)
          window[d].front() = grid.lower_corner()[d] + setback[2 * d];
        if (upper)
          window[d].back() = grid.upper_corner()[d] - setback[2 * d + 1];
        first_traced += begin * (d == 0 ? 1 : n_x);
      }
    contour = MarchingSquares(window, closed_faces);

    if constexpr (dim == 3)
      if (!parameters.is_of_section(dim))
        {
          spatial.emplace();
          spatial->whole        = &grid;
          spatial->parameters   = parameters;
          spatial->closed_faces = closed_faces;
          spatial->setback      = setback;
        }
  }


  template <int dim>
  ProximitySurface &
  ProximityField<dim>::Spatial::on(
    const std::shared_ptr<const BackgroundGrid<dim>> &other)
  {
    if constexpr (dim == 3)
      if (!surface || window != other)
        {
          window  = other;
          surface = std::make_unique<ProximitySurface>(
            window ? *window : *whole, parameters, closed_faces, setback);
        }
    has_field = window == nullptr;
    return *surface;
  }


  template <int dim>
  const std::vector<double> &
  ProximityField<dim>::nodal_values(const Body<dim> &body)
  {
    if constexpr (dim == 3)
      if (spatial)
        {
          if (!spatial->has_field)
            spatial->on(nullptr).field(body.whole());
          return spatial->surface->nodal_values();
        }
    (void)body;
    return nodal_field;
  }



  template <int dim>
  template <int width>
  void
  ProximityField<dim>::add_kernels(const MaterialPoints<dim> &points)
  {
    double *const values     = nodal_field.data();
    const int     nx         = n_x;
    const int     ny         = n_y;
    const double  a          = radius;
    const double  inverse_a2 = 1. / (a * a);

    // The kernel of the point (x, y), in cells from the origin.
    const auto add = [=](const double x, const double y, const double c) {
      // First node right of x - a, also for x - a a little below zero.
      const int i0 = static_cast<int>(x - a + 8.) - 7;
      const int j0 = static_cast<int>(y - a + 8.) - 7;
      for (int j = std::max(j0, 0); j < std::min(j0 + width, ny); ++j)
        for (int i = std::max(i0, 0); i < std::min(i0 + width, nx); ++i)
          {
            const double t = 1. - (j - y) * (j - y) * inverse_a2;
            const double u = (i - x) * (i - x) * inverse_a2;
            values[j * nx + i] += c * std::max(t - u, 0.);
          }
    };

    // All images of a point near closed faces: in x, in y and, at a corner, in
    // both.
    const auto add_images =
      [&](const double x, const double y, const double c) {
        double xs[3] = {x};
        double ys[3] = {y};
        int    n_xs  = 1;
        int    n_ys  = 1;
        for (int side = 0; side < 2; ++side)
          {
            if (std::abs(x - mirrors[side]) < a)
              xs[n_xs++] = 2 * mirrors[side] - x;
            if (std::abs(y - mirrors[2 + side]) < a)
              ys[n_ys++] = 2 * mirrors[2 + side] - y;
          }
        for (int k = 1; k < n_xs * n_ys; ++k)
          add(xs[k % n_xs], ys[k / n_xs], c);
      };

    // Blocks of points, so that the compiler can use vector instructions; the
    // last one repeats its last point, without effect.
    constexpr int     N        = 16;
    const std::size_t n_points = points.n_points();
    for (std::size_t begin = 0; begin < n_points; begin += N)
      {
        double x[N], y[N], c[N];
        for (int l = 0; l < N; ++l)
          {
            const std::size_t p = std::min(begin + l, n_points - 1);
            x[l] = (points.position[p][0] - origin[0]) * inverse_h;
            y[l] = (points.position[p][1] - origin[1]) * inverse_h;
            c[l] = points.volume[p] * factor;
          }

        int    i0[N], j0[N];
        double u2[width][N], t[width][N], share[width][width][N];
        for (int l = 0; l < N; ++l)
          {
            i0[l] = static_cast<int>(x[l] - a + 8.) - 7;
            j0[l] = static_cast<int>(y[l] - a + 8.) - 7;
          }
        for (int i = 0; i < width; ++i)
          for (int l = 0; l < N; ++l)
            {
              u2[i][l] = (i0[l] + i - x[l]) * (i0[l] + i - x[l]) * inverse_a2;
              t[i][l] =
                1. - (j0[l] + i - y[l]) * (j0[l] + i - y[l]) * inverse_a2;
            }
        for (int j = 0; j < width; ++j)
          for (int i = 0; i < width; ++i)
            for (int l = 0; l < N; ++l)
              share[j][i][l] = c[l] * std::max(t[j][l] - u2[i][l], 0.);

        const int n = std::min<std::size_t>(N, n_points - begin);
        for (int l = 0; l < n; ++l)
          {
            if (i0[l] >= 0 && j0[l] >= 0 && i0[l] + width <= nx &&
                j0[l] + width <= ny)
              for (int j = 0; j < width; ++j)
                {
                  double *const row = values + (j0[l] + j) * nx + i0[l];
                  for (int i = 0; i < width; ++i)
                    row[i] += share[j][i][l];
                }
            else // at the edge of the lattice
              add(x[l], y[l], c[l]);

            if (x[l] - a < mirrors[0] || x[l] + a > mirrors[1] ||
                y[l] - a < mirrors[2] || y[l] + a > mirrors[3])
              add_images(x[l], y[l], c[l]);
          }
      }
  }



  template <int dim>
  const std::vector<double> &
  ProximityField<dim>::field(const Body<dim> &body)
  {
    const MaterialPoints<dim> &points = body.own();
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
    body.sum(nodal_field.data(), nodal_field.size());
    return nodal_field;
  }



  template <int dim>
  void
  ProximityField<dim>::detect(const Body<dim> &body, Surface &surface)
  {
    field(body);
    contour.trace(nodal_field.data() + first_traced, n_x, threshold, surface);
  }



  template <int dim>
  Surface
  ProximityField<dim>::detect(const Body<dim> &body)
  {
    Surface surface;
    detect(body, surface);
    return surface;
  }



  template <int dim>
  void
  ProximityField<dim>::detect(const Body<dim> &body, Facets<dim> &facets)
  {
    if constexpr (dim == 2)
      {
        detect(body, chains);
        to_facets(chains, facets);
      }
    else
      {
        Assert(spatial, ExcMessage("A prismatic body has no facets."));
        spatial->on(body.window()).detect(body, facets);
      }
  }



  template class ProximityField<2>;
  template class ProximityField<3>;
} // namespace Waker
