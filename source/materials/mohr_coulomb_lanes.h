// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_materials_mohr_coulomb_lanes_h
#define waker_source_materials_mohr_coulomb_lanes_h

#include <waker/materials/material.h>

#include "mohr_coulomb_return.h"

namespace Waker
{
  namespace MohrCoulombPlanes
  {
    struct Three;
  }

  /**
   * MohrCoulombReturn for up to 16 points at a time, whose strengths do not
   * change within the step: the same sets of planes in the same order, each for
   * all points at once, without branches. What none of the usual sets holds
   * goes to MohrCoulombReturn, which stays the reference.
   *
   * Principal directions are found for all at once where z is one of them, as
   * in plane strain; else point by point.
   */
  class MohrCoulombLanes
  {
  public:
    static constexpr unsigned int size = Material::block_size;

    unsigned int
    n_points() const
    {
      return n;
    }

    /// Take a point in.
    /// @param trial [c][point]: component c of its elastic stress (kPa)
    /// @param shear_modulus, lame kPa
    void
    add(const double (&trial)[6][size],
        const unsigned int         point,
        const MohrCoulombStrength &strength,
        const double               shear_modulus,
        const double               lame);

    /// Of all that were added.
    /// @throws NumericalFailure as MohrCoulombReturn
    void
    find_return(const bool with_slope);

    /// After find_return(): stress (kPa) of the l-th point that was added.
    void
    get_stress(const unsigned int l, double (&stress)[6]) const;

    /// What the equivalent plastic strain of the l-th point grows by (-).
    double
    plastic_strain(const unsigned int l) const
    {
      return MohrCoulombReturn::equivalent(
        {{strain[0][l], strain[1][l], strain[2][l]}});
    }

    /// Plastic dissipation of the l-th point (kPa).
    double
    dissipation(const unsigned int l) const
    {
      return value[0][l] * strain[0][l] + value[1][l] * strain[1][l] +
             value[2][l] * strain[2][l];
    }

    /// After find_return(true): as Material::tangent_block(), of the points
    /// that were added, in their order.
    void
    tangent(const unsigned int  n_components,
            const unsigned int *components,
            double (*D)[size]) const;

  private:
    void
    find_principal_stresses();

    void
    begin(const bool with_slope);

    /// Is there a point whose planes are not yet known?
    bool
    any_open() const;

    /// Points that these planes hold are done.
    template <bool with_slope, unsigned int p>
    void
    try_plane();

    template <bool with_slope, unsigned int p, unsigned int q>
    void
    try_edge();

    template <bool with_slope, unsigned int p, unsigned int q, unsigned int r>
    void
    try_corner();

    template <bool with_slope>
    void
    try_all();

    /// A point's planes, if it is taken: its stress and plastic strain.
    void
    keep(const unsigned int              l,
         const bool                      take,
         const MohrCoulombPlanes::Three &stress,
         const MohrCoulombPlanes::Three &plastic_strain);

    /// Likewise, the rows of its slope.
    void
    keep_slope(const unsigned int              l,
               const bool                      take,
               const MohrCoulombPlanes::Three &first,
               const MohrCoulombPlanes::Three &second,
               const MohrCoulombPlanes::Three &third);

    /// By MohrCoulombReturn.
    void
    return_open_points(const bool with_slope);

    unsigned int        n = 0;
    MohrCoulombStrength strength[size];
    double              two_G[size], lame[size]; // kPa
    double              stress[6][size];         // elastic, kPa
    // Principal values, largest first, and components of their directions.
    double trial[3][size], direction[3][3][size];
    // As in MohrCoulombStrength; 2 c cos phi, and what round-off may be (kPa).
    double sin_phi[size], sin_psi[size], tension[size], offset[size],
      tolerance[size];

    double open[size];   // 1: its planes are not yet known; else 0
    double yields[size]; // likewise
    double value[3][size], strain[3][size], slope[3][3][size];
  };
} // namespace Waker

#endif
