// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The program `waker` for tests that call it many times: to load its 200 shared
// libraries takes ten times as long as to refuse a wrong input. They are loaded
// once here; each call is a child of this process, in which nothing has run
// but the libraries' initialisation, as at the beginning of main().
//
// A request on standard input is its length in bytes (32 bits, native) and
// strings that each end with a zero: working folder, files for standard input,
// output and error, the whole environment, an empty string, and the arguments
// from the name of the program on. The answer is a line: the exit code, or
// minus the number of the signal. What is read before main(), like
// LD_LIBRARY_PATH and OMP_NUM_THREADS, is that of the server.
#include <waker/program/program.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace
{
  [[noreturn]] void
  give_up(const std::string &what)
  {
    std::perror(("fork server: " + what).c_str());
    // The tests' own mistakes: no exit code of the program.
    std::_Exit(99);
  }


  /// Without a buffer: a child must not find a piece of a request in one.
  /// False at the end of the input.
  bool
  read_fully(const int file, void *const to, const std::size_t n)
  {
    for (std::size_t done = 0; done < n;)
      {
        const ssize_t more =
          read(file, static_cast<char *>(to) + done, n - done);
        if (more < 0)
          give_up("cannot read");
        if (more == 0)
          return false;
        done += more;
      }
    return true;
  }


  std::vector<char *>
  split(std::vector<char> &text)
  {
    std::vector<char *> strings;
    for (char *at = text.data(); at < text.data() + text.size();
         at += std::string(at).size() + 1)
      strings.push_back(at);
    return strings;
  }


  void
  redirect(const int descriptor, const char *const path, const int flags)
  {
    const int file = open(path, flags, 0666);
    if (file < 0 || dup2(file, descriptor) < 0)
      give_up(path);
    close(file);
  }


  /// In the child: what the shell does, then what main() does.
  [[noreturn]] void
  run_child(std::vector<char *> strings)
  {
    if (chdir(strings.at(0)) != 0)
      give_up(strings[0]);
    redirect(STDIN_FILENO, strings.at(1), O_RDONLY);
    // Both may be the same file.
    redirect(STDOUT_FILENO, strings.at(2), O_WRONLY | O_CREAT | O_APPEND);
    redirect(STDERR_FILENO, strings.at(3), O_WRONLY | O_CREAT | O_APPEND);

    std::size_t i = 4;
    clearenv();
    for (; *strings.at(i) != '\0'; ++i)
      putenv(strings[i]);
    const int argc = strings.size() - (i + 1);
    strings.push_back(nullptr);
    std::exit(Waker::run_program(argc, &strings[i + 1]));
  }
} // namespace


int
main()
{
  // A child has but the one thread that forks.
  std::size_t n_threads = 0;
  for ([[maybe_unused]] const auto &thread :
       std::filesystem::directory_iterator("/proc/self/task"))
    ++n_threads;
  if (n_threads != 1)
    give_up("a library has started a thread");

  // Children get other files as standard input and output.
  const int requests = fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 10);
  const int answers  = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 10);
  if (requests < 0 || answers < 0)
    give_up("no standard input or output");

  std::uint32_t size = 0;
  while (read_fully(requests, &size, sizeof(size)))
    {
      std::vector<char> text(size);
      if (!read_fully(requests, text.data(), size) || text.empty() ||
          text.back() != '\0')
        give_up("half a request");
      const pid_t child = fork();
      if (child < 0)
        give_up("cannot fork");
      if (child == 0)
        {
          close(requests);
          close(answers);
          run_child(split(text));
        }
      int status = 0;
      if (waitpid(child, &status, 0) != child)
        give_up("cannot wait");
      const int code =
        WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
      const std::string answer = std::to_string(code) + "\n";
      if (write(answers, answer.data(), answer.size()) !=
          static_cast<ssize_t>(answer.size()))
        give_up("cannot answer");
    }
  return 0;
}
