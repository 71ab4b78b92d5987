// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/simulation/factor_search.h>

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <vector>

namespace simulation_factor_search
{
  namespace
  {
    using namespace Waker;
    using Law = std::function<TrialResult(double)>;

    /// Search to the end; the factors in the order in which they were tried.
    std::vector<double>
    run(FactorSearch &search, const Law &law)
    {
      std::vector<double> tried;
      while (const auto factor = search.next())
        {
          tried.push_back(*factor);
          search.add(law(*factor));
          if (tried.size() == 1000)
            {
              ADD_FAILURE() << "the search does not end";
              break;
            }
        }
      return tried;
    }


    TrialResult
    fails_above(const double factor, const double limit)
    {
      return factor > limit ? TrialResult::failed : TrialResult::stable;
    }


    TEST(FactorSearch, halves_the_bracket)
    {
      FactorSearch search(0.5, 2.5, 0.25);
      EXPECT_EQ(search.n_left(), 5u);
      const auto tried =
        run(search, [](double f) { return fails_above(f, 1.3); });
      EXPECT_EQ(tried, (std::vector<double>{0.5, 2.5, 1.5, 1., 1.25}));
      EXPECT_EQ(search.highest_stable(), 1.25);
      EXPECT_EQ(search.lowest_failed(), 1.5);
      EXPECT_EQ(search.factor(), 1.375);
      EXPECT_EQ(search.n_left(), 0u);
    }


    TEST(FactorSearch, an_end_on_the_wrong_side_ends_it)
    {
      FactorSearch low(1., 2., 0.1), high(1., 2., 0.1);
      EXPECT_EQ(run(low, [](double f) { return fails_above(f, 0.9); }).size(),
                1u);
      EXPECT_EQ(low.lowest_failed(), 1.);
      EXPECT_FALSE(low.highest_stable() || low.factor());
      EXPECT_EQ(run(high, [](double f) { return fails_above(f, 3.); }).size(),
                2u);
      EXPECT_EQ(high.highest_stable(), 2.);
      EXPECT_FALSE(high.lowest_failed() || high.factor());
    }


    TEST(FactorSearch, one_factor_that_does_not_decide_is_gone_round)
    {
      FactorSearch search(0., 2., 0.1);
      run(search, [](double f) {
        return f == 1. ? TrialResult::undecided : fails_above(f, 1.3);
      });
      ASSERT_TRUE(search.factor());
      EXPECT_NEAR(*search.factor(), 1.3, 0.1);
      EXPECT_TRUE(search.undecided().empty()) << "1 lies below what is stable";
    }


    TEST(FactorSearch, a_gap_of_the_tolerance_is_not_divided)
    {
      FactorSearch search(0., 1., 0.25);
      const auto   tried = run(search, [](const double f) {
        return f == 0.   ? TrialResult::stable
                 : f == 1. ? TrialResult::failed
                           : TrialResult::undecided;
      });
      EXPECT_EQ(tried, (std::vector<double>{0., 1., 0.5, 0.25, 0.75}));
      EXPECT_FALSE(search.factor());
    }


    TEST(FactorSearch, a_gap_without_decisions_is_no_factor_of_safety)
    {
      // Between 1.1 and 1.6 nothing is known: neither side may claim it.
      const Law gap = [](const double f) {
        return f > 1.1 && f < 1.6 ? TrialResult::undecided
                                  : fails_above(f, 1.3);
      };
      FactorSearch search(0.5, 2.5, 0.01);
      const auto   tried = run(search, gap);
      EXPECT_FALSE(search.factor());
      EXPECT_LE(*search.highest_stable(), 1.1);
      EXPECT_GE(*search.lowest_failed(), 1.6);
      EXPECT_EQ(search.undecided().size(), FactorSearch::max_undecided);
      EXPECT_LT(tried.size(), 20u);

      FactorSearch at_end(0.5, 2.5, 0.01);
      EXPECT_EQ(
        run(at_end, [](double) { return TrialResult::undecided; }).size(), 1u);
      EXPECT_FALSE(at_end.factor() || at_end.highest_stable());
      EXPECT_EQ(at_end.undecided(), std::vector<double>{0.5});
    }
  } // namespace
} // namespace simulation_factor_search
