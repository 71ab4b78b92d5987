// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/file_error.h>
#include <waker/statistics/failure_class.h>
#include <waker/statistics/results_file.h>

#include "output_temporary_folder.h"
#include "processes.h"
#include "results_store.h"
#include "store_records.h"
#include "user_errors.h"
#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <hdf5_hl.h>
#include <limits>
#include <sys/resource.h>
#include <unistd.h>

namespace Waker::statistics_results_file_writing
{
  using namespace Waker;
  using namespace ResultsStore;

  TEST(Statistics, store_says_what_is_missing)
  {
    const TemporaryFolder folder;
    write(folder.file("results.h5"), six_records());
    const OpenStore store(folder.file("results.h5"));
    EXPECT_EQ(store.count("schema_version"), 1u);
    EXPECT_EQ(store.count("seed"), 18446744073709551557u);
    EXPECT_EQ(store.count("realisations_planned"), 8u);
    EXPECT_EQ(store.count("n_truncated_lines"), 3u);
    EXPECT_EQ(store.count("n_damaged_lines"), 4u);
    EXPECT_EQ(store.count("n_foreign_lines"), 5u);
    EXPECT_EQ(store.count("n_repeated_lines"), 6u);
    EXPECT_EQ(store.count("n_conflicting_lines"), 7u);
    EXPECT_EQ(store.count("n_surplus"), 8u);
    EXPECT_NE(store.text("machines").find("\"host\":\"node7\""),
              std::string::npos);
  }


  TEST(Statistics, store_does_not_depend_on_the_order_of_records)
  {
    const TemporaryFolder folder;
    std::vector<Record>   records = six_records();
    write(folder.file("a"), records);
    std::reverse(records.begin(), records.end());
    std::swap(records[1], records[3]);
    write(folder.file("b"), records);
    const std::string a = get(folder.file("a"));
    EXPECT_GT(a.size(), 1000u);
    EXPECT_TRUE(a == get(folder.file("b"))); // byte by byte

    records[2].residual_height += 1e-15;
    write(folder.file("c"), records);
    EXPECT_FALSE(a == get(folder.file("c")));
  }


  TEST(Statistics, store_of_nothing_is_empty)
  {
    const TemporaryFolder folder;
    write(folder.file("results.h5"), {});
    const OpenStore store(folder.file("results.h5"));
    EXPECT_EQ(store.sizes("outcome"), (std::vector<hsize_t>{2, 0}));
    EXPECT_EQ(store.sizes("slide_start"), (std::vector<hsize_t>{2, 0, 1}));
  }


  TEST(Statistics, store_is_written_whole_or_not_at_all)
  {
    const TemporaryFolder folder;
    const std::string     path = folder.file("results.h5");
    put(path, "the one before");
    // A limit on the size of files stands for a full disk. In a process of its
    // own: whatever is thrown, no other test meets the limit.
    const int result = exit_code(in_another_process([&]() {
      std::signal(SIGXFSZ, SIG_IGN);
      const rlimit tight{1000, 1000};
      if (::setrlimit(RLIMIT_FSIZE, &tight) != 0)
        return 1;
      try
        {
          write(path, six_records());
          return 2; // 1000 bytes do not hold it
        }
      catch (const FileError &error)
        {
          const std::string text = error.what();
          return text.find(path) == std::string::npos               ? 3
                 : text.find("File too large") == std::string::npos ? 4
                                                                    : 0;
        }
    }));
    EXPECT_EQ(result, 0);
    EXPECT_EQ(get(path), "the one before");
    EXPECT_FALSE(std::filesystem::exists(path + ".tmp"));

    const std::string nowhere = folder.file("none/results.h5");
    EXPECT_USER_ERROR(write(nowhere, six_records()),
                      "Output/Directory",
                      "cannot write '" + nowhere);
    expect_user_error([&]() { write(path, {synthetic_record(2, 0)}); },
                      path,
                      "a record of scenario 2");
    EXPECT_THROW(write(path, {synthetic_record(0, 0), synthetic_record(0, 0)}),
                 std::logic_error);
    EXPECT_EQ(get(path), "the one before");
  }


  TEST(Statistics, store_takes_parameters_of_any_length)
  {
    // Attributes of fixed length end at 64 KB.
    const TemporaryFolder folder;
    CampaignInfo          info = synthetic_campaign();
    info.parameters            = std::string(200000, 'x');
    write_store(folder.file("results.h5"),
                info,
                six_records(),
                SlideParameters(),
                JournalCounts());
    EXPECT_NE(get(folder.file("results.h5")).find(info.parameters),
              std::string::npos);
  }


  // store_opens.py reads it with other programs.
  TEST(Statistics, store_for_other_programs)
  {
    const char *const     wanted = std::getenv("WAKER_TEST_STORE");
    const TemporaryFolder folder;
    const std::string     path =
      wanted != nullptr ? wanted : folder.file("results.h5");
    write(path, six_records());
    EXPECT_EQ(get(path).substr(1, 3), "HDF");
  }
} // namespace Waker::statistics_results_file_writing
