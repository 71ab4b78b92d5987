// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_surface_marching_cubes_h
#define waker_surface_marching_cubes_h

#include <waker/surface/shape/facet.h>

#include <array>
#include <vector>

namespace Waker
{
  /// Triangles on common vertices, anticlockwise seen from outside the body.
  struct TriangleMesh
  {
    std::vector<Point<3>>                    vertices; // m
    std::vector<std::array<unsigned int, 3>> triangles;
    std::vector<int> on_face; // of each triangle, see Facet::on_face
    /// Of each triangle, ascending: the number of its cell in the lattice with
    /// a plane of cells more on each side.
    std::vector<unsigned int> cells;
  };

  /// The triangles larger than `smallest_area` (m^2). `facets` is overwritten.
  /// @param cells of the facets, see TriangleMesh; overwritten
  void
  to_facets(const TriangleMesh        &mesh,
            const double               smallest_area,
            Facets<3>                 &facets,
            std::vector<unsigned int> *cells = nullptr);


  /**
   * Contour surface of a nodal field on a rectangular lattice in 3D, what
   * MarchingSquares is in 2D: the body is where the field is at least the
   * threshold, vertices lie on the edges of the lattice by linear
   * interpolation, beyond an open side the field is zero one cell further on,
   * and at a closed side the body is cut, with its triangles in that face
   * marked.
   *
   * No table of cases: on each face of a cell the lines are those of marching
   * squares, with the same rule for saddles (joined if the mean of the four
   * values reaches the threshold), and the lines of the six faces form the
   * closed loops between which the surface is spanned. Two cells draw the same
   * lines on the face that they share. So the surface is closed: every edge
   * belongs to as many triangles in one direction as in the other. A prismatic
   * field has a prismatic surface, with marching squares as its section, and
   * the surface of a mirrored field is mirrored.
   *
   * Deterministic, O(cells). Keeps its work arrays from call to call.
   */
  class MarchingCubes
  {
  public:
    MarchingCubes() = default;

    /**
     * @param coordinates of the planes of nodes, ascending, two or more in each
     *        direction (m)
     * @param closed_faces bit 2d: the lower, 2d + 1: the upper face in
     *        direction d is closed
     * @param traced one flag a node: are the cells traced whose lowest node,
     *        the nearest one for those beyond a side, it is? Empty: all are.
     */
    MarchingCubes(const std::array<std::vector<double>, 3> &coordinates,
                  const unsigned int                        closed_faces,
                  const std::vector<unsigned char>         &traced = {});

    /**
     * @param values at the nodes: node (i, j, k) at values[k * strides[1] +
     *        j * strides[0] + i]
     * @param threshold positive
     * @param mesh overwritten; its storage is used again. Triangles without
     *        area belong to it, where the surface passes through nodes and
     *        along the common edges of closed faces.
     */
    void
    trace(const double                      *values,
          const std::array<unsigned int, 2> &strides,
          const double                       threshold,
          TriangleMesh                      &mesh);

  private:
    void
    march(const unsigned int node,
          const unsigned int code,
          const int          face,
          const double       threshold,
          TriangleMesh      &mesh);

    // The vertex on an edge of the lattice, 3 * (lower node) + direction.
    unsigned int
    vertex_on(const unsigned int edge,
              const double       threshold,
              TriangleMesh      &mesh);

    // Span the loop of vertices, in the cell of this padded node.
    void
    span(const unsigned int node, const int face, TriangleMesh &mesh);

    // The lattice is padded by one node all round. The padding has the value
    // zero; at a closed face it lies on the face itself.
    std::array<std::vector<double>, 3> padded_coordinates;
    std::array<int, 6>                 face_marks; // face number or -1
    std::array<unsigned int, 3>        stride;     // between padded nodes

    std::vector<unsigned char> is_traced; // by padded cell; empty: all are
    std::vector<double>        padded_values;
    std::vector<unsigned char> inside;
    std::vector<unsigned int>  vertex_of_edge; // or invalid
    std::vector<unsigned int>  used_edges;
    std::vector<unsigned int>  loop;
  };
} // namespace Waker

#endif
