// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_boundary_water_load_h
#define waker_boundary_water_load_h

#include <waker/boundary/nodal_support.h>
#include <waker/boundary/surface.h>
#include <waker/grid/background_grid.h>
#include <waker/nodes/nodal_vector.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  /// Section "Water".
  struct WaterParameters
  {
    /// "none", "left" or "right": on which side the water stands.
    std::string side = "none";
    /// Level (m) on the vertical axis.
    double level = 0.;
    /// Unit weight (kN/m^3).
    double unit_weight = 10.;
    /// A node carries load only if its mass is at least this share of the mass
    /// of a node inside the body.
    double minimum_support = 0.01;

    void
    add_parameters(ParameterHandler &prm);
  };

  /// A straight piece of the wetted surface, as loaded.
  struct LoadedSegment
  {
    Point<2>     from;   // m
    Point<2>     to;     // m
    Tensor<1, 2> normal; // out of the body
  };

  /// What the water does to the body, for checks and output. Per m of length
  /// along z, also in 3D.
  struct WaterResultant
  {
    Tensor<1, 2> force;       // kN/m
    double       moment = 0.; // kNm/m, about the origin, anticlockwise
  };

  /**
   * Hydrostatic pressure on the outer slope: from the outer toe of the largest
   * body along its surface up to where it first rises above the water level,
   * the last segment clipped there (section 5.2.2 of Remmerswaal 2023).
   *
   * The outer toe, with the water on the left, is the left end of the body's
   * contact with the closed bottom of the grid. If the body also leans against
   * the closed left wall, it is the point where its surface leaves the wall; if
   * it touches no bottom, its lowest vertex, the left one of several. A body
   * that does not rise above the water is loaded until it meets a closed face
   * again. Water on the right: mirrored.
   *
   * The pressure is integrated exactly, with two Gauss points on each piece of
   * the segments between cell faces, with linear functions also under GIMP (eq.
   * 3.4). A node that a support domain has hardly touched would be thrown away
   * by its share, so the share of a node with less mass than `minimum_support`
   * goes to supported nodes nearby, with weights that reproduce linear
   * functions: resultant and moment are kept (boundary/nodal_support.h).
   *
   * In 3D the body is prismatic: the load is that of the x-y plane, integrated
   * with the linear functions along z over the extent of the grid's box, and
   * support is judged in each plane of nodes.
   */
  template <int dim>
  class WaterLoad
  {
  public:
    WaterLoad(const BackgroundGrid<dim> &grid,
              const WaterParameters     &parameters);

    /// The wetted part of the surface, from the toe up. Empty without water.
    void
    find_wetted_segments(const Surface &surface);

    const std::vector<LoadedSegment> &
    wetted_segments() const
    {
      return wetted;
    }

    /**
     * Add the nodal forces of the wetted segments to `force` (kN).
     *
     * @param node_mass mass of each node (Mg), n_nodes long
     * @param full_node_mass mass of a node inside the body (Mg)
     *
     * If no node has support, nothing is added.
     */
    void
    add_nodal_forces(const std::vector<double> &node_mass,
                     const double               full_node_mass,
                     NodalVector               &force);

    /// Exact resultant of the pressure on the wetted segments.
    WaterResultant
    resultant() const;

  private:
    // Pressure at height y (kPa).
    double
    pressure(const double y) const;

    // Collect the nodal forces of a segment in plane_force.
    void
    integrate(const LoadedSegment &segment);

    // Gauss points on the piece [a, b] (m), which lies within one cell.
    void
    integrate_piece(const Point<2>     &a,
                    const Point<2>     &b,
                    const Tensor<1, 2> &normal);

    const BackgroundGrid<dim> *grid;
    WaterParameters            parameters;
    std::vector<LoadedSegment> wetted;

    // Work arrays. Forces (kN/m) on the nodes of the x-y plane, and the nodes
    // of it that have one.
    std::vector<Tensor<1, 2>>   plane_force;
    std::vector<unsigned char>  is_loaded;
    std::vector<unsigned int>   loaded_nodes;
    std::vector<SupportNode<2>> support;
    std::vector<double>         cuts;
  };
} // namespace Waker

#endif
