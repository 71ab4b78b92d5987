// SPDX-License-Identifier: LGPL-2.1-or-later
// Modified Cam clay in a case: what it starts from, and what is refused.
#include <waker/simulation/plausibility.h>
#include <waker/simulation/strengths.h>

#include "cam_clay_ground.h"
#include "stress_in_ground.h"
#include "user_errors.h"
#include "warnings.h"

namespace case_cam_clay
{
  using namespace Waker;
  using namespace StressInGround;
  using CamClayGround::isotropic_share;
  using CamClayGround::phi;

  namespace
  {
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


  namespace
  {
    /// Sand on it, 1:3, from K0 stress.
    std::vector<std::string>
    bank(const std::string &laws)
    {
      return with_cam_clay(
        {"Grid/Upper corner=12, 5",
         "Pore water/Phreatic line=0, 1; 12, 1",
         "Soil profile/top/Polygon=0, 2; 8, 2; 5, 3; 0, 3",
         "Soil profile/below/Polygon=0, 0; 12, 0; 12, 2; 0, 2",
         "Materials/sand/Cohesion=3",
         "Materials/clay/POP=5",
         "Initial stress/Laws=" + laws});
    }
  } // namespace


  TEST(CamClayGround, plastic_balance_under_a_slope_keeps_it_on_its_surface)
  {
    const Case<2> plastic(*read(level_ground, bank("plastic")), MPI_COMM_SELF);
    EXPECT_GT(plastic.stages[0].imbalance, 1e-3);
    EXPECT_TRUE(plastic.stages[0].balance->converged);
    EXPECT_LT(largest_excess(plastic), 1e-6);
    for (const std::string &text : strange_things(plastic))
      EXPECT_EQ(text.find("outside the yield surface"), std::string::npos)
        << text;
  }


  // An elastic step knows no critical state: a bank of it, 1:1.
  TEST(CamClayGround, stress_beyond_critical_state_is_told)
  {
    const Case<2> elastic(
      *read(level_ground,
            with_cam_clay(
              {"Grid/Upper corner=12, 5",
               "Pore water/Phreatic line=0, 0.5; 12, 0.5",
               "Soil profile/top/Material=clay",
               "Soil profile/top/Polygon=0, 2; 7, 2; 5, 4; 0, 4",
               "Soil profile/below/Polygon=0, 0; 12, 0; 12, 2; 0, 2",
               "Materials/clay/POP=5"})),
      MPI_COMM_SELF);
    const auto  &points = elastic.initial_points;
    const auto  &pc     = points.scalar("preconsolidation pressure");
    const double M      = 6. * std::sin(phi) / (3. - std::sin(phi));
    unsigned int n = 0, n_outside = 0, n_beyond = 0;
    for (std::size_t q = 0; q < points.n_points(); ++q)
      if (points.material[q] == 1)
        {
          ++n;
          const double p = -trace(points.stress[q]) / 3.;
          const double deviator =
            std::sqrt(1.5) *
            (points.stress[q] + p * dealii::unit_symmetric_tensor<3>()).norm();
          const double f = deviator * deviator / (M * M) + p * (p - pc[q]);
          n_outside += f > 1e-3 || p <= 0. ? 1 : 0;
          n_beyond += (f > 1e-3 && deviator > M * p) || p <= 0. ? 1 : 0;
        }
    EXPECT_EQ(n_beyond, n_outside);
    ASSERT_GT(n_outside, 0u);
    std::ostringstream number;
    number << "at " << n_outside << " of " << n
           << " points the stress at the start lies beyond critical state";
    const std::string all = Warnings::joined(strange_things(elastic));
    EXPECT_TRUE(Warnings::has(all, number.str())) << all << number.str();
    EXPECT_TRUE(Warnings::has(all, "outside the yield surface, by up to "));
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
} // namespace case_cam_clay
