// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_case_k0_stress_h
#define waker_case_k0_stress_h

#include <waker/case/ground.h>
#include <waker/materials/factory.h>
#include <waker/mechanics/stress_update.h>
#include <waker/particles/place_expression.h>

#include <vector>

namespace Waker
{
  /// K0 at the points of a material at t = 0, by Materials/<name>/K0.
  template <int dim>
  class K0OfPoints
  {
  public:
    /// @param points must outlive it
    /// @throws UserError "Materials/<name>/K0"
    K0OfPoints(const MaterialParameters  &parameters,
               const Material            &law,
               const Ground<dim>         &ground,
               const MaterialPoints<dim> &points);

    /// @param p number of a point of the material
    /// @param place where it lies
    double
    value(const std::size_t p, const InGround &place) const;

    /// Does it follow from a stress in the ground?
    bool
    follows_stress() const
    {
      return k0.asks_for_stress();
    }

  private:
    const MaterialPoints<dim> *points;
    std::vector<int>           known; // arrays of the variables it may name
    PlaceExpression<dim>       k0;
  };


  /**
   * The stress of ground at rest (Initial stress/From = K0): effective
   *   sigma'_yy = -sigma'_v,  sigma'_xx = sigma'_zz = -K0 sigma'_v,
   * with sigma'_v of columns (Ground); of laws of total stress less the
   * pressure of the water. In balance only in level ground.
   *
   * @param layers number of each point's layer
   * @param points their variables are those of the start
   * @throws UserError Materials/<name>/K0: it is no number of at least 0
   *         somewhere, or the law does not bear it (with the place, by how
   *         much, and between which K0 it would)
   */
  template <int dim>
  void
  set_k0_stress(const std::vector<MaterialParameters> &parameters,
                const Materials                       &materials,
                const Ground<dim>                     &ground,
                const PoreWater<dim>                  &pore_water,
                const std::vector<unsigned int>       &layers,
                MaterialPoints<dim>                   &points);
} // namespace Waker

#endif
