// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/host.h>
#include <waker/output/files.h>
#include <waker/output/folder_lock.h>
#include <waker/output/output_files.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace Waker
{
  namespace
  {
    /// Does the name still stand for the file that is open?
    bool
    is_same_file(const int descriptor, const std::string &path)
    {
      struct stat open_file, named_file;
      return ::fstat(descriptor, &open_file) == 0 &&
             ::lstat(path.c_str(), &named_file) == 0 &&
             open_file.st_ino == named_file.st_ino &&
             open_file.st_dev == named_file.st_dev;
    }


    /// Never waits, as for the other end of a pipe. @return -1, with errno
    /// @throws UserError "Output/Directory" of what is no regular file
    int
    open_lock(const std::string &path, const int flags)
    {
      const std::string kind = kind_of_irregular_file(path);
      if (!kind.empty())
        throw_no_regular_file(path, kind);
      int descriptor;
      do
        descriptor = ::open(path.c_str(),
                            flags | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK,
                            0666);
      while (descriptor < 0 && errno == EINTR);
      return descriptor;
    }


    /// What a lock says.
    std::string
    text_of(const std::string &what,
            const std::string &host,
            const long         process,
            const std::string &since)
    {
      const nlohmann::ordered_json json = {{"what", what},
                                           {"host", host},
                                           {"process", process},
                                           {"since", since}};
      return json.dump(-1,
                       ' ',
                       false,
                       nlohmann::json::error_handler_t::replace) +
             "\n";
    }


    /// Is this the beginning of what a lock says, whatever it says? A killed
    /// process or a full disk leaves one; a power cut may leave zeros.
    bool
    is_beginning(const std::string &text)
    {
      if (text.find_first_not_of('\0') == std::string::npos)
        return true;
      // The text with nothing in it, of which a "" stands for any string, and
      // the 0 for any number.
      const std::string form = text_of("", "", 0, "");
      std::size_t       at   = 0;
      for (std::size_t i = 0; i < form.size() && at < text.size(); ++i)
        if (form[i] == '0')
          while (at < text.size() && text[at] >= '0' && text[at] <= '9')
            ++at;
        else if (text[at++] != form[i])
          return false;
        else if (form.compare(i, 2, "\"\"") == 0)
          while (at < text.size() && text[at] != '"')
            at += text[at] == '\\' ? 2 : 1;
      return at >= text.size();
    }


    enum class Says
    {
      who,     // holds it, or has held it
      nothing, // yet
      foreign  // things, but it is no lock
    };


    Says
    read_holder(const int descriptor, LockHolder &holder)
    {
      char        buffer[2048]; // several times what a lock says
      struct stat status;
      if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode) ||
          status.st_size > static_cast<off_t>(sizeof buffer))
        return Says::foreign;
      const ssize_t     size = ::pread(descriptor, buffer, sizeof buffer, 0);
      const std::string text(buffer, std::max<ssize_t>(size, 0));
      const auto        json = nlohmann::json::parse(text, nullptr, false);
      const Says otherwise = is_beginning(text) ? Says::nothing : Says::foreign;
      if (!json.is_object())
        return otherwise;
      try
        {
          holder.what    = json.at("what").get<std::string>();
          holder.host    = json.at("host").get<std::string>();
          holder.process = json.at("process").get<long>();
          holder.since   = json.at("since").get<std::string>();
          return Says::who;
        }
      catch (const nlohmann::json::exception &)
        {
          return otherwise;
        }
    }


    enum class Kernel
    {
      free,
      held,
      unknown // the file system knows no locks
    };


    /// Waits some milliseconds: others that only look hold it for microseconds.
    Kernel
    try_lock(const int          descriptor,
             const int          operation,
             const unsigned int n_attempts)
    {
      for (unsigned int attempt = 0; attempt < n_attempts; ++attempt)
        {
          if (::flock(descriptor, operation | LOCK_NB) == 0)
            return Kernel::free;
          if (errno != EWOULDBLOCK && errno != EINTR)
            return Kernel::unknown;
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
      return Kernel::held;
    }


    /// @param kernel what it said about the open file
    FolderLock::State
    judge(const int descriptor, const Kernel kernel, LockHolder &holder)
    {
      const Says says = read_holder(descriptor, holder);
      if (kernel == Kernel::held)
        return FolderLock::State::held;
      if (says == Says::foreign)
        return FolderLock::State::foreign;
      if (says == Says::nothing)
        return FolderLock::State::ours;
      if (holder.host != host_name())
        return FolderLock::State::of_other_host;
      if (kernel == Kernel::unknown && holder.process != ::getpid() &&
          (::kill(static_cast<pid_t>(holder.process), 0) == 0 ||
           errno == EPERM))
        return FolderLock::State::held;
      return FolderLock::State::ours;
    }
  } // namespace


  std::string
  LockHolder::text() const
  {
    return what + (process > 0 ? ", process " + std::to_string(process) : "") +
           (host.empty() ? "" : " on " + host) +
           (since.empty() ? "" : ", since " + since);
  }


  FolderLock::FolderLock(const std::string &path, const std::string &what)
    : name(path)
  {
    while (true)
      {
        descriptor = open_lock(path, O_RDWR | O_CREAT);
        if (descriptor < 0)
          throw_cannot_write(path, errno);
        const Kernel kernel = try_lock(descriptor, LOCK_EX, 50);
        // The one before may have removed its file in between.
        if (kernel == Kernel::held || is_same_file(descriptor, path))
          {
            present_state = judge(descriptor, kernel, other);
            break;
          }
        ::close(descriptor);
      }
    if (present_state != State::ours)
      {
        ::close(std::exchange(descriptor, -1));
        return;
      }

    const std::string text = text_of(what, host_name(), ::getpid(), utc_time());
    if (::ftruncate(descriptor, 0) != 0 ||
        ::pwrite(descriptor, text.data(), text.size(), 0) !=
          static_cast<ssize_t>(text.size()))
      {
        const int error = errno;
        release();
        throw_cannot_write(path, error);
      }
  }


  FolderLock::~FolderLock()
  {
    release();
  }


  FolderLock::FolderLock(FolderLock &&lock) noexcept
    : name(std::move(lock.name))
    , descriptor(std::exchange(lock.descriptor, -1))
    , present_state(lock.present_state)
    , other(std::move(lock.other))
  {}


  FolderLock &
  FolderLock::operator=(FolderLock &&lock) noexcept
  {
    if (this != &lock)
      {
        release();
        name          = std::move(lock.name);
        descriptor    = std::exchange(lock.descriptor, -1);
        present_state = lock.present_state;
        other         = std::move(lock.other);
      }
    return *this;
  }


  void
  FolderLock::release()
  {
    if (descriptor < 0)
      return;
    // While it is still held: nobody else can have made it theirs.
    if (is_same_file(descriptor, name))
      ::unlink(name.c_str());
    ::close(std::exchange(descriptor, -1));
  }


  FolderLock::State
  FolderLock::look(const std::string &path, LockHolder &holder)
  {
    const int descriptor = open_lock(path, O_RDONLY);
    if (descriptor < 0) // a link, or nobody's
      return errno == ELOOP ? State::foreign : State::ours;
    const State state =
      judge(descriptor, try_lock(descriptor, LOCK_SH, 3), holder);
    ::close(descriptor);
    return state;
  }


  bool
  FolderLock::remove_dead(const std::string &path)
  {
    const int descriptor = open_lock(path, O_RDWR);
    if (descriptor < 0)
      return errno == ENOENT;
    const Kernel kernel = try_lock(descriptor, LOCK_EX, 3);
    LockHolder   holder;
    const bool   dead = judge(descriptor, kernel, holder) != State::held;
    // Whoever holds the file may remove its name, and nobody else.
    if (dead && is_same_file(descriptor, path))
      ::unlink(path.c_str());
    ::close(descriptor);
    return dead;
  }


  void
  require_lock(const std::string      &folder,
               const std::string      &lock_path,
               const FolderLock::State state,
               const LockHolder       &holder)
  {
    if (state == FolderLock::State::held)
      throw UserError("Output/Directory",
                      "'" + folder + "' is in use by " + holder.text(),
                      "to wait until it has ended; or another folder, --set "
                      "Output/Directory=...");
    if (state == FolderLock::State::of_other_host)
      throw UserError("Output/Directory",
                      "'" + folder + "' may be in use by " + holder.text(),
                      "if that process is there no more, to remove '" +
                        lock_path + "'; or another folder");
    if (state == FolderLock::State::foreign)
      throw UserError("Output/Directory",
                      "'" + folder + "' holds a file " +
                        lock_path.substr(lock_path.rfind('/') + 1) +
                        " that is not ours",
                      "to move '" + lock_path +
                        "' away; or another folder, --set "
                        "Output/Directory=...");
  }


  FolderLock
  lock_folder(const std::string &folder, const std::string &what)
  {
    make_folder(folder);
    const std::string path = join_path(folder, lock_name);
    FolderLock        lock(path, what);
    require_lock(folder, path, lock.state(), lock.holder());
    return lock;
  }


  void
  refuse_locked_folder(const std::string &folder)
  {
    const std::string path = join_path(folder, lock_name);
    LockHolder        holder;
    const auto        state = FolderLock::look(path, holder);
    require_lock(folder, path, state, holder);
  }
} // namespace Waker
