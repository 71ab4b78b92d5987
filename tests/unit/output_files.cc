// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/file_error.h>
#include <waker/output/files.h>

#include "output_temporary_folder.h"
#include "processes.h"
#include "user_errors.h"
#include <csignal>
#include <gtest/gtest.h>
#include <sys/resource.h>

namespace Waker::output_files
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


  TEST(Output, append_file_takes_a_text_whole_or_not_at_all)
  {
    const TemporaryFolder folder;
    {
      AppendFile file(folder.file("a"), false);
      EXPECT_TRUE(file.write("one\n"));
      EXPECT_TRUE(file.sync());
    }
    {
      AppendFile file(folder.file("a"), false);
      EXPECT_TRUE(file.write("two\n"));
    }
    EXPECT_EQ(get(folder.file("a")), "one\ntwo\n");
    {
      AppendFile file(folder.file("a"), true);
    }
    EXPECT_EQ(get(folder.file("a")), "");
    if (fs::exists("/dev/full"))
      {
        EXPECT_USER_ERROR(AppendFile("/dev/full", false),
                          "Output/Directory",
                          "'/dev/full' is no regular file, but a device");
      }

    // A limit on the size of files takes a part of the text, as a full disk.
    const pid_t pid = in_another_process([&]() {
      ::signal(SIGXFSZ, SIG_IGN);
      const rlimit limit = {10, 10};
      ::setrlimit(RLIMIT_FSIZE, &limit);
      AppendFile file(folder.file("b"), false);
      if (!file.write("1234567\n") || file.write("1234567\n"))
        return 1;
      return file.write("9\n") ? 0 : 2; // what fits still does
    });
    EXPECT_EQ(exit_code(pid), 0);
    EXPECT_EQ(get(folder.file("b")), "1234567\n9\n");

    put(folder.file("mine"), "mine");
    fs::create_symlink("mine", folder.file("link"));
    EXPECT_THROW(AppendFile(folder.file("link"), true), UserError);
    EXPECT_EQ(get(folder.file("mine")), "mine");
  }


  TEST(Output, file_that_cannot_be_written_stays_as_it_was)
  {
    const TemporaryFolder folder;
    put(folder.file("a"), "before");
    const pid_t pid = in_another_process([&]() {
      ::signal(SIGXFSZ, SIG_IGN);
      const rlimit limit = {1000, 1000};
      ::setrlimit(RLIMIT_FSIZE, &limit);
      try
        {
          write_file(folder.file("a"), std::string(5000, 'x'));
        }
      catch (const FileError &error)
        {
          return contains(error.problem, "File too large") ? 0 : 1;
        }
      return 2;
    });
    EXPECT_EQ(exit_code(pid), 0);
    EXPECT_EQ(get(folder.file("a")), "before");
    EXPECT_FALSE(fs::exists(folder.file("a.tmp")));
  }


  TEST(Output, file_that_is_read_must_be_one)
  {
    const TemporaryFolder folder;
    put(folder.file("empty"), "");
    EXPECT_EQ(read_file(folder.file("empty")), "");
    const auto why = [&](const std::string &name) -> std::string {
      try
        {
          read_file(folder.file(name));
        }
      catch (const UserError &error)
        {
          return error.problem;
        }
      return "";
    };
    EXPECT_EQ(why("none"), "cannot be read: No such file or directory");
    EXPECT_EQ(why("."), "cannot be read: it is a folder");
  }
} // namespace Waker::output_files
