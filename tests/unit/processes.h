// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_processes_h
#define waker_tests_processes_h

#include <csignal>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace Waker
{
  /// Run a function in another process, which ends without any clean-up.
  template <typename Function>
  pid_t
  in_another_process(const Function &function)
  {
    const pid_t pid = ::fork();
    if (pid == 0)
      {
        try
          {
            ::_exit(function());
          }
        catch (...)
          {
            ::_exit(99);
          }
      }
    return pid;
  }


  /// Minus the number of the signal that has ended it.
  inline int
  exit_code(const pid_t pid)
  {
    int status = 0;
    ::waitpid(pid, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }


  /// Another process that holds what a function returns, until it is killed.
  class RunningProcess
  {
  public:
    template <typename Function>
    explicit RunningProcess(const Function &make)
    {
      int  ends[2];
      char said = '?';
      if (::pipe(ends) != 0)
        return;
      pid = in_another_process([&]() {
        ::close(ends[0]);
        const auto held = make();
        if (::write(ends[1], "x", 1) != 1)
          return 1;
        while (true)
          ::pause();
        return 0;
      });
      ::close(ends[1]);
      if (::read(ends[0], &said, 1) != 1)
        kill(); // it has ended by itself
      ::close(ends[0]);
    }

    ~RunningProcess()
    {
      kill();
    }

    RunningProcess(const RunningProcess &) = delete;
    RunningProcess &
    operator=(const RunningProcess &) = delete;

    pid_t
    id() const
    {
      return pid;
    }

    void
    kill()
    {
      if (pid <= 0)
        return;
      ::kill(pid, SIGKILL);
      exit_code(pid);
      pid = -1;
    }

  private:
    pid_t pid = -1;
  };


  /// One that has been killed while it held that.
  class KilledProcess
  {
  public:
    template <typename Function>
    explicit KilledProcess(const Function &make)
    {
      RunningProcess(make).kill();
    }
  };
} // namespace Waker

#endif
