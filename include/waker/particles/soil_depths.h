// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_soil_depths_h
#define waker_particles_soil_depths_h

#include <deal.II/base/point.h>

#include <waker/grid/background_grid.h>
#include <waker/particles/layer_body.h>
#include <waker/particles/soil_profile.h>

#include <vector>

namespace Waker
{
  using namespace dealii;

  /// How deep a place lies, vertically (m), at least 0.
  struct Depths
  {
    double below_surface; // the highest soil over or at the place
    double in_layer;      // below the top of its layer
  };


  /**
   * Depths in a soil profile, before anything moves. The surface is the
   * highest edge of any layer at the place's x (3D: of the layers whose extent
   * holds its z, below their height maps). The top of a layer is that edge of
   * its polygon (or map) which a vertical line upwards from the place meets
   * first, so that each limb of a concave layer has its own. A place outside
   * its layer, as the centre of a row's support domain may be, has a depth of 0
   * in it.
   */
  template <int dim>
  class SoilDepths
  {
  public:
    /// @throws UserError as make_material_points()
    SoilDepths(const BackgroundGrid<dim>          &grid,
               const std::vector<LayerParameters> &layers);

    /// @param layer number of the layer that the place belongs to; one that
    /// there is not (of soil that flows in): both depths are NaN
    Depths
    at(const Point<dim> &x, const unsigned int layer) const;

    /// A stretch of a vertical line, and the number of the layer it lies in.
    struct InLayer
    {
      unsigned int       layer;
      LayerBody::Stretch stretch; // m
    };

    /// The soil on the vertical line through x. Of a line through the edge
    /// between two columns the one on its right, if there is soil.
    std::vector<InLayer>
    column(const Point<dim> &x) const;

    /// Does the place lie in the layer, or on its edge?
    bool
    holds(const Point<dim> &x, const unsigned int layer) const;

    unsigned int
    n_layers() const
    {
      return layer_bodies.size();
    }

    const std::vector<LayerBody> &
    bodies() const
    {
      return layer_bodies;
    }

  private:
    bool
    reaches(const LayerBody &body, const Point<dim> &x) const;

    /// The stretches in a body of the vertical line through x; a joint counts
    /// with both sides.
    std::vector<LayerBody::Stretch>
    stretches_at(const LayerBody &body, const Point<dim> &x) const;

    std::vector<LayerBody> layer_bodies; // m
    double                 tolerance;    // m: round-off
  };
} // namespace Waker

#endif
