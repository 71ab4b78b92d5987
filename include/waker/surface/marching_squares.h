// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_surface_marching_squares_h
#define waker_surface_marching_squares_h

#include <waker/surface/shape/surface.h>

#include <array>
#include <vector>

namespace Waker
{
  /**
   * Contour lines of a nodal field on a rectangular lattice, as closed oriented
   * chains. The body is where the field is at least the threshold; vertices
   * lie on the edges of the lattice, by linear interpolation.
   *
   * Beyond an open side of the lattice the field is taken as zero one cell
   * further on. At a closed side the body is cut: the chain closes exactly
   * along the face, and those segments are marked (SurfaceChain::on_face; one
   * segment per straight run). A saddle, a cell with two opposite nodes inside,
   * is joined if the mean of its four values reaches the threshold.
   *
   * Deterministic, O(cells). Keeps its work arrays from call to call.
   */
  class MarchingSquares
  {
  public:
    MarchingSquares() = default;

    /**
     * @param coordinates of the lines of nodes in x and y, ascending, two or
     *        more each (m)
     * @param closed_faces bit 2d: the lower, 2d + 1: the upper face in
     *        direction d is closed
     */
    MarchingSquares(const std::array<std::vector<double>, 2> &coordinates,
                    const unsigned int                        closed_faces);

    /**
     * @param values at the nodes: node (i, j) at values[j * row_stride + i]
     * @param threshold positive
     * @param surface overwritten; its storage is used again
     */
    void
    trace(const double      *values,
          const unsigned int row_stride,
          const double       threshold,
          Surface           &surface);

  private:
    // A segment within a cell. An edge has the number 2 * node (along x) or
    // 2 * node + 1 (along y), with the padded node at its lower end.
    struct Segment
    {
      unsigned int from_edge;
      unsigned int to_edge;
      int          on_face;
    };

    void
    find_segments(const double threshold);

    Point<2>
    crossing(const unsigned int edge, const double threshold) const;

    // Follow the segments from number `start` until they close; false if the
    // chain has no area.
    bool
    follow(const unsigned int start,
           const double       threshold,
           SurfaceChain      &chain);

    // The lattice is padded by one node all round. The padding has the value
    // zero; at a closed face it lies on the face itself.
    std::array<std::vector<double>, 2> padded_coordinates;
    std::array<int, 4>                 face_marks;     // face number or -1
    double                             tolerance = 0.; // m

    std::vector<double>        padded_values;
    std::vector<unsigned char> inside;
    std::vector<Segment>       segments;
    std::vector<unsigned char> followed;
    std::vector<unsigned int>  segment_from_edge;
    std::vector<double>        areas;
  };
} // namespace Waker

#endif
