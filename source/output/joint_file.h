// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_output_joint_file_h
#define waker_source_output_joint_file_h

#include <deal.II/base/mpi.h>

#include <waker/base/hash.h>

#include "temporary_file.h"
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace Waker
{
  using namespace dealii;

  /**
   * A file that ranks write together: it consists of pieces, of which each rank
   * has its part, and no rank ever has more than that of one piece. It is
   * written aside under a temporary name ("<path>.tmp"), and renamed at the
   * end. On one rank there is no MPI. All functions are collective. Private to
   * the room.
   */
  class JointFile
  {
  public:
    /**
     * @param path the first rank's counts; all must see its folder
     * @param to_disk is it to outlast a power cut?
     * @param makes_folder if the folder is not there
     * @throws as throw_cannot_write(), on all ranks alike, if it cannot be made
     */
    JointFile(const MPI_Comm     communicator,
              const std::string &path,
              const bool         to_disk      = false,
              const bool         makes_folder = false);

    JointFile(const JointFile &) = delete;
    JointFile &
    operator=(const JointFile &) = delete;

    ~JointFile();

    /// What all ranks know: the first one writes it.
    void
    add_text(const std::string &text);

    /// What comes next, in the order of the ranks: each adds its part, which
    /// may be empty. All add as many.
    void
    add_part(const std::string &part);

    /// Of all after the first `n_bytes`, with which a call of add_part() must
    /// have ended.
    CheckedPiece
    checked_from(const std::uint64_t n_bytes);

    /// What is known at the end only; the first rank writes it over what is
    /// there. The last call before write().
    void
    replace(const std::uint64_t at, const std::string &text);

    /**
     * The end of it; once.
     *
     * @return checksum_of_text() of the whole, before replace()
     * @throws as throw_cannot_write(), on all ranks alike: there is nothing
     *         left of it then
     */
    std::string
    write();

    const MPI_Comm communicator;

  private:
    /// @return an errno, or 0
    int
    write_own(std::uint64_t at, const std::string &text) const;

    /// One of all ranks', if any has one.
    int
    of_any(const int error) const;

    /// What is left of the text is a piece.
    void
    end_piece();

    std::string                  path;
    const bool                   to_disk;
    const bool                   has_others;
    std::optional<TemporaryFile> file;      // on the first rank
    MPI_File                     open_file; // if there are others
    int                          error = 0; // an errno; the same on all ranks
    std::string                  next; // on the first rank: of the next part
    std::vector<CheckedPiece>    pieces;
    std::uint64_t                n_bytes = 0;
  };
} // namespace Waker

#endif
