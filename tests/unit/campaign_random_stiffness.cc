// SPDX-License-Identifier: LGPL-2.1-or-later
// Random Young's moduli; and a field without spread against a case with other
// parameters, step by step.
#include <waker/base/errors.h>
#include <waker/simulation/run_to_end.h>

#include "campaign_layered_ground.h"
#include "campaign_random_dyke.h"
#include "user_errors.h"
#include <algorithm>

namespace campaign_random_stiffness
{
  using namespace Waker;
  using RandomDyke::coarse;
  using RandomDyke::field;

  namespace
  {
    const std::string stiffness = field + "Property=Young's modulus";


    /// A weak dyke half a second after it was let go.
    State<2>
    moved(const std::vector<std::string> &more,
          const bool                      is_random,
          unsigned int                   &n_iterations,
          double                         &remainder)
    {
      std::vector<std::string> all = {"Time stepping/End time=0.5",
                                      "Materials/clay/Initial strength=9",
                                      "Gravity/Initial share=0.8"};
      all.insert(all.end(), more.begin(), more.end());
      const auto    input = coarse(all);
      const Case<2> the_case(input->simulation, MPI_COMM_SELF);
      State<2>      state = initial_state(the_case);
      if (is_random)
        {
          const RandomProperties<2> properties(the_case,
                                               input->reliability.fields);
          properties.apply(realisation_noise(1, 0, properties.n_noise()).data(),
                           state);
        }
      Realisation<2> realisation(the_case, state);
      run_to_end(realisation);
      n_iterations = state.newton_iterations;
      remainder    = state.energy.remainder();
      return state;
    }


    double
    largest_difference(const State<2> &a, const State<2> &b)
    {
      double worst = 0.;
      for (std::size_t q = 0; q < a.points.n_points(); ++q)
        worst =
          std::max(worst, a.points.position[q].distance(b.points.position[q]));
      return worst;
    }


    double
    largest_displacement(const State<2> &a)
    {
      double most = 0.;
      for (std::size_t q = 0; q < a.points.n_points(); ++q)
        most =
          std::max(most,
                   a.points.position[q].distance(a.points.initial_position[q]));
      return most;
    }
  } // namespace


  TEST(RandomStiffness, a_field_without_spread_is_another_modulus)
  {
    for (const char *const strain : {"standard", "B-bar"})
      {
        const std::string kind =
          std::string("Kinematics and mapping/Volumetric strain=") + strain;
        unsigned int   n_field, n_plain, n_other;
        double         of_field, of_plain, of_other;
        const State<2> varied = moved({kind,
                                       stiffness,
                                       field + "Mean=2000",
                                       field + "Minimum=100",
                                       field + "Coefficient of variation=0"},
                                      true,
                                      n_field,
                                      of_field);
        const State<2> plain =
          moved({kind, "Materials/clay/Young's modulus=2000"},
                false,
                n_plain,
                of_plain);
        const State<2> other = moved({kind}, false, n_other, of_other);
        EXPECT_GT(largest_displacement(plain), 0.005);
        EXPECT_LT(largest_difference(varied, plain),
                  1e-6 * largest_displacement(plain));
        EXPECT_GT(largest_difference(other, plain),
                  0.1 * largest_displacement(plain));
        // The consistent tangent: as many iterations.
        EXPECT_EQ(n_field, n_plain);
        EXPECT_NEAR(varied.energy.elastic,
                    plain.energy.elastic,
                    1e-5 * plain.energy.elastic);
        EXPECT_NEAR(of_field, of_plain, 1e-5 * plain.energy.elastic);
      }
  }


  TEST(RandomStiffness, a_weight_without_spread_is_another_weight)
  {
    unsigned int   n_field, n_plain;
    double         of_field, of_plain;
    const State<2> varied = moved({field + "Property=unit weight",
                                   field + "Mean=18",
                                   field + "Minimum=1",
                                   field + "Coefficient of variation=0"},
                                  true,
                                  n_field,
                                  of_field);
    const State<2> plain =
      moved({"Materials/clay/Unit weight=18"}, false, n_plain, of_plain);
    EXPECT_GT(largest_displacement(plain), 0.005);
    EXPECT_LT(largest_difference(varied, plain),
              1e-6 * largest_displacement(plain));
    for (std::size_t q = 0; q < plain.points.n_points(); ++q)
      ASSERT_NEAR(varied.points.mass[q], plain.points.mass[q], 1e-14);
  }


  TEST(RandomStiffness, a_column_of_layers_carries_the_same_weight)
  {
    using namespace LayeredGround;
    const std::string a = "Random fields/a/";
    const Drawn       drawn({a + "Property=Young's modulus",
                             a + "Material=all",
                             a + "Coefficient of variation=0.3",
                             a + "Minimum=100",
                             a + "Scales of fluctuation=1000, 1"});
    const auto       &E      = drawn.values("Young's modulus");
    const auto       &r      = drawn.values("stiffness ratio");
    const auto [least, most] = std::minmax_element(E.begin(), E.end());
    EXPECT_LT(*least, 800.);
    EXPECT_GT(*most, 1200.);
    double difference = 0.;
    for (std::size_t q = 0; q < E.size(); ++q)
      {
        ASSERT_NEAR(r[q], E[q] / 1000., 1e-12);
        // Layers under one weight: each carries what lies on it.
        difference += (drawn.state.points.stress[q][1][1] -
                       drawn.the_case.initial_points.stress[q][1][1]) /
                      E.size();
      }
    EXPECT_NEAR(difference, 0., 0.05); // of 50 kPa
    EXPECT_GT(drawn.state.energy.elastic_start, 0.);
    EXPECT_NE(drawn.state.energy.elastic_start,
              initial_state(drawn.the_case).energy.elastic_start);
  }


  TEST(RandomStiffness, mistakes)
  {
    using RandomDyke::Drawn;
    const std::string least = field + "Minimum=200";
    EXPECT_NO_THROW(Drawn(*coarse({stiffness, least})));
    EXPECT_THROW(coarse({stiffness}), UserError);
    RandomFieldParameters one;
    one.name     = "strength";
    one.property = FieldProperty::youngs_modulus;
    EXPECT_USER_ERROR(one.check(2), field + "Minimum", "of a Young's modulus");
    // 3 G + sqrt(3) H_s: below 83.7 kPa with H_s = -50 kPa.
    EXPECT_USER_ERROR(Drawn(*coarse({stiffness, field + "Minimum=80"})),
                      field + "Minimum",
                      "snap-back");
    EXPECT_USER_ERROR(Drawn(
                        *coarse({stiffness, field + "Distribution=lognormal"})),
                      field + "Minimum",
                      "snap-back");
    EXPECT_USER_ERROR(
      Drawn(*coarse(
        {stiffness, least, "Kinematics and mapping/Strain=logarithmic"})),
      field + "Property",
      "logarithmic");
    EXPECT_USER_ERROR(Drawn(
                        *coarse({field + "Property=unit weight",
                                 field + "Minimum=10",
                                 "Kinematics and mapping/Strain=logarithmic"})),
                      field + "Property",
                      "logarithmic");
    EXPECT_USER_ERROR(Drawn(*coarse(
                        {stiffness, least, "Time stepping/Scheme=explicit"})),
                      field + "Property",
                      "explicit");
  }
} // namespace campaign_random_stiffness
