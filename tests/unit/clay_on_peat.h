// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_clay_on_peat_h
#define waker_tests_clay_on_peat_h

#include <waker/base/errors.h>
#include <waker/case/case.h>
#include <waker/case/state.h>
#include <waker/program/parameter_reader.h>
#include <waker/simulation/plausibility.h>

#include "level_ground.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

/// Level ground of two layers, and strengths that follow from its stress.
namespace ClayOnPeat
{
  using namespace Waker;

  constexpr double gamma_w = 10.; // the default


  /// Level ground: 2 m of clay on 2 m of peat; the water at 3 m.
  inline std::unique_ptr<Parameters>
  ground(const std::vector<std::string> &more)
  {
    return read_parameters(LevelGround::written(
                             LevelGround::text_of({2.,
                                                   5.,
                                                   {{"top", "clay", 2., 4.},
                                                    {"below", "peat", 0., 2.}},
                                                   R"(
subsection Materials
set Names = clay, peat
subsection clay
  set Unit weight           = 14
  set Saturated unit weight = 15
end
subsection peat
  set Unit weight        = 11
  set Residual strength  = initial_strength/2
end
end
)",
                                                   R"(
subsection Pore water
set Phreatic line = 0, 3; 2, 3
end
)"})),
                           more);
  }


  /// sigma'_v (kPa) at the height y, with the water at `line`.
  inline double
  stress(const double y, const double line)
  {
    const auto weight = [](const double from, const double to) {
      return std::max(to - from, 0.);
    };
    const double clay_low = std::max(y, 2.);
    return 14. * weight(std::max(clay_low, line), 4.) +
           15. * weight(clay_low, std::min(line, 4.)) + 11. * weight(y, 2.) +
           gamma_w * weight(4., line) - gamma_w * weight(y, line);
  }


  const std::vector<std::string> shansep = {
    "Materials/peat/Strength from=SHANSEP",
    "Materials/peat/Strength ratio=0.27",
    "Materials/peat/Strength exponent=0.9",
    "Materials/peat/POP=15"};


  /// SHANSEP, but for what is said otherwise.
  inline std::vector<std::string>
  with(std::vector<std::string> more)
  {
    for (const std::string &usual : shansep)
      {
        const std::string name = usual.substr(0, usual.find('=') + 1);
        if (std::none_of(more.begin(),
                         more.end(),
                         [&](const std::string &setting) {
                           return setting.rfind(name, 0) == 0;
                         }))
          more.push_back(usual);
      }
    return more;
  }
} // namespace ClayOnPeat

#endif
