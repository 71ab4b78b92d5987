// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/surface/shape/facet.h>
#include <waker/surface/shape/surface.h>

namespace Waker
{
  namespace
  {
    /// Normal of the facet, as long as the facet is large.
    Tensor<1, 2>
    area_vector(const std::array<Point<2>, 2> &vertices)
    {
      const Tensor<1, 2> along = vertices[1] - vertices[0];
      Tensor<1, 2>       normal;
      normal[0] = along[1];
      normal[1] = -along[0];
      return normal;
    }


    Tensor<1, 3>
    area_vector(const std::array<Point<3>, 3> &vertices)
    {
      return 0.5 * cross_product_3d(vertices[1] - vertices[0],
                                    vertices[2] - vertices[0]);
    }
  } // namespace


  template <int dim>
  double
  Facet<dim>::measure() const
  {
    return area_vector(vertices).norm();
  }


  template <int dim>
  Point<dim>
  Facet<dim>::centroid() const
  {
    Point<dim> sum;
    for (const Point<dim> &x : vertices)
      sum += x;
    return sum / static_cast<double>(dim);
  }


  template <int dim>
  Facet<dim>
  make_facet(const std::array<Point<dim>, dim> &vertices, const int on_face)
  {
    Facet<dim> facet;
    facet.vertices      = vertices;
    facet.normal        = area_vector(vertices);
    facet.on_face       = on_face;
    const double length = facet.normal.norm();
    if (length > 0.)
      facet.normal /= length;
    return facet;
  }


  Facets<2>
  to_facets(const Surface &surface)
  {
    Facets<2> facets;
    to_facets(surface, facets);
    return facets;
  }


  void
  to_facets(const Surface &surface, Facets<2> &facets)
  {
    facets.clear();
    int number = 0;
    for (const SurfaceChain &chain : surface.chains)
      {
        const std::size_t n       = chain.vertices.size();
        const bool        in_hole = chain.area() < 0.;
        for (std::size_t k = 0; k < n; ++k)
          {
            facets.push_back(
              make_facet<2>({{chain.vertices[k], chain.vertices[(k + 1) % n]}},
                            chain.on_face[k]));
            facets.back().in_hole = in_hole;
            facets.back().chain   = number;
          }
        ++number;
      }
  }


  Facets<3>
  extrude(const Facets<2> &section, const double back, const double front)
  {
    Facets<3> facets;
    for (const Facet<2> &segment : section)
      {
        // The body is on the left seen from the front.
        const Point<2> &a    = segment.vertices[0];
        const Point<2> &b    = segment.vertices[1];
        const Point<3>  x[4] = {Point<3>(a[0], a[1], back),
                                Point<3>(b[0], b[1], back),
                                Point<3>(b[0], b[1], front),
                                Point<3>(a[0], a[1], front)};
        for (const auto &vertices :
             {std::array<Point<3>, 3>{{x[0], x[1], x[2]}},
              {{x[0], x[2], x[3]}}})
          {
            facets.push_back(make_facet<3>(vertices, segment.on_face));
            facets.back().in_hole = segment.in_hole;
            facets.back().chain   = segment.chain;
          }
      }
    return facets;
  }


  template <int dim>
  double
  enclosed_volume(const Facets<dim> &facets)
  {
    if (facets.empty())
      return 0.;

    // Relative to a vertex, so that a body far from the origin loses no
    // digits.
    const Point<dim> &origin = facets[0].vertices[0];
    double            sum    = 0.;
    for (const Facet<dim> &facet : facets)
      sum += (facet.vertices[0] - origin) * area_vector(facet.vertices);
    return sum / dim;
  }


  template struct Facet<2>;
  template struct Facet<3>;
  template Facet<2>
  make_facet<2>(const std::array<Point<2>, 2> &, const int);
  template Facet<3>
  make_facet<3>(const std::array<Point<3>, 3> &, const int);
  template double
  enclosed_volume<2>(const Facets<2> &);
  template double
  enclosed_volume<3>(const Facets<3> &);
} // namespace Waker
