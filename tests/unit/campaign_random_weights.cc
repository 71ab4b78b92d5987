// SPDX-License-Identifier: LGPL-2.1-or-later
// Random unit weights: masses, vertical stress and initial stress together; and
// averages as random variables.
#include <waker/base/errors.h>
#include <waker/campaign/realisation_runner.h>
#include <waker/case/scene.h>

#include "campaign_layered_ground.h"
#include "output_temporary_folder.h"
#include "user_errors.h"
#include <algorithm>
#include <limits>

namespace campaign_random_weights
{
  using namespace LayeredGround;

  namespace
  {
    const std::string a = "Random fields/a/", b = "Random fields/b/";

    const std::vector<std::string> clay_weight = {
      a + "Property=unit weight",
      a + "Minimum=11",
      a + "Coefficient of variation=0.05"};


    /// Largest residual of the forces at t = 0 over the largest of them.
    double
    imbalance(const Drawn &drawn)
    {
      Scene<2> scene(drawn.the_case);
      scene.set(drawn.state.points);
      scene.set_internal_force(drawn.state.points);
      double worst = 0., most = 0.;
      for (unsigned int dof = 0; dof < drawn.the_case.grid.n_dofs(); ++dof)
        if (!drawn.the_case.fixities.removed()[dof])
          {
            const double f = scene.nodes.external_force.begin()[dof];
            worst =
              std::max(worst,
                       std::abs(f - scene.nodes.internal_force.begin()[dof]));
            most = std::max(most, std::abs(f));
          }
      return worst / most;
    }
  } // namespace


  TEST(RandomWeights, one_weight_of_a_layer_by_hand)
  {
    std::vector<std::string> set = clay_weight;
    set.push_back(a + "Local share=0");
    const Drawn  drawn(set);
    const auto   clay  = drawn.points_of(1);
    const double gamma = drawn.values("unit weight")[clay[0]];
    const auto   own   = [&](const std::size_t q) {
      return drawn.the_case.initial_points.mass[q];
    };
    EXPECT_GT(std::abs(gamma - 15.), 0.1);
    for (const std::size_t q : clay)
      ASSERT_NEAR(drawn.state.points.mass[q], own(q) * gamma / 15., 1e-12);
    // Under d metres of it the stress differs by d times the difference, and
    // so does the strength that follows from it: of the peat, too.
    for (const unsigned int material : {1, 2})
      for (const std::size_t q : drawn.points_of(material))
        {
          const double y     = drawn.state.points.initial_position[q][1];
          const double extra = (gamma - 15.) * std::min(4. - y, 2.);
          const double now   = stress(y, 4.) + extra;
          const double yield =
            stress(y, 3.5) + extra + (material == 1 ? 15. : 20.);
          const double S = material == 1 ? 0.3 : 0.36;
          const double m = material == 1 ? 0.9 : 0.85;
          ASSERT_NEAR(drawn.values("undrained shear strength")[q],
                      S * now * std::pow(yield / now, m),
                      1e-10);
        }
    // In situ: the effective stress of a column, at points in the middle of
    // the box. The points' total stress is that of the undrained soil.
    EXPECT_LT(imbalance(drawn), 1e-6);
    for (const std::size_t q : drawn.points_of(2))
      {
        const double y     = drawn.state.points.initial_position[q][1];
        const double total = 2. * 17. + 2. * gamma + (2. - y) * 11.;
        ASSERT_NEAR(drawn.state.points.stress[q][1][1], -total, 0.06 * total);
      }
    double sum = 0., weight = 0.;
    for (const std::size_t q : drawn.points_of(2))
      {
        const double y = drawn.state.points.initial_position[q][1];
        sum += drawn.state.points.stress[q][1][1] / 256.;
        weight -= (2. * 17. + 2. * gamma + (2. - y) * 11.) / 256.;
      }
    EXPECT_NEAR(sum, weight, 1e-4 * std::abs(weight));
  }


  TEST(RandomWeights, a_field_of_it_is_summed_up_over_the_column)
  {
    const Drawn              drawn(clay_weight);
    const MaterialPoints<2> &points = drawn.state.points;
    unsigned int             n      = 0;
    for (const std::size_t q : drawn.points_of(1))
      {
        const double y = points.initial_position[q][1];
        // The points over it, 0.25 m each, and half of its own.
        double total = 2. * 17.;
        for (const std::size_t p : drawn.points_of(1))
          if (std::abs(points.initial_position[p][0] -
                       points.initial_position[q][0]) < 1e-6 &&
              points.initial_position[p][1] > y - 1e-6)
            total += drawn.values("unit weight")[p] * (p == q ? 0.125 : 0.25);
        const double now   = total - gamma_w * (4. - y);
        const double yield = total - gamma_w * std::max(3.5 - y, 0.) + 15.;
        ASSERT_NEAR(drawn.values("undrained shear strength")[q],
                    0.3 * now * std::pow(yield / now, 0.9),
                    1e-10);
        n += std::abs(drawn.values("unit weight")[q] - 15.) > 0.5;
      }
    EXPECT_GT(n, 50u);
    EXPECT_LT(imbalance(drawn), 1e-6);
    // Negative control: with the masses of the case it is not in balance.
    Drawn other(clay_weight);
    other.state.points.mass = other.the_case.initial_points.mass;
    EXPECT_GT(imbalance(other), 1e-3);
  }


  TEST(RandomWeights, saturated_soil_varies_in_the_same_ratio)
  {
    std::vector<std::string> set = clay_weight;
    set.push_back(a + "Material=sand");
    set.push_back(a + "Local share=0");
    set.push_back("Pore water/Phreatic line=0, 5; 8, 5");
    const Drawn drawn(set);
    double      dry = 0., wet = 0.;
    for (const std::size_t q : drawn.points_of(0))
      (drawn.state.points.initial_position[q][1] > 5. ? dry : wet) =
        drawn.values("unit weight")[q];
    EXPECT_GT(std::abs(dry - 17.), 0.1);
    EXPECT_NEAR(wet / dry, 20. / 17., 1e-12);
  }


  TEST(RandomWeights, means_of_the_fields)
  {
    std::vector<std::string> set = clay_weight;
    set.push_back(a + "Mean=16");
    Drawn drawn(set);
    drawn.state = initial_state(drawn.the_case);
    drawn.properties.apply_means(drawn.state);
    for (const std::size_t q : drawn.points_of(1))
      ASSERT_NEAR(drawn.values("unit weight")[q], 16., 1e-12);
    EXPECT_LT(imbalance(drawn), 1e-6);
  }


  TEST(RandomWeights, mistakes)
  {
    EXPECT_NO_THROW(Drawn{clay_weight});
    const std::string weight = a + "Property=unit weight";
    EXPECT_NO_THROW(Drawn({weight, a + "Distribution=lognormal"}));
    EXPECT_USER_ERROR(Drawn({weight, a + "Minimum=16"}), a + "Mean", "limits");
    RandomFieldParameters field;
    field.name     = "a";
    field.property = FieldProperty::unit_weight;
    EXPECT_USER_ERROR(field.check(2), a + "Minimum", "of a unit weight");
    field.minimum = 11.;
    EXPECT_NO_THROW(field.check(2));
    field.mean = "14 + depth";
    EXPECT_USER_ERROR(field.check(2), a + "Mean", "of a unit weight");
    field.mean               = "14";
    field.standard_deviation = "0.1*depth";
    EXPECT_USER_ERROR(field.check(2),
                      a + "Standard deviation",
                      "of a unit weight");
    field.standard_deviation = "0.5";
    EXPECT_NO_THROW(field.check(2));
    field.local_share = 1.5;
    EXPECT_USER_ERROR(field.check(2), a + "Local share", "1.5");
    field.local_share = std::numeric_limits<double>::quiet_NaN();
    EXPECT_USER_ERROR(field.check(2), a + "Local share", "nan");
  }


  TEST(LayerAverages, variance_is_split)
  {
    for (const double share : {0., 0.25, 1.})
      {
        Drawn drawn({a + "Local share=" + std::to_string(share)});
        const std::vector<std::size_t> clay = drawn.points_of(1);
        std::size_t                    p = clay[0], q = clay[0];
        for (const std::size_t i : clay) // the most distant one
          if (drawn.state.points.initial_position[i].distance(
                drawn.state.points.initial_position[p]) >
              drawn.state.points.initial_position[q].distance(
                drawn.state.points.initial_position[p]))
            q = i;
        constexpr unsigned int n      = 400;
        double                 square = 0., product = 0., of_score = 0.;
        for (unsigned int i = 0; i < n; ++i)
          {
            drawn.draw(i);
            const auto  &S = drawn.values("strength ratio");
            const double x = (S[p] - 0.3) / 0.06, y = (S[q] - 0.3) / 0.06;
            square += x * x / n;
            product += x * y / n;
            const auto fields = drawn.properties.summaries(drawn.state);
            EXPECT_EQ(fields.has_value(), share < 1.);
            if (fields)
              {
                const double u = (*fields)[0].average_score;
                of_score += u * u / n;
                if (share == 0.)
                  {
                    ASSERT_NEAR(x, u, 1e-9);
                    ASSERT_EQ(S[p], S[q]);
                  }
              }
          }
        const Correlation markov(Correlation::Function::markov, {8., 1.});
        const std::array<double, 3> cell = {{0.25, 0.25, 1.}};
        const double far = markov.between_cells(cell, {{31, 7, 0}}) /
                           markov.between_cells(cell, {});
        // Four standard errors.
        EXPECT_NEAR(square, 1., 4. * std::sqrt(2. / n));
        EXPECT_NEAR(product, 1. - share + share * far, 4. * std::sqrt(2. / n));
        if (share < 1.)
          {
            EXPECT_NEAR(of_score, 1., 4. * std::sqrt(2. / n));
          }
      }
  }


  TEST(LayerAverages, the_field_beside_it_is_that_of_the_same_noise)
  {
    const Drawn  field({}), both({a + "Local share=0.75"});
    const double u = (*both.properties.summaries(both.state))[0].average_score;
    for (const std::size_t q : field.points_of(1))
      ASSERT_NEAR(both.values("strength ratio")[q] - 0.3,
                  std::sqrt(0.75) * (field.values("strength ratio")[q] - 0.3) +
                    0.5 * 0.06 * u,
                  1e-12);
  }


  TEST(LayerAverages, records_keep_them)
  {
    const auto           input = ground({"Random fields/Names=a, b",
                                         a + "Local share=0",
                                         b + "Material=peat",
                                         b + "Property=POP",
                                         "Time stepping/End time=0.02",
                                         "Time stepping/Time step=0.01"});
    RealisationRunner<2> runner(input->simulation,
                                input->reliability.fields,
                                1,
                                MPI_COMM_SELF);
    const auto           record = runner.run(1, 3, {});
    ASSERT_TRUE(record && record->random_fields);
    ASSERT_EQ(record->random_fields->size(), 2u);
    const FieldSummary &S = (*record->random_fields)[0];
    EXPECT_EQ(S.name, "a");
    EXPECT_NEAR(S.mean, 0.3 + 0.06 * S.average_score, 1e-12);
    EXPECT_EQ(S.mean, record->mean_strength);
    EXPECT_TRUE(std::isnan((*record->random_fields)[1].average_score));
    EXPECT_GT((*record->random_fields)[1].mean, 10.);
    EXPECT_LT((*record->random_fields)[1].least, 20.);
    // As a line of a journal, and back.
    const Record copy = record_from_json(to_json(*record));
    EXPECT_EQ(fingerprint(copy), fingerprint(*record));
    ASSERT_TRUE(copy.random_fields);
    EXPECT_EQ((*copy.random_fields)[0].mean, S.mean);
    EXPECT_EQ((*copy.random_fields)[0].average_score, S.average_score);
    EXPECT_THROW(record_from_json([&] {
                   std::string line = to_json(*record);
                   line.replace(line.find("[\"a\","), 5, "[");
                   return line;
                 }()),
                 std::runtime_error);
  }


  TEST(LayerAverages, measurements_with_errors_tell_of_the_average)
  {
    // z = u, three measurements with error variance e: u | z_o is normal with
    // the mean sum(z_o) / (3 + e) and the variance e / (3 + e).
    RandomFieldsParameters parameters;
    parameters.fields.resize(1);
    RandomFieldParameters &field = parameters.fields[0];
    field.name                   = "a";
    field.local_share            = 0.;
    field.measurement_error      = 0.5;
    const TemporaryFolder folder;
    field.measurements = folder.file("average.csv");
    put(field.measurements, "0.5, 0.5, 1\n1.5, 0.5, 2\n2.5, 0.5, 0.9\n");
    FieldLattice lattice;
    lattice.n_cells = {{4, 2, 1}};
    const RandomFields fields(parameters,
                              {lattice},
                              [](const unsigned int,
                                 const std::array<double, 3> &,
                                 const double value,
                                 const double) { return value; });
    EXPECT_EQ(fields.n_noise(), 4u);
    double                           sum = 0., square = 0.;
    std::vector<std::vector<double>> scores;
    std::vector<double>              averages;
    constexpr unsigned int           n = 4000;
    for (unsigned int i = 0; i < n; ++i)
      {
        const std::vector<double> noise = realisation_noise(5, i, 4);
        fields.generate(noise.data(), scores, averages);
        for (const double z : scores[0])
          ASSERT_NEAR(z, averages[0], 1e-12);
        sum += averages[0] / n;
        square += averages[0] * averages[0] / n;
      }
    const double e = 0.25, mean = 3.9 / (3. + e), variance = e / (3. + e);
    EXPECT_NEAR(sum, mean, 4. * std::sqrt(variance / n));
    EXPECT_NEAR(square - sum * sum,
                variance,
                4. * variance * std::sqrt(2. / n));
  }
} // namespace campaign_random_weights
