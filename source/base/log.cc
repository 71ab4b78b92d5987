// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/log.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ostream>
#include <unistd.h>

namespace Waker
{
  namespace
  {
    double
    seconds(const std::chrono::steady_clock::duration duration)
    {
      return std::chrono::duration<double>(duration).count();
    }


    /// "45 s", "3:05", "2:03:05"
    std::string
    format_time(const double time)
    {
      const auto total = static_cast<long>(std::min(std::ceil(time), 1e9));
      const long h = total / 3600, m = total / 60 % 60, s = total % 60;
      char       text[64];
      if (h > 0)
        std::snprintf(text, sizeof(text), "%ld:%02ld:%02ld", h, m, s);
      else if (m > 0)
        std::snprintf(text, sizeof(text), "%ld:%02ld", m, s);
      else
        std::snprintf(text, sizeof(text), "%ld s", s);
      return text;
    }
  } // namespace


  Log::Log() = default;


  Log::Log(std::ostream &screen, const bool terminal)
    : screen(&screen)
    , terminal(terminal)
  {}


  bool
  Log::is_terminal()
  {
    return ::isatty(STDOUT_FILENO) == 1;
  }


  void
  Log::open_file(const std::string &path, const bool append)
  {
    file.open(path, append ? std::ios::app : std::ios::trunc);
    if (!file)
      throw UserError("Output/Directory",
                      "cannot write '" + path + "': " + std::strerror(errno),
                      "a writable folder");
  }


  void
  Log::line(const std::string &text)
  {
    const std::string mark = warning_mark;
    if (text.rfind(mark, 0) == 0)
      all_warnings.push_back(text.substr(mark.size()));
    // Flushed each time: the last lines matter most if a run is killed.
    if (screen != nullptr)
      {
        erase_bar();
        *screen << text << '\n' << std::flush;
      }
    if (file.is_open() && !(file << text << '\n' << std::flush))
      {
        // No reason to end a run; what is read is written elsewhere, and
        // checked.
        file.clear();
        if (screen != nullptr && !file_failed)
          *screen << "The log file cannot be written: " << std::strerror(errno)
                  << std::endl;
        file_failed = true;
      }
  }


  void
  Log::warning(const std::string &text)
  {
    line(warning_mark + text);
  }


  bool
  Log::progress_due() const
  {
    return !started || seconds(Clock::now() - last_time) >=
                         (terminal ? bar_interval : line_interval);
  }


  void
  Log::progress(const double share, const std::string &text)
  {
    // Of nothing, nothing is left: 0 / 0 is no number.
    const double fraction = std::isnan(share) ? 1. : share;
    if (!progress_due())
      return;
    const Clock::time_point now = Clock::now();
    last_time                   = now;
    if (!started)
      {
        // From here on the speed is measured: a resumed run does not begin
        // at 0. Nothing is known yet, so on paper there is nothing to say.
        started        = true;
        start_time     = now;
        start_fraction = fraction;
        if (!terminal)
          return;
      }

    const double done = std::clamp(fraction, 0., 1.);
    std::string  left;
    if (done > start_fraction)
      left = ", " +
             format_time(seconds(now - start_time) * (1. - done) /
                         (done - start_fraction)) +
             " left";
    char percent[16];
    std::snprintf(percent, sizeof(percent), "%3.0f %%", 100. * done);

    if (!terminal)
      line(std::string("  ") + percent + "  " + text + left);
    else if (screen != nullptr)
      {
        constexpr unsigned int width = 30;
        const auto n = static_cast<unsigned int>(std::floor(done * width));
        // "\033[K" erases what the bar before left at the end of the line.
        *screen << '\r' << '[' << std::string(n, '=')
                << std::string(width - n, ' ') << "] " << percent << "  "
                << text << left << "\033[K" << std::flush;
        bar_shown = true;
      }
  }


  void
  Log::end_progress()
  {
    erase_bar();
    started = false;
  }


  void
  Log::erase_bar()
  {
    if (bar_shown)
      *screen << "\r\033[K" << std::flush;
    bar_shown = false;
  }
} // namespace Waker
