// SPDX-License-Identifier: LGPL-2.1-or-later
// The stress that a campaign starts from shows how far it is.
#include <waker/campaign/realisation_runner.h>

#include "campaign_layered_ground.h"

namespace campaign_initial_stress
{
  using namespace Waker;

  TEST(RealisationRunner, shows_the_load_steps_of_the_initial_stress)
  {
    const auto n_shown = [](const std::string &laws) {
      const auto input = LayeredGround::ground(
        {"Soil profile/top/Polygon=0, 4; 5, 4; 4, 5; 0, 5",
         "Materials/sand/Cohesion=3",
         "Pore water/Phreatic line=0, 3; 8, 3",
         "Random fields/a/Property=POP",
         "Initial stress/From=K0",
         "Initial stress/Laws=" + laws});
      unsigned int         n     = 0;
      double               share = -1.;
      RealisationRunner<2> runner(input->simulation,
                                  input->reliability.fields,
                                  1,
                                  MPI_COMM_SELF,
                                  [&](const BalanceReport &report) {
                                    EXPECT_GE(report.share, share);
                                    share = report.share;
                                    ++n;
                                  });
      return n;
    };
    EXPECT_GE(n_shown("plastic"), 5u);
    EXPECT_EQ(n_shown("elastic"), 0u);
  }
} // namespace campaign_initial_stress
