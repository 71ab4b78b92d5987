// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_boundary_water_load_h
#define waker_boundary_water_load_h

#include <waker/boundary/facet_load.h>
#include <waker/boundary/surface.h>
#include <waker/boundary/wetted_surface.h>
#include <waker/grid/background_grid.h>
#include <waker/nodes/nodal_vector.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  /// The side of the dyke on which the water stands.
  enum class WaterSide
  {
    none,
    left,
    right
  };

  constexpr const char *
  name_of(const WaterSide choice)
  {
    switch (choice)
      {
        case WaterSide::none:
          return "none";
        case WaterSide::left:
          return "left";
        case WaterSide::right:
          return "right";
      }
    return nullptr;
  }


  /// Section "Water".
  struct WaterParameters
  {
    WaterSide side = WaterSide::none;
    /// Level (m) on the vertical axis at which the dyke's width is measured,
    /// and to which `rise` is added. NaN: none, allowed without water.
    double level = std::numeric_limits<double>::quiet_NaN();
    /// Rise of the level in time (m): see base/time_function.h.
    std::string rise = "0";
    /// Unit weight (kN/m^3).
    double unit_weight = 10.;
    /// A node carries load only if its mass is at least this share of the mass
    /// of a node inside the body.
    double minimum_support = 0.01;

    /// Along x: +1 or -1, away from the water; +1 without water.
    int
    inner_direction() const
    {
      return side == WaterSide::right ? -1 : 1;
    }

    /// What the user wrote for `level`: read by the parameter handler, judged
    /// by check().
    std::string level_text = "none";

    void
    add_parameters(ParameterHandler &prm);

    /// @throws UserError "Water/Level" if it is no number, or missing
    void
    check() const;
  };

  /// What the water does to the body, for checks and output. Per m of length
  /// along z, also in 3D.
  struct WaterResultant
  {
    Tensor<1, 2> force;       // kN/m
    double       moment = 0.; // kNm/m, about the origin, anticlockwise
  };

  /// The same in space.
  struct SpatialResultant
  {
    Tensor<1, 3> force;  // kN
    Tensor<1, 3> moment; // kNm, about the origin
  };

  /**
   * Hydrostatic pressure on the outer slope: from the outer toe of the largest
   * body along its surface up to where it first reaches the water level
   * (find_wetted_segments(), in 3D WettedFacets).
   *
   * The pressure is integrated exactly, with linear functions also under GIMP
   * (FacetLoad, eq. 3.4 of Remmerswaal 2023). The share of a node with less
   * mass than `minimum_support` goes to supported nodes nearby, with weights
   * that reproduce linear functions: resultant and moment are kept.
   *
   * In 3D the surface is that of the body itself (find_wetted_facets()), or
   * that of the x-y plane, if the body is prismatic (find_wetted_segments()):
   * then the load of the plane is integrated with the linear functions along z
   * over the extent of the grid's box, and support is judged in each plane of
   * nodes.
   */
  template <int dim>
  class WaterLoad
  {
  public:
    WaterLoad(const BackgroundGrid<dim> &grid,
              const WaterParameters     &parameters);

    /// From now on the water stands at this level (m).
    void
    set_level(const double level)
    {
      parameters.level = level;
    }

    /// The wetted part of the surface, from the toe up. Empty without water.
    void
    find_wetted_segments(const Surface &surface);

    /// 3D: the wetted part of the surface of the body itself.
    void
    find_wetted_facets(const Facets<dim> &surface);

    /// As found last; empty if it was facets that were found last.
    const std::vector<LoadedSegment> &
    wetted_segments() const
    {
      return wetted;
    }

    /// As found last; empty if it was segments.
    const Facets<dim> &
    wetted_facets() const
    {
      return facets;
    }

    /**
     * Add the nodal forces of what is wet to `force` (kN).
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

    /// Exact resultant of the pressure on what is wet. Of facets: their force
    /// and their moment about the z axis, by the length of the grid's box.
    WaterResultant
    resultant() const;

    /// 3D: exact resultant of the pressure on the wetted facets.
    SpatialResultant
    spatial_resultant() const;

  private:
    // Pressure at height y (kPa).
    double
    pressure(const double y) const;

    const BackgroundGrid<dim> *grid;
    WaterParameters            parameters;
    std::vector<LoadedSegment> wetted;
    Facets<dim>                facets;

    // Work space; that of facets when they are first needed.
    FacetLoad<2>                  plane_load; // kN/m
    std::optional<FacetLoad<dim>> load;
    std::optional<WettedFacets>   finder;
  };
} // namespace Waker

#endif
