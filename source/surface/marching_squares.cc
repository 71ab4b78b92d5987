// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/surface/marching_squares.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    // Nodes of a cell: 0 lower left, 1 lower right, 2 upper right, 3 upper
    // left. Edges: 0 bottom, 1 right, 2 top, 3 left. The code of a cell has
    // bit n set if node n is inside. A segment has the body on its left: on a
    // round of the cell's edges (anticlockwise) it starts where the round
    // leaves the body and ends where it enters it again.
    struct CellSegments
    {
      int n;
      int edges[2][2]; // from, to
    };

    constexpr CellSegments cell_segments[16] = {{0, {}},
                                                {1, {{0, 3}}},
                                                {1, {{1, 0}}},
                                                {1, {{1, 3}}},
                                                {1, {{2, 1}}},
                                                {2, {{0, 3}, {2, 1}}},
                                                {1, {{2, 0}}},
                                                {1, {{2, 3}}},
                                                {1, {{3, 2}}},
                                                {1, {{0, 2}}},
                                                {2, {{1, 0}, {3, 2}}},
                                                {1, {{1, 2}}},
                                                {1, {{3, 1}}},
                                                {1, {{0, 1}}},
                                                {1, {{3, 0}}},
                                                {0, {}}};

    // Saddles with the two corners inside joined (codes 5 and 10).
    constexpr CellSegments joined_5  = {2, {{0, 1}, {2, 3}}};
    constexpr CellSegments joined_10 = {2, {{3, 0}, {1, 2}}};
  } // namespace



  MarchingSquares::MarchingSquares(
    const std::array<std::vector<double>, 2> &coordinates,
    const unsigned int                        closed_faces)
    : tolerance(coordinates[0][1] - coordinates[0][0])
  {
    for (unsigned int d = 0; d < 2; ++d)
      {
        const std::vector<double> &x = coordinates[d];
        const std::size_t          n = x.size();
        Assert(n >= 2, ExcMessage("A lattice needs two lines of nodes."));

        const bool lower  = closed_faces >> (2 * d) & 1u;
        const bool upper  = closed_faces >> (2 * d + 1) & 1u;
        auto      &padded = padded_coordinates[d];
        padded.reserve(n + 2);
        padded.push_back(lower ? x[0] : 2 * x[0] - x[1]);
        padded.insert(padded.end(), x.begin(), x.end());
        padded.push_back(upper ? x[n - 1] : 2 * x[n - 1] - x[n - 2]);
        face_marks[2 * d]     = lower ? 2 * d : -1;
        face_marks[2 * d + 1] = upper ? 2 * d + 1 : -1;
        for (std::size_t i = 1; i < n; ++i)
          tolerance = std::min(tolerance, x[i] - x[i - 1]);
      }
    // Vertices closer than this are one.
    tolerance *= 1e-9;

    const std::size_t n_padded =
      padded_coordinates[0].size() * padded_coordinates[1].size();
    padded_values.assign(n_padded, 0.);
    inside.assign(n_padded, 0);
    segment_from_edge.assign(2 * n_padded, 0);
  }



  void
  MarchingSquares::trace(const double      *values,
                         const unsigned int row_stride,
                         const double       threshold,
                         Surface           &surface)
  {
    Assert(threshold > 0, ExcMessage("The field outside is zero."));

    const std::size_t nx = padded_coordinates[0].size();
    const std::size_t ny = padded_coordinates[1].size();
    for (std::size_t j = 1; j + 1 < ny; ++j)
      {
        const double *const  row    = values + (j - 1) * row_stride;
        double *const        padded = padded_values.data() + j * nx + 1;
        unsigned char *const in     = inside.data() + j * nx + 1;
        for (std::size_t i = 0; i + 2 < nx; ++i)
          {
            padded[i] = row[i];
            in[i]     = row[i] >= threshold;
          }
      }
    find_segments(threshold);

    std::vector<SurfaceChain> &chains = surface.chains;
    std::size_t                n      = 0;
    areas.clear();
    for (std::size_t s = 0; s < segments.size(); ++s)
      {
        if (followed[s])
          continue;
        if (chains.size() == n)
          chains.emplace_back();
        if (!follow(s, threshold, chains[n]))
          continue;

        // Insert it in the order of the surface; there are few chains.
        areas.push_back(chains[n].area());
        for (std::size_t k = n; k > 0; --k)
          {
            const double a      = areas[k - 1];
            const double b      = areas[k];
            const bool   sorted = (a > 0) ? (b < 0 || b <= a) : b < 0 && b >= a;
            if (sorted)
              break;
            std::swap(areas[k - 1], areas[k]);
            std::swap(chains[k - 1], chains[k]);
          }
        ++n;
      }
    chains.resize(n);
  }



  void
  MarchingSquares::find_segments(const double threshold)
  {
    segments.clear();
    const unsigned int nx = padded_coordinates[0].size();
    const unsigned int ny = padded_coordinates[1].size();
    for (unsigned int j = 0; j + 1 < ny; ++j)
      {
        const unsigned char *const below = inside.data() + j * nx;
        const unsigned char *const above = below + nx;
        for (unsigned int i = 0; i + 1 < nx; ++i)
          {
            const unsigned int code =
              below[i] | below[i + 1] << 1 | above[i + 1] << 2 | above[i] << 3;
            if (code == 0 || code == 15)
              continue;

            const unsigned int  node = j * nx + i;
            const CellSegments *cell = &cell_segments[code];
            if (code == 5 || code == 10)
              {
                const double *const f = padded_values.data() + node;
                if ((f[0] + f[1]) + (f[nx] + f[nx + 1]) >= 4 * threshold)
                  cell = (code == 5) ? &joined_5 : &joined_10;
              }

            // A segment in a cell of the padding runs along the face, if that
            // is closed.
            int face = -1;
            if (i == 0)
              face = face_marks[0];
            else if (i + 2 == nx)
              face = face_marks[1];
            if (face < 0 && j == 0)
              face = face_marks[2];
            else if (face < 0 && j + 2 == ny)
              face = face_marks[3];

            const unsigned int edges[4] = {2 * node,
                                           2 * (node + 1) + 1,
                                           2 * (node + nx),
                                           2 * node + 1};
            for (int s = 0; s < cell->n; ++s)
              {
                const unsigned int from = edges[cell->edges[s][0]];
                const unsigned int to   = edges[cell->edges[s][1]];
                segment_from_edge[from] = segments.size();
                segments.push_back({from, to, face});
              }
          }
      }
    followed.assign(segments.size(), 0);
  }



  Point<2>
  MarchingSquares::crossing(const unsigned int edge,
                            const double       threshold) const
  {
    const unsigned int nx        = padded_coordinates[0].size();
    const unsigned int direction = edge & 1u;
    const unsigned int a         = edge / 2;
    const unsigned int b         = a + (direction == 0 ? 1 : nx);

    // Measured from the node inside: a node at the threshold is met exactly.
    const unsigned int in  = inside[a] ? a : b;
    const unsigned int out = inside[a] ? b : a;
    const double       t   = (padded_values[in] - threshold) /
                     (padded_values[in] - padded_values[out]);

    Point<2>    vertex(padded_coordinates[0][in % nx],
                    padded_coordinates[1][in / nx]);
    const auto &x   = padded_coordinates[direction];
    const auto  i_o = (direction == 0) ? out % nx : out / nx;
    vertex[direction] += t * (x[i_o] - vertex[direction]);
    return vertex;
  }



  bool
  MarchingSquares::follow(const unsigned int start,
                          const double       threshold,
                          SurfaceChain      &chain)
  {
    auto &vertices = chain.vertices;
    auto &on_face  = chain.on_face;
    vertices.clear();
    on_face.clear();

    unsigned int s = start;
    do
      {
        followed[s]           = 1;
        const Point<2> vertex = crossing(segments[s].from_edge, threshold);
        const int      face   = segments[s].on_face;
        if (!vertices.empty() &&
            vertex.distance_square(vertices.back()) < tolerance * tolerance)
          on_face.back() = face; // the segment before had no length
        else if (face < 0 || on_face.empty() || on_face.back() != face)
          {
            vertices.push_back(vertex);
            on_face.push_back(face);
          }
        s = segment_from_edge[segments[s].to_edge];
    } while (s != start);

    // The same where the end meets the beginning.
    if (vertices.size() > 1 && vertices.back().distance_square(
                                 vertices.front()) < tolerance * tolerance)
      {
        vertices.pop_back();
        on_face.pop_back();
      }
    if (vertices.size() > 1 && on_face.front() >= 0 &&
        on_face.front() == on_face.back())
      {
        vertices.erase(vertices.begin());
        on_face.erase(on_face.begin());
      }

    return vertices.size() >= 3 &&
           std::abs(chain.area()) > tolerance * tolerance;
  }
} // namespace Waker
