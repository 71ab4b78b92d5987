// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/hash.h>
#include <waker/output/output_files.h>
#include <waker/output/pvd.h>

#include "output_temporary_folder.h"
#include <gtest/gtest.h>

namespace Waker::output_pvd
{
  namespace fs = std::filesystem;

  namespace
  {
    bool
    contains(const std::string &text, const std::string &part)
    {
      return text.find(part) != std::string::npos;
    }


    /// Three files of a series, and the entries of which the first two are.
    std::vector<PvdEntry>
    two_of_three(const TemporaryFolder &folder)
    {
      PvdSeries             series(folder.path, FieldSeries::surface);
      std::vector<PvdEntry> entries;
      for (const std::string text : {"zero", "one", "two"})
        {
          entries = series.entries();
          put(series.next_path(), text);
          series.add(static_cast<double>(entries.size()),
                     checksum_of_text(text));
        }
      return entries;
    }
  } // namespace


  TEST(PvdSeries, goes_on_from_a_checkpoint_without_the_files_after_it)
  {
    const TemporaryFolder       folder;
    const std::vector<PvdEntry> entries = two_of_three(folder);
    const auto                  path    = [&](const std::size_t number) {
      return folder.file(frame_name(FieldSeries::surface, number));
    };
    ASSERT_EQ(get(path(2)), "two");

    PvdSeries series(folder.path, FieldSeries::surface);
    EXPECT_TRUE(series.restore(entries).empty());
    EXPECT_EQ(get(path(1)), "one");
    EXPECT_FALSE(std::filesystem::exists(path(2)));
    EXPECT_EQ(series.next_path(), path(2));
    const std::string pvd = get(folder.file("surface.pvd"));
    EXPECT_NE(pvd.find("surface-00001.vtu"), std::string::npos);
    EXPECT_EQ(pvd.find("surface-00002.vtu"), std::string::npos);
  }


  TEST(PvdSeries, names_files_that_are_gone_or_damaged)
  {
    const TemporaryFolder       folder;
    const std::vector<PvdEntry> entries = two_of_three(folder);
    const std::string           first   = frame_name(FieldSeries::surface, 0);
    const std::string           second  = frame_name(FieldSeries::surface, 1);

    // One bit, at the same length.
    put(folder.file(second), "ooe");
    PvdSeries series(folder.path, FieldSeries::surface);
    EXPECT_EQ(series.restore(entries), std::vector<std::string>{second});
    EXPECT_EQ(get(folder.file(second)), "ooe");

    std::filesystem::remove(folder.file(first));
    EXPECT_EQ(series.restore(entries),
              (std::vector<std::string>{first, second}));
  }


  TEST(Output, pvd_of_a_resumed_run_forgets_what_came_after_the_checkpoint)
  {
    const TemporaryFolder folder;
    fs::create_directory(folder.file("solution"));
    std::vector<PvdEntry> at_checkpoint;
    {
      PvdSeries series(folder.path, FieldSeries::particles);
      for (unsigned int i = 0; i < 5; ++i)
        {
          put(series.next_path(), "frame");
          series.add(0.1 * i, checksum_of_text("frame"));
          if (i == 2)
            at_checkpoint = series.entries();
        }
    }
    ASSERT_EQ(at_checkpoint.size(), 3u);
    EXPECT_EQ(at_checkpoint[2].file, "solution/particles-00002.vtu");
    const std::string whole = get(folder.file("particles.pvd"));
    EXPECT_TRUE(contains(whole,
                         "timestep=\"0.4\" group=\"\" part=\"0\" "
                         "file=\"solution/particles-00004.vtu\""));

    PvdSeries series(folder.path, FieldSeries::particles);
    series.restore(at_checkpoint);
    EXPECT_FALSE(contains(get(folder.file("particles.pvd")), "00003"));
    EXPECT_TRUE(contains(get(folder.file("particles.pvd")), "00002"));
    EXPECT_TRUE(fs::exists(folder.file("solution/particles-00002.vtu")));
    EXPECT_FALSE(fs::exists(folder.file("solution/particles-00003.vtu")));
    EXPECT_FALSE(fs::exists(folder.file("solution/particles-00004.vtu")));

    for (unsigned int i = 3; i < 5; ++i)
      {
        put(series.next_path(), "frame");
        series.add(0.1 * i, checksum_of_text("frame"));
      }
    EXPECT_EQ(get(folder.file("particles.pvd")), whole);
  }
} // namespace Waker::output_pvd
