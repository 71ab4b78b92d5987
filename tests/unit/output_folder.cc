// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/output/files.h>
#include <waker/output/folder_lock.h>
#include <waker/output/output_folder.h>

#include "output_temporary_folder.h"
#include "processes.h"
#include "user_errors.h"
#include <array>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace Waker::output_folder
{
  namespace fs = std::filesystem;

  namespace
  {
    std::string
    problem(const std::string &directory, const FolderMode mode)
    {
      try
        {
          check_output_folder(directory, mode);
        }
      catch (const UserError &error)
        {
          EXPECT_EQ(error.where, "Output/Directory");
          EXPECT_FALSE(error.allowed.empty());
          return error.problem;
        }
      return "";
    }


    bool
    contains(const std::string &text, const std::string &part)
    {
      return text.find(part) != std::string::npos;
    }
  } // namespace


  TEST(Output, folder_is_checked_without_writing)
  {
    const TemporaryFolder folder;
    const std::string     fresh = folder.file("a/b/c");
    EXPECT_EQ(problem(fresh, FolderMode::must_be_new), "");
    EXPECT_EQ(problem(fresh, FolderMode::overwrite), "");
    EXPECT_TRUE(contains(problem(fresh, FolderMode::resume), "does not exist"));
    EXPECT_TRUE(fs::is_empty(folder.path));
    EXPECT_EQ(problem(folder.path, FolderMode::must_be_new), "");

    put(folder.file("file"), "mine");
    for (const FolderMode mode :
         {FolderMode::must_be_new, FolderMode::overwrite, FolderMode::resume})
      EXPECT_TRUE(contains(problem(folder.file("file"), mode), "is a file"));
    EXPECT_TRUE(
      contains(problem(folder.file("file/below"), FolderMode::must_be_new),
               "is not a folder"));
    EXPECT_TRUE(
      contains(problem(folder.path, FolderMode::must_be_new), "is not empty"));
    EXPECT_EQ(problem(folder.path, FolderMode::overwrite), "");
    EXPECT_EQ(problem(folder.path, FolderMode::resume), "");
    EXPECT_TRUE(contains(problem("", FolderMode::overwrite), "is empty"));
  }


  TEST(Output, folder_that_cannot_be_made_is_the_users_matter)
  {
    // Below a file not even root can make a folder.
    const TemporaryFolder folder;
    put(folder.file("file"), "mine");
    EXPECT_USER_ERROR(prepare_output_folder(folder.file("file/waker"),
                                            FolderMode::must_be_new,
                                            ""),
                      "Output/Directory",
                      "cannot write '" + folder.file("file/waker") + "'");
    EXPECT_EQ(get(folder.file("file")), "mine");
  }


  TEST(Output, overwriting_removes_a_run_and_nothing_else)
  {
    const TemporaryFolder folder;
    const std::string     run = folder.file("run");
    prepare_output_folder(run, FolderMode::must_be_new, "first");
    EXPECT_EQ(get(run + "/parameters.prm"), "first");
    EXPECT_TRUE(fs::is_directory(run + "/solution"));

    const char *const ours[] = {"log.txt",
                                "statistics",
                                "summary.json",
                                "particles.pvd",
                                "tractions.pvd",
                                "walls.pvd",
                                "strength_reduction.csv",
                                "strength_reduction.json",
                                "surface.pvd.tmp",
                                "solution/particles-00012.vtu",
                                "solution/grid-123456.vtu",
                                "solution/walls-00000.vtu",
                                "solution/tractions-00007.vtu",
                                "checkpoints/checkpoint-0.bin",
                                "checkpoints/checkpoint-1.bin.tmp"};
    const char *const mine[] = {"notes.txt",
                                "statistics.ods",
                                "draft.tmp",
                                "solution/particles-best.vtu",
                                "solution/old/particles-00001.vtu"};
    for (const char *const name : ours)
      put(run + "/" + name, "x");
    for (const char *const name : mine)
      put(run + "/" + name, "x");

    // A resumed run keeps its files, but not those that were half written, nor
    // what came out in the end: that is not so any more.
    prepare_output_folder(run, FolderMode::resume, "second");
    for (const std::string name : ours)
      EXPECT_EQ(fs::exists(run + "/" + name),
                name.find(".tmp") == std::string::npos &&
                  name != "summary.json" && name != "strength_reduction.json")
        << name;
    EXPECT_USER_ERROR(prepare_output_folder(run,
                                            FolderMode::must_be_new,
                                            "third"),
                      "Output/Directory",
                      "is not empty");
    EXPECT_EQ(get(run + "/parameters.prm"), "second");

    put(run + "/surface.pvd.tmp", "x");
    put(run + "/log.txt.2.tmp", "x");
    prepare_output_folder(run, FolderMode::overwrite, "fourth");
    for (const char *const name : ours)
      EXPECT_FALSE(fs::exists(run + "/" + name)) << name;
    for (const char *const name : mine)
      EXPECT_TRUE(fs::exists(run + "/" + name)) << name;
    EXPECT_FALSE(fs::exists(run + "/checkpoints"));
    EXPECT_EQ(get(run + "/parameters.prm"), "fourth");
  }


  TEST(Output, links_in_a_folder_are_refused_and_not_followed)
  {
    const TemporaryFolder other;
    for (const std::string name : {"particles-00001.vtu",
                                   "checkpoint-0.bin",
                                   "statistics",
                                   "solution/grid-00001.vtu"})
      put(other.file(name), "mine");
    for (const std::string name : {"solution",
                                   "checkpoints",
                                   "statistics",
                                   "log.txt",
                                   "walls.pvd",
                                   "statistics.tmp",
                                   "solution/grid-00000.vtu"})
      for (const bool dangling : {false, true})
        for (const FolderMode mode :
             {FolderMode::overwrite, FolderMode::resume})
          {
            const TemporaryFolder folder;
            put(folder.file("parameters.prm"), "mine");
            fs::create_directories(fs::path(folder.file(name)).parent_path());
            fs::create_symlink(dangling ? other.file("none") : other.path,
                               folder.file(name));
            EXPECT_TRUE(
              contains(problem(folder.path, mode),
                       "'" + folder.file(name) + "' is a symbolic link"))
              << name;
            EXPECT_THROW(prepare_output_folder(folder.path, mode, "new"),
                         UserError);
            EXPECT_TRUE(fs::is_symlink(folder.file(name)));
            EXPECT_EQ(get(folder.file("parameters.prm")), "mine");
          }
    EXPECT_FALSE(fs::exists(other.file("none")));
    for (const std::string name : {"particles-00001.vtu",
                                   "checkpoint-0.bin",
                                   "statistics",
                                   "solution/grid-00001.vtu"})
      EXPECT_EQ(get(other.file(name)), "mine") << name;

    // Links of the user's own, under other names, stay.
    const TemporaryFolder folder;
    fs::create_symlink(other.path, folder.file("archive"));
    fs::create_symlink(other.file("none"), folder.file("dangling"));
    EXPECT_EQ(problem(folder.path, FolderMode::overwrite), "");
    prepare_output_folder(folder.path, FolderMode::overwrite, "new");
    EXPECT_TRUE(fs::is_symlink(folder.file("archive")));
    EXPECT_TRUE(fs::is_symlink(folder.file("dangling")));
  }


  // A pipe in place of a file made the run wait for its other end, for ever.
  TEST(Output, what_is_no_regular_file_is_refused)
  {
    enum class Kind
    {
      pipe,
      folder,
      socket
    };
    const auto make = [](const std::string &path, const Kind kind) {
      if (kind == Kind::folder)
        fs::create_directory(path);
      else
        ASSERT_EQ(::mknod(path.c_str(),
                          (kind == Kind::pipe ? S_IFIFO : S_IFSOCK) | 0600,
                          0),
                  0)
          << path;
    };
    const std::array<std::string, 3> words = {
      {"is no regular file, but a pipe",
       "is no regular file, but a folder",
       "is no regular file, but a socket"}};
    unsigned int n = 0;
    for (const std::string name : {"statistics",
                                   "log.txt",
                                   "summary.json",
                                   "walls.pvd",
                                   "statistics.tmp",
                                   "lock",
                                   "checkpoints/checkpoint-0.bin",
                                   "solution/grid-00000.vtu"})
      for (const Kind kind : {Kind::pipe, Kind::folder, Kind::socket})
        for (const FolderMode mode :
             {FolderMode::overwrite, FolderMode::resume})
          {
            const TemporaryFolder folder;
            put(folder.file("parameters.prm"), "mine");
            fs::create_directories(fs::path(folder.file(name)).parent_path());
            make(folder.file(name), kind);
            EXPECT_TRUE(contains(problem(folder.path, mode),
                                 "'" + folder.file(name) + "' " +
                                   words.at(static_cast<std::size_t>(kind))))
              << name;
            EXPECT_THROW(prepare_output_folder(folder.path, mode, "new"),
                         UserError);
            EXPECT_TRUE(fs::exists(folder.file(name)));
            EXPECT_EQ(get(folder.file("parameters.prm")), "mine");
            ++n;
          }
    EXPECT_EQ(n, 48u);

    // In place of a folder; and what is opened without such a look before.
    const TemporaryFolder folder;
    put(folder.file("solution"), "mine");
    EXPECT_TRUE(contains(problem(folder.path, FolderMode::resume),
                         "solution' is no folder"));
    make(folder.file("pipe"), Kind::pipe);
    const std::string what = "is no regular file, but a pipe";
    const std::string path = folder.file("pipe");
    EXPECT_USER_ERROR(AppendFile(path, false), "Output/Directory", what);
    EXPECT_USER_ERROR(FolderLock(path, "test"), "Output/Directory", what);
    LockHolder holder;
    EXPECT_USER_ERROR(FolderLock::look(path, holder), "Output/Directory", what);
    EXPECT_USER_ERROR(FolderLock::remove_dead(path), "Output/Directory", what);

    // The user's own, under another name, stays.
    fs::remove(folder.file("solution"));
    EXPECT_EQ(problem(folder.path, FolderMode::overwrite), "");
    prepare_output_folder(folder.path, FolderMode::overwrite, "new");
    EXPECT_TRUE(fs::is_fifo(path));
  }


  TEST(Output, folder_itself_may_be_a_link)
  {
    const TemporaryFolder folder;
    fs::create_directory(folder.file("real"));
    fs::create_symlink("real", folder.file("link"));
    EXPECT_EQ(problem(folder.file("link"), FolderMode::must_be_new), "");
    prepare_output_folder(folder.file("link"), FolderMode::must_be_new, "a");
    EXPECT_EQ(get(folder.file("real/parameters.prm")), "a");
    put(folder.file("real/statistics"), "x");
    put(folder.file("real/notes"), "x");
    prepare_output_folder(folder.file("link"), FolderMode::overwrite, "b");
    EXPECT_EQ(get(folder.file("real/parameters.prm")), "b");
    EXPECT_FALSE(fs::exists(folder.file("real/statistics")));
    EXPECT_TRUE(fs::exists(folder.file("real/notes")));
    EXPECT_TRUE(fs::is_symlink(folder.file("link")));

    // A snapshot is removed with its folder, but not through a link.
    remove_run_folder(folder.file("link"));
    EXPECT_TRUE(fs::is_symlink(folder.file("link")));
    EXPECT_TRUE(fs::exists(folder.file("real/parameters.prm")));
  }


  TEST(Output, folder_with_nothing_but_a_lock_is_new)
  {
    const TemporaryFolder folder;
    put(folder.file("lock"), ""); // its process was killed at once
    EXPECT_EQ(problem(folder.path, FolderMode::must_be_new), "");
    prepare_output_folder(folder.path, FolderMode::must_be_new, "a");
    EXPECT_TRUE(
      contains(problem(folder.path, FolderMode::must_be_new), "is not empty"));
  }
} // namespace Waker::output_folder
