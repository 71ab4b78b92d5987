// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_output_joint_file_h
#define waker_source_output_joint_file_h

#include <deal.II/base/mpi.h>

#include <string>
#include <vector>

namespace Waker
{
  using namespace dealii;

  /**
   * A file that ranks write together: it consists of pieces, of which each rank
   * has its part, and no rank ever has more. On one rank it is write_file(),
   * without MPI. Private to the room.
   */
  class JointFile
  {
  public:
    explicit JointFile(const MPI_Comm communicator)
      : communicator(communicator)
    {}

    /// What all ranks know: the first one writes it.
    void
    add_text(const std::string &text);

    /// What comes next, in the order of the ranks: each adds its part, which
    /// may be empty. All add as many.
    void
    add_part(const std::string &part);

    /**
     * Write it, aside under a temporary name ("<path>.tmp"), and rename it.
     * Collective; once.
     *
     * @param path the same on all ranks, which must all see the folder
     * @return checksum_of_text() of the whole
     * @throws as throw_cannot_write(), on all ranks alike: there is nothing
     *         left of it then
     */
    std::string
    write(const std::string &path);

    const MPI_Comm communicator;

  private:
    /// @param begins of the parts in the file
    /// @return an errno, or 0; the same on all ranks
    int
    write_parts(const std::string             &name,
                const std::vector<MPI_Offset> &begins) const;

    std::string              next;  // on the first rank: of the next part
    std::vector<std::string> parts; // of this rank
  };
} // namespace Waker

#endif
