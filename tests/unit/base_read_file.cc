// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/read_file.h>

#include "output_temporary_folder.h"
#include "user_errors.h"
#include <gtest/gtest.h>
#include <sstream>
#include <sys/stat.h>

namespace Waker::base_read_file
{
  TEST(Base, file_is_read_whole)
  {
    const TemporaryFolder folder;
    std::string           text;
    for (unsigned int i = 0; i < 200000; ++i)
      text += static_cast<char>(i % 251);
    put(folder.file("a"), text);
    EXPECT_EQ(read_file(folder.file("a")), text);
    std::istringstream stream(text);
    EXPECT_EQ(read_input(stream, "here"), text);
    put(folder.file("empty"), "");
    EXPECT_EQ(read_file(folder.file("empty")), "");
    std::filesystem::create_symlink("a", folder.file("link"));
    EXPECT_EQ(read_input_file(folder.file("link")), text);
    // Their size is 0 until they are read.
    if (std::filesystem::exists("/proc/self/status"))
      {
        EXPECT_NE(read_file("/proc/self/status").find("Pid:"),
                  std::string::npos);
      }
  }


  TEST(Base, no_regular_file_is_not_read)
  {
    const TemporaryFolder folder;
    const std::string     pipe = folder.file("pipe");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::filesystem::create_symlink("pipe", folder.file("link"));
    EXPECT_USER_ERROR(read_file(pipe), pipe, "is no regular file, but a pipe");
    EXPECT_USER_ERROR(read_file(folder.file("link")),
                      folder.file("link"),
                      "is no regular file, but a pipe");
    EXPECT_USER_ERROR(read_file("/dev/zero"),
                      "/dev/zero",
                      "is no regular file, but a device");
    EXPECT_USER_ERROR(read_file(folder.path),
                      folder.path,
                      "cannot be read: it is a folder");
    EXPECT_USER_ERROR(read_file(folder.file("none")),
                      folder.file("none"),
                      "cannot be read: No such file or directory");
    EXPECT_EQ(kind_of_irregular_file(pipe), "a pipe");
    put(folder.file("a"), "");
    for (const std::string name : {"a", "none"})
      EXPECT_EQ(kind_of_irregular_file(folder.file(name)), "");
  }


  TEST(Base, input_has_a_largest_size)
  {
    const TemporaryFolder folder;
    const std::string     path = folder.file("a");
    put(path, "12345");
    EXPECT_EQ(read_file(path, 5), "12345");
    EXPECT_USER_ERROR(read_file(path, 4), path, "has 5 bytes");
    for (const unsigned int limit : {5, 4})
      {
        std::istringstream stream("12345");
        if (limit == 5)
          {
            EXPECT_EQ(read_input(stream, "here", limit), "12345");
          }
        else
          {
            EXPECT_USER_ERROR(read_input(stream, "here", limit),
                              "here",
                              "has more than 4 bytes");
          }
      }
    // With holes: it takes no space, and is not read.
    std::filesystem::resize_file(path, largest_input + 1000000);
    EXPECT_USER_ERROR(read_input_file(path), path, "has 257 MB");
    if (std::filesystem::exists("/proc/self/status"))
      {
        EXPECT_USER_ERROR(read_file("/proc/self/status", 10),
                          "/proc/self/status",
                          "has more than 10 bytes");
      }
  }
} // namespace Waker::base_read_file
