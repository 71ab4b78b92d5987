// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/output/summary.h>

#include "output_temporary_folder.h"
#include "store_records.h"
#include "user_errors.h"
#include <gtest/gtest.h>
#include <limits>

namespace Waker::output_summary
{
  namespace fs = std::filesystem;

  namespace
  {
    bool
    contains(const std::string &text, const std::string &part)
    {
      return text.find(part) != std::string::npos;
    }
  } // namespace


  TEST(Output, summary_comes_back_as_it_was)
  {
    const TemporaryFolder folder;
    Summary               summary;
    summary.outcome              = "flooding";
    summary.stop_reason          = "a \"quoted\" reason";
    summary.initial_failure_time = 3.141592653589793;
    summary.residual_width       = 0.1 + 0.2;
    summary.residual_height      = std::numeric_limits<double>::quiet_NaN();
    summary.steps                = 9007199254740993; // no double holds it
    summary.unconverged_steps    = 2;
    summary.parameters_hash      = "abc";
    summary.sliding_masses       = synthetic_masses(3);
    summary.residual_width_z     = 1. / 3.;
    summary.loads                = {{"soil", "m", 0.35, 1.5, 2.5},
                                    {"traffic", "-", 2., 0., {}}};
    summary.write(folder.file("summary.json"));

    const Summary read = Summary::read(folder.file("summary.json"));
    EXPECT_EQ(read.outcome, summary.outcome);
    EXPECT_EQ(read.stop_reason, summary.stop_reason);
    EXPECT_EQ(read.initial_failure_time, summary.initial_failure_time);
    EXPECT_FALSE(read.initial_failure_time_thesis.has_value());
    EXPECT_FALSE(read.flooding_time.has_value());
    EXPECT_EQ(read.residual_width, summary.residual_width);
    EXPECT_NE(read.residual_height, read.residual_height);
    EXPECT_EQ(read.steps, summary.steps);
    EXPECT_EQ(read.unconverged_steps, 2u);
    EXPECT_EQ(read.parameters_hash, "abc");
    EXPECT_EQ(read.residual_width_z, 1. / 3.);
    ASSERT_EQ(read.loads.size(), 2u);
    EXPECT_EQ(read.loads[0].name, "soil");
    EXPECT_EQ(read.loads[0].unit, "m");
    EXPECT_EQ(read.loads[0].factor, 0.35);
    EXPECT_EQ(read.loads[0].held_for, 1.5);
    EXPECT_EQ(read.loads[0].stop_time, 2.5);
    EXPECT_EQ(read.loads[1].factor, 2.);
    EXPECT_FALSE(read.loads[1].stop_time.has_value());
    EXPECT_FALSE(read.residual_height_z.has_value());
    ASSERT_TRUE(read.sliding_masses.has_value());
    EXPECT_EQ(read.sliding_masses->failed_volume, 0.1 + 0.2);
    ASSERT_EQ(read.sliding_masses->masses.size(), 2u);
    EXPECT_EQ(read.sliding_masses->masses[1].upper,
              summary.sliding_masses->masses[1].upper);
    EXPECT_EQ(read.sliding_masses->masses[1].width, 0.7);
    EXPECT_FALSE(read.version.empty());
    EXPECT_FALSE(read.compiler.empty());
    EXPECT_TRUE(
      contains(get(folder.file("summary.json")), "\"flooding_time\": null"));
    EXPECT_FALSE(fs::exists(folder.file("summary.json.tmp")));
  }


  TEST(Output, summary_of_a_newer_version_or_none_is_refused)
  {
    const TemporaryFolder folder;
    const std::string     path = folder.file("summary.json");
    EXPECT_USER_ERROR(Summary::read(path), path, "cannot be read");
    put(path, "{\"outcome\": ");
    EXPECT_USER_ERROR(Summary::read(path), path, "is not a summary");
    Summary summary;
    summary.schema_version = Summary::current_schema_version + 1;
    summary.write(path);
    EXPECT_USER_ERROR(Summary::read(path),
                      path,
                      "has schema version " +
                        std::to_string(summary.schema_version));
  }
} // namespace Waker::output_summary
