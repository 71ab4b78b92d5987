// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/loads/water_level.h>
#include <waker/mechanics/energy.h>
#include <waker/simulation/plausibility.h>
#include <waker/simulation/run_to_end.h>

#include "campaign_random_dyke.h"
#include "long_steps.h"
#include "user_errors.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace simulation_long_step_input
{
  using namespace Waker;
  using namespace RandomDyke;
  using namespace LongStepsOfADyke;

  TEST(LongSteps, and_what_does_not_go_with_them)
  {
    const auto refuses = [](const std::vector<std::string> &more,
                            const std::string              &path,
                            const std::string              &text) {
      const auto given = with(settings(13., "0: 0, 3600: 2", 7200.), more);
      EXPECT_USER_ERROR(coarse(given), "--set " + path, text);
    };
    const std::string section = "Time stepping/";
    refuses({section + "Longest step=0.005"},
            section + "Longest step",
            "0.005 s, shorter than Time step, 0.01 s");
    for (const std::string name :
         {"Longest step", "Largest rise", "Largest displacement"})
      for (const std::string scheme : {"quasi-static at rest", "Newmark"})
        for (const std::string value : {"0", "1e308"})
          refuses({section + "Scheme=" + scheme, section + name + "=" + value},
                  section + name,
                  "is " + (value == "0" ? value : "1e+308"));
    refuses({"Outflow/Faces=right"}, "Outflow/Faces", "no balance of momentum");
    refuses({"Materials/clay/Softening modulus=-20",
             "Materials/clay/Residual strength=5",
             "Materials/clay/Regularisation=nonlocal",
             "Materials/clay/Averaging length=2"},
            "Materials/clay/Regularisation",
            "softens soil after a step");
    refuses({"Water/Rise=0: 0, 5: 1, 4: 2"},
            "Water/Rise",
            "does not come after");
  }


  TEST(LongSteps, and_what_is_strange)
  {
    const auto warnings = [](const std::vector<std::string> &more,
                             const std::string              &text) {
      const auto given = with(settings(13., "0: 0, 3600: 2", 7200.), more);
      const auto input = coarse(given);
      for (const std::string &warning : strange_parameters(input->simulation))
        if (warning.find(text) != std::string::npos)
          return true;
      return false;
    };
    EXPECT_FALSE(warnings({}, "Time stepping"));
    EXPECT_TRUE(warnings({"Time stepping/End time=3000"},
                         "3000 s, before the peak of Water/Rise, 2 m at 3600"));
    EXPECT_TRUE(warnings({"Time stepping/Scheme=Newmark"},
                         "quasi-static at rest takes long ones"));
    EXPECT_TRUE(warnings({"Time stepping/Scheme=Newmark",
                          "Time stepping/Largest rise=0.1"},
                         "Largest rise is not used with Scheme = Newmark"));
    EXPECT_TRUE(warnings({"Time stepping/Move points=false"},
                         "Move points is not used with"));
  }
} // namespace simulation_long_step_input
