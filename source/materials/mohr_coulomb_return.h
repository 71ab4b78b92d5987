// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_materials_mohr_coulomb_return_h
#define waker_source_materials_mohr_coulomb_return_h

#include <array>
#include <cmath>

namespace Waker
{
  /// Three principal values.
  using Principal = std::array<double, 3>;


  /// What bounds the principal stresses of Mohr-Coulomb, or the derivative of
  /// each by the plastic strain.
  struct MohrCoulombStrength
  {
    double cohesion; // kPa
    double sin_phi, cos_phi;
    double sin_psi;
    double tension; // largest principal stress, kPa; may be infinite

    /// Of a derivative: does nothing change?
    bool
    is_zero() const
    {
      return cohesion == 0. && sin_phi == 0. && cos_phi == 0. &&
             sin_psi == 0. && tension == 0.;
    }
  };


  /**
   * The return to Mohr-Coulomb's surface with a tension cut-off, in principal
   * stresses s_1 >= s_2 >= s_3 (tension positive), where all faces are planes:
   *   f_ij = (1 + sin phi) s_i - (1 - sin phi) s_j - 2 c cos phi,
   *   t_i  = s_i - tension,
   * with flow along (1 + sin psi) e_i - (1 - sin psi) e_j, and along e_i. A
   * return ends on up to three planes: it is exact on faces, edges and corners
   * (Clausen, Damkilde & Andersen 2007 have the regions in closed form; here
   * the planes are found by their multipliers, which must not be negative).
   */
  class MohrCoulombReturn
  {
  public:
    /// @param shear_modulus G (kPa)
    /// @param lame first Lame parameter (kPa)
    MohrCoulombReturn(const double shear_modulus, const double lame)
      : G(shear_modulus)
      , lambda(lame)
    {}

    struct Result
    {
      Principal    stress;         // kPa
      Principal    plastic_strain; // increment, -
      unsigned int n_active = 0;   // planes that hold the stress; 0: elastic
      unsigned int active[3];      // their numbers
      double       multiplier[3];
    };

    /// Is this stress within the surface?
    static bool
    holds(const Principal &trial, const MohrCoulombStrength &strength);

    /// @param trial elastic stress, largest first
    /// @throws NumericalFailure no planes hold it
    Result
    operator()(const Principal           &trial,
               const MohrCoulombStrength &strength) const;

    /**
     * d stress_i / d trial_j of a result. The plastic strain that softens is
     * sqrt(2/3 e:e) of the plastic strain's deviator.
     *
     * @param rate of the strengths; all 0 if they do not depend on it
     */
    void
    slope(const Result              &result,
          const MohrCoulombStrength &strength,
          const MohrCoulombStrength &rate,
          double (&slope)[3][3]) const;

    /**
     * The plastic strain, sqrt(2/3 e:e) of the deviator, by which planes that
     * draw back by `loss` (kPa) let a stress on them go, if the body stays as
     * it is: the largest of a face and the edges beside it. A plane that draws
     * back faster, per plastic strain, snaps back.
     */
    double
    strain_of_loss(const double sin_phi,
                   const double sin_psi,
                   const double loss) const;

    /// sqrt(2/3 e:e) of the deviator of a plastic strain.
    static double
    equivalent(const Principal &e)
    {
      const double mean = (e[0] + e[1] + e[2]) / 3.;
      const double a = e[0] - mean, b = e[1] - mean, c = e[2] - mean;
      return std::sqrt(2. / 3. * (a * a + b * b + c * c));
    }

  private:
    /// D e, elastic.
    Principal
    elastic(const Principal &e) const
    {
      const double add = lambda * (e[0] + e[1] + e[2]);
      return {{2. * G * e[0] + add, 2. * G * e[1] + add, 2. * G * e[2] + add}};
    }

    /// slope() of strengths that do not change.
    void
    fixed_slope(const Result              &result,
                const MohrCoulombStrength &strength,
                double (&slope)[3][3]) const;

    double G, lambda;
  };
} // namespace Waker

#endif
