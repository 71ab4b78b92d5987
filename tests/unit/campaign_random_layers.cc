// SPDX-License-Identifier: LGPL-2.1-or-later
// Random fields of coefficients, and through several layers.
#include <waker/base/errors.h>

#include "campaign_layered_ground.h"
#include "output_temporary_folder.h"
#include "user_errors.h"
#include <algorithm>

namespace campaign_random_layers
{
  using namespace LayeredGround;

  namespace
  {
    const std::string a = "Random fields/a/", b = "Random fields/b/";


    double
    shansep(const double S, const double m, const double pop, const double y)
    {
      const double now = stress(y, 4.), yield = stress(y, 3.5) + pop;
      return S * now * std::pow(yield / now, m);
    }


    std::pair<double, double>
    mean_and_deviation(const std::vector<double> &values)
    {
      double sum = 0., square = 0.;
      for (const double v : values)
        sum += v;
      const double mean = sum / values.size();
      for (const double v : values)
        square += (v - mean) * (v - mean);
      return {mean, std::sqrt(square / (values.size() - 1.))};
    }
  } // namespace


  TEST(RandomLayers, strengths_follow_from_fields_of_S_m_and_POP)
  {
    const Drawn         drawn({"Random fields/Names=a, b, m",
                               b + "Material=clay",
                               b + "Property=POP",
                               b + "Standard deviation=3.5",
                               "Random fields/m/Material=clay",
                               "Random fields/m/Property=strength exponent",
                               "Random fields/m/Coefficient of variation=0.05"});
    std::vector<double> S, pop;
    for (const std::size_t q : drawn.points_of(1))
      {
        S.push_back(drawn.values("strength ratio")[q]);
        pop.push_back(drawn.values("POP")[q]);
        const double m  = drawn.values("strength exponent")[q];
        const double y  = drawn.state.points.initial_position[q][1];
        const double su = shansep(S.back(), m, pop.back(), y);
        // To round-off: the same formula; practice's 4 digits are 1e-4.
        ASSERT_NEAR(drawn.values("undrained shear strength")[q],
                    su,
                    1e-12 * su);
        ASSERT_NEAR(drawn.values("residual strength")[q], su / 2., 1e-12 * su);
        ASSERT_NEAR(drawn.values("overconsolidation ratio")[q],
                    (stress(y, 3.5) + pop.back()) / stress(y, 4.),
                    1e-12);
        ASSERT_GT(m, 0.5);
        ASSERT_LE(m, 1.);
      }
    EXPECT_EQ(S.size(), 256u);
    // They do vary: by more than a third of a deviation, in one realisation.
    EXPECT_GT(mean_and_deviation(S).second, 0.02);
    EXPECT_GT(mean_and_deviation(pop).second, 1.2);
    // The peat is as it was; nothing is random in it.
    for (const std::size_t q : drawn.points_of(2))
      ASSERT_EQ(drawn.values("undrained shear strength")[q],
                drawn.the_case.initial_points.scalar(
                  "undrained shear strength")[q]);
    EXPECT_TRUE(drawn.properties.cut_off(drawn.state).empty() ||
                drawn.properties.cut_off(drawn.state)[0].find("/m:") !=
                  std::string::npos);
  }


  TEST(RandomLayers, a_warning_of_a_field_names_each_of_its_materials_once)
  {
    const std::vector<std::string> settings = {"Materials/peat/POP=15",
                                               a + "Material=clay, peat",
                                               a + "Property=POP",
                                               a + "Distribution=normal"};
    const auto                     warnings = [&](const std::string &sd) {
      auto all = settings;
      all.push_back(a + "Standard deviation=" + sd);
      return Drawn(all).properties.warnings();
    };
    // Of 15 +- 9 kPa 4.8 % lie below 0.
    const auto told = warnings("9");
    ASSERT_EQ(told.size(), 2u);
    EXPECT_EQ(told[0].find("Random fields/a, of \"clay\": with mean 15 and "
                           "standard deviation 9 the limits cut off 4.77"),
              0u)
      << told[0];
    EXPECT_EQ(told[1].find("Random fields/a, of \"peat\": with mean 15"), 0u)
      << told[1];
    EXPECT_TRUE(warnings("3.5").empty());
  }


  TEST(RandomLayers, a_number_of_practice)
  {
    // sigma'_v = 95.551 and sigma'_y = 115.731 kPa, S = 0.22, m = 0.9: 24.978.
    const Drawn drawn({"Random fields/a/Coefficient of variation=0",
                       "Random fields/a/Mean=0.22*24.978/(0.22*vertical_stress"
                       "*((daily_vertical_stress + 15)/vertical_stress)^0.9)"});
    for (const std::size_t q : drawn.points_of(1))
      ASSERT_NEAR(drawn.values("undrained shear strength")[q], 24.978, 1e-10);
  }


  TEST(RandomLayers, strength_at_the_top_and_its_growth)
  {
    for (const bool in_layer : {false, true})
      {
        const std::string clay = "Materials/clay/";
        const Drawn       drawn(
          {clay + "Strength from=" + (in_layer ? "depth in layer" : "depth"),
                 clay + "Strength at top=8",
                 clay + "Strength growth=1.5",
                 "Random fields/Names=a, b",
                 a + "Property=strength at top",
                 b + "Material=clay",
                 b + "Property=strength growth",
                 b + "Local share=0"});
        const double k = drawn.values("strength growth")[drawn.points_of(1)[0]];
        EXPECT_NE(k, 1.5);
        for (const std::size_t q : drawn.points_of(1))
          {
            const double depth =
              (in_layer ? 4. : 6.) - drawn.state.points.initial_position[q][1];
            ASSERT_EQ(drawn.values("strength growth")[q], k);
            ASSERT_NEAR(drawn.values("undrained shear strength")[q],
                        drawn.values("strength at top")[q] + k * depth,
                        1e-12);
          }
      }
  }


  TEST(RandomLayers, one_field_runs_through_two_layers)
  {
    const Drawn drawn({a + "Material=clay, peat",
                       a + "Property=POP",
                       a + "Coefficient of variation=0.1"});
    const Drawn all({a + "Material=all",
                     a + "Property=POP",
                     a + "Coefficient of variation=0.1"});
    const Drawn clay({a + "Material=clay",
                      a + "Property=POP",
                      a + "Coefficient of variation=0.1"});
    // What "all" leaves out is said.
    EXPECT_EQ(all.properties.description().back(),
              "Random field \"a\": not of sand, whose law has no POP");
    EXPECT_EQ(drawn.properties.description().size(), 1u);
    // The normal score of a point, with its layer's own mean and deviation.
    const auto score = [&](const Drawn &d, const std::size_t q) {
      const double mean = d.state.points.material[q] == 1 ? 15. : 20.;
      return (d.values("POP")[q] - mean) / (0.1 * mean);
    };
    double       across = 0., square = 0.;
    unsigned int n = 0;
    Drawn        many({a + "Material=clay, peat",
                       a + "Property=POP",
                       a + "Coefficient of variation=0.1"});
    for (const std::size_t q : drawn.points_of(1))
      {
        ASSERT_EQ(drawn.values("POP")[q], all.values("POP")[q]);
        ASSERT_EQ(drawn.values("POP")[q], clay.values("POP")[q]);
      }
    for (const std::size_t q : drawn.points_of(2))
      ASSERT_EQ(clay.values("POP")[q], 20.);
    // Across the border at y = 2, over 200 realisations: neighbouring cells
    // are correlated like those inside of a layer.
    for (unsigned int i = 0; i < 200; ++i)
      {
        many.draw(i);
        const auto &x = many.state.points.initial_position;
        for (const std::size_t p : many.points_of(2))
          if (x[p][1] > 1.75 && std::abs(x[p][0] - 4.125) < 0.01)
            for (const std::size_t q : many.points_of(1))
              if (x[q].distance(x[p] + Tensor<1, 2>({0., 0.25})) < 1e-6)
                {
                  across += score(many, p) * score(many, q);
                  square += score(many, p) * score(many, p);
                  ++n;
                }
      }
    EXPECT_EQ(n, 200u);
    const Correlation   markov(Correlation::Function::markov, {8., 1.});
    const FieldLattice &lattice =
      FieldLattice{2, {{2, 2, 1}}, {{0.25, 0.25, 1.}}, {}};
    const double expected =
      markov.between_cells(lattice.cell_size, {{0, 1, 0}}) /
      markov.between_cells(lattice.cell_size, {});
    // Standard errors 0.1 and 0.06.
    EXPECT_NEAR(square / n, 1., 0.3);
    EXPECT_NEAR(across / square, expected, 0.15);
    EXPECT_GT(expected, 0.5);
  }


  TEST(RandomLayers, mean_deviation_and_correlation_of_what_points_get)
  {
    Drawn               drawn({"Random fields/Names=a, b",
                               b + "Material=clay",
                               b + "Property=POP",
                               b + "Standard deviation=3.5",
                               b + "Scales of fluctuation=8, 1",
                               "Random fields/Correlations=a, b: 0.6"});
    const std::size_t   q = drawn.points_of(1)[100];
    std::vector<double> S, pop;
    double              product = 0.;
    constexpr unsigned  n       = 400;
    for (unsigned int i = 0; i < n; ++i)
      {
        drawn.draw(i);
        S.push_back(drawn.values("strength ratio")[q]);
        pop.push_back(drawn.values("POP")[q]);
      }
    const auto [mean_S, s_S]     = mean_and_deviation(S);
    const auto [mean_pop, s_pop] = mean_and_deviation(pop);
    for (unsigned int i = 0; i < n; ++i)
      product +=
        (S[i] - mean_S) * (pop[i] - mean_pop) / (s_S * s_pop * (n - 1));
    // Four standard errors.
    EXPECT_NEAR(mean_S, 0.3, 4. * 0.06 / std::sqrt(n));
    EXPECT_NEAR(s_S, 0.06, 4. * 0.06 / std::sqrt(2. * n));
    EXPECT_NEAR(mean_pop, 15., 4. * 3.5 / std::sqrt(n));
    EXPECT_NEAR(s_pop, 3.5, 4. * 3.5 / std::sqrt(2. * n));
    EXPECT_NEAR(product, 0.6, 4. * (1. - 0.36) / std::sqrt(n));
  }


  /// What follows from coefficients sets all variables of its points, but the
  /// stiffness.
  TEST(RandomLayers, stiffness_varies_beside_coefficients)
  {
    const std::string   E = "Random fields/E/";
    const Drawn         drawn({"Random fields/Names=a, E",
                               E + "Material=clay",
                               E + "Property=Young's modulus",
                               E + "Distribution=lognormal",
                               E + "Minimum=200",
                               E + "Coefficient of variation=0.3"});
    std::vector<double> ratio, S;
    for (const std::size_t q : drawn.points_of(1))
      {
        ratio.push_back(drawn.values("stiffness ratio")[q]);
        S.push_back(drawn.values("strength ratio")[q]);
      }
    EXPECT_NEAR(mean_and_deviation(ratio).first, 1., 0.3);
    EXPECT_GT(mean_and_deviation(ratio).second, 0.1);
    EXPECT_GT(mean_and_deviation(S).second, 0.02);
  }


  TEST(RandomLayers, measurements_count_where_they_are)
  {
    const TemporaryFolder folder;
    const std::string     name = folder.file("pop.csv");
    // One in the clay, one in the peat, each with its layer's distribution.
    put(name, "4.1, 3.1, 12\n4.1, 1.1, 26\n");
    const Drawn  drawn({a + "Material=clay, peat",
                        a + "Property=POP",
                        a + "Local share=0.75",
                        a + "Measurements=" + name});
    unsigned int found = 0;
    for (std::size_t q = 0; q < drawn.state.points.n_points(); ++q)
      for (const double y : {3.125, 1.125})
        if (drawn.state.points.initial_position[q].distance(
              Point<2>(4.125, y)) < 1e-6)
          {
            EXPECT_NEAR(drawn.values("POP")[q], y > 2. ? 12. : 26., 1e-9);
            ++found;
          }
    EXPECT_EQ(found, 2u);
    // In the sand there is none.
    put(name, "4.1, 3.1, 12\n4.1, 5.1, 26\n");
    EXPECT_USER_ERROR(Drawn({a + "Material=clay, peat",
                             a + "Property=POP",
                             a + "Measurements=" + name}),
                      a + "Measurements",
                      "no points");
  }


  TEST(RandomLayers, what_is_cut_off_is_counted)
  {
    Drawn        drawn({a + "Property=POP", a + "Standard deviation=10"});
    unsigned int n = 0;
    for (unsigned int i = 0; i < 20 && n == 0; ++i)
      {
        drawn.draw(i);
        for (const std::size_t q : drawn.points_of(1))
          {
            ASSERT_GE(drawn.values("POP")[q], 0.);
            n += drawn.values("POP")[q] == 0.;
          }
        ASSERT_EQ(drawn.properties.cut_off(drawn.state).size(),
                  n > 0 ? 1u : 0u);
      }
    ASSERT_GT(n, 0u);
    EXPECT_EQ(drawn.properties.cut_off(drawn.state)[0].find(
                "Random fields/a: " + std::to_string(n) + " of 256 points"),
              0u);
    ASSERT_EQ(drawn.properties.warnings().size(), 1u);
    EXPECT_NE(drawn.properties.warnings()[0].find("cut off 6.68"),
              std::string::npos);
  }


  TEST(RandomLayers, fields_of_different_coefficients_in_two_layers)
  {
    // Of each material the other coefficient stays its own.
    const Drawn drawn({"Random fields/Names=a, b",
                       a + "Material=peat",
                       b + "Material=clay",
                       b + "Property=POP"});
    for (const std::size_t q : drawn.points_of(2))
      {
        const double S = drawn.values("strength ratio")[q];
        const double y = drawn.state.points.initial_position[q][1];
        ASSERT_EQ(drawn.values("POP")[q], 20.);
        ASSERT_NEAR(drawn.values("undrained shear strength")[q],
                    shansep(S, 0.85, 20., y),
                    1e-11);
      }
    for (const std::size_t q : drawn.points_of(1))
      {
        const double pop = drawn.values("POP")[q];
        const double y   = drawn.state.points.initial_position[q][1];
        ASSERT_EQ(drawn.values("strength ratio")[q], 0.3);
        ASSERT_NEAR(drawn.values("undrained shear strength")[q],
                    shansep(0.3, 0.9, pop, y),
                    1e-11);
      }
  }


  TEST(RandomLayers, dilatancy)
  {
    const Drawn drawn({a + "Material=sand", a + "Property=dilatancy angle"});
    double      least = 90., most = 0.;
    for (const std::size_t q : drawn.points_of(0))
      {
        least = std::min(least, drawn.values("dilatancy angle")[q]);
        most  = std::max(most, drawn.values("dilatancy angle")[q]);
        ASSERT_EQ(drawn.values("friction angle")[q], 33.);
      }
    EXPECT_LT(least, 3. - 0.6);
    EXPECT_GT(most, 3. + 0.6);
  }


  TEST(RandomLayers, mistakes)
  {
    EXPECT_NO_THROW(Drawn({}));
    EXPECT_USER_ERROR(Drawn({a + "Material=sand"}),
                      a + "Property",
                      "the material \"sand\" does not have");
    EXPECT_USER_ERROR(Drawn({a + "Property=strength growth"}),
                      a + "Property",
                      "the material \"clay\" does not have");
    EXPECT_USER_ERROR(Drawn({a + "Material=clay, clay"}),
                      a + "Material",
                      "twice");
    EXPECT_USER_ERROR(Drawn({a + "Material=clay, loam"}),
                      a + "Material",
                      "clay, loam");
    EXPECT_USER_ERROR(Drawn({a + "Material="}), a + "Material", "is \"\"");
    EXPECT_USER_ERROR(Drawn(
                        {a + "Material=all", a + "Property=residual cohesion"}),
                      a + "Property",
                      "no material has");
    EXPECT_USER_ERROR(Drawn({"Random fields/Names=a, b",
                             b + "Material=peat, clay",
                             b + "Property=strength ratio"}),
                      b + "Property",
                      "has a field already");
    // The strength follows from S: it cannot have a field beside it.
    EXPECT_USER_ERROR(Drawn({"Random fields/Names=a, b",
                             b + "Material=clay",
                             b + "Property=undrained shear strength"}),
                      b + "Property",
                      "follows from");
    EXPECT_USER_ERROR(Drawn({a + "Mean=0"}), a + "Mean", "is 0.0");
    for (const char *const value : {"-0.1", "1.1", "nan"})
      EXPECT_THROW(Drawn({a + "Local share=" + value}), UserError);
    for (const char *const value : {"-1", "nan", "1e999"})
      {
        EXPECT_THROW(Drawn({std::string("Materials/sand/Strength growth=") +
                            value}),
                     UserError);
        EXPECT_THROW(Drawn({std::string("Materials/peat/Strength at top=") +
                            value}),
                     UserError);
      }
    UndrainedStrengthParameters soil;
    soil.from   = StrengthFrom::depth;
    soil.at_top = 0.;
    EXPECT_USER_ERROR(soil.check("Materials/peat/"),
                      "Materials/peat/Strength at top",
                      "is 0 kPa, and");
  }
} // namespace campaign_random_layers
