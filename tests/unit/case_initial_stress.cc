// SPDX-License-Identifier: LGPL-2.1-or-later
// Stress at the start by K0 and by gravity, in balance: level ground, layers
// of other stiffness, slopes.
#include <waker/case/scene.h>

#include "stress_in_ground.h"
#include "user_errors.h"

namespace case_initial_stress
{
  using namespace Waker;
  using namespace StressInGround;

  namespace
  {
    /// Largest difference from K0 and columns (kPa), and that it was looked at.
    template <int dim>
    double
    difference_from_k0(const Case<dim> &level)
    {
      const MaterialPoints<dim> &points = level.initial_points;
      const double jaky    = 1. - std::sin(33. * std::acos(-1.) / 180.);
      double       worst   = 0.;
      unsigned int of_sand = 0, of_clay = 0;
      for (std::size_t p = 0; p < points.n_points(); ++p)
        {
          const double y        = points.position[p][1];
          const bool   is_clay  = points.material[p] == 1;
          const double vertical = vertical_stress(y);
          const double k0       = is_clay ? 0.7 + 0.01 * y : jaky;
          const double pressure = is_clay ? 10. * (3. - y) : 0.;
          (is_clay ? of_clay : of_sand) += 1;
          const auto &stress = points.stress[p];
          for (unsigned int a = 0; a < 3; ++a)
            for (unsigned int b = a; b < 3; ++b)
              worst = std::max(
                worst,
                std::abs(
                  stress[a][b] +
                  (a != b ? 0. : (a == 1 ? 1. : k0) * vertical + pressure)));
        }
      EXPECT_GT(of_sand, 100u);
      EXPECT_GT(of_clay, 100u);
      return worst;
    }


    /// A bank of 4 m, 1:2, on 2 m of stiffer ground; K0 far from nu/(1 - nu).
    const std::vector<std::string> bank = {
      "Grid/Upper corner=20, 7",
      "Pore water/Phreatic line=",
      "Soil profile/top/Polygon=0, 2; 16, 2; 8, 6; 0, 6",
      "Soil profile/below/Polygon=0, 0; 20, 0; 20, 2; 0, 2",
      "Materials/sand/Cohesion=4",
      "Materials/sand/Saturated unit weight=0",
      "Materials/clay/Initial strength=60",
      "Materials/clay/K0=0.6"};

    std::vector<std::string>
    bank_with(const std::vector<std::string> &more)
    {
      std::vector<std::string> all = bank;
      all.insert(all.end(), more.begin(), more.end());
      return all;
    }


    template <int dim>
    double
    imbalance(const Case<dim> &the_case)
    {
      Scene<dim> scene(the_case);
      scene.set(the_case.initial_points);
      scene.set_internal_force(the_case.initial_points);
      return out_of_balance(the_case.fixities, scene.nodes);
    }
  } // namespace


  TEST(InitialStress, k0_of_level_ground_is_in_balance_as_it_is)
  {
    const Case<2> level(*read(level_ground), MPI_COMM_SELF);
    EXPECT_LT(difference_from_k0(level), 1e-10); // round-off
    ASSERT_EQ(level.stages.size(), 1u);
    EXPECT_LT(level.stages[0].imbalance, 1e-12);
    EXPECT_LT(level.stages[0].difference_rms, 1e-10);
    const Case<2> plastic(*read(level_ground, {"Initial stress/Laws=plastic"}),
                          MPI_COMM_SELF);
    EXPECT_LT(difference_from_k0(plastic), 1e-10);
    EXPECT_EQ(plastic.stages[0].balance->iterations, 0u);
    const Case<3> space(*read(level_ground, in_space()), MPI_COMM_SELF);
    EXPECT_LT(difference_from_k0(space), 1e-10);
    EXPECT_LT(space.stages[0].imbalance, 1e-12);
    // Control: another K0 is seen.
    const Case<2> other(*read(level_ground, {"Materials/clay/K0=0.75"}),
                        MPI_COMM_SELF);
    EXPECT_GT(difference_from_k0(other), 0.5);
  }


  TEST(InitialStress, load_steps_do_not_go_with_walls)
  {
    EXPECT_USER_ERROR(read(level_ground,
                           {"Initial stress/Laws=plastic",
                            "Walls/Names=w",
                            "Walls/w/Line=-1, 0.1; 3, 0.1"}),
                      "--set Initial stress/Laws",
                      "not carried from load step to load step");
  }


  TEST(InitialStress, gravity_gives_level_ground_the_elastic_k0)
  {
    // One material, without water: each cell has the stress of its centre.
    for (const std::string laws : {"elastic", "plastic"})
      {
        const Case<2> level(*read(level_ground,
                                  {"Initial stress/From=gravity",
                                   "Initial stress/Laws=" + laws,
                                   "Pore water/Phreatic line=",
                                   "Soil profile/Layers=below",
                                   "Soil profile/below/Polygon=0,0; 4,0; 4,4; "
                                   "0,4"}),
                            MPI_COMM_SELF);
        const double  k0 = 0.45 / 0.55;
        for (const auto &stress : level.initial_points.stress)
          {
            EXPECT_NEAR(stress[0][0] / stress[1][1], k0, 1e-6);
            EXPECT_NEAR(stress[2][2] / stress[1][1], k0, 1e-6);
          }
        double lowest = 0.;
        for (std::size_t p = 0; p < level.initial_points.n_points(); ++p)
          {
            const double y      = level.initial_points.position[p][1];
            const double centre = 0.5 * (std::floor(y / 0.5) + 0.5);
            EXPECT_NEAR(level.initial_points.stress[p][1][1],
                        -14. * (4. - centre),
                        1e-5);
            lowest = std::min(lowest, level.initial_points.stress[p][1][1]);
          }
        EXPECT_LT(lowest, -50.);
        EXPECT_EQ(level.stages[0].imbalance, 1.);
      }
  }


  TEST(InitialStress, a_joint_inside_cells_leaves_the_stress_of_columns)
  {
    // Ten times as stiff above a joint at 2.25 m, in the middle of cells.
    const std::vector<std::string> joint = {
      "Pore water/Phreatic line=",
      "Materials/sand/Saturated unit weight=0",
      "Soil profile/top/Polygon=0, 2.25; 4, 2.25; 4, 4; 0, 4",
      "Soil profile/below/Polygon=0, 0; 4, 0; 4, 2.25; 0, 2.25"};
    for (const std::string laws : {"elastic", "plastic"})
      {
        auto more = joint;
        more.push_back("Initial stress/Laws=" + laws);
        const Case<2> level(*read(level_ground, more), MPI_COMM_SELF);
        double        worst = 0.;
        for (std::size_t p = 0; p < level.initial_points.n_points(); ++p)
          {
            const double y = level.initial_points.position[p][1];
            const double vertical =
              18. * (4. - std::max(y, 2.25)) + 14. * std::max(2.25 - y, 0.);
            worst = std::max(worst,
                             std::abs(level.initial_points.stress[p][1][1] +
                                      vertical));
          }
        // Half a metre of soil is 9 kPa.
        EXPECT_LT(worst, 0.6) << laws;
      }
  }


  TEST(InitialStress, under_a_slope_what_is_out_of_balance_is_carried)
  {
    for (const std::string laws : {"elastic", "plastic"})
      {
        const Case<2> slope(*read(level_ground,
                                  bank_with({"Initial stress/Laws=" + laws})),
                            MPI_COMM_SELF);
        EXPECT_GT(slope.stages[0].imbalance, 0.02) << laws;
        EXPECT_LT(slope.stages[0].imbalance, 0.5) << laws;
        EXPECT_LT(imbalance(slope), 1e-4) << laws;
        if (laws == "elastic")
          {
            EXPECT_GT(largest_excess(slope), 0.05); // the control
          }
        else
          {
            EXPECT_LT(largest_excess(slope), 1e-6);
            EXPECT_GT(slope.stages[0].balance->yielding, 1e-3);
          }
        // It is the stress alone that has changed.
        const auto &points = slope.initial_points;
        for (std::size_t p = 0; p < points.n_points(); ++p)
          {
            EXPECT_EQ(points.scalar("plastic strain")[p], 0.);
            EXPECT_EQ(points.position[p], points.initial_position[p]);
            if (points.material[p] == 1)
              {
                EXPECT_EQ(points.scalar("undrained shear strength")[p], 60.);
              }
          }
      }
  }


  TEST(InitialStress, in_space_a_bank_is_that_of_plane_strain)
  {
    // Where soil yields, the ghost stiffness of nodes that are hardly touched
    // counts, which in space has other nodes.
    for (const std::string laws : {"elastic", "plastic"})
      {
        const std::vector<std::string> more = {"Initial stress/Laws=" + laws,
                                               "Grid/Cell size=1"};
        const Case<2> plane(*read(level_ground, bank_with(more)),
                            MPI_COMM_SELF);
        auto          in_3d = in_space(bank_with(more));
        in_3d.erase(std::remove_if(in_3d.begin(),
                                   in_3d.end(),
                                   [](const std::string &setting) {
                                     return setting.rfind("Grid/Upper", 0) == 0;
                                   }),
                    in_3d.end());
        in_3d.push_back("Grid/Upper corner=20, 7, 1");
        const Case<3> space(*read(level_ground, in_3d), MPI_COMM_SELF);
        EXPECT_NEAR(space.stages[0].imbalance, plane.stages[0].imbalance, 1e-9);
        double       worst = 0., square = 0.;
        unsigned int compared = 0;
        for (std::size_t p = 0; p < plane.initial_points.n_points(); ++p)
          for (std::size_t q = 0; q < space.initial_points.n_points(); ++q)
            {
              const auto &x = plane.initial_points.position[p];
              const auto &y = space.initial_points.position[q];
              if (std::abs(x[0] - y[0]) + std::abs(x[1] - y[1]) > 1e-9)
                continue;
              const double difference = (plane.initial_points.stress[p] -
                                         space.initial_points.stress[q])
                                          .norm();
              worst = std::max(worst, difference);
              square += difference * difference;
              ++compared;
            }
        EXPECT_EQ(compared, space.initial_points.n_points());
        EXPECT_LT(std::sqrt(square / compared), 0.3) << laws; // kPa
        EXPECT_LT(laws == "elastic" ? worst : largest_excess(space), 1e-6);
      }
  }


  TEST(InitialStress, bad_input_is_refused)
  {
    const auto refused = [](const std::vector<std::string> &more,
                            const std::string              &where,
                            const std::string              &what) {
      expect_refused(
        [&]() { Case<2>(*read(level_ground, more), MPI_COMM_SELF); },
        where,
        what);
    };
    // Active earth pressure of 33 degrees is 0.295, passive 3.392.
    refused({"Materials/sand/K0=0.25"}, "Materials/sand/K0", "outside the");
    refused({"Materials/sand/K0=3.6"}, "Materials/sand/K0", "outside the");
    refused({"Materials/clay/K0=0.1",
             "Materials/clay/Initial strength=10",
             "Materials/clay/Residual strength=5"},
            "Materials/clay/K0",
            "outside the");
    refused({"Materials/sand/K0=-0.1"}, "Materials/sand/K0", "is -0.1");
    refused({"Materials/sand/K0=1e308"}, "Materials/sand/K0", "is 1e+308");
    refused({"Materials/sand/K0=y/0"}, "Materials/sand/K0", "is inf");
    refused({"Materials/sand/K0=0.5 - y"}, "Materials/sand/K0", "at the point");
    refused({"Materials/sand/K0=nonsense"}, "Materials/sand/K0", "nonsense");
    refused({"Materials/clay/K0=Jaky"}, "Materials/clay/K0", "friction");
    // Also if it is not used.
    refused({"Initial stress/From=gravity", "Materials/sand/K0=-1"},
            "Materials/sand/K0",
            "is -1");
    refused({"Gravity/Initial stress=false"},
            "Gravity/Initial stress",
            "From = K0");
    refused({"Gravity/Initial share=0.5"}, "Gravity/Initial share", "is 0.5");
    refused({"Gravity/Acceleration=0"}, "Initial stress/From", "K0");
    refused({"Kinematics and mapping/Strain=logarithmic",
             "Kinematics and mapping/Volumetric strain=standard",
             "Materials/sand/Saturated unit weight=0"},
            "Kinematics and mapping/Strain",
            "logarithmic");
    refused({"Materials/sand/Unit weight=3",
             "Materials/sand/Saturated unit weight=0"},
            "Initial stress/From",
            "float");
    refused({"Initial stress/Laws=plastic",
             "Materials/sand/Pore fluid stiffness=1000"},
            "Materials/sand/Pore fluid stiffness",
            "no stage carries");
    // Borne just so.
    EXPECT_NO_THROW(
      Case<2>(*read(level_ground, {"Materials/sand/K0=0.3"}), MPI_COMM_SELF));
  }


  TEST(InitialStress, a_given_one_must_be_borne)
  {
    const std::string verification =
      WAKER_SOURCE_DIRECTORY "/parameters/verification/";
    const std::string stress = "Soil profile/sample/Initial stress";
    const auto        made   = [&](const std::string &file,
                          const std::string &given,
                          const std::string &more) {
      const auto input =
        read_parameters(verification + file, {stress + "=" + given, more});
      if (input->dimension == 2)
        Case<2>(*input, MPI_COMM_SELF);
      else
        Case<3>(*input, MPI_COMM_SELF);
    };
    // Tension everywhere, of sand; in the plane; pressure along x beyond the
    // passive one, of those points that have it.
    const std::string no_cohesion = "Materials/soil/Cohesion=0";
    expect_refused(
      [&]() {
        made("triaxial_compression.prm", "10; 10; 10; 0; 0; 0", no_cohesion);
      },
      stress,
      "is 10; 10; 10; 0; 0; 0 kPa at the point");
    expect_refused(
      [&]() { made("simple_shear.prm", "10; 10; 10; 0", no_cohesion); },
      stress,
      "17.32 kPa outside");
    const auto input =
      read_parameters(verification + "triaxial_compression.prm",
                      {stress + "=-100 - 400*x; -100; -100; 0; 0; 0",
                       no_cohesion});
    std::size_t n_beyond = 0, n_points = 0;
    {
      auto borne                     = *input;
      borne.layers[0].initial_stress = "-100; -100; -100; 0; 0; 0";
      const Case<3> the_case(borne, MPI_COMM_SELF);
      n_points = the_case.initial_points.n_points();
      for (const Point<3> &x : the_case.initial_points.position)
        n_beyond += 100. + 400. * x[0] > 300.; // tan^2(60 degrees)
    }
    EXPECT_GT(n_beyond, 0u);
    EXPECT_LT(n_beyond, n_points);
    expect_refused([&]() { Case<3>(*input, MPI_COMM_SELF); },
                   stress,
                   "the worst of " + std::to_string(n_beyond) +
                     " such points of the layer's " + std::to_string(n_points));
    // No number, and one whose square is none.
    for (const char *const given : {"0; 0; 0; 1e200", "0; 0; 0; sqrt(-1-y)"})
      EXPECT_THROW(made("simple_shear.prm", given, no_cohesion), UserError);
    // Clay, in total stress.
    const std::string layer = "Soil profile/layer/Initial stress";
    for (const auto &[shear, is_borne] :
         std::vector<std::pair<std::string, bool>>{{"7", true}, {"12", false}})
      {
        const auto clay =
          read_parameters(verification + "sheared_layer.prm",
                          {layer + "=-500; -500; -500; " + shear});
        const auto make = [&]() { Case<2>(*clay, MPI_COMM_SELF); };
        if (is_borne)
          EXPECT_NO_THROW(make());
        else
          expect_refused(make, layer, "is -500; -500; -500; 12 kPa");
      }
    // Borne: none at all, of sand at its apex; pressure; to the limit.
    for (const char *const given :
         {"0; 0; 0; 0; 0; 0", "-10; -10; -10; 0; 0; 0", "-30; -10; -20; 0;0;0"})
      EXPECT_NO_THROW(made("triaxial_compression.prm", given, no_cohesion));
  }


  TEST(InitialStress, each_load_step_is_told)
  {
    unsigned int  n_told = 0;
    double        share  = 0.;
    const auto    input  = read(level_ground,
                            bank_with({"Initial stress/Laws=plastic",
                                           "Initial stress/Steps=20"}));
    const Case<2> the_case(*input,
                           MPI_COMM_SELF,
                           Materials(),
                           [&](const BalanceReport &report) {
                             ++n_told;
                             EXPECT_GE(report.share, share);
                             share = report.share;
                           });
    EXPECT_GE(n_told, 20u);
    EXPECT_NEAR(share, 0.95, 1e-12); // before the last one
  }


  TEST(InitialStress, soil_that_slides_does_not_come_into_balance)
  {
    auto weak = bank_with({"Initial stress/Laws=plastic",
                           "Initial stress/Steps=4",
                           "Materials/sand/Friction angle=10",
                           "Materials/sand/K0=0.8"});
    for (std::string &setting : weak)
      if (setting == "Materials/sand/Cohesion=4")
        setting = "Materials/sand/Cohesion=0.5";
    try
      {
        Case<2>(*read(level_ground, weak), MPI_COMM_SELF);
        ADD_FAILURE() << "a slope of 27 degrees stands on 10";
      }
    catch (const NumericalFailure &failure)
      {
        EXPECT_NE(std::string(failure.what()).find("balance with its laws"),
                  std::string::npos)
          << failure.what();
      }
  }
} // namespace case_initial_stress
