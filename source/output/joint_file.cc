// SPDX-License-Identifier: LGPL-2.1-or-later
#include "joint_file.h"

#include <waker/base/hash.h>
#include <waker/base/ranks.h>
#include <waker/output/files.h>

#include "temporary_file.h"
#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <fcntl.h>
#include <optional>
#include <utility>

namespace Waker
{
  namespace
  {
    /// MPI counts with int: so many bytes are written at once.
    constexpr std::size_t most_at_once = std::size_t(1) << 30;


    /// An errno for what MPI says, which knows only some of them.
    int
    errno_of(const int code)
    {
      if (code == MPI_SUCCESS)
        return 0;
      int kind = MPI_ERR_OTHER;
      MPI_Error_class(code, &kind);
      switch (kind)
        {
          case MPI_ERR_NO_SPACE:
            return ENOSPC;
          case MPI_ERR_QUOTA:
            return EDQUOT;
          case MPI_ERR_ACCESS:
            return EACCES;
          case MPI_ERR_READ_ONLY:
            return EROFS;
          case MPI_ERR_NO_SUCH_FILE:
            return ENOENT;
          default:
            return EIO;
        }
    }


    /// One of all ranks', if any has one.
    int
    error_of_any(const int error, const MPI_Comm communicator)
    {
      return Utilities::MPI::max(error, communicator);
    }


    /// Room on the disk, if the file system can tell: no rank then finds it
    /// full when others have written.
    /// @return an errno, or 0
    int
    make_room(const int descriptor, const std::size_t n_bytes)
    {
      int error;
      do
        error = ::posix_fallocate(descriptor, 0, static_cast<off_t>(n_bytes));
      while (error == EINTR);
      for (const int fault : {ENOSPC, EDQUOT, EFBIG, EIO})
        if (error == fault)
          return error;
      return 0;
    }
  } // namespace


  void
  JointFile::add_text(const std::string &text)
  {
    if (is_first_rank(communicator))
      next += text;
  }


  void
  JointFile::add_part(const std::string &part)
  {
    next += part;
    if (n_ranks(communicator) > 1)
      parts.push_back(std::exchange(next, std::string()));
  }


  std::string
  JointFile::write(const std::string &path)
  {
    add_part(""); // the rest of the text
    const unsigned int n = n_ranks(communicator);
    if (n == 1)
      {
        write_file(path, next);
        return checksum_of_text(next);
      }

    std::vector<std::uint64_t> mine; // CRC and size of each part
    for (const std::string &part : parts)
      {
        const CheckedPiece piece = check_piece(part);
        mine.push_back(piece.crc);
        mine.push_back(piece.size);
      }
    std::vector<std::uint64_t> all(n * mine.size());
    MPI_Allgather(mine.data(),
                  static_cast<int>(mine.size()),
                  MPI_UINT64_T,
                  all.data(),
                  static_cast<int>(mine.size()),
                  MPI_UINT64_T,
                  communicator);
    const unsigned int me = Utilities::MPI::this_mpi_process(communicator);
    std::vector<CheckedPiece> pieces;
    std::vector<MPI_Offset>   begins; // of the own parts
    std::size_t               n_bytes = 0;
    for (std::size_t k = 0; k < parts.size(); ++k)
      for (unsigned int rank = 0; rank < n; ++rank)
        {
          if (rank == me)
            begins.push_back(static_cast<MPI_Offset>(n_bytes));
          const std::uint64_t *const piece = &all[rank * mine.size() + 2 * k];
          pieces.push_back({static_cast<std::uint32_t>(piece[0]), piece[1]});
          n_bytes += piece[1];
        }

    // What is wrong with the place shows when the first rank makes the file.
    std::optional<TemporaryFile> file;
    if (me == 0)
      file.emplace(path);
    const std::string name = shared(file ? file->name : "", communicator);
    int error              = error_of_any(file ? file->error : 0, communicator);
    if (error != 0)
      throw_cannot_write(name, error);
    error = error_of_any(file ? make_room(file->descriptor, n_bytes) : 0,
                         communicator);
    if (error == 0)
      error = write_parts(name, begins);
    if (file)
      error = finish(*file, path, error);
    error = error_of_any(error, communicator);
    if (error != 0)
      throw_cannot_write(path, error);
    return checksum_of_pieces(pieces);
  }


  int
  JointFile::write_parts(const std::string             &name,
                         const std::vector<MPI_Offset> &begins) const
  {
    // Only if it is there: a rank that does not see the folder must not make
    // another file.
    MPI_File  file;
    const int opened = MPI_File_open(
      communicator, name.c_str(), MPI_MODE_WRONLY, MPI_INFO_NULL, &file);
    int error = error_of_any(errno_of(opened), communicator);
    if (error != 0)
      return error;
    for (std::size_t k = 0; k < parts.size(); ++k)
      for (std::size_t from = 0; from < parts[k].size() && error == 0;
           from += most_at_once)
        {
          const int size =
            static_cast<int>(std::min(most_at_once, parts[k].size() - from));
          MPI_Status status;
          error = errno_of(
            MPI_File_write_at(file,
                              begins[k] + static_cast<MPI_Offset>(from),
                              parts[k].data() + from,
                              size,
                              MPI_BYTE,
                              &status));
          int written = 0;
          if (error == 0)
            MPI_Get_count(&status, MPI_BYTE, &written);
          if (error == 0 && written < size)
            error = ENOSPC; // what write() means by it
        }
    const int closed = MPI_File_close(&file);
    return error_of_any(error != 0 ? error : errno_of(closed), communicator);
  }
} // namespace Waker
