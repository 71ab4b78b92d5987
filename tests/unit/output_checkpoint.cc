// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/output/checkpoint.h>

#include "output_temporary_folder.h"
#include <gtest/gtest.h>

namespace Waker::output_checkpoint
{
  namespace
  {
    const std::string hash = "0123456789abcdef";

    /// Any bytes: zeros, line ends, high bits.
    std::string
    make_blob(const unsigned int size)
    {
      std::string blob;
      for (unsigned int i = 0; i < size; ++i)
        blob += static_cast<char>(i * i);
      return blob;
    }


    std::string
    problem_on_reading(const std::string &folder, const std::string &hash)
    {
      std::string warning;
      try
        {
          CheckpointSlots(folder, hash).read_latest(warning);
        }
      catch (const UserError &error)
        {
          EXPECT_EQ(error.where, "Output/Directory");
          return error.problem;
        }
      return "";
    }


    std::string
    flip_byte(std::string text, const std::size_t at)
    {
      text.at(at) ^= 0x10;
      return text;
    }
  } // namespace


  TEST(Output, checkpoint_comes_back_as_it_was)
  {
    const TemporaryFolder folder;
    const std::string     blob = make_blob(10000);
    CheckpointSlots(folder.path, hash).write(123456789012, blob);

    std::string      warning = "left over";
    const Checkpoint read =
      CheckpointSlots(folder.path, hash).read_latest(warning);
    EXPECT_EQ(read.step, 123456789012u);
    EXPECT_EQ(read.case_hash, hash);
    EXPECT_EQ(read.blob, blob);
    EXPECT_EQ(read.program.substr(0, 6), "waker ");
    EXPECT_EQ(warning, "");
  }


  TEST(Output, checkpoints_alternate_also_after_a_resume)
  {
    const TemporaryFolder folder;
    std::string           warning;
    {
      CheckpointSlots slots(folder.path, hash);
      for (const unsigned int step : {10, 20, 30})
        slots.write(step, "state " + std::to_string(step));
    }
    {
      // Slot 0 holds 30, slot 1 holds 20: the next one must replace 20.
      CheckpointSlots slots(folder.path, hash);
      EXPECT_EQ(slots.read_latest(warning).step, 30u);
      slots.write(40, "state 40");
      EXPECT_EQ(slots.read_latest(warning).step, 40u);
      std::filesystem::remove(slots.slot_path(1));
      EXPECT_EQ(slots.read_latest(warning).step, 30u);
      EXPECT_EQ(warning, "");
    }
  }


  TEST(Output, damaged_checkpoint_falls_back_to_the_older_one)
  {
    const TemporaryFolder folder;
    CheckpointSlots       slots(folder.path, hash);
    slots.write(10, make_blob(100));
    slots.write(20, make_blob(200));
    const std::string newest = slots.slot_path(1);
    const std::string whole  = get(newest);

    // One byte changed anywhere, or the file cut short anywhere.
    for (std::size_t at = 0; at < whole.size(); ++at)
      for (const std::string &damaged :
           {flip_byte(whole, at), whole.substr(0, at)})
        {
          put(newest, damaged);
          std::string      warning;
          const Checkpoint read =
            CheckpointSlots(folder.path, hash).read_latest(warning);
          ASSERT_EQ(read.step, 10u) << "byte " << at;
          ASSERT_EQ(read.blob, make_blob(100));
          ASSERT_NE(warning.find(newest), std::string::npos);
        }

    // The next checkpoint must not overwrite the only good one.
    std::string     warning;
    CheckpointSlots resumed(folder.path, hash);
    resumed.read_latest(warning);
    resumed.write(15, "new");
    EXPECT_EQ(resumed.read_latest(warning).step, 15u);
    EXPECT_EQ(get(slots.slot_path(0)).find("WAKERCP"), 0u);
    std::filesystem::remove(newest);
    EXPECT_EQ(resumed.read_latest(warning).step, 10u);
  }


  TEST(Output, checkpoint_of_another_case_is_refused)
  {
    const TemporaryFolder folder;
    CheckpointSlots(folder.path, hash).write(10, "state");
    EXPECT_EQ(problem_on_reading(folder.path, hash), "");
    EXPECT_NE(
      problem_on_reading(folder.path, "other").find("belongs to another case"),
      std::string::npos);
  }


  TEST(Output, checkpoint_of_another_case_says_in_what_it_differs)
  {
    const TemporaryFolder folder;
    CheckpointSlots(folder.path, hash).write(10, "state");
    put(folder.file("parameters.prm"),
        "# realisation 3\nsubsection Water\n  set Level = 4.75\n"
        "  subsection Sub section\n    set A b = 1; 2\n  end\n"
        "  set Side = left\nend\nsubsection Output\n  set Interval = 1\nend\n"
        "set Dimension = 2\n# contents: Tractions/load/Surface file = 01\n");
    const std::string now =
      "subsection Water\n  set Level = 4.5\n"
      "  subsection Sub section\n    set A b = 1; 3\n  end\n"
      "  set Side = left\nend\nsubsection Output\n  set Interval = 2\nend\n"
      "set Dimension = 2\n# contents: Tractions/load/Surface file = 02\n";
    std::string warning;
    try
      {
        CheckpointSlots(folder.path, "other", now).read_latest(warning);
        FAIL();
      }
    catch (const UserError &error)
      {
        EXPECT_NE(error.problem.find(
                    "differ: Water/Level (4.75 there, 4.5 here), Water/Sub "
                    "section/A b (1; 2 there, 1; 3 here), contents of "
                    "Tractions/load/Surface file (01 there, 02 here)"),
                  std::string::npos)
          << error.problem;
        EXPECT_EQ(error.problem.find("Interval"), std::string::npos);
      }
  }


  TEST(Output, missing_and_useless_checkpoints_are_told_apart)
  {
    const TemporaryFolder folder;
    EXPECT_NE(problem_on_reading(folder.path, hash).find("is no checkpoint"),
              std::string::npos);
    put(CheckpointSlots(folder.path, hash).slot_path(1), "WAKERCP\nnonsense");
    EXPECT_NE(problem_on_reading(folder.path, hash).find("damaged"),
              std::string::npos);
  }


  /// Of each schema version there is a file, which must stay readable: that of
  /// the first one written by the program, that of the second made of it
  /// (Python: size, struct and zlib.crc32).
  std::string
  data_of_version(const unsigned int version)
  {
    return get((std::filesystem::path(__FILE__).parent_path().parent_path() /
                "data" / ("checkpoint-v" + std::to_string(version) + ".bin"))
                 .string());
  }


  void
  expect_old_schema(const unsigned int version, const std::string &arrays)
  {
    const TemporaryFolder folder;
    CheckpointSlots       slots(folder.path, hash);
    put(slots.slot_path(0), data_of_version(version));
    std::string      warning;
    const Checkpoint read = slots.read_latest(warning);
    EXPECT_EQ(read.step, 4321u);
    EXPECT_EQ(read.blob, make_blob(64));
    EXPECT_EQ(read.arrays(), arrays);
  }


  TEST(Output, checkpoint_of_older_schema_versions_can_be_read)
  {
    expect_old_schema(1, "");
    expect_old_schema(2, "values of points");
  }


  TEST(Output, checkpoint_of_a_newer_schema_version_is_told)
  {
    // Whole, but not for us.
    std::string newer = data_of_version(1);
    ASSERT_EQ(newer.at(8), 1);
    newer[8] = 3;
    // CRC-32 of the file with schema version 3, worked out independently
    // (Python: zlib.crc32(f[8:12] + f[16:])).
    const unsigned char crc[4] = {0xea, 0xf6, 0xa8, 0xcb};
    for (unsigned int i = 0; i < 4; ++i)
      newer[12 + i] = static_cast<char>(crc[i]);
    const TemporaryFolder folder;
    put(CheckpointSlots(folder.path, hash).slot_path(0), newer);
    EXPECT_NE(problem_on_reading(folder.path, hash).find("newer version"),
              std::string::npos);
  }
} // namespace Waker::output_checkpoint
