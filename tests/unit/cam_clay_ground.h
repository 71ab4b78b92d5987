// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_cam_clay_ground_h
#define waker_tests_cam_clay_ground_h

#include <cmath>
#include <string>
#include <vector>

/// Modified Cam clay of 25 degrees, in triaxial compression, in the ground.
namespace CamClayGround
{
  const double phi = 25. * std::acos(-1.) / 180.;

  /// p_c over the vertical yield stress: (sigma'_y, (1 - sin(phi)) sigma'_y)
  /// lies on the yield surface.
  inline double
  isotropic_share()
  {
    const double M = 6. * std::sin(phi) / (3. - std::sin(phi));
    const double k = 1. - std::sin(phi);
    const double p = (1. + 2. * k) / 3., q = 1. - k;
    return p + q * q / (M * M * p);
  }
} // namespace CamClayGround

#endif
