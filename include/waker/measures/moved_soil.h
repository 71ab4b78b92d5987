// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_measures_moved_soil_h
#define waker_measures_moved_soil_h

namespace Waker
{
  template <int dim>
  struct MaterialPoints;

  /// Soil that has moved horizontally by more than 0.5 m, one way.
  struct MovedSoil
  {
    double area = 0.; // m^2: volume per metre of dyke, also in 3D
    double dx   = 0.; // its mean displacement, m
    double dy   = 0.;
  };

  /**
   * The soil that has moved along x. In 3D its volume is divided by the length
   * of the whole body along z, as it lay in the beginning.
   *
   * @param positive true: towards positive x
   */
  template <int dim>
  MovedSoil
  moved_soil(const MaterialPoints<dim> &points, const bool positive);
} // namespace Waker

#endif
