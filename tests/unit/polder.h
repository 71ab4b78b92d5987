// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_polder_h
#define waker_tests_polder_h

#include <waker/case/case.h>
#include <waker/program/parameter_reader.h>
#include <waker/simulation/plausibility.h>

#include "level_ground.h"
#include "warnings.h"
#include <memory>

/// Level ground, 4 m of clay on 2 m of sand, an aquifer with a head of its own.
namespace Polder
{
  using namespace Waker;
  using Warnings::has;

  constexpr double gamma_w = 10.; // the default

  inline std::unique_ptr<Parameters>
  ground(const std::vector<std::string> &more)
  {
    const std::string text = LevelGround::text_of(
      {3.,
       5.,
       {{"cover", "clay", 0., 4.}, {"aquifer", "sand", -2., 0.}},
       R"(
subsection Materials
  set Names = clay, sand
  subsection clay
    set Model           = Mohr-Coulomb
    set Unit weight     = 15
    set Poisson's ratio = 0.3
    set Friction angle  = 25
  end
  subsection sand
    set Model           = Mohr-Coulomb
    set Unit weight     = 20
    set Poisson's ratio = 0.3
    set Friction angle  = 32
  end
end
)",
       R"(
subsection Pore water
  set Phreatic line = 0, 3; 3, 3
end
subsection Head lines
  set Names = deep
  subsection deep
    set Line = 0, 5; 3, 5
  end
end
subsection Reference lines
  set Names = bottom of clay, top of seepage
  subsection bottom of clay
    set Line             = 0, 0; 3, 0
    set Top head line    = deep
    set Bottom head line = deep
  end
  subsection top of seepage
    set Line = 0, 2; 3, 2
  end
end
)",
       0.5,
       -2.});
    return read_parameters(LevelGround::written(text), more);
  }


  inline std::string
  all_warnings(const std::vector<std::string> &more)
  {
    const auto    parameters = ground(more);
    const Case<2> the_case(*parameters, MPI_COMM_SELF);
    return Warnings::joined(strange_things(the_case));
  }
} // namespace Polder

#endif
