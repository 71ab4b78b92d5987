// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/file_error.h>
#include <waker/statistics/failure_class.h>
#include <waker/statistics/results_file.h>

#include "output_temporary_folder.h"
#include "processes.h"
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

namespace Waker::statistics_results_file
{
  namespace
  {
    /// A store opened with the C library.
    class OpenStore
    {
    public:
      explicit OpenStore(const std::string &path)
        : file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT))
      {}

      ~OpenStore()
      {
        H5Fclose(file);
      }

      std::vector<hsize_t>
      sizes(const std::string &name) const
      {
        int rank = 0;
        H5LTget_dataset_ndims(file, name.c_str(), &rank);
        std::vector<hsize_t> sizes(rank);
        H5LTget_dataset_info(
          file, name.c_str(), sizes.data(), nullptr, nullptr);
        return sizes;
      }

      /// Any numbers.
      std::vector<double>
      values(const std::string &name) const
      {
        std::size_t n = 1;
        for (const hsize_t size : sizes(name))
          n *= size;
        std::vector<double> values(n);
        EXPECT_GE(H5LTread_dataset_double(file, name.c_str(), values.data()),
                  0);
        return values;
      }

      std::uint64_t
      count(const std::string &attribute) const
      {
        std::uint64_t value = 0;
        EXPECT_GE(H5LTget_attribute(
                    file, "/", attribute.c_str(), H5T_NATIVE_UINT64, &value),
                  0);
        return value;
      }

      std::string
      text(const std::string &attribute) const
      {
        const hid_t id     = H5Aopen(file, attribute.c_str(), H5P_DEFAULT);
        const hid_t type   = H5Aget_type(id);
        char       *buffer = nullptr;
        EXPECT_GE(H5Aread(id, type, &buffer), 0);
        const std::string value = buffer == nullptr ? "" : buffer;
        H5free_memory(buffer);
        H5Tclose(type);
        H5Aclose(id);
        return value;
      }

    private:
      const hid_t file;
    };


    /// Scenario 0 has 0, 1, 2, 5; scenario 1 has 1 and 7.
    std::vector<Record>
    six_records()
    {
      return {synthetic_record(0, 0),
              synthetic_record(0, 1),
              synthetic_record(0, 2),
              synthetic_record(0, 5),
              synthetic_record(1, 1),
              synthetic_record(1, 7)};
    }

    const std::vector<double> realisations = {0., 1., 2., 5., 7.};


    void
    write(const std::string &path, const std::vector<Record> &records)
    {
      JournalCounts counts;
      counts.n_truncated   = 3;
      counts.n_damaged     = 4;
      counts.n_foreign     = 5;
      counts.n_repeated    = 6;
      counts.n_conflicting = 7;
      MachineUse use;
      use.machine.host   = "node7";
      use.n_realisations = 6;
      counts.machines    = {use};
      write_store(
        path, synthetic_campaign(), records, SlideParameters(), counts, 8);
    }


    /// NaN for -1.
    double
    event(const double time)
    {
      return time < 0. ? std::numeric_limits<double>::quiet_NaN() : time;
    }


    void
    expect_same(const double obtained, const double expected)
    {
      if (std::isnan(expected))
        EXPECT_TRUE(std::isnan(obtained)) << obtained;
      else
        EXPECT_EQ(obtained, expected);
    }
  } // namespace


  TEST(Statistics, store_holds_what_the_records_hold)
  {
    const TemporaryFolder     folder;
    const std::vector<Record> records = six_records();
    write(folder.file("results.h5"), records);
    const OpenStore store(folder.file("results.h5"));
    EXPECT_EQ(store.values("realisation"), realisations);
    EXPECT_EQ(store.sizes("outcome"), (std::vector<hsize_t>{2, 5}));

    const auto outcome    = store.values("outcome");
    const auto classes    = store.values("failure_class");
    const auto attempts   = store.values("attempts");
    const auto linear     = store.values("linear_iterations");
    const auto initial    = store.values("initial_failure_time");
    const auto thesis     = store.values("initial_failure_time_thesis");
    const auto flooding   = store.values("flooding_time");
    const auto width      = store.values("residual_width");
    const auto height     = store.values("residual_height");
    const auto strength   = store.values("mean_strength");
    const auto area       = store.values("inward_area");
    const auto dx         = store.values("inward_dx");
    const auto dy         = store.values("inward_dy");
    const auto first_area = store.values("first_inward_area");
    const auto outward    = store.values("outward_area");

    std::vector<bool> run(10, false);
    for (const Record &record : records)
      {
        const auto        number = std::find(realisations.begin(),
                                      realisations.end(),
                                      double(record.realisation));
        const std::size_t at =
          5 * record.scenario + (number - realisations.begin());
        run[at]            = true;
        const auto slides  = find_slides(record, SlideParameters());
        const bool flooded = record.outcome == Outcome::flooding;
        EXPECT_EQ(outcome[at], static_cast<int>(record.outcome));
        EXPECT_EQ(classes[at], static_cast<int>(classify(record, slides, 0.)));
        EXPECT_EQ(attempts[at], record.attempts);
        EXPECT_EQ(linear[at], 3e12);
        expect_same(initial[at], event(record.initial_time));
        expect_same(thesis[at], event(record.initial_time_thesis));
        expect_same(flooding[at], event(record.flooding_time));
        EXPECT_EQ(width[at], record.residual_width);
        EXPECT_EQ(height[at], record.residual_height);
        EXPECT_EQ(strength[at], record.mean_strength);
        EXPECT_EQ(area[at], record.inward.area);
        expect_same(dx[at], flooded ? 4.5 : NAN);
        expect_same(dy[at], flooded ? -1.25 : NAN);
        expect_same(first_area[at], flooded ? 21. : NAN);
        EXPECT_EQ(outward[at], 0.);
      }
    for (std::size_t at = 0; at < run.size(); ++at)
      if (!run[at])
        {
          EXPECT_EQ(outcome[at], -1.);
          EXPECT_EQ(classes[at], -1.);
          EXPECT_EQ(attempts[at], -1.);
          EXPECT_EQ(linear[at], -1.);
          for (const auto *values :
               {&initial, &flooding, &width, &strength, &area, &outward})
            EXPECT_TRUE(std::isnan((*values)[at]));
        }
    EXPECT_EQ(std::count(run.begin(), run.end(), true), 6);
  }


  TEST(Statistics, store_holds_slides_and_pads_them)
  {
    const TemporaryFolder folder;
    std::vector<Record>   records = six_records();
    records.push_back(synthetic_record(0, 7)); // of which only the first slide
    records.back().trace.resize(4);
    records.back().flooding_time = -1.;
    records.back().outcome       = Outcome::initial_failure;
    write(folder.file("results.h5"), records);
    const OpenStore store(folder.file("results.h5"));
    EXPECT_EQ(store.values("n_slides")[4], 1.);
    EXPECT_FALSE(std::isnan(store.values("slide_start")[2 * 4]));
    EXPECT_TRUE(std::isnan(store.values("slide_start")[2 * 4 + 1]));

    const auto expected =
      find_slides(synthetic_record(1, 7), SlideParameters());
    ASSERT_EQ(expected.size(), 2u); // or the case shows nothing
    ASSERT_EQ(store.sizes("slide_start"), (std::vector<hsize_t>{2, 5, 2}));

    const std::size_t at = 5 + 4; // scenario 1, realisation 7
    EXPECT_EQ(store.values("n_slides")[at], 2.);
    EXPECT_EQ(store.values("n_slides")[0], 0.);  // stands
    EXPECT_EQ(store.values("n_slides")[5], -1.); // not run
    EXPECT_EQ(store.values("width_after_first_slide")[at], expected[0].width);
    EXPECT_EQ(store.values("height_after_first_slide")[at], expected[0].height);
    EXPECT_TRUE(std::isnan(store.values("width_after_first_slide")[0]));
    for (const std::size_t j : {0, 1})
      {
        EXPECT_EQ(store.values("slide_start")[2 * at + j], expected[j].start);
        EXPECT_EQ(store.values("slide_end")[2 * at + j], expected[j].end);
        EXPECT_EQ(store.values("slide_width")[2 * at + j], expected[j].width);
        EXPECT_EQ(store.values("slide_height")[2 * at + j], expected[j].height);
        EXPECT_TRUE(std::isnan(store.values("slide_start")[j]));
      }
  }


  TEST(Statistics, store_holds_sliding_masses_and_pads_them)
  {
    const TemporaryFolder folder;
    std::vector<Record>   records = six_records();
    records[1].sliding_masses     = synthetic_masses(3); // realisation 1
    records[2].sliding_masses     = SlidingMasses();
    records[2].sliding_masses->whole_volume = 24.25;
    write(folder.file("results.h5"), records);
    const OpenStore store(folder.file("results.h5"));
    ASSERT_EQ(store.sizes("mass_time"), (std::vector<hsize_t>{2, 5, 2}));
    const SlidingMasses masses = synthetic_masses(3);
    for (const std::size_t j : {0, 1})
      {
        const SlidingMass &mass = masses.masses[j];
        EXPECT_EQ(store.values("mass_time")[2 * 1 + j], mass.time);
        EXPECT_EQ(store.values("mass_volume")[2 * 1 + j], mass.volume);
        EXPECT_EQ(store.values("mass_width")[2 * 1 + j], mass.width);
        EXPECT_EQ(store.values("mass_x")[2 * 1 + j], mass.centre[0]);
        EXPECT_EQ(store.values("mass_y")[2 * 1 + j], mass.centre[1]);
        EXPECT_EQ(store.values("mass_z")[2 * 1 + j], mass.centre[2]);
        EXPECT_EQ(store.values("mass_x_from")[2 * 1 + j], mass.lower[0]);
        EXPECT_EQ(store.values("mass_x_to")[2 * 1 + j], mass.upper[0]);
        EXPECT_EQ(store.values("mass_z_from")[2 * 1 + j], mass.lower[2]);
        EXPECT_EQ(store.values("mass_z_to")[2 * 1 + j], mass.upper[2]);
        EXPECT_TRUE(std::isnan(store.values("mass_time")[2 * 2 + j]));
      }
    const double volume = masses.failed_volume;
    EXPECT_EQ(store.values("body_volume")[1], 24.25);
    EXPECT_EQ(store.values("stable_volume")[1], 24.25 - volume);
    EXPECT_EQ(store.values("relative_failure_volume")[1], volume / 24.25);
    EXPECT_EQ(store.values("retrogression_distance")[1], masses.retrogression);
    EXPECT_EQ(store.values("damaged_crest_width")[1], 4.25);
    EXPECT_EQ(store.values("first_mass_time")[1], masses.masses[0].time);
    EXPECT_EQ(store.values("first_mass_volume")[1], masses.masses[0].volume);
    EXPECT_EQ(store.values("first_mass_width")[1], 0.7);
    EXPECT_EQ(store.values("n_masses")[1], 2.);
    // Its offset is 1 m back, of a half length of 4/7 m.
    EXPECT_EQ(store.values("n_masses_behind_off_centre")[1] +
                store.values("n_masses_side")[1],
              1.);
    // Nothing has slid; nobody knows; not run.
    EXPECT_EQ(store.values("n_masses")[2], 0.);
    EXPECT_EQ(store.values("relative_failure_volume")[2], 0.);
    EXPECT_TRUE(std::isnan(store.values("first_mass_time")[2]));
    for (const std::size_t at : {0, 5})
      {
        EXPECT_EQ(store.values("n_masses")[at], -1.);
        EXPECT_EQ(store.values("n_masses_side")[at], -1.);
        EXPECT_TRUE(std::isnan(store.values("relative_failure_volume")[at]));
      }
  }


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
} // namespace Waker::statistics_results_file
