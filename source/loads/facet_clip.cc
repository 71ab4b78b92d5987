// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/loads/facet_clip.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    /// The convex polygon that a plane leaves of a facet: one vertex more than
    /// a facet has, at most.
    template <int dim>
    struct Piece
    {
      std::array<Point<dim>, dim + 1> vertices;
      unsigned int                    n = 0;

      void
      add(const Point<dim> &x)
      {
        vertices[n++] = x;
      }
    };


    void
    append(const Piece<2> &piece, const Facet<2> &facet, Facets<2> &facets)
    {
      if (piece.n < 2)
        return;
      facets.push_back(facet);
      facets.back().vertices = {{piece.vertices[0], piece.vertices[1]}};
    }


    void
    append(const Piece<3> &piece, const Facet<3> &facet, Facets<3> &facets)
    {
      for (unsigned int k = 2; k < piece.n; ++k)
        {
          facets.push_back(facet);
          facets.back().vertices = {
            {piece.vertices[0], piece.vertices[k - 1], piece.vertices[k]}};
        }
    }
  } // namespace


  template <int dim>
  void
  cut_facet(const Facet<dim>     &facet,
            const Tensor<1, dim> &n,
            const double          c,
            Facets<dim>          &below,
            Facets<dim>          &above)
  {
    // Height of the vertices over the plane.
    std::array<double, dim> height;
    bool                    any_below = false, any_above = false;
    for (unsigned int k = 0; k < dim; ++k)
      {
        height[k] = n * facet.vertices[k] - c;
        any_below = any_below || height[k] < 0.;
        any_above = any_above || height[k] > 0.;
      }
    if (!any_above || !any_below)
      {
        (any_above ? above : below).push_back(facet);
        return;
      }

    // Walk round; a segment has no way back.
    Piece<dim>             lower, upper;
    constexpr unsigned int n_edges = dim == 2 ? 1 : 3;
    for (unsigned int k = 0; k < dim; ++k)
      {
        if (height[k] <= 0.)
          lower.add(facet.vertices[k]);
        if (height[k] >= 0.)
          upper.add(facet.vertices[k]);
        const unsigned int next = (k + 1) % dim;
        if (k < n_edges && ((height[k] < 0. && height[next] > 0.) ||
                            (height[k] > 0. && height[next] < 0.)))
          {
            const double     t = height[k] / (height[k] - height[next]);
            const Point<dim> x = facet.vertices[k] +
                                 t * (facet.vertices[next] - facet.vertices[k]);
            lower.add(x);
            upper.add(x);
          }
      }
    append(lower, facet, below);
    append(upper, facet, above);
  }


  template <int dim>
  void
  keep_below(const Tensor<1, dim> &n,
             const double          c,
             const double          tolerance,
             Facets<dim>          &facets,
             Facets<dim>          &work)
  {
    // Most facets lie on one side: nothing is copied but what is cut.
    work.clear();
    std::size_t kept = 0;
    for (std::size_t f = 0; f < facets.size(); ++f)
      {
        bool all_below = true, all_above = true;
        for (const Point<dim> &x : facets[f].vertices)
          {
            const double height = n * x - c;
            all_below           = all_below && height <= tolerance;
            all_above           = all_above && height >= 0.;
          }
        if (all_below)
          {
            if (kept != f)
              facets[kept] = facets[f];
            ++kept;
          }
        else if (!all_above)
          work.push_back(facets[f]);
      }
    facets.resize(kept);
    const std::size_t n_cut = work.size();
    for (std::size_t f = 0; f < n_cut; ++f)
      {
        // Both ends of the same storage: copy, for it may grow.
        const Facet<dim>  facet = work[f];
        const std::size_t size  = work.size();
        cut_facet(facet, n, c, facets, work);
        work.resize(size);
      }
  }


  template void
  cut_facet<2>(const Facet<2> &,
               const Tensor<1, 2> &,
               const double,
               Facets<2> &,
               Facets<2> &);
  template void
  cut_facet<3>(const Facet<3> &,
               const Tensor<1, 3> &,
               const double,
               Facets<3> &,
               Facets<3> &);
  template void
  keep_below<2>(const Tensor<1, 2> &,
                const double,
                const double,
                Facets<2> &,
                Facets<2> &);
  template void
  keep_below<3>(const Tensor<1, 3> &,
                const double,
                const double,
                Facets<3> &,
                Facets<3> &);
} // namespace Waker
