// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/sizes.h>

#include "output_temporary_folder.h"
#include <gtest/gtest.h>
#include <limits>

namespace base_sizes
{
  namespace
  {
    using namespace Waker;


    TEST(Sizes, counts_that_fit_become_integers)
    {
      EXPECT_EQ(checked_count("A/B", 0., "cells", 10.), 0u);
      EXPECT_EQ(checked_count("A/B", 10., "cells", 10.), 10u);
      EXPECT_EQ(checked_count("A/B", 4294967297., "cells", 1e15), 4294967297u);
    }


    TEST(Sizes, counts_that_do_not_are_refused_with_the_number)
    {
      for (const double count : {11.,
                                 1e300,
                                 -1.,
                                 std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::quiet_NaN()})
        EXPECT_THROW(checked_count("A/B", count, "cells", 10.), UserError)
          << count;
      try
        {
          checked_count("Grid/Cell size", 3e12, "cells", 1e9, "larger cells");
          FAIL();
        }
      catch (const UserError &error)
        {
          EXPECT_EQ(error.where, "Grid/Cell size");
          EXPECT_EQ(error.problem, "asks for 3e+12 cells");
          EXPECT_EQ(error.allowed, "at most 1e+09: larger cells");
        }
    }


    TEST(Sizes, memory_that_is_not_there_is_refused)
    {
      EXPECT_NO_THROW(require_memory("A/B", "is 3", 1e9, "less", 1e9));
      try
        {
          require_memory("A/B", "is 3 m", 1.234e12, "less", 21e9);
          FAIL();
        }
      catch (const UserError &error)
        {
          EXPECT_EQ(error.problem, "is 3 m, about 1.2 TB of memory");
          EXPECT_EQ(error.allowed,
                    "at most the 21 GB that this program can have here: less");
        }
    }


    TEST(Sizes, this_machine_has_some_memory)
    {
      const double bytes = available_memory();
      EXPECT_GT(bytes, 1e7);
      EXPECT_LT(bytes, 1e15);
    }


    TEST(Sizes, the_least_of_machine_and_control_groups_counts)
    {
      const TemporaryFolder folder;
      const std::string     root = folder.path + "/";
      EXPECT_EQ(available_memory(root),
                std::numeric_limits<double>::infinity());
      put(root + "proc/meminfo", "MemTotal: 9000 kB\nMemAvailable: 8000 kB\n");
      EXPECT_EQ(available_memory(root), 8000. * 1024.);

      // Version 2: the group around leaves less than the own one.
      put(root + "proc/self/cgroup", "0::/job/step\n");
      put(root + "sys/fs/cgroup/job/step/memory.max", "max\n");
      put(root + "sys/fs/cgroup/job/step/memory.current", "100\n");
      EXPECT_EQ(available_memory(root), 8000. * 1024.);
      put(root + "sys/fs/cgroup/job/memory.max", "5000000\n");
      put(root + "sys/fs/cgroup/job/memory.current", "1000000\n");
      put(root + "sys/fs/cgroup/job/memory.stat", "anon 700000\nfile 300000\n");
      EXPECT_EQ(available_memory(root), 4300000.);

      // Version 1, where a container sees itself as the root of its mount.
      put(root + "proc/self/cgroup", "7:cpu:/a\n4:memory:/far/away\n");
      put(root + "sys/fs/cgroup/memory/memory.limit_in_bytes", "3000000\n");
      put(root + "sys/fs/cgroup/memory/memory.usage_in_bytes", "500000\n");
      EXPECT_EQ(available_memory(root), 2500000.);
    }


    TEST(Sizes, are_written_in_units_that_one_reads)
    {
      EXPECT_EQ(bytes_text(12.), "12 B");
      EXPECT_EQ(bytes_text(31.4e6), "31.4 MB");
      EXPECT_EQ(bytes_text(999.9e6), "1 GB");
      EXPECT_EQ(bytes_text(4.21e9), "4.2 GB");
      EXPECT_EQ(rough_duration_text(0.2), "1 s");
      EXPECT_EQ(rough_duration_text(45.3), "45 s");
      EXPECT_EQ(rough_duration_text(600.), "10 minutes");
      EXPECT_EQ(rough_duration_text(1.1e6), "13 days");
      EXPECT_EQ(rough_duration_text(1e12), "31688 years");
    }
  } // namespace
} // namespace base_sizes
