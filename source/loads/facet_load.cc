// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/loads/facet_load.h>

#include "polygon_cells.h"
#include <algorithm>
#include <cmath>

namespace Waker
{
  template <int dim>
  FacetLoad<dim>::FacetLoad(const LoadNodes<dim> &nodes)
    : lattice(nodes)
    , distribution(nodes)
    , forces(dim * nodes.n_nodes(), 0.)
    , is_loaded(nodes.n_nodes(), 0)
  {}



  template <int dim>
  void
  FacetLoad<dim>::clear()
  {
    for (const unsigned int node : loaded_nodes)
      {
        for (unsigned int d = 0; d < dim; ++d)
          forces[dim * node + d] = 0.;
        is_loaded[node] = 0;
      }
    loaded_nodes.clear();
  }



  template <int dim>
  typename FacetLoad<dim>::Index
  FacetLoad<dim>::cell_of(const Point<dim> &x) const
  {
    Index cell;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const int last = lattice.n_whole[d] - 2;
        Assert(x[d] > -1e-6 && x[d] < last + 1 + 1e-6,
               ExcMessage("A load must lie inside the grid and its margin."));
        cell[d] =
          std::min(std::max(static_cast<int>(std::floor(x[d])), 0), last);
      }
    return cell;
  }



  template <int dim>
  void
  FacetLoad<dim>::add_in_cell(const Index          &cell,
                              const Point<dim>     &u,
                              const Tensor<1, dim> &f)
  {
    unsigned int first  = 0;
    unsigned int stride = 1;
    unsigned int strides[dim];
    for (unsigned int d = 0; d < dim; ++d)
      {
        strides[d] = stride;
        first += stride * (cell[d] - lattice.first[d]);
        stride *= lattice.n[d];
      }

    for (unsigned int i = 0; i < (1u << dim); ++i)
      {
        double       N    = 1.;
        unsigned int node = first;
        for (unsigned int d = 0; d < dim; ++d)
          {
            const bool upper = i >> d & 1u;
            N *= upper ? u[d] : 1. - u[d];
            node += upper * strides[d];
          }
        for (unsigned int d = 0; d < dim; ++d)
          forces[dim * node + d] += N * f[d];
        if (!is_loaded[node])
          {
            is_loaded[node] = 1;
            loaded_nodes.push_back(node);
          }
      }
  }



  template <int dim>
  template <typename Force>
  void
  FacetLoad<dim>::integrate_segment(const Point<dim> &a,
                                    const Point<dim> &b,
                                    const Force      &force_at)
  {
    // The cell is that of the mid-point, which round-off cannot put into a
    // neighbour.
    const Tensor<1, dim> along = b - a;
    Point<dim>           middle;
    for (unsigned int d = 0; d < dim; ++d)
      middle[d] = (0.5 * (a[d] + b[d]) - lattice.origin[d]) * lattice.inverse_h;
    const Index cell = cell_of(middle);
    if (!lattice.has_cell(cell))
      return;

    const double weight = 0.5 * along.norm();
    const double offset = 0.5 / std::sqrt(3.);
    for (const double t : {0.5 - offset, 0.5 + offset})
      {
        const Point<dim> x = a + t * along;
        Point<dim>       u;
        for (unsigned int d = 0; d < dim; ++d)
          u[d] = (x[d] - lattice.origin[d]) * lattice.inverse_h - cell[d];
        add_in_cell(cell, u, force_at(x, weight));
      }
  }



  template <int dim>
  template <typename Force>
  void
  FacetLoad<dim>::integrate_polygon(const Point<dim>  *corners,
                                    const unsigned int n,
                                    const Index       &cell,
                                    const Force       &force_at)
  {
    // The rule of degree 4 with six points of Dunavant (1985): two orbits of
    // points with barycentric coordinates (1 - 2 b, b, b).
    constexpr double b[2] = {0.445948490915964886, 0.0915762135097707435};
    constexpr double w[2] = {0.223381589678011466, 0.109951743655321868};

    if (!lattice.has_cell(cell))
      return;
    for (unsigned int k = 1; k + 1 < n; ++k)
      {
        const Point<dim> *vertices[3] = {corners, corners + k, corners + k + 1};
        const double      area        = 0.5 * lattice.h * lattice.h *
                            cross_product_3d(*vertices[1] - *vertices[0],
                                             *vertices[2] - *vertices[0])
                              .norm();
        if (area == 0.)
          continue;
        Tensor<1, dim> sum;
        for (const Point<dim> *v : vertices)
          sum += *v;
        for (unsigned int orbit = 0; orbit < 2; ++orbit)
          for (const Point<dim> *v : vertices)
            {
              Point<dim> u, x;
              for (unsigned int d = 0; d < dim; ++d)
                {
                  const double xi =
                    b[orbit] * sum[d] + (1. - 3. * b[orbit]) * (*v)[d];
                  u[d] = xi - cell[d];
                  x[d] = lattice.origin[d] + lattice.h * xi;
                }
              add_in_cell(cell, u, force_at(x, w[orbit] * area));
            }
      }
  }



  template <int dim>
  bool
  FacetLoad<dim>::may_meet(const Facet<dim> &facet) const
  {
    for (unsigned int d = 0; d < dim; ++d)
      {
        double low = facet.vertices[0][d], high = low;
        for (const Point<dim> &x : facet.vertices)
          {
            low  = std::min(low, x[d]);
            high = std::max(high, x[d]);
          }
        // A cell more, for round-off.
        const double begin = lattice.origin[d] + lattice.h * lattice.first[d];
        if (high < begin - lattice.h || low > begin + lattice.h * lattice.n[d])
          return false;
      }
    return true;
  }



  template <int dim>
  template <typename Force>
  void
  FacetLoad<dim>::integrate(const Facet<dim> &facet, const Force &force_at)
  {
    if (!may_meet(facet))
      return;
    if constexpr (dim == 2)
      {
        // Cut the segment where it crosses the lines of the lattice.
        const Point<2>    &from  = facet.vertices[0];
        const Tensor<1, 2> along = facet.vertices[1] - from;
        cuts.clear();
        cuts.push_back(0.);
        for (unsigned int d = 0; d < 2; ++d)
          {
            const double a = (from[d] - lattice.origin[d]) * lattice.inverse_h;
            const double b =
              (facet.vertices[1][d] - lattice.origin[d]) * lattice.inverse_h;
            const int last = std::ceil(std::max(a, b));
            for (int i = std::floor(std::min(a, b)) + 1; i < last; ++i)
              cuts.push_back((i - a) / (b - a));
          }
        cuts.push_back(1.);
        std::sort(cuts.begin(), cuts.end());

        for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
          if (cuts[k + 1] > cuts[k])
            integrate_segment(from + cuts[k] * along,
                              from + cuts[k + 1] * along,
                              force_at);
      }
    else
      {
        Polygon polygon;
        for (const Point<3> &vertex : facet.vertices)
          {
            Point<3> x;
            for (unsigned int d = 0; d < 3; ++d)
              x[d] = (vertex[d] - lattice.origin[d]) * lattice.inverse_h;
            cell_of(x); // is it inside?
            polygon.add(x);
          }
        int n_cells[3];
        for (unsigned int d = 0; d < 3; ++d)
          n_cells[d] = lattice.n_whole[d] - 1;
        Index first;
        cut_into_cells(polygon,
                       0,
                       n_cells,
                       first,
                       [&](const Polygon &piece, const Index &cell) {
                         integrate_polygon(piece.corners,
                                           piece.n,
                                           cell,
                                           force_at);
                       });
      }
  }



  template <int dim>
  void
  FacetLoad<dim>::add(const Facet<dim> &facet, const Traction &traction)
  {
    integrate(facet, [&](const Point<dim> &x, const double weight) {
      return Tensor<1, dim>(weight * traction(facet, x));
    });
  }



  template <int dim>
  void
  FacetLoad<dim>::add_pressure(const Facet<dim> &facet,
                               const Pressure   &pressure)
  {
    integrate(facet, [&](const Point<dim> &x, const double weight) {
      return Tensor<1, dim>(-weight * pressure(x) * facet.normal);
    });
  }



  template <int dim>
  void
  FacetLoad<dim>::add(const Point<dim> &x, const Tensor<1, dim> &force)
  {
    Point<dim> u;
    for (unsigned int d = 0; d < dim; ++d)
      u[d] = (x[d] - lattice.origin[d]) * lattice.inverse_h;
    const Index cell = cell_of(u);
    if (!lattice.has_cell(cell))
      return;
    for (unsigned int d = 0; d < dim; ++d)
      u[d] -= cell[d];
    add_in_cell(cell, u, force);
  }



  template <int dim>
  void
  FacetLoad<dim>::distribute(const std::vector<double> &node_mass,
                             const double               minimum_mass,
                             NodalVector               &force,
                             const std::vector<Plane>  &planes)
  {
    distribution.add(
      loaded_nodes, forces, planes, node_mass, minimum_mass, force);
  }



  template class FacetLoad<2>;
  template class FacetLoad<3>;
} // namespace Waker
