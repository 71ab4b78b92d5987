// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/campaign/progress.h>
#include <waker/statistics/intervals.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <vector>

namespace campaign_stopping
{
  // What becomes of the 95 % intervals if a rule that looks at the counts ends
  // the campaign: Clopper and Pearson's promise is for an N that is fixed
  // beforehand.
  namespace
  {
    using namespace Waker;

    /// Of one probability, over all campaigns.
    struct Quality
    {
      double below    = 0.; // probability that the truth is below the interval
      double above    = 0.;
      double estimate = 0.; // mean of the estimates, where there is one
      double weight   = 0.;

      double
      coverage() const
      {
        return 1. - below - above;
      }

      /// (mean - truth) / truth
      double
      bias(const double truth) const
      {
        return estimate / weight / truth - 1.;
      }

      void
      add(const double probability, const Proportion &p, const double truth)
      {
        below += truth < p.low ? probability : 0.;
        above += truth > p.high ? probability : 0.;
        if (p.n > 0)
          {
            estimate += probability * p.estimate;
            weight += probability;
          }
      }
    };


    struct Outcomes
    {
      Quality initial, flooding, flooding_given;
      double  n_mean  = 0.; // realisations
      double  stopped = 0.; // probability that a rule, not N, ended it

      void
      add(const double  probability,
          const Counts &c,
          const double  p_initial,
          const double  p_given)
      {
        const std::uint64_t n = c.n - c.n_failures;
        initial.add(probability, cached(c.n_initial, n), p_initial);
        flooding.add(probability, cached(c.n_flooding, n), p_initial * p_given);
        flooding_given.add(probability,
                           cached(c.n_flooding, c.n_initial),
                           p_given);
        n_mean += probability * n;
      }

    private:
      const Proportion &
      cached(const std::uint64_t count, const std::uint64_t n)
      {
        const auto found = known.find({count, n});
        if (found != known.end())
          return found->second;
        return known.emplace(std::pair(count, n), proportion(count, n))
          .first->second;
      }

      std::map<std::pair<std::uint64_t, std::uint64_t>, Proportion> known;
    };


    /// By name: another member of Counts must not shift these.
    Counts
    counts(const std::uint64_t n,
           const std::uint64_t n_initial,
           const std::uint64_t n_flooding)
    {
      Counts result;
      result.n          = n;
      result.n_initial  = n_initial;
      result.n_flooding = n_flooding;
      return result;
    }


    /**
     * Exactly, by summing over all ways in which counts can come about: the
     * probability of each pair (n_S1, n_F) after each realisation, with what
     * the rule has stopped taken out after each batch.
     */
    Outcomes
    enumerate(const CampaignParameters &parameters,
              const double              p_initial,
              const double              p_given)
    {
      Outcomes           result;
      const unsigned int n_max = parameters.realisations;
      // what cannot matter: counts with a probability below 1e-12
      const unsigned int k_max = std::min<double>(
        n_max, n_max * p_initial + 8. * std::sqrt(n_max * p_initial) + 20.);
      const unsigned int  size = k_max + 1;
      std::vector<double> now(size * size, 0.), next(size * size);
      now[0]               = 1.;
      unsigned int highest = 0; // n_S1 that occurs
      for (unsigned int n = 1; n <= n_max; ++n)
        {
          const unsigned int top = std::min(highest + 1, k_max);
          for (unsigned int k = 0; k <= top; ++k)
            for (unsigned int f = 0; f <= k; ++f)
              {
                double p = (1. - p_initial) * now[k * size + f];
                if (k > 0)
                  {
                    const double *const before = &now[(k - 1) * size];
                    if (f < k)
                      p += p_initial * (1. - p_given) * before[f];
                    if (f > 0)
                      p += p_initial * p_given * before[f - 1];
                  }
                next[k * size + f] = p > 1e-15 ? p : 0.;
              }
          // what the last but one realisation left there
          std::fill(next.begin() + (top + 1) * size, next.end(), 0.);
          now.swap(next);

          const bool                   at_end = n == n_max;
          std::map<unsigned int, bool> rule; // depends on one of the counts
          highest = 0;
          for (unsigned int k = 0; k <= top; ++k)
            for (unsigned int f = 0; f <= k; ++f)
              {
                double &p = now[k * size + f];
                if (p == 0.)
                  continue;
                bool stops = false;
                if (n % parameters.batch == 0)
                  {
                    const bool by_flooding =
                      parameters.initial_failures == 0 &&
                      parameters.target == CampaignTarget::flooding;
                    const unsigned int which = by_flooding ? f : k;
                    const auto         found = rule.find(which);
                    stops =
                      found != rule.end()
                        ? found->second
                        : (rule[which] = enough(parameters, counts(n, k, f)));
                  }
                if (stops || at_end)
                  {
                    result.add(p, counts(n, k, f), p_initial, p_given);
                    result.stopped += stops && !at_end ? p : 0.;
                    p = 0.;
                  }
                else
                  highest = k;
              }
        }
      return result;
    }


    /// The same by chance, with the class that ends campaigns.
    Outcomes
    simulate(const CampaignParameters &parameters,
             const double              p_initial,
             const double              p_given,
             const unsigned int        n_campaigns)
    {
      Outcomes                               result;
      std::mt19937_64                        generator(17);
      std::uniform_real_distribution<double> uniform(0., 1.);
      for (unsigned int c = 0; c < n_campaigns; ++c)
        {
          Progress progress(parameters, 1);
          for (std::uint64_t i = 0; i < progress.end(0); ++i)
            {
              Record record;
              record.realisation = i;
              if (uniform(generator) < p_initial)
                {
                  record.outcome      = Outcome::initial_failure;
                  record.initial_time = 3.;
                  if (uniform(generator) < p_given)
                    {
                      record.outcome       = Outcome::flooding;
                      record.flooding_time = 6.;
                    }
                }
              progress.add(record);
            }
          result.add(1. / n_campaigns, progress.counts(0), p_initial, p_given);
          result.stopped += progress.stopped(0) ? 1. / n_campaigns : 0.;
        }
      return result;
    }


    CampaignParameters
    rule(const std::uint64_t initial_failures,
         const double        variation,
         const double        width,
         const std::uint64_t batch = 50)
    {
      CampaignParameters parameters;
      parameters.realisations             = 2000;
      parameters.batch                    = batch;
      parameters.initial_failures         = initial_failures;
      parameters.coefficient_of_variation = variation;
      parameters.interval_width           = width;
      return parameters;
    }
  } // namespace


  TEST(Stopping, rules_bend_estimates_more_than_intervals)
  {
    struct Case
    {
      CampaignParameters parameters;
      double             p_initial, p_given;
      // expected: coverage and relative bias, rounded; as in
      // doc/theory-reliability.md
      double initial, flooding, flooding_given;
      double bias_initial, bias_flooding, bias_flooding_given;
    };
    const CampaignParameters failures  = rule(50, 0., 0.);
    const CampaignParameters variation = rule(0, 0.3, 0.);
    const CampaignParameters width     = rule(0, 0., 0.1);
    // clang-format off
  for (const Case &c : {
    Case{failures,  0.13, 0.75, 0.958, 0.959, 0.966,  0.016,  0.016,  0.000},
    Case{failures,  0.03, 0.50, 0.951, 0.958, 0.962,  0.018,  0.018,  0.000},
    Case{variation, 0.13, 0.75, 0.961, 0.950, 0.977,  0.047,  0.065,  0.016},
    Case{variation, 0.03, 0.50, 0.961, 0.959, 0.973,  0.046,  0.093,  0.044},
    Case{variation, 0.20, 0.50, 0.961, 0.949, 0.969,  0.029,  0.065,  0.034},
    Case{width,     0.13, 0.75, 0.957, 0.969, 0.971, -0.032, -0.044, -0.017},
    Case{width,     0.03, 0.50, 0.990, 0.984, 0.999, -0.118, -0.239, -0.141}})
      // clang-format on
      {
        const Outcomes o = enumerate(c.parameters, c.p_initial, c.p_given);
        EXPECT_NEAR(o.initial.weight, 1., 1e-9);
        EXPECT_NEAR(o.initial.coverage(), c.initial, 6e-4);
        EXPECT_NEAR(o.flooding.coverage(), c.flooding, 6e-4);
        EXPECT_NEAR(o.flooding_given.coverage(), c.flooding_given, 6e-4);
        EXPECT_NEAR(o.initial.bias(c.p_initial), c.bias_initial, 6e-4);
        EXPECT_NEAR(o.flooding.bias(c.p_initial * c.p_given),
                    c.bias_flooding,
                    6e-4);
        EXPECT_NEAR(o.flooding_given.bias(c.p_given),
                    c.bias_flooding_given,
                    6e-4);
      }
  }


  TEST(Stopping, fixed_number_has_no_bias_and_keeps_its_promise)
  {
    CampaignParameters parameters = rule(0, 0., 0.);
    parameters.realisations       = 400;
    const Outcomes o              = enumerate(parameters, 0.13, 0.75);
    EXPECT_EQ(o.stopped, 0.);
    for (const Quality *const q : {&o.initial, &o.flooding, &o.flooding_given})
      {
        EXPECT_GE(q->coverage(), 0.95);
        EXPECT_LE(q->below, 0.025);
        EXPECT_LE(q->above, 0.025);
      }
    EXPECT_NEAR(o.initial.bias(0.13), 0., 1e-9);
    EXPECT_NEAR(o.flooding_given.bias(0.75), 0., 1e-9);
  }


  TEST(Stopping, bias_after_k_failures_is_that_of_the_inverse_binomial)
  {
    const double       p = 0.13, k = 50.;
    CampaignParameters parameters = rule(50, 0., 0., 1);
    parameters.realisations       = 1000; // none gets that far
    const Outcomes at_once        = enumerate(parameters, p, 0.75);
    EXPECT_NEAR(at_once.stopped, 1., 1e-9);
    const double bias = at_once.initial.bias(p);
    EXPECT_NEAR(bias, (1. - p) / k, 0.04 * (1. - p) / k);
    parameters.batch = 50;
    EXPECT_LT(enumerate(parameters, p, 0.75).initial.bias(p), bias);
  }


  TEST(Stopping, campaigns_by_chance_agree_with_the_enumeration)
  {
    const unsigned int n = 1000;
    for (const CampaignParameters &parameters :
         {rule(50, 0., 0.), rule(0, 0.3, 0.), rule(0, 0., 0.1)})
      {
        const Outcomes exact    = enumerate(parameters, 0.13, 0.75);
        const Outcomes observed = simulate(parameters, 0.13, 0.75, n);
        EXPECT_NEAR(observed.n_mean / exact.n_mean, 1., 0.02);
        EXPECT_NEAR(observed.stopped, exact.stopped, 1e-3);
        for (const auto which : {&Outcomes::initial,
                                 &Outcomes::flooding,
                                 &Outcomes::flooding_given})
          {
            const double c = (exact.*which).coverage();
            EXPECT_NEAR((observed.*which).coverage(),
                        c,
                        4. * std::sqrt(c * (1. - c) / n));
          }
      }
  }
} // namespace campaign_stopping
