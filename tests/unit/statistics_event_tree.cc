// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/statistics/event_tree.h>

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace statistics_event_tree
{
  namespace
  {
    using namespace Waker;

    double
    share_of_floods(const std::vector<SlideSequence> &sequences)
    {
      double n = 0;
      for (const SlideSequence &s : sequences)
        n += s.floods;
      return n / sequences.size();
    }
  } // namespace


  TEST(EventTree, equals_the_direct_count_for_any_sequences)
  {
    std::mt19937 generator(7);
    for (unsigned int campaign = 0; campaign < 200; ++campaign)
      {
        // Probabilities that depend on the past in any way, so no Markov chain:
        // on the number of slides and on a hidden property of the realisation.
        std::uniform_real_distribution<double> uniform(0., 1.);
        const unsigned int                     n =
          1 + static_cast<unsigned int>(300 * uniform(generator));
        std::vector<SlideSequence> sequences;
        for (unsigned int i = 0; i < n; ++i)
          {
            const double  weakness = uniform(generator);
            SlideSequence s        = {0, false};
            while (!s.floods && s.n_slides < 9 && uniform(generator) < weakness)
              {
                ++s.n_slides;
                s.floods = uniform(generator) < weakness * weakness;
              }
            sequences.push_back(s);
          }
        const EventTree tree = build_event_tree(sequences, 3);
        const double    p    = share_of_floods(sequences);
        EXPECT_NEAR(tree.probability, p, 1e-14);
        EXPECT_EQ(tree.direct.estimate, p);
        EXPECT_EQ(tree.direct.n, n);
        EXPECT_GE(tree.truncated, p - 1e-14);
        EXPECT_NEAR(tree.truncated, tree.truncated_direct.estimate, 1e-14);
        if (!tree.levels.empty())
          {
            EXPECT_EQ(tree.levels.front().n_reached, n);
            EXPECT_NEAR(tree.levels.back().cumulative, p, 1e-14);
            EXPECT_LE(tree.levels.back().interval.low, p);
            EXPECT_GE(tree.levels.back().interval.high, p);
          }
      }
  }


  TEST(EventTree, by_hand)
  {
    // ten dykes: four stand; one slides once; of the other five, one floods
    // with its first slide, three with the second, one slides three times
    const std::vector<SlideSequence> sequences = {{0, false},
                                                  {0, false},
                                                  {0, false},
                                                  {0, false},
                                                  {1, false},
                                                  {1, true},
                                                  {2, true},
                                                  {2, true},
                                                  {2, true},
                                                  {3, false}};
    const EventTree                  tree      = build_event_tree(sequences, 2);
    ASSERT_EQ(tree.levels.size(), 3U);

    EXPECT_EQ(tree.levels[0].n_reached, 10U);
    EXPECT_EQ(tree.levels[0].n_slides, 6U);
    EXPECT_DOUBLE_EQ(tree.levels[0].slide, 0.6);
    EXPECT_DOUBLE_EQ(tree.levels[0].flooding, 1. / 6);
    EXPECT_DOUBLE_EQ(tree.levels[0].path, 0.1);
    EXPECT_DOUBLE_EQ(tree.levels[0].standing, 0.5);

    EXPECT_EQ(tree.levels[1].n_reached, 5U);
    EXPECT_DOUBLE_EQ(tree.levels[1].slide, 4. / 5);
    EXPECT_DOUBLE_EQ(tree.levels[1].flooding, 3. / 4);
    EXPECT_DOUBLE_EQ(tree.levels[1].path, 0.3);
    EXPECT_DOUBLE_EQ(tree.levels[1].cumulative, 0.4);

    EXPECT_EQ(tree.levels[2].n_reached, 1U);
    EXPECT_DOUBLE_EQ(tree.levels[2].slide, 1.);
    EXPECT_DOUBLE_EQ(tree.levels[2].path, 0.);

    EXPECT_DOUBLE_EQ(tree.probability, 0.4);
    // (4.24): whoever slides twice floods
    EXPECT_DOUBLE_EQ(tree.truncated, 0.5);
    // (4.25): three quarters flood with the second slide
    EXPECT_EQ(tree.critical_slide, 2U);
    EXPECT_DOUBLE_EQ(tree.critical_path, 0.6 * 0.8);

    // Half is not the most.
    EXPECT_EQ(build_event_tree({{1, false}, {1, true}}, 2).critical_slide, 0U);

    EXPECT_EQ(tree.truncated_direct.count, 5U);
    EXPECT_EQ(tree.truncated_direct.n, 10U);
    EXPECT_DOUBLE_EQ(build_event_tree(sequences, 1).truncated, 0.6); // P(S_1)
    EXPECT_DOUBLE_EQ(build_event_tree(sequences, 4).truncated, 0.4);
  }


  TEST(EventTree, without_slides_or_realisations)
  {
    const EventTree none = build_event_tree({{0, false}, {0, false}}, 4);
    EXPECT_TRUE(none.levels.empty());
    EXPECT_EQ(none.probability, 0.);
    EXPECT_EQ(none.truncated, 0.);
    EXPECT_EQ(none.critical_slide, 0U);
    EXPECT_TRUE(std::isnan(none.critical_path));
    EXPECT_GT(none.truncated_direct.high, 0.5); // no count is no certainty
    EXPECT_GT(none.direct.high, 0.5);
    EXPECT_EQ(build_event_tree({}, 4).probability, 0.);
  }


  TEST(EventTree, loses_no_flood_and_takes_no_numerical_failure)
  {
    std::vector<Record> records(4);
    records[1].outcome      = Outcome::flooding; // but no slide was found
    records[1].initial_time = records[1].flooding_time = 3.;
    records[2].outcome      = Outcome::numerical_failure;
    records[2].initial_time = 2.;
    records[3].outcome      = Outcome::initial_failure;
    records[3].initial_time = 2.;
    const std::vector<std::vector<Slide>> slides(4);

    const auto sequences = slide_sequences(records, slides);
    ASSERT_EQ(sequences.size(), 3U);
    const EventTree tree = build_event_tree(sequences, 4);
    EXPECT_EQ(tree.levels.at(0).n_slides, 2U);
    EXPECT_NEAR(tree.probability, 1. / 3, 1e-15);
  }
} // namespace statistics_event_tree
