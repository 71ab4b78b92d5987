// SPDX-License-Identifier: LGPL-2.1-or-later
// What records say of random fields, as columns of tables.
#include <waker/statistics/field_columns.h>

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace statistics_field_columns
{
  using namespace Waker;

  TEST(FieldColumns, of_all_names_that_records_have)
  {
    const double        nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<Record> one(2), two(1);
    one[1].random_fields = {{"S of peat", 0.5, 0.33, 0.2}};
    two[0].random_fields = {{"S_of_peat", nan, 15., 9.},
                            {"S of peat", -1., 0.3, 0.1}};
    const auto columns   = field_columns({&one, &two});
    ASSERT_EQ(columns.size(), 6u);
    EXPECT_EQ(columns[0].name, "field_S_of_peat_average_score");
    EXPECT_EQ(columns[1].name, "field_S_of_peat_mean");
    EXPECT_EQ(columns[2].name, "field_S_of_peat_least");
    EXPECT_EQ(columns[4].name, "field_S_of_peat__mean"); // another one
    EXPECT_TRUE(std::isnan(columns[1].value(one[0])));
    EXPECT_EQ(columns[0].value(one[1]), 0.5);
    EXPECT_EQ(columns[1].value(two[0]), 0.3);
    EXPECT_EQ(columns[2].value(two[0]), 0.1);
    EXPECT_TRUE(std::isnan(columns[3].value(two[0])));
    EXPECT_EQ(columns[4].value(two[0]), 15.);
    EXPECT_TRUE(field_columns({}).empty());
    EXPECT_EQ(columns[0].units, "1");
  }
} // namespace statistics_field_columns
