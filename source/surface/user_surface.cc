// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/utilities.h>

#include <waker/base/errors.h>
#include <waker/base/places.h>
#include <waker/surface/user_surface.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

namespace Waker
{
  namespace
  {
    std::string
    place(const Point<2> &x)
    {
      return place_text(x) + " m";
    }


    /// Twice the signed area of a, b, c.
    double
    area(const Point<2> &a, const Point<2> &b, const Point<2> &c)
    {
      const Tensor<1, 2> ab = b - a, ac = c - a;
      return ab[0] * ac[1] - ab[1] * ac[0];
    }


    /// Do the closed segments have a point in common? They share no vertex.
    bool
    touch(const Point<2> &a,
          const Point<2> &b,
          const Point<2> &c,
          const Point<2> &d)
    {
      for (unsigned int i = 0; i < 2; ++i)
        if (std::max(a[i], b[i]) < std::min(c[i], d[i]) ||
            std::max(c[i], d[i]) < std::min(a[i], b[i]))
          return false;
      const double abc = area(a, b, c), abd = area(a, b, d);
      const double cda = area(c, d, a), cdb = area(c, d, b);
      return abc * abd <= 0. && cda * cdb <= 0.;
    }


    /// Chains may not touch themselves or each other.
    void
    check_simple(const UserSurface<2> &surface,
                 const std::string    &name,
                 const std::string    &path)
    {
      const auto &x = surface.vertices;
      const auto &e = surface.elements;
      // From left to right, so that few pairs are looked at.
      std::vector<unsigned int> order(e.size());
      for (unsigned int k = 0; k < e.size(); ++k)
        order[k] = k;
      const auto left = [&](const unsigned int k) {
        return std::min(x[e[k][0]][0], x[e[k][1]][0]);
      };
      std::sort(order.begin(),
                order.end(),
                [&](const unsigned int a, const unsigned int b) {
                  return left(a) < left(b);
                });
      for (unsigned int i = 0; i < order.size(); ++i)
        {
          const auto  &s     = e[order[i]];
          const double right = std::max(x[s[0]][0], x[s[1]][0]);
          for (unsigned int j = i + 1;
               j < order.size() && left(order[j]) <= right;
               ++j)
            {
              const auto &t = e[order[j]];
              bool        cross;
              if (s[1] == t[0] || t[1] == s[0])
                {
                  // Neighbours: one may not fold back on the other.
                  const bool         s_first = s[1] == t[0];
                  const Tensor<1, 2> u =
                    x[s_first ? s[1] : t[1]] - x[s_first ? s[0] : t[0]];
                  const Tensor<1, 2> v =
                    x[s_first ? t[1] : s[1]] - x[s_first ? t[0] : s[0]];
                  cross = u[0] * v[1] - u[1] * v[0] == 0. && u * v < 0.;
                }
              else
                cross = touch(x[s[0]], x[s[1]], x[t[0]], x[t[1]]);
              if (cross)
                throw UserError(path,
                                name + " crosses or touches itself near " +
                                  place(x[t[0]]),
                                "closed chains that do not cross");
            }
        }
    }


    void
    check_shape(const UserSurface<2> &surface,
                const std::string    &name,
                const std::string    &path)
    {
      check_simple(surface, name, path);
    }


    /// Each edge has a triangle on either side, which run along it in opposite
    /// directions.
    void
    check_shape(const UserSurface<3> &surface,
                const std::string    &name,
                const std::string    &path)
    {
      std::map<std::pair<unsigned int, unsigned int>, int> edges;
      for (const auto &element : surface.elements)
        for (unsigned int k = 0; k < 3; ++k)
          ++edges[{element[k], element[(k + 1) % 3]}];
      for (const auto &[edge, count] : edges)
        {
          const auto opposite = edges.find({edge.second, edge.first});
          if (count == 1 && opposite != edges.end() && opposite->second == 1)
            continue;
          std::ostringstream where;
          where << "(" << surface.vertices[edge.first] << ") - ("
                << surface.vertices[edge.second] << ") m";
          throw UserError(path,
                          name + " is open or wrongly oriented at the edge " +
                            where.str(),
                          "a closed triangulation, each edge in two triangles "
                          "that both have their outside out");
        }
    }
  } // namespace


  template <int dim>
  void
  UserSurface<dim>::to_facets(const std::vector<Point<dim>> &moved,
                              Facets<dim>                   &facets) const
  {
    Assert(moved.size() == vertices.size(),
           ExcDimensionMismatch(moved.size(), vertices.size()));
    facets.clear();
    for (const auto &element : elements)
      {
        std::array<Point<dim>, dim> x;
        for (unsigned int k = 0; k < dim; ++k)
          x[k] = moved[element[k]];
        facets.push_back(make_facet<dim>(x));
      }
  }


  template <int dim>
  void
  check_user_surface(const UserSurface<dim>    &surface,
                     const std::string         &name,
                     const std::string         &path,
                     const BackgroundGrid<dim> &grid)
  {
    if (surface.vertices.size() < 3 || surface.elements.size() < 3)
      throw UserError(path,
                      name + " has " + std::to_string(surface.vertices.size()) +
                        " different vertices",
                      "at least three");
    const double tolerance = 1e-9 * grid.cell_size();
    for (const Point<dim> &x : surface.vertices)
      for (unsigned int d = 0; d < dim; ++d)
        if (!(x[d] >= grid.lower_corner()[d] - tolerance &&
              x[d] <= grid.upper_corner()[d] + tolerance))
          {
            std::ostringstream where;
            where << "the vertex " << place_text(x) << " m of " << name
                  << " lies outside the grid";
            throw UserError(path,
                            where.str(),
                            "vertices between Grid/Lower corner and Grid/Upper "
                            "corner");
          }
    check_shape(surface, name, path);

    Facets<dim> facets;
    surface.to_facets(surface.vertices, facets);
    if (!(enclosed_volume<dim>(facets) > 0.))
      throw UserError(path,
                      name + " has the soil on the wrong side",
                      dim == 2 ? "the soil on the left of every chain: the "
                                 "outer ones anticlockwise"
                               : "triangles that run anticlockwise seen from "
                                 "outside");
  }


  namespace
  {
    /// How far a vertex goes with the nodes around it (m).
    template <int dim>
    Tensor<1, dim>
    motion_at(const BackgroundGrid<dim>                 &grid,
              const typename BackgroundGrid<dim>::Index &cell,
              const Point<dim>                          &x,
              const std::vector<double>                 &mass,
              const double                               least_mass,
              const double *const                        u)
    {
      const auto motion_of = [&](const unsigned int node) {
        Tensor<1, dim> motion;
        for (unsigned int d = 0; d < dim; ++d)
          motion[d] = u[dim * node + d];
        return motion;
      };
      double         sum = 0.;
      Tensor<1, dim> motion;
      for (unsigned int v = 0; v < 1u << dim; ++v)
        {
          auto   index = cell;
          double N     = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            {
              const double xi =
                (x[d] - grid.lattice_origin()[d]) * grid.inverse_cell_size() -
                (cell[d] + grid.offset()[d]);
              const bool upper = (v >> d) & 1u;
              index[d] += upper;
              N *= upper ? xi : 1. - xi;
            }
          const unsigned int i = grid.node(index);
          if (!(mass[i] > least_mass))
            continue;
          sum += N;
          motion += N * motion_of(i);
        }
      // A share so small that it is round-off says nothing.
      if (sum > 1e-9)
        return motion / sum;

      // The closest node around that counts.
      constexpr int      reach = carrying_reach - 1, width = 2 * reach + 2;
      double             closest  = std::numeric_limits<double>::max();
      unsigned int       best     = 0;
      const unsigned int n_around = Utilities::pow(width, dim);
      for (unsigned int k = 0; k < n_around; ++k)
        {
          auto index  = cell;
          int  rest   = k;
          bool inside = true;
          for (unsigned int d = 0; d < dim; ++d)
            {
              index[d] += rest % width - reach;
              rest /= width;
              inside =
                inside && index[d] >= 0 &&
                index[d] < static_cast<int>(grid.n_nodes_per_direction()[d]);
            }
          if (!inside || !(mass[grid.node(index)] > least_mass))
            continue;
          const double distance =
            (grid.node_position(grid.node(index)) - x).norm_square();
          if (distance < closest)
            {
              closest = distance;
              best    = grid.node(index);
            }
        }
      return closest < std::numeric_limits<double>::max() ? motion_of(best)
                                                          : Tensor<1, dim>();
    }
  } // namespace


  template <int dim>
  void
  carry_vertices(const BackgroundGrid<dim> &grid,
                 const std::vector<double> &mass,
                 const double               least_mass,
                 const NodalVector         &increment,
                 std::vector<Point<dim>>   &vertices)
  {
    std::vector<Tensor<1, dim>> motions(vertices.size());
    for (std::size_t k = 0; k < vertices.size(); ++k)
      {
        const auto cell = grid.nearest_cell(vertices[k]);
        if (grid.owns_cell(cell))
          motions[k] = motion_at(
            grid, cell, vertices[k], mass, least_mass, increment.begin());
      }
    if (!motions.empty())
      grid.exchange().sum(&motions[0][0], dim * motions.size());
    for (std::size_t k = 0; k < vertices.size(); ++k)
      vertices[k] += motions[k];
  }


  template struct UserSurface<2>;
  template struct UserSurface<3>;
  template void
  check_user_surface<2>(const UserSurface<2> &,
                        const std::string &,
                        const std::string &,
                        const BackgroundGrid<2> &);
  template void
  check_user_surface<3>(const UserSurface<3> &,
                        const std::string &,
                        const std::string &,
                        const BackgroundGrid<3> &);
  template void
  carry_vertices<2>(const BackgroundGrid<2> &,
                    const std::vector<double> &,
                    const double,
                    const NodalVector &,
                    std::vector<Point<2>> &);
  template void
  carry_vertices<3>(const BackgroundGrid<3> &,
                    const std::vector<double> &,
                    const double,
                    const NodalVector &,
                    std::vector<Point<3>> &);
} // namespace Waker
