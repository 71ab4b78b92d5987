// SPDX-License-Identifier: LGPL-2.1-or-later
// The energy of a run with modified Cam clay.
#include <waker/simulation/run_to_end.h>

#include "stress_in_ground.h"

namespace simulation_cam_clay
{
  using namespace Waker;
  using StressInGround::read;

  // A block that is pressed together, sheared and let go: the account closes
  // with the step, also with water in the pores.
  TEST(CamClay, energy_account_of_a_run_closes)
  {
    const std::string block =
      LevelGround::text_of({1.,
                            1.5,
                            {{"sample", "clay", 0., 1.}},
                            R"(
subsection Materials
  set Names = clay
  subsection clay
    set Model                     = modified Cam clay
    set Unit weight               = 16
    set Young's modulus           = 3900
    set Poisson's ratio           = 0.3
    set Friction angle            = 25
    set Preconsolidation pressure = 30
  end
end
)",
                            R"(
subsection Gravity
  set Acceleration   = 0
  set Initial stress = false
end
subsection Kinematics and mapping
  set Objective rate = false
end
subsection Time stepping
  set Scheme          = quasi-static
  set End time        = 2.4
  set Ramp duration   = 0
  set Move points     = false
  set Ghost stiffness = 0
end
subsection Newton
  set Tolerance = 1e-9
end
)"});
    const std::string top = "Boundary conditions/top/";
    for (const std::string water : {"0", "30000"})
      {
        double remainder[2], lost = 0.;
        for (const unsigned int fine : {0u, 1u})
          {
            const auto p = read(
              block,
              {std::string("Time stepping/Time step=") +
                 (fine == 1 ? "0.01" : "0.04"),
               "Materials/clay/Pore fluid stiffness=" + water,
               "Soil profile/sample/Initial stress=-20; -20; -20; 0",
               "Boundary conditions/Names=base, left side, right side, top",
               top + "Region=box",
               top + "From=-1, 0.99",
               top + "To=2, 1.01",
               top + "Type=prescribed",
               top + "Displacement=free; -0.05*sin(t)"});
            const Case<2> the_case(*p, MPI_COMM_SELF);
            State<2>      state = initial_state(the_case);
            EXPECT_GT(state.energy.elastic_start, 0.3); // kappa* p' and more
            Realisation<2> realisation(the_case, state);
            run_to_end(realisation);
            remainder[fine] = state.energy.remainder();
            lost            = state.energy.dissipation;
            EXPECT_EQ(state.unconverged_steps, 0u);
          }
        EXPECT_GT(lost, 0.1);
        EXPECT_LT(std::abs(remainder[1]), 5e-3 * lost) << water;
        EXPECT_LT(std::abs(remainder[1]), 0.3 * std::abs(remainder[0]));
      }
  }
} // namespace simulation_cam_clay
