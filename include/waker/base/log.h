// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_log_h
#define waker_base_log_h

#include <chrono>
#include <fstream>
#include <iosfwd>
#include <string>
#include <vector>

namespace Waker
{
  /**
   * What a run says: lines, to the screen and to a file, and how far it is.
   *
   * On a terminal the progress is a bar with the time left, on one line that
   * is overwritten; otherwise a plain line every few seconds. There is no
   * global log: it is passed by reference. Not thread safe.
   */
  class Log
  {
  public:
    /// Says nothing (tests).
    Log();

    /**
     * @param screen   where lines go, usually std::cout; borrowed
     * @param terminal can lines be overwritten? See is_terminal().
     */
    Log(std::ostream &screen, const bool terminal);

    /// Is standard output a terminal?
    static bool
    is_terminal();

    /// Write to this file too, from now on.
    /// @param append go on with the file of a resumed run
    /// @throws UserError "Output/Directory" if it cannot be opened
    void
    open_file(const std::string &path, const bool append);

    /// A line (or several, without the last line break).
    void
    line(const std::string &text);

    /// What is allowed, but likely not meant: a line "Warning: ...".
    void
    warning(const std::string &text);

    /// What such lines begin with, whoever makes them: they are kept, for the
    /// summary.
    static constexpr const char *warning_mark = "Warning: ";

    /// All warnings so far.
    const std::vector<std::string> &
    warnings() const
    {
      return all_warnings;
    }

    /**
     * How far the work is. Cheap enough for every step: mostly it only looks
     * at the clock.
     *
     * @param fraction done, 0 to 1
     * @param text     short, "t = 3.2 s"
     */
    void
    progress(const double fraction, const std::string &text);

    /// Is it time for progress() to say something? For callers whose `text`
    /// costs something to make.
    bool
    progress_due() const;

    /// The work is over: removes the bar.
    void
    end_progress();

    /// Wall time between two signs of progress (s).
    static constexpr double bar_interval  = 0.1;
    static constexpr double line_interval = 5.;

  private:
    using Clock = std::chrono::steady_clock;

    void
    erase_bar();

    std::ostream            *screen   = nullptr;
    bool                     terminal = false;
    std::ofstream            file;
    std::vector<std::string> all_warnings;
    bool                     file_failed = false; // and the screen has said so
    bool                     bar_shown   = false;
    bool                     started     = false;
    Clock::time_point        start_time;
    Clock::time_point        last_time;
    double                   start_fraction = 0.;
  };
} // namespace Waker

#endif
