// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/control/outcome.h>

#include <gtest/gtest.h>
#include <set>

namespace control_outcome
{
  using namespace Waker;

  namespace
  {
    FailureRecord
    record(const double initial, const double flooding)
    {
      FailureRecord r;
      r.started       = true;
      r.initial_time  = initial;
      r.flooding_time = flooding;
      return r;
    }
  } // namespace


  TEST(Control, stable_is_only_a_dyke_at_rest)
  {
    const FailureRecord stands = record(-1., -1.);
    EXPECT_EQ(outcome_of(stands, {}), Outcome::stable);
    EXPECT_EQ(outcome_of(stands, {true, false, false}), Outcome::still_moving);
    EXPECT_EQ(outcome_of(stands, {false, true, false}), Outcome::loads_change);
    EXPECT_EQ(outcome_of(stands, {false, false, true}),
              Outcome::stopped_by_box);
    // What moves under changing loads, or against the box, needs time first.
    EXPECT_EQ(outcome_of(stands, {true, true, true}), Outcome::loads_change);
    EXPECT_EQ(outcome_of(stands, {true, false, true}), Outcome::still_moving);
  }


  TEST(Control, a_failed_dyke_has_failed_whatever_it_does_then)
  {
    for (const Unrest &unrest : {Unrest{},
                                 Unrest{true, false, false},
                                 Unrest{false, true, false},
                                 Unrest{false, false, true}})
      {
        EXPECT_EQ(outcome_of(record(2., -1.), unrest),
                  Outcome::initial_failure);
        EXPECT_EQ(outcome_of(record(2., 3.), unrest), Outcome::flooding);
      }
  }


  TEST(Control, every_outcome_has_a_name_of_its_own)
  {
    std::set<std::string> names;
    unsigned int          n_decided = 0;
    for (unsigned int i = 0; i < n_outcomes; ++i)
      {
        names.insert(to_string(static_cast<Outcome>(i)));
        n_decided += is_decided(static_cast<Outcome>(i));
      }
    EXPECT_EQ(names.size(), n_outcomes);
    EXPECT_EQ(names.count(""), 0u);
    EXPECT_EQ(n_decided, 3u);
    // The numbers and names of stores and journals of Waker 0.1.
    EXPECT_EQ(to_string(Outcome(0)), "stable");
    EXPECT_EQ(to_string(Outcome(1)), "initial failure");
    EXPECT_EQ(to_string(Outcome(2)), "flooding");
    EXPECT_EQ(to_string(Outcome(3)), "numerical failure");
    EXPECT_EQ(to_string(Unrest()), "");
    EXPECT_EQ(to_string(Unrest{true, false, true}),
              "still moving, soil lies against a side of the box");
  }
} // namespace control_outcome
