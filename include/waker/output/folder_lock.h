// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_folder_lock_h
#define waker_output_folder_lock_h

#include <string>

namespace Waker
{
  /// Who writes somewhere, as the lock's file says.
  struct LockHolder
  {
    std::string what = "a process"; // "waker run"
    std::string host;
    long        process = 0;
    std::string since; // UTC, ISO 8601

    /// "waker run, process 123 on node7, since 2026-01-31T12:00:00Z"
    std::string
    text() const;
  };


  /**
   * A file that one process at a time holds, and that says which. The kernel
   * knows who holds it (flock) and lets go when the process ends, however it
   * ends: what a killed one has left is taken over. The file of another host
   * counts as held until somebody removes it, since not every file system tells
   * hosts of each other's locks. Where there are no locks at all, a process of
   * this host counts as long as it is there. A file that no lock can have left
   * (neither our text nor its beginning, nor empty) is somebody's of that name:
   * it is not touched.
   */
  class FolderLock
  {
  public:
    enum class State
    {
      ours,          // held by this object
      held,          // by another process, or another object of this one
      of_other_host, // left by, or still held on, another host
      foreign        // no lock of ours, but a file that somebody has there
    };

    /// Holds nothing.
    FolderLock() = default;

    /**
     * Try to get the lock. Does not wait.
     *
     * @param path of the file, in a folder that exists
     * @param what this process does, for others' messages: "waker run"
     * @throws UserError "Output/Directory" if the file cannot be made, or is a
     *         link
     */
    FolderLock(const std::string &path, const std::string &what);

    /// Lets go and removes the file.
    ~FolderLock();

    FolderLock(FolderLock &&other) noexcept;
    FolderLock &
    operator=(FolderLock &&other) noexcept;

    State
    state() const
    {
      return present_state;
    }

    /// The other one, if it is not ours.
    const LockHolder &
    holder() const
    {
      return other;
    }

    const std::string &
    path() const
    {
      return name;
    }

    /// Does a file say that another process writes? Changes nothing.
    /// @param holder gets who
    static State
    look(const std::string &path, LockHolder &holder);

    /**
     * Remove a file that a process has left which does not hold it any more,
     * on whatever host it was, and whatever is in it: for what may be done
     * twice, in a folder that only we write in. No two callers remove each
     * other's new file.
     *
     * @return false if it is held
     */
    static bool
    remove_dead(const std::string &path);

  private:
    void
    release();

    std::string name;
    int         descriptor    = -1;
    State       present_state = State::held;
    LockHolder  other;
  };


  /// @throws UserError "Output/Directory" that says who writes in the folder,
  /// or whose file is in the way, and what to do, unless the state is "ours"
  void
  require_lock(const std::string      &folder,
               const std::string      &lock_path,
               const FolderLock::State state,
               const LockHolder       &holder);

  /**
   * Get the lock of an output folder, for as long as the object lives.
   *
   * @param folder made if it is not there
   * @throws UserError "Output/Directory" if another process writes there, or
   *         a file of that name is not a lock of ours
   */
  FolderLock
  lock_folder(const std::string &folder, const std::string &what);

  /// The same without getting it: nothing is written.
  void
  refuse_locked_folder(const std::string &folder);
} // namespace Waker

#endif
