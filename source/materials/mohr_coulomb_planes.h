// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_materials_mohr_coulomb_planes_h
#define waker_source_materials_mohr_coulomb_planes_h

// The planes of mohr_coulomb_return.h, each known to the compiler by its
// number: 0 to 2 of two principal stresses, 3 to 5 of one. Nothing here has a
// branch.
namespace Waker::MohrCoulombPlanes
{
  constexpr unsigned int higher[3] = {0, 0, 1};
  constexpr unsigned int lower[3]  = {2, 1, 2};


  /// Three principal values, which a compiler keeps in registers.
  struct Three
  {
    double x, y, z;
  };


  inline double
  dot(const Three &a, const Three &b)
  {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }


  inline Three
  cross(const Three &a, const Three &b)
  {
    return {a.y * b.z - a.z * b.y,
            a.z * b.x - a.x * b.z,
            a.x * b.y - a.y * b.x};
  }


  template <unsigned int d>
  inline double
  at(const Three &v)
  {
    return d == 0 ? v.x : (d == 1 ? v.y : v.z);
  }


  /// Normal (with sin phi) or flow (with sin psi) of plane k.
  template <unsigned int k>
  inline Three
  across(const double sine)
  {
    if constexpr (k < 3)
      {
        const double up = 1. + sine, down = -(1. - sine);
        const auto   entry = [&](const unsigned int d) {
          return d == higher[k] ? up : (d == lower[k] ? down : 0.);
        };
        return {entry(0), entry(1), entry(2)};
      }
    else
      return {k == 3 ? 1. : 0., k == 4 ? 1. : 0., k == 5 ? 1. : 0.};
  }


  /// normal . v
  template <unsigned int k>
  inline double
  along(const double sine, const Three &v)
  {
    if constexpr (k < 3)
      return (1. + sine) * at<higher[k]>(v) - (1. - sine) * at<lower[k]>(v);
    else
      return at<k - 3>(v);
  }


  /// D flow
  template <unsigned int k>
  inline Three
  stress_of_flow(const double sin_psi, const double two_G, const double lame)
  {
    const Three  flow  = across<k>(sin_psi);
    const double trace = k < 3 ? 2. * sin_psi : 1.;
    const double add   = lame * trace;
    return {two_G * flow.x + add, two_G * flow.y + add, two_G * flow.z + add};
  }


  template <unsigned int k>
  inline double
  offset_of(const double of_pairs, const double tension)
  {
    return k < 3 ? of_pairs : tension;
  }


  /// Is this stress, up to a tolerance, on no plane's wrong side?
  inline bool
  is_held(const Three &s,
          const double sin_phi,
          const double offset,
          const double tension,
          const double tolerance)
  {
    const double most = offset + 4. * tolerance;
    const double high = tension + 4. * tolerance;
    return (along<0>(sin_phi, s) <= most) & (along<1>(sin_phi, s) <= most) &
           (along<2>(sin_phi, s) <= most) & (s.x <= high) & (s.y <= high) &
           (s.z <= high);
  }
} // namespace Waker::MohrCoulombPlanes

#endif
