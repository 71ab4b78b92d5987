// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_soil_profile_h
#define waker_particles_soil_profile_h

#include <waker/grid/background_grid.h>
#include <waker/particles/material_points.h>
#include <waker/particles/polygon.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  /// A layer as the user writes it: subsection "Soil profile/<name>".
  struct LayerParameters
  {
    std::string name;     // of the subsection
    std::string material; // a name of "Materials/Names"
    /// Corners x, y (m) of a simple polygon, "x1, y1; x2, y2; ...", in either
    /// orientation. In 3D it is extruded along z.
    std::string polygon;
    /// 3D: from z0 to z1 (m); empty: over the whole grid.
    std::vector<double> extent;
    /// 3D: files of height maps (m) that bound the layer, see height_map.h:
    /// what lies above `top` or below `bottom` is no part of it. Empty: none.
    std::string top;
    std::string bottom;
    /// Initial velocity (m/s): per component an expression of the point's x, y,
    /// z (m), for example "0.1*sin(pi*x/50); 0". Empty: at rest.
    std::string velocity;
    /// Initial stress (kPa, tension positive): xx, yy, zz, xy[, xz, yz], each
    /// an expression of the point's place. Empty: none, or that of the gravity
    /// step.
    std::string initial_stress;

    void
    add_parameters(ParameterHandler &prm);

    /// Corners of the polygon, anticlockwise.
    /// @throws UserError "Soil profile/<name>/Polygon": fewer than 3 corners,
    /// not numbers, self-crossing, zero area
    Polygon
    corners() const;

    /// The expressions of the velocity, one per component; none: at rest.
    /// Plain numbers may also have commas between them.
    /// @throws UserError "Soil profile/<name>/Velocity": not `dim` parts
    std::vector<std::string>
    velocity_components(const unsigned int dim) const;

    /// The expressions of the stress, in the order given above; none: zero.
    /// @throws UserError "Soil profile/<name>/Initial stress": not 4 parts in
    /// 2D, 6 in 3D
    std::vector<std::string>
    stress_components(const unsigned int dim) const;
  };

  /// Of the points in a layer.
  enum class Placement
  {
    sub_cells,       // of the grid, cut by the layers' edges
    whole_sub_cells, // those that soil fills at least by half, uncut
    rows             // rectangles that fill rows of sub-cells
  };

  constexpr const char *
  name_of(const Placement choice)
  {
    switch (choice)
      {
        case Placement::sub_cells:
          return "sub-cells";
        case Placement::whole_sub_cells:
          return "whole sub-cells";
        case Placement::rows:
          return "rows";
      }
    return nullptr;
  }


  /// Section "Material points".
  struct MaterialPointParameters
  {
    /// Points per cell and direction.
    unsigned int points_per_direction = 2;
    /// A sub-cell of which a slope leaves less than this share is given to the
    /// fullest neighbour of the same layer: its volume and first moment are
    /// kept, its point is not made. 0 to 0.5.
    double minimum_cut = 0.25;
    /// Whole sub-cells: each that soil fills at least by half is a point with
    /// all of its volume, as on the slope of section 6.2 of Remmerswaal 2023.
    /// Rows: rectangles that fill each row of sub-cells between the edges of
    /// the layer, whose slopes cut the middle of the outermost ones (section
    /// 3.5 of Remmerswaal 2023).
    Placement placement = Placement::sub_cells;

    void
    add_parameters(ParameterHandler &prm);
  };

  /**
   * Make the material points of a soil profile: a regular lattice of
   * `points_per_direction` per cell, one support domain (sub-cell) each. A
   * sub-cell that a layer's edge cuts keeps the part inside: its point moves
   * to the centroid of that part and gets its volume. The support domain of
   * every point is a whole sub-cell: `half_size` is h / (2
   * points_per_direction) in each direction.
   *
   * Ids count from 0 in the order of creation (cells lexicographically, x
   * fastest, sub-cells likewise within a cell), which also keeps neighbours
   * close in memory. `mass`, `velocity`, `material` and `stress` are set;
   * acceleration and scalars are zero, empty.
   *
   * With Placement = whole sub-cells nothing is cut: the surface is a
   * staircase, with the volume of the points, which may differ from the
   * profile's.
   *
   * With Placement = rows the domains are rectangles that fill the rows of
   * sub-cells (fill_rows(); in z a layer's extent is divided likewise), each
   * point is the centre of its domain and has all of its volume. Where corners
   * lie inside a row, the volume differs from that of the profile.
   *
   * Corners that only round-off keeps off a line of the lattice are put on it.
   *
   * @param densities mass density of each material (Mg/m^3), by number
   * @param material_names to find a layer's material
   * @param layers_of_points if not null: out, the number of each point's layer
   * @throws UserError: no layers, a polygon or extent outside the grid's box
   * (margin not included), layers that overlap, an unknown material, an extent
   * or velocity of the wrong length, a velocity or stress that is no number at
   * a point or no expression of place; rows (whole sub-cells) whose volume
   * differs by more than 1 % (5 %) from their profile's; and what corners()
   * throws
   */
  template <int dim>
  MaterialPoints<dim>
  make_material_points(const BackgroundGrid<dim>          &grid,
                       const std::vector<LayerParameters> &layers,
                       const MaterialPointParameters      &parameters,
                       const std::vector<std::string>     &material_names,
                       const std::vector<double>          &densities,
                       std::vector<unsigned int> *layers_of_points = nullptr);

  /// Volume of the layers (area x extent), m^dim: what the points must have.
  /// @throws UserError for polygons and extents as make_material_points()
  template <int dim>
  double
  profile_volume(const BackgroundGrid<dim>          &grid,
                 const std::vector<LayerParameters> &layers);
} // namespace Waker

#endif
