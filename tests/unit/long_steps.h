// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_long_steps_h
#define waker_tests_long_steps_h

#include <waker/base/errors.h>
#include <waker/loads/water_level.h>
#include <waker/mechanics/energy.h>
#include <waker/simulation/plausibility.h>
#include <waker/simulation/run_to_end.h>

#include "campaign_random_dyke.h"
#include "level_ground.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

/// The coarse dyke in water that moves, in long steps.
namespace LongStepsOfADyke
{
  using namespace Waker;

  using LevelGround::with;


  /// The coarse dyke, elastic but for its strength (kPa), in water that is at
  /// 2 m at first.
  inline std::vector<std::string>
  settings(const double strength, const std::string &rise, const double end)
  {
    return {"Time stepping/Scheme=quasi-static at rest",
            "Time stepping/End time=" + std::to_string(end),
            "Newton/Tolerance=1e-6",
            "Soil profile/dyke/Polygon=0, 0; 30, 0; 18, 5; 12, 5",
            "Materials/clay/Initial strength=" + std::to_string(strength),
            "Materials/clay/Residual strength=" + std::to_string(strength),
            "Materials/clay/Softening modulus=0",
            "Water/Level=2",
            "Water/Rise=" + rise};
  }
} // namespace LongStepsOfADyke

#endif
