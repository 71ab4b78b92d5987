// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_materials_envelope_return_h
#define waker_source_materials_envelope_return_h

#include "mohr_coulomb_return.h"
#include <vector>

namespace Waker
{
  /// A plane normal . s <= offset of principal stresses, and the plastic strain
  /// per multiplier.
  struct YieldPlane
  {
    Principal normal, flow;
    double    offset; // kPa
  };


  /**
   * The return of principal stresses to where several of Mohr-Coulomb's
   * surfaces and a tension cut-off hold together, all of them planes: as
   * MohrCoulombReturn, by multipliers that must not be negative. With one
   * surface it is that.
   */
  class EnvelopeReturn
  {
  public:
    /// @param shear_modulus G (kPa)
    /// @param lame first Lame parameter (kPa)
    /// @param surfaces from the steepest to the flattest; of the first the
    /// tension counts
    EnvelopeReturn(const double                            shear_modulus,
                   const double                            lame,
                   const std::vector<MohrCoulombStrength> &surfaces);

    struct Result
    {
      Principal    stress;         // kPa
      Principal    plastic_strain; // increment, -
      unsigned int n_active = 0;
      unsigned int active[3];
    };

    /// @param trial elastic stress, largest first
    /// @throws NumericalFailure no planes hold it
    Result
    operator()(const Principal &trial) const;

    /// d stress_i / d trial_j of a result.
    void
    slope(const Result &result, double (&slope)[3][3]) const;

    /// Is this stress within all surfaces?
    static bool
    holds(const Principal                        &trial,
          const std::vector<MohrCoulombStrength> &surfaces);

  private:
    /// Can these planes hold it alone?
    bool
    try_set(const Principal    &trial,
            const unsigned int  n,
            const unsigned int *set,
            Result             &result) const;

    Principal
    elastic(const Principal &strain) const;

    double                  G, lambda;
    unsigned int            n_surfaces;
    double                  size;   // of the offsets, kPa
    std::vector<YieldPlane> planes; // three of each surface, then tension
  };
} // namespace Waker

#endif
