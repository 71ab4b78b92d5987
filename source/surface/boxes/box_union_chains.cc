// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/surface/boxes/box_union_chains.h>

#include <algorithm>
#include <numeric>

namespace Waker
{
  void
  ContourChains::start(const unsigned int n_y)
  {
    edges.clear();
    next_edge.clear();
    open_vertex.assign(n_y, none);
  }



  void
  ContourChains::open(const unsigned int vertex, const unsigned int y)
  {
    open_vertex[y] = vertex;
  }



  void
  ContourChains::close(const unsigned int vertex, const unsigned int y)
  {
    const unsigned int left = open_vertex[y];
    Assert(left != none, ExcInternalError());
    open_vertex[y] = none;
    // The horizontal edge runs from the end of a vertical one to the start of
    // the other.
    const bool left_ends = edges[left / 2].upwards == (left % 2 == 1);
    const auto from      = left_ends ? left : vertex;
    const auto to        = left_ends ? vertex : left;
    next_edge[from / 2]  = to / 2;
  }



  void
  ContourChains::add(const std::vector<Edge> &edges_at_x)
  {
    const unsigned int first = edges.size();
    edges.insert(edges.end(), edges_at_x.begin(), edges_at_x.end());
    const unsigned int last = edges.size();
    next_edge.resize(last, none);

    const auto attach = [&](const unsigned int vertex, const unsigned int y) {
      if (open_vertex[y] != none)
        close(vertex, y);
      else
        open(vertex, y);
    };
    for (unsigned int e = first; e < last; ++e)
      {
        const Edge &edge = edges[e];
        if (e == first || edges[e - 1].high != edge.low)
          attach(2 * e, edge.low);
        if (e + 1 == last || edges[e + 1].low != edge.high)
          attach(2 * e + 1, edge.high);
        else
          {
            // Two parts touch. That on the left ends at the edge upwards.
            const unsigned int below = 2 * e + 1;
            const unsigned int above = 2 * (e + 1);
            close(edge.upwards ? below : above, edge.high);
            open(edge.upwards ? above : below, edge.high);
          }
      }
  }



  void
  ContourChains::finish(const std::vector<double> &x,
                        const std::vector<double> &y,
                        const FaceRanks           &faces,
                        Surface                   &surface)
  {
    std::vector<SurfaceChain> &chains = surface.chains;
    std::size_t                n      = 0;
    areas.clear();
    followed.assign(edges.size(), 0);
    for (unsigned int start = 0; start < edges.size(); ++start)
      {
        if (followed[start])
          continue;
        if (n == chains.size())
          chains.emplace_back();
        SurfaceChain &chain = chains[n++];
        chain.vertices.clear();
        chain.on_face.clear();
        unsigned int e = start;
        do
          {
            followed[e]            = 1;
            const Edge        &a   = edges[e];
            const unsigned int end = a.upwards ? a.high : a.low;
            chain.vertices.emplace_back(x[a.x], y[a.upwards ? a.low : a.high]);
            chain.vertices.emplace_back(x[a.x], y[end]);
            chain.on_face.push_back(a.x == faces[0]   ? 0
                                    : a.x == faces[1] ? 1
                                                      : -1);
            chain.on_face.push_back(end == faces[2]   ? 2
                                    : end == faces[3] ? 3
                                                      : -1);
            e = next_edge[e];
        } while (e != start);
        areas.push_back(chain.area());
      }
    chains.resize(n);

    // Outer chains before holes, the largest of each first.
    order.resize(n);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(),
                     order.end(),
                     [&](const std::size_t a, const std::size_t b) {
                       if ((areas[a] > 0.) != (areas[b] > 0.))
                         return areas[a] > 0.;
                       return std::abs(areas[a]) > std::abs(areas[b]);
                     });
    // Move each chain to its place along the cycles of the permutation.
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t hole = k; order[hole] != hole;)
        {
          const std::size_t from = order[hole];
          order[hole]            = hole;
          if (from == k)
            break;
          std::swap(chains[hole], chains[from]);
          hole = from;
        }
  }
} // namespace Waker
