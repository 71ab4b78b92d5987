// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_cam_clay_sample_h
#define waker_tests_cam_clay_sample_h

#include <waker/materials/modified_cam_clay.h>

#include <cmath>

/// A sample of modified Cam clay in the triaxial apparatus, for the tests of
/// the law.
namespace CamClaySample
{
  using namespace Waker;

  constexpr double compression = 0.1, swelling = 0.02; // lambda*, kappa*
  constexpr double theta  = compression - swelling;
  constexpr double Lambda = 1. - swelling / compression;
  constexpr double E = 3900., nu = 0.3; // G = 1500 kPa
  constexpr double phi   = 25.;         // degrees
  constexpr double least = 1.;          // kPa

  inline ModifiedCamClay
  clay(const double youngs_modulus = E)
  {
    return ModifiedCamClay(1.6,
                           {youngs_modulus, nu, compression, swelling, least},
                           phi,
                           100.);
  }

  inline double
  ratio() // M
  {
    return critical_state_ratio(phi, FrictionHolds::triaxial_compression);
  }

  inline SymmetricTensor<2, 3>
  diagonal(const double axial, const double radial)
  {
    SymmetricTensor<2, 3> t;
    t[0][0] = t[2][2] = radial;
    t[1][1]           = axial;
    return t;
  }

  struct Sample
  {
    Sample(const Material &law, const double p, const double pc)
      : law(&law)
      , stress(diagonal(-p, -p))
      , variables{phi, pc, 0., 0.}
    {}

    double
    strain(const SymmetricTensor<2, 3> &increment)
    {
      strains += increment;
      return law->update(increment, stress, variables, nullptr);
    }

    /// Compress it by an axial strain, with the radial one that makes
    /// `excess`, which falls as the sample widens, 0.
    template <typename Excess>
    void
    compress(const double axial, const Excess &excess)
    {
      double low = -2. * axial, high = 4. * axial;
      for (unsigned int i = 0; i < 100; ++i)
        {
          const double radial = 0.5 * (low + high);
          Sample       tried  = *this;
          tried.strain(diagonal(-axial, radial));
          (excess(tried) > 0. ? low : high) = radial;
        }
      strain(diagonal(-axial, low));
    }

    double
    p() const
    {
      return -trace(stress) / 3.;
    }

    double
    q() const
    {
      return std::sqrt(1.5) * deviator(stress).norm();
    }

    double
    pc() const
    {
      return variables[1];
    }

    /// Compression of the volume (-).
    double
    volume() const
    {
      return -trace(strains);
    }

    /// How far it lies outside the yield surface, over p_c^2.
    double
    excess() const
    {
      const double M = ratio();
      return (q() * q() / (M * M) + p() * (p() - pc())) / (pc() * pc());
    }

    const Material       *law;
    SymmetricTensor<2, 3> stress, strains;
    double                variables[4]; // and an excess pore pressure
  };
} // namespace CamClaySample

#endif
