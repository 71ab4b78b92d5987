// SPDX-License-Identifier: LGPL-2.1-or-later
#include "joint_file.h"

#include <deal.II/base/exceptions.h>

#include <waker/base/ranks.h>
#include <waker/output/files.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <system_error>

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


    /// Room on the disk, if the file system can tell: no rank then finds it
    /// full when others have written. @return an errno, or 0
    int
    make_room(const int           descriptor,
              const std::uint64_t begin,
              const std::uint64_t n_bytes)
    {
      if (n_bytes == 0)
        return 0;
      // Not posix_fallocate(): where the file system cannot, that writes zeros,
      // which may come to a network's disk after what other ranks have written.
      int error;
      do
        error = ::fallocate(descriptor,
                            0,
                            static_cast<off_t>(begin),
                            static_cast<off_t>(n_bytes)) == 0
                  ? 0
                  : errno;
      while (error == EINTR);
      for (const int fault : {ENOSPC, EDQUOT, EFBIG, EIO})
        if (error == fault)
          return error;
      return 0;
    }
  } // namespace


  JointFile::JointFile(const MPI_Comm     communicator,
                       const std::string &given_path,
                       const bool         to_disk,
                       const bool         makes_folder)
    : communicator(communicator)
    , path(given_path)
    , to_disk(to_disk)
    , has_others(n_ranks(communicator) > 1)
  {
    if (has_others)
      path = shared(path, communicator);
    // What is wrong with the place shows when the first rank makes the file.
    std::string name = path;
    if (is_first_rank(communicator))
      {
        std::error_code folder_error;
        if (makes_folder)
          std::filesystem::create_directories(
            std::filesystem::path(path).parent_path(), folder_error);
        error = folder_error.value();
        if (error == 0)
          {
            file.emplace(path);
            name  = file->name;
            error = file->error;
          }
      }
    if (!has_others)
      {
        if (error != 0)
          throw_cannot_write(name, error);
        return;
      }
    name  = shared(name, communicator);
    error = of_any(error);
    if (error == 0)
      // Only if it is there: a rank that does not see the folder must not make
      // another file.
      error = of_any(errno_of(MPI_File_open(communicator,
                                            name.c_str(),
                                            MPI_MODE_WRONLY,
                                            MPI_INFO_NULL,
                                            &open_file)));
    if (error != 0)
      {
        if (file && file->error == 0)
          finish(*file, path, false, error);
        throw_cannot_write(name, error);
      }
  }


  JointFile::~JointFile()
  {
    // An exception came between; other ranks may not have one.
    if (file)
      finish(*file, path, false, ECANCELED);
  }


  int
  JointFile::of_any(const int mine) const
  {
    return has_others ? Utilities::MPI::max(mine, communicator) : mine;
  }


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
    end_piece();
  }


  void
  JointFile::end_piece()
  {
    const CheckedPiece mine = check_piece(next);
    if (!has_others)
      {
        if (error == 0)
          error = append(*file, next);
        pieces.push_back(mine);
        n_bytes += mine.size;
        next.clear();
        return;
      }
    const unsigned int n  = n_ranks(communicator);
    const unsigned int me = Utilities::MPI::this_mpi_process(communicator);
    const std::array<std::uint64_t, 2>        told{{mine.crc, mine.size}};
    std::vector<std::array<std::uint64_t, 2>> all(n);
    MPI_Allgather(
      told.data(), 2, MPI_UINT64_T, all.data(), 2, MPI_UINT64_T, communicator);
    std::uint64_t my_begin = n_bytes, end = n_bytes;
    for (unsigned int rank = 0; rank < n; ++rank)
      {
        if (rank == me)
          my_begin = end;
        pieces.push_back(
          {static_cast<std::uint32_t>(all[rank][0]), all[rank][1]});
        end += all[rank][1];
      }
    if (error == 0)
      error =
        of_any(file ? make_room(file->descriptor, n_bytes, end - n_bytes) : 0);
    if (error == 0)
      error = of_any(write_own(my_begin, next));
    n_bytes = end;
    next.clear();
  }


  int
  JointFile::write_own(std::uint64_t at, const std::string &text) const
  {
    for (std::size_t from = 0; from < text.size(); from += most_at_once)
      {
        const int size =
          static_cast<int>(std::min(most_at_once, text.size() - from));
        MPI_Status status;
        const int  fault =
          errno_of(MPI_File_write_at(open_file,
                                     static_cast<MPI_Offset>(at + from),
                                     text.data() + from,
                                     size,
                                     MPI_BYTE,
                                     &status));
        if (fault != 0)
          return fault;
        int written = 0;
        MPI_Get_count(&status, MPI_BYTE, &written);
        if (written < size)
          return ENOSPC; // what write() means by it
      }
    return 0;
  }


  CheckedPiece
  JointFile::checked_from(const std::uint64_t first)
  {
    end_piece();
    std::uint64_t at    = 0;
    auto          piece = pieces.begin();
    for (; piece != pieces.end() && at < first; ++piece)
      at += piece->size;
    AssertThrow(at == first, ExcMessage("no piece of the file begins there"));
    return joined({piece, pieces.end()});
  }


  void
  JointFile::replace(const std::uint64_t at, const std::string &text)
  {
    end_piece();
    if (error == 0)
      error = of_any(!file        ? 0
                     : has_others ? write_own(at, text)
                                  : overwrite(*file, at, text));
  }


  std::string
  JointFile::write()
  {
    end_piece(); // the rest of the text
    if (has_others)
      {
        if (error == 0 && to_disk)
          error = errno_of(MPI_File_sync(open_file));
        const int closed = errno_of(MPI_File_close(&open_file));
        error            = of_any(error != 0 ? error : closed);
      }
    if (file)
      error = finish(*file, path, to_disk, error);
    file.reset();
    error = of_any(error);
    if (error != 0)
      throw_cannot_write(path, error);
    return checksum_of_pieces(pieces);
  }
} // namespace Waker
