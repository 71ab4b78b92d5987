// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/statistics/mass_class.h>

#include <cmath>

namespace Waker
{
  namespace
  {
    double
    half_length(const SlidingMass &mass, const unsigned int d)
    {
      return 0.5 * (mass.upper[d] - mass.lower[d]);
    }


    MassClass
    classify(const SlidingMass &first,
             const SlidingMass &mass,
             const double       direction)
    {
      const double back =
        direction * (first.centre[0] - mass.centre[0]) / half_length(first, 0);
      const double sideways =
        std::isnan(first.centre[2])
          ? 0. // 2D
          : std::abs(mass.centre[2] - first.centre[2]) / half_length(first, 2);
      using namespace MassClassLimits;
      if (mass.volume < volume * first.volume ||
          (back < offset && sideways < offset))
        return MassClass::remnant;
      if (sideways >= back)
        return MassClass::side;
      return sideways < offset ? MassClass::behind_centred
                               : MassClass::behind_off_centre;
    }
  } // namespace


  std::vector<MassClass>
  classify_masses(const SlidingMasses &sliding)
  {
    std::vector<MassClass> classes;
    for (const SlidingMass &mass : sliding.masses)
      classes.push_back(
        classes.empty()
          ? MassClass::initial
          : classify(sliding.masses.front(), mass, sliding.direction));
    return classes;
  }
} // namespace Waker
