// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <waker/surface/marching_cubes.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    // Corner c of a cell is at the upper end in direction d if it has bit d.
    // Corners of the faces, in the order of Facet::on_face, anticlockwise seen
    // from outside the cell.
    constexpr int face_corners[6][4] = {{0, 4, 6, 2},
                                        {1, 3, 7, 5},
                                        {0, 1, 5, 4},
                                        {2, 6, 7, 3},
                                        {0, 2, 3, 1},
                                        {4, 5, 7, 6}};


    // Number of the edge between two corners of a cell, below 24: 8 times its
    // direction and its lower corner.
    int
    edge_between(const int a, const int b)
    {
      const int direction = (a ^ b) >> 1; // 1, 2, 4 -> 0, 1, 2
      return 8 * direction + (a & b);
    }
  } // namespace


  void
  to_facets(const TriangleMesh        &mesh,
            const double               smallest_area,
            Facets<3>                 &facets,
            std::vector<unsigned int> *cells)
  {
    facets.clear();
    if (cells != nullptr)
      cells->clear();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      {
        const auto    &v     = mesh.triangles[t];
        const Facet<3> facet = make_facet<3>(
          {{mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]}},
          mesh.on_face[t]);
        if (!(facet.measure() > smallest_area))
          continue;
        facets.push_back(facet);
        if (cells != nullptr)
          cells->push_back(mesh.cells[t]);
      }
  }


  MarchingCubes::MarchingCubes(
    const std::array<std::vector<double>, 3> &coordinates,
    const unsigned int                        closed_faces,
    const std::vector<unsigned char>         &traced)
  {
    unsigned int n_padded = 1;
    for (unsigned int d = 0; d < 3; ++d)
      {
        const std::vector<double> &x = coordinates[d];
        const std::size_t          n = x.size();
        Assert(n >= 2, ExcMessage("A lattice needs two planes of nodes."));

        const bool lower  = closed_faces >> (2 * d) & 1u;
        const bool upper  = closed_faces >> (2 * d + 1) & 1u;
        auto      &padded = padded_coordinates[d];
        padded.reserve(n + 2);
        padded.push_back(lower ? x[0] : 2 * x[0] - x[1]);
        padded.insert(padded.end(), x.begin(), x.end());
        padded.push_back(upper ? x[n - 1] : 2 * x[n - 1] - x[n - 2]);
        face_marks[2 * d]     = lower ? 2 * d : -1;
        face_marks[2 * d + 1] = upper ? 2 * d + 1 : -1;
        stride[d]             = n_padded;
        n_padded *= n + 2;
      }
    padded_values.assign(n_padded, 0.);
    inside.assign(n_padded, 0);
    vertex_of_edge.assign(3 * std::size_t(n_padded),
                          numbers::invalid_unsigned_int);
    if (traced.empty())
      return;
    AssertDimension(traced.size(),
                    coordinates[0].size() * coordinates[1].size() *
                      coordinates[2].size());
    is_traced.resize(n_padded);
    for (std::size_t cell = 0; cell < n_padded; ++cell)
      {
        std::size_t node = 0;
        for (int d = 2; d >= 0; --d)
          {
            const std::size_t n = coordinates[d].size();
            const std::size_t i = cell / stride[d] % (n + 2);
            node                = node * n + std::min(i > 0 ? i - 1 : 0, n - 1);
          }
        is_traced[cell] = traced[node];
      }
  }


  void
  MarchingCubes::trace(const double                      *values,
                       const std::array<unsigned int, 2> &strides,
                       const double                       threshold,
                       TriangleMesh                      &mesh)
  {
    Assert(threshold > 0, ExcMessage("The field outside is zero."));
    mesh.vertices.clear();
    mesh.triangles.clear();
    mesh.on_face.clear();
    mesh.cells.clear();

    unsigned int n[3];
    for (unsigned int d = 0; d < 3; ++d)
      n[d] = padded_coordinates[d].size();
    for (unsigned int k = 1; k + 1 < n[2]; ++k)
      for (unsigned int j = 1; j + 1 < n[1]; ++j)
        {
          const double *const row =
            values + std::size_t(k - 1) * strides[1] + (j - 1) * strides[0];
          const unsigned int first = k * stride[2] + j * stride[1] + 1;
          for (unsigned int i = 0; i + 2 < n[0]; ++i)
            {
              padded_values[first + i] = row[i];
              inside[first + i]        = row[i] >= threshold;
            }
        }

    // A cell of the padding lies in the face, if that is closed.
    const auto mark = [&](const unsigned int i, const unsigned int d) {
      if (i == 0)
        return face_marks[2 * d];
      return i + 2 == n[d] ? face_marks[2 * d + 1] : -1;
    };
    for (unsigned int k = 0; k + 1 < n[2]; ++k)
      for (unsigned int j = 0; j + 1 < n[1]; ++j)
        {
          const unsigned int         first = k * stride[2] + j * stride[1];
          const unsigned char *const in    = inside.data() + first;
          const auto                 side  = [&](const unsigned int i) {
            return in[i] | in[i + stride[1]] << 2 | in[i + stride[2]] << 4 |
                   in[i + stride[1] + stride[2]] << 6;
          };
          unsigned int left = side(0);
          for (unsigned int i = 0; i + 1 < n[0]; ++i)
            {
              const unsigned int right = side(i + 1);
              const unsigned int code  = left | right << 1;
              left                     = right;
              if (code == 0 || code == 255)
                continue;
              if (!is_traced.empty() && !is_traced[first + i])
                continue;
              int face = mark(i, 0);
              if (face < 0)
                face = mark(j, 1);
              if (face < 0)
                face = mark(k, 2);
              march(first + i, code, face, threshold, mesh);
            }
        }

    for (const unsigned int edge : used_edges)
      vertex_of_edge[edge] = numbers::invalid_unsigned_int;
    used_edges.clear();
  }


  void
  MarchingCubes::march(const unsigned int node,
                       const unsigned int code,
                       const int          face,
                       const double       threshold,
                       TriangleMesh      &mesh)
  {
    const auto is_inside = [=](const int c) { return (code >> c & 1u) != 0; };
    const auto value     = [&](const int c) {
      return padded_values[node + (c & 1) + (c >> 1 & 1) * stride[1] +
                           (c >> 2) * stride[2]];
    };

    // Where the line through an edge goes on. A line on a face, seen from
    // outside the cell, has the body on its right: it starts where a round of
    // the face (anticlockwise) enters the body, and ends where it leaves it.
    int next[24];
    for (int &edge : next)
      edge = -1;
    for (const auto &corners : face_corners)
      {
        int n_crossings = 0;
        for (int k = 0; k < 4; ++k)
          n_crossings +=
            is_inside(corners[k]) != is_inside(corners[(k + 1) % 4]);
        if (n_crossings == 0)
          continue;

        // A saddle: the corners inside are joined, and the lines go round
        // those outside, or the other way. The sum has the same order for both
        // cells of the face: corners 0 and 2 are the lowest and the highest.
        bool joined = false;
        if (n_crossings == 4)
          {
            const double diagonal = value(corners[0]) + value(corners[2]);
            const double other    = value(corners[1]) + value(corners[3]);
            joined                = diagonal + other >= 4 * threshold;
          }
        for (int k = 0; k < 4; ++k)
          {
            if (!is_inside(corners[k]) || is_inside(corners[(k + 1) % 4]))
              continue;
            // The round leaves the body on side k. Where did it enter, or
            // where will it enter again?
            const int step = joined ? 1 : 3;
            int       m    = k;
            do
              m = (m + step) % 4;
            while (is_inside(corners[m]) || !is_inside(corners[(m + 1) % 4]));
            next[edge_between(corners[m], corners[(m + 1) % 4])] =
              edge_between(corners[k], corners[(k + 1) % 4]);
          }
      }

    for (int start = 0; start < 24; ++start)
      {
        if (next[start] < 0)
          continue;
        loop.clear();
        int edge = start;
        do
          {
            const int c = edge % 8;
            loop.push_back(
              vertex_on(3 * (node + (c & 1) + (c >> 1 & 1) * stride[1] +
                             (c >> 2) * stride[2]) +
                          edge / 8,
                        threshold,
                        mesh));
            const int after = next[edge];
            next[edge]      = -1;
            edge            = after;
        } while (edge != start);
        span(node, face, mesh);
      }
  }


  unsigned int
  MarchingCubes::vertex_on(const unsigned int edge,
                           const double       threshold,
                           TriangleMesh      &mesh)
  {
    if (vertex_of_edge[edge] != numbers::invalid_unsigned_int)
      return vertex_of_edge[edge];

    const unsigned int d = edge % 3;
    const unsigned int a = edge / 3;
    const unsigned int b = a + stride[d];

    // Measured from the node inside: a node at the threshold is met exactly.
    const unsigned int in  = inside[a] ? a : b;
    const unsigned int out = inside[a] ? b : a;
    const double       t   = (padded_values[in] - threshold) /
                     (padded_values[in] - padded_values[out]);
    const auto index = [&](const unsigned int node, const unsigned int e) {
      return node / stride[e] % padded_coordinates[e].size();
    };
    Point<3> x;
    for (unsigned int e = 0; e < 3; ++e)
      x[e] = padded_coordinates[e][index(in, e)];
    x[d] += t * (padded_coordinates[d][index(out, d)] - x[d]);

    vertex_of_edge[edge] = mesh.vertices.size();
    used_edges.push_back(edge);
    mesh.vertices.push_back(x);
    return vertex_of_edge[edge];
  }


  void
  MarchingCubes::span(const unsigned int node,
                      const int          face,
                      TriangleMesh      &mesh)
  {
    const auto add =
      [&](const unsigned int a, const unsigned int b, const unsigned int c) {
        mesh.triangles.push_back({{a, b, c}});
        mesh.on_face.push_back(face);
        mesh.cells.push_back(node);
      };
    const auto vertex = [&](const std::size_t k) -> const Point<3> & {
      return mesh.vertices[loop[k]];
    };

    if (loop.size() == 3)
      {
        add(loop[0], loop[1], loop[2]);
        return;
      }
    if (loop.size() == 4)
      {
        const Tensor<1, 3> a    = vertex(1) - vertex(0);
        const Tensor<1, 3> b    = vertex(2) - vertex(0);
        const Tensor<1, 3> c    = vertex(3) - vertex(0);
        const double       size = a.norm() * b.norm() * c.norm();
        if (std::abs(cross_product_3d(a, b) * c) <= 1e-12 * size)
          {
            add(loop[0], loop[1], loop[2]);
            add(loop[0], loop[2], loop[3]);
            return;
          }
      }

    // A fan from the mean keeps the symmetry of the loop.
    Point<3> mean;
    for (std::size_t k = 0; k < loop.size(); ++k)
      mean += (vertex(k) - Point<3>()) / double(loop.size());
    const unsigned int centre = mesh.vertices.size();
    mesh.vertices.push_back(mean);
    for (std::size_t k = 0; k < loop.size(); ++k)
      add(loop[k], loop[(k + 1) % loop.size()], centre);
  }
} // namespace Waker
