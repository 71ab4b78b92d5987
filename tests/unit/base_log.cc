// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/log.h>

#include "output_temporary_folder.h"
#include "user_errors.h"
#include <gtest/gtest.h>
#include <sstream>

namespace Waker::base_log
{
  TEST(Base, log_writes_to_screen_and_file)
  {
    const TemporaryFolder folder;
    std::ostringstream    screen;
    {
      Log log(screen, false);
      log.line("before");
      log.open_file(folder.file("log.txt"), false);
      log.line("first");
    }
    EXPECT_EQ(screen.str(), "before\nfirst\n");
    EXPECT_EQ(get(folder.file("log.txt")), "first\n");

    Log quiet;
    quiet.open_file(folder.file("log.txt"), true);
    quiet.line("resumed");
    quiet.progress(0.5, "t = 1 s");
    quiet.end_progress();
    EXPECT_EQ(get(folder.file("log.txt")), "first\nresumed\n");
    EXPECT_USER_ERROR(quiet.open_file(folder.file("none/log.txt"), false),
                      "Output/Directory",
                      folder.file("none/log.txt"));
  }


  TEST(Base, log_that_cannot_be_written_says_so_once)
  {
    if (!std::filesystem::exists("/dev/full"))
      GTEST_SKIP();
    std::ostringstream screen;
    Log                log(screen, false);
    log.open_file("/dev/full", true);
    log.line("first");
    log.line("second");
    EXPECT_EQ(screen.str(),
              "first\nThe log file cannot be written: No space left on "
              "device\nsecond\n");
  }


  TEST(Base, progress_on_a_terminal_is_one_line_that_gives_way_to_others)
  {
    std::ostringstream screen;
    Log                log(screen, true);
    EXPECT_TRUE(log.progress_due());
    log.progress(0.5, "t = 1 s");
    EXPECT_EQ(screen.str(),
              "\r[" + std::string(15, '=') + std::string(15, ' ') +
                "]  50 %  t = 1 s\033[K");
    log.line("slide");
    EXPECT_NE(screen.str().find("\r\033[Kslide\n"), std::string::npos);
    const std::size_t length = screen.str().size();
    log.end_progress();
    EXPECT_EQ(screen.str().size(), length);
  }


  TEST(Base, progress_elsewhere_is_rare)
  {
    std::ostringstream screen;
    Log                log(screen, false);
    for (unsigned int i = 0; i < 1000; ++i)
      log.progress(i / 1000., "step");
    EXPECT_EQ(screen.str(), "");
  }
} // namespace Waker::base_log
