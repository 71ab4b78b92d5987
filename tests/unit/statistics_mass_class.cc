// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/statistics/mass_class.h>

#include <gtest/gtest.h>

namespace statistics_mass_class
{
  using namespace Waker;

  namespace
  {
    /// A box of soil, 1 m high.
    SlidingMass
    box(const double x0, const double x1, const double z0, const double z1)
    {
      SlidingMass mass;
      mass.lower  = {{x0, 0., z0}};
      mass.upper  = {{x1, 1., z1}};
      mass.centre = {{0.5 * (x0 + x1), 0.5, 0.5 * (z0 + z1)}};
      mass.width  = z1 - z0;
      mass.volume = (x1 - x0) * (z1 - z0);
      return mass;
    }


    std::vector<std::string>
    names(const SlidingMasses &sliding)
    {
      std::vector<std::string> names;
      for (const MassClass mass_class : classify_masses(sliding))
        names.push_back(name_of(mass_class));
      return names;
    }
  } // namespace


  // A slope with its edge at x = 2.5 that falls to the right; the first mass is
  // 2 m long and from z = 3 to 5.
  TEST(Statistics, sliding_masses_are_beside_the_first_or_behind_it)
  {
    SlidingMasses sliding;
    EXPECT_TRUE(classify_masses(sliding).empty());
    sliding.masses                          = {box(1.5, 3.5, 3., 5.),
                                               box(1.6, 3.5, 5., 6.), // beside it
                                               box(1.7, 3.5, 1., 3.), // on the other side
                                               box(0.7, 1.5, 3.2, 4.8), // behind it
                                               box(0.7, 1.5, 4.5, 5.), // behind one of its corners
                                               box(0., 0.7, 3.2, 4.4), // and further back
                                               box(1.4, 3.4, 3., 5.), // what it has left on its face
                                               box(0.7, 1.5, 3.9, 4.1)}; // small
    const std::vector<std::string> expected = {"initial",
                                               "side",
                                               "side",
                                               "behind, centred",
                                               "behind, off centre",
                                               "behind, centred",
                                               "remnant",
                                               "remnant"};
    EXPECT_EQ(names(sliding), expected);

    // A slope that falls to the left.
    SlidingMasses mirrored = sliding;
    mirrored.direction     = -1.;
    for (SlidingMass &mass : mirrored.masses)
      {
        mass.centre[0] = -mass.centre[0];
        std::swap(mass.lower[0], mass.upper[0]);
        mass.lower[0] = -mass.lower[0];
        mass.upper[0] = -mass.upper[0];
      }
    EXPECT_EQ(names(mirrored), expected);
    // Soil in front of the first mass is not behind it.
    sliding.direction = -1.;
    EXPECT_EQ(names(sliding)[3], "remnant");
  }


  TEST(Statistics, sliding_masses_in_the_plane_are_all_centred)
  {
    SlidingMasses sliding;
    sliding.masses = {box(1.5, 3.5, 0., 1.), box(0.7, 1.5, 0., 1.)};
    for (SlidingMass &mass : sliding.masses)
      mass.lower[2] = mass.upper[2] = mass.centre[2] = mass.width =
        SlidingMass::nan;
    EXPECT_EQ(classify_masses(sliding).at(1), MassClass::behind_centred);
  }
} // namespace statistics_mass_class
