// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_surface_domain_contour_h
#define waker_surface_domain_contour_h

#include <waker/grid/background_grid.h>
#include <waker/particles/body.h>
#include <waker/surface/boxes/box_union.h>
#include <waker/surface/proximity_field.h>
#include <waker/surface/shape/facet.h>
#include <waker/surface/shape/surface.h>

#include <memory>
#include <vector>

namespace Waker
{
  /**
   * The surface of a body as the contour of the support domains of its points,
   * [x_p - l_p, x_p + l_p] (section 3.6.2 of Remmerswaal 2023). A load on it is
   * consistent with the internal force of GIMP for every shape of the body.
   *
   * In 2D: closed chains by the slab method
   * (surface/boxes/box_union_contour.h). In 3D: the outer faces of the union of
   * boxes (surface/boxes/box_union_faces.h).
   *
   * Gaps up to a share of the smallest domain's width (in x, and in z) or
   * height (in y) are filled, SurfaceParameters::minimum_gap_width and _height.
   * At a closed face of the grid's box the body is cut and a gap to the face is
   * a gap like others.
   *
   * On several ranks each looks at its own points. In space it finds the facets
   * of its own part, from the domains in and near it, and tells all what these
   * are. In the plane, where there are fewer domains, it leaves out those that
   * lie inside its part, and tells all others: each rank then finds the chains.
   *
   * Keeps its work arrays from call to call.
   */
  template <int dim>
  class DomainContour
  {
  public:
    /**
     * @param closed_faces as of Fixities::closed_faces()
     * @param setback as of ProximityField
     * @throws UserError "Surface/Minimum gap width" or "... height" if a gap as
     *         large as a domain would be filled
     */
    DomainContour(const BackgroundGrid<dim>        &grid,
                  const SurfaceParameters          &parameters,
                  const unsigned int                closed_faces,
                  const std::array<double, 2 *dim> &setback = {});

    ~DomainContour();

    /// The chains; in 3D those of the domains' projection on the x-y plane, for
    /// a body that is prismatic along z. `surface` is overwritten.
    void
    detect(const Body<dim> &body, Surface &surface);

    /// The surface itself. In 3D the triangles are those of rectangles, with
    /// vertices on the sides of others: closed, but without a common topology.
    /// `facets` is overwritten.
    void
    detect(const Body<dim> &body, Facets<dim> &facets);

  private:
    struct WorkSpace;
    std::unique_ptr<WorkSpace> work;
  };
} // namespace Waker

#endif
