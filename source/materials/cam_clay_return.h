// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_materials_cam_clay_return_h
#define waker_source_materials_cam_clay_return_h

#include <algorithm>

namespace Waker
{
  /**
   * Elasticity of a pressure that grows exponentially with the strain,
   *   p = p_m exp(x / kappa*),  K = p / kappa*,
   * and below p_m goes on along its tangent there. Pressure and volumetric
   * strain x are positive in compression, and x is 0 at p_m.
   */
  class ExponentialElasticity
  {
  public:
    /// @param swelling kappa* (-)
    /// @param least p_m (kPa)
    ExponentialElasticity(const double swelling, const double least)
      : swelling(swelling)
      , least(least)
    {}

    double
    pressure(const double strain) const;

    double
    strain(const double pressure) const;

    double
    bulk_modulus(const double pressure) const
    {
      return std::max(pressure, least) / swelling;
    }

    /// Per volume (kPa): the integral of p dx from no pressure on.
    double
    energy(const double pressure) const
    {
      return swelling * (pressure > least ? pressure - 0.5 * least
                                          : 0.5 * pressure * pressure / least);
    }

  private:
    double swelling;
    double least;
  };


  /// Where a step ends. Compression is positive.
  struct CamClayEnd
  {
    double pressure;         // p', kPa
    double bulk_modulus;     // K at p', kPa
    double shear_left;       // s / s_trial (-)
    double volume_strain;    // plastic, of the step (-)
    double preconsolidation; // p_c, kPa
    bool   has_yielded;

    // d pressure_strain / d x and so on, where it yields: of shear_left and
    // volume_strain, by the trial strain x and by q dq of the trial stress.
    double shear_left_by_strain, shear_left_by_shear;
    double volume_by_strain, volume_by_shear;
  };


  /**
   * The return to the ellipse of modified Cam clay,
   *   f = q^2 / M^2 + p (p - p_c),
   * implicit in flow and hardening (Borja & Lee 1990), with
   *   p = p(x_trial - d),  s = b s_trial,  p_c = p_c0 exp(d / theta),
   * d the plastic volumetric strain and b = 1 / (1 + 6 G g / M^2) of the
   * multiplier g. The flow rule d = g (2 p - p_c) makes d a function of b, and
   * f one of b alone: on the wet side it has one root, and it is found inside
   * of a bracket. On the dry side too, unless a point snaps back.
   */
  class CamClayReturn
  {
  public:
    /// @param theta lambda* - kappa* (-)
    /// @param least that p_c does not fall below (kPa)
    CamClayReturn(const ExponentialElasticity &elasticity,
                  const double                 theta,
                  const double                 shear_modulus,
                  const double                 least)
      : elasticity(elasticity)
      , theta(theta)
      , G(shear_modulus)
      , least(least)
    {}

    /**
     * @param strain x_trial (-)
     * @param shear_stress q of the elastic trial stress (kPa)
     * @param ratio M (-)
     * @param preconsolidation p_c at the start (kPa)
     * @throws NumericalFailure
     */
    CamClayEnd
    operator()(const double strain,
               const double shear_stress,
               const double ratio,
               const double preconsolidation) const;

  private:
    struct Point;

    Point
    at(const double volume_strain,
       const double strain,
       const double preconsolidation) const;

    double
    volume_strain(const double b,
                  const double per_shear,
                  const double strain,
                  const double preconsolidation,
                  const double furthest,
                  const double guess) const;

    ExponentialElasticity elasticity;
    double                theta;
    double                G;
    double                least;
  };
} // namespace Waker

#endif
