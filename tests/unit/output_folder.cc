// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/file_error.h>
#include <waker/base/hash.h>
#include <waker/output/files.h>
#include <waker/output/folder_lock.h>
#include <waker/output/output_folder.h>
#include <waker/output/pvd.h>
#include <waker/output/summary.h>

#include "output_temporary_folder.h"
#include "processes.h"
#include "user_errors.h"
#include <array>
#include <gtest/gtest.h>
#include <limits>
#include <sys/resource.h>
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
    ASSERT_EQ(read.loads.size(), 2u);
    EXPECT_EQ(read.loads[0].name, "soil");
    EXPECT_EQ(read.loads[0].unit, "m");
    EXPECT_EQ(read.loads[0].factor, 0.35);
    EXPECT_EQ(read.loads[0].held_for, 1.5);
    EXPECT_EQ(read.loads[0].stop_time, 2.5);
    EXPECT_EQ(read.loads[1].factor, 2.);
    EXPECT_FALSE(read.loads[1].stop_time.has_value());
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
} // namespace Waker::output_folder
