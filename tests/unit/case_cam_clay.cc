// SPDX-License-Identifier: LGPL-2.1-or-later
// Modified Cam clay in a case: what it starts from, random fields of it, what
// is refused, and the energy of a run.
#include <waker/simulation/plausibility.h>
#include <waker/simulation/run_to_end.h>
#include <waker/simulation/strengths.h>

#include "campaign_layered_ground.h"
#include "stress_in_ground.h"
#include "user_errors.h"

namespace case_cam_clay
{
  using namespace Waker;
  using namespace StressInGround;

  namespace
  {
    const double phi = 25. * std::acos(-1.) / 180.;

    /// p_c over the vertical yield stress: (sigma'_y, (1 - sin(phi)) sigma'_y)
    /// lies on the yield surface.
    double
    isotropic_share()
    {
      const double M = 6. * std::sin(phi) / (3. - std::sin(phi));
      const double k = 1. - std::sin(phi);
      const double p = (1. + 2. * k) / 3., q = 1. - k;
      return p + q * q / (M * M * p);
    }

    /// The level ground with it as clay.
    std::vector<std::string>
    with_cam_clay(const std::vector<std::string> &more = {},
                  const std::string              &k0   = "Jaky")
    {
      std::vector<std::string> all = {"Materials/clay/Model=modified Cam clay",
                                      "Materials/clay/Friction angle=25",
                                      "Materials/clay/K0=" + k0};
      all.insert(all.end(), more.begin(), more.end());
      return all;
    }


    template <int dim>
    void
    expect_normally_consolidated(const Case<dim> &level, const double more = 0.)
    {
      const MaterialPoints<dim> &points = level.initial_points;
      unsigned int               n      = 0;
      for (std::size_t p = 0; p < points.n_points(); ++p)
        if (points.material[p] == 1)
          {
            const double vertical = vertical_stress(points.position[p][1]);
            EXPECT_NEAR(-points.stress[p][1][1], vertical, 1e-10);
            EXPECT_NEAR(-points.stress[p][0][0],
                        (1. - std::sin(phi)) * vertical,
                        1e-10);
            EXPECT_NEAR(points.scalar("preconsolidation pressure")[p],
                        isotropic_share() * (vertical + more),
                        1e-9);
            ++n;
          }
      EXPECT_GT(n, 50u);
      EXPECT_LT(largest_excess(level), 1e-9);
      EXPECT_LT(level.stages[0].imbalance, 1e-12);
    }
  } // namespace


  TEST(CamClayGround, k0_stress_is_normally_consolidated_and_in_balance)
  {
    expect_normally_consolidated(
      Case<2>(*read(level_ground, with_cam_clay()), MPI_COMM_SELF));
    expect_normally_consolidated(
      Case<3>(*read(level_ground, in_space(with_cam_clay())), MPI_COMM_SELF));
    expect_normally_consolidated(Case<2>(
      *read(level_ground,
            with_cam_clay({"Materials/clay/Pore fluid stiffness=20000"})),
      MPI_COMM_SELF));
    expect_normally_consolidated(
      Case<2>(*read(level_ground, with_cam_clay({"Materials/clay/POP=12"})),
              MPI_COMM_SELF),
      12.);
    const Case<2> plastic(*read(level_ground,
                                with_cam_clay({"Initial stress/Laws=plastic"})),
                          MPI_COMM_SELF);
    expect_normally_consolidated(plastic);
    EXPECT_EQ(plastic.stages[0].balance->iterations, 0u);
  }


  // Plane strain: K0 stress and M of the other choice lie on the surface, too.
  TEST(CamClayGround, yield_stress_fits_the_test_in_which_friction_holds)
  {
    const Case<2> level(
      *read(level_ground,
            with_cam_clay(
              {"Materials/clay/Friction angle holds in=plane strain",
               "Materials/clay/OCR=1.5"})),
      MPI_COMM_SELF);
    const double s = std::sin(phi), p = (3. - 2. * s) / 3.;
    const double share  = p + s * s / (3. * s * s * p);
    const auto  &points = level.initial_points;
    for (std::size_t q = 0; q < points.n_points(); ++q)
      if (points.material[q] == 1)
        {
          EXPECT_NEAR(points.scalar("preconsolidation pressure")[q],
                      1.5 * share * vertical_stress(points.position[q][1]),
                      1e-9);
        }
  }


  // The stress of a gravity step, or of a K0 below that of virgin compression:
  // the soil has been consolidated by it, and says so.
  TEST(CamClayGround, stress_in_situ_raises_the_preconsolidation_pressure)
  {
    for (const bool is_gravity : {true, false})
      {
        const Case<2> level(
          *(is_gravity
              ? read(level_ground,
                     with_cam_clay({"Initial stress/From=gravity",
                                    "Materials/clay/Poisson's ratio=0.3",
                                    "Materials/sand/Poisson's ratio=0.3"}))
              : read(level_ground, with_cam_clay({}, "0.45"))),
          MPI_COMM_SELF);
        const auto  &points   = level.initial_points;
        unsigned int n_raised = 0;
        for (std::size_t p = 0; p < points.n_points(); ++p)
          n_raised +=
            points.material[p] == 1 &&
            points.scalar("preconsolidation pressure")[p] >
              1.05 * isotropic_share() * vertical_stress(points.position[p][1]);
        EXPECT_GT(n_raised, 50u);
        EXPECT_LT(largest_excess(level), 1e-8);
        unsigned int n_said = 0;
        for (const std::string &text : strange_things(level))
          n_said +=
            text.find("needs a preconsolidation pressure") != std::string::npos;
        EXPECT_EQ(n_said, 1u);
      }
    const Case<2> as_given(*read(level_ground, with_cam_clay()), MPI_COMM_SELF);
    for (const std::string &text : strange_things(as_given))
      EXPECT_EQ(text.find("needs a preconsolidation pressure"),
                std::string::npos)
        << text;
    // A K0 that no pressure explains.
    EXPECT_USER_ERROR(Case<2>(*read(level_ground, with_cam_clay({}, "0.2")),
                              MPI_COMM_SELF),
                      "Materials/clay/K0",
                      "outside the yield surface");
  }


  TEST(CamClayGround, plastic_balance_under_a_slope_keeps_it_on_its_surface)
  {
    const Case<2> bank(
      *read(level_ground,
            with_cam_clay(
              {"Grid/Upper corner=12, 5",
               "Pore water/Phreatic line=0, 1; 12, 1",
               "Soil profile/top/Polygon=0, 2; 8, 2; 5, 3; 0, 3",
               "Soil profile/below/Polygon=0, 0; 12, 0; 12, 2; 0, 2",
               "Materials/sand/Cohesion=3",
               "Materials/clay/POP=5",
               "Initial stress/Laws=plastic"})),
      MPI_COMM_SELF);
    EXPECT_GT(bank.stages[0].imbalance, 1e-3);
    EXPECT_TRUE(bank.stages[0].balance->converged);
    EXPECT_LT(largest_excess(bank), 1e-6);
  }


  TEST(CamClayGround, daily_stage_consolidates_it)
  {
    const auto pc = [](const std::vector<std::string> &more) {
      const Case<2> staged(*read(level_ground,
                                 with_cam_clay(
                                   {"Pore water/Daily phreatic line=0, 1; 4, 1",
                                    "Pore water/Phreatic line=0, 3; 4, 3",
                                    more[0]})),
                           MPI_COMM_SELF);
      const auto   &points = staged.initial_points;
      for (std::size_t p = 0; p < points.n_points(); ++p)
        if (points.material[p] == 1)
          {
            EXPECT_NEAR(points.scalar("preconsolidation pressure")[p],
                        isotropic_share() *
                          vertical_stress(points.position[p][1], 1.),
                        1e-6);
          }
      return largest_excess(staged);
    };
    EXPECT_LT(pc({"Initial stress/Daily stage=true"}), 1e-9);
    EXPECT_LT(pc({"Initial stress/Daily stage=false"}), 1e-9);
  }


  TEST(CamClayGround, what_does_not_go_with_it_is_refused)
  {
    EXPECT_USER_ERROR(
      read(level_ground,
           with_cam_clay(
             {"Time stepping/Scheme=explicit",
              "Kinematics and mapping/Volumetric strain=standard"})),
      "--set Materials/clay/Model",
      "stiffness grows with the pressure");
    EXPECT_USER_ERROR(
      read(level_ground,
           with_cam_clay({"Kinematics and mapping/Strain=logarithmic",
                          "Kinematics and mapping/Volumetric strain=standard",
                          "Pore water/Phreatic line=",
                          "Materials/sand/Saturated unit weight=0",
                          "Initial stress/From=gravity"})),
      "--set Materials/clay/Model",
      "logarithmic strain");
    // Water on it without water in it, as of all soil with friction.
    EXPECT_USER_ERROR(read(level_ground,
                           with_cam_clay({"Pore water/Phreatic line=",
                                          "Materials/sand/Friction angle=0",
                                          "Materials/sand/K0=0.5",
                                          "Water/Side=right",
                                          "Water/Level=3"})),
                      "--set Materials/clay/Model",
                      "press the grains together");
    EXPECT_USER_ERROR(Case<2>(*read(level_ground,
                                    with_cam_clay(
                                      {"Materials/clay/Preconsolidation "
                                       "pressure=50 - 30*y"})),
                              MPI_COMM_SELF),
                      "Materials/clay/Preconsolidation pressure",
                      "is -");
  }


  TEST(CamClayGround, strength_reduction_divides_its_friction)
  {
    const auto    parameters = read(level_ground, with_cam_clay());
    const Case<2> level(*parameters, MPI_COMM_SELF);
    const auto    lines =
      described_strengths(level.materials, parameters->materials);
    EXPECT_NE(lines[1].find("clay: friction angle"), std::string::npos);
    State<2>   state  = initial_state(level);
    const auto before = state.points.scalar("preconsolidation pressure");
    divide_strengths(level.materials, 1.3, state.points);
    for (std::size_t p = 0; p < before.size(); ++p)
      if (state.points.material[p] == 1)
        {
          EXPECT_NEAR(std::tan(state.points.scalar("friction angle")[p] *
                               std::acos(-1.) / 180.),
                      std::tan(phi) / 1.3,
                      1e-12);
          EXPECT_EQ(state.points.scalar("preconsolidation pressure")[p],
                    before[p]);
        }
  }


  TEST(CamClayGround, random_fields_of_what_it_starts_from)
  {
    using LayeredGround::Drawn;
    const std::string        a    = "Random fields/a/";
    std::vector<std::string> soil = {"Materials/clay/Model=modified Cam clay",
                                     "Materials/clay/Friction angle=25",
                                     "Materials/clay/Strength from=initial "
                                     "strength",
                                     "Materials/clay/POP=15"};
    const auto               with = [&](std::vector<std::string> more) {
      more.insert(more.begin(), soil.begin(), soil.end());
      return more;
    };
    const Drawn pop(with({a + "Property=POP", a + "Standard deviation=3.5"}));
    double      least = 1e9, most = 0.;
    for (const std::size_t q : pop.points_of(1))
      {
        const double y = pop.state.points.initial_position[q][1];
        const double x = pop.values("POP")[q];
        least          = std::min(least, x);
        most           = std::max(most, x);
        ASSERT_NEAR(pop.values("preconsolidation pressure")[q],
                    isotropic_share() * (LayeredGround::stress(y, 3.5) + x),
                    1e-9);
      }
    EXPECT_GT(most - least, 5.);
    const Drawn ocr(with({"Random fields/Names=a, b",
                          a + "Property=OCR",
                          a + "Mean=1.5",
                          "Random fields/b/Material=clay",
                          "Random fields/b/Property=friction angle",
                          "Random fields/b/Coefficient of variation=0.1"}));
    for (const std::size_t q : ocr.points_of(1))
      {
        const double y = ocr.state.points.initial_position[q][1];
        const double given =
          isotropic_share() *
          (LayeredGround::stress(y, 3.5) * ocr.values("OCR")[q] + 15.);
        ASSERT_GE(ocr.values("preconsolidation pressure")[q], given - 1e-9);
        ASSERT_NE(ocr.values("friction angle")[q], 25.);
      }
    const Drawn own(with({a + "Property=preconsolidation pressure",
                          a + "Coefficient of variation=0.2"}));
    EXPECT_NE(own.values("preconsolidation pressure")[own.points_of(1)[0]],
              own.the_case.initial_points.scalar(
                "preconsolidation pressure")[own.points_of(1)[0]]);
    EXPECT_USER_ERROR(
      Drawn(with({"Random fields/Names=a, b",
                  a + "Property=POP",
                  a + "Standard deviation=3.5",
                  "Random fields/b/Material=clay",
                  "Random fields/b/Property=preconsolidation pressure"})),
      "Random fields/b/Property",
      "follows from what has a field, too");
    EXPECT_USER_ERROR(Drawn(with(
                        {a + "Property=Young's modulus", a + "Minimum=100"})),
                      "Random fields/a/Property",
                      "does not have");
  }


  // A block that is pressed together, sheared and let go: the account closes
  // with the step, also with water in the pores.
  TEST(CamClayGround, energy_account_of_a_run_closes)
  {
    const std::string block = R"(
subsection Grid
  set Lower corner = 0, 0
  set Upper corner = 1, 1.5
  set Cell size    = 0.5
end
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
subsection Soil profile
  set Layers = sample
  subsection sample
    set Material       = clay
    set Polygon        = 0, 0; 1, 0; 1, 1; 0, 1
    set Initial stress = -20; -20; -20; 0
  end
end
subsection Boundary conditions
  set Names = base, left side, right side, top
  subsection base
    set Region = bottom
    set Type   = fixed
  end
  subsection left side
    set Region = left
    set Type   = roller
  end
  subsection right side
    set Region = right
    set Type   = roller
  end
  subsection top
    set Region       = box
    set From         = -1, 0.99
    set To           = 2, 1.01
    set Type         = prescribed
    set Displacement = free; -0.05*sin(t)
  end
end
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
)";
    for (const std::string water : {"0", "30000"})
      {
        double remainder[2], lost = 0.;
        for (const unsigned int fine : {0u, 1u})
          {
            const auto p =
              read(block,
                   {std::string("Time stepping/Time step=") +
                      (fine == 1 ? "0.01" : "0.04"),
                    "Materials/clay/Pore fluid stiffness=" + water});
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
} // namespace case_cam_clay
