// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/file_error.h>
#include <waker/output/files.h>

#include "temporary_file.h"
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>

namespace Waker
{
  namespace
  {
    // A signal ends a call of the system that waits (see program/compute.cc):
    // each one is begun again.

    /// fsync. @return false, with errno
    bool
    sync_descriptor(const int descriptor)
    {
      int result;
      do
        result = ::fsync(descriptor);
      while (result != 0 && errno == EINTR);
      return result == 0;
    }


    /// fsync of a file or folder, by name.
    bool
    sync_path(const std::string &path)
    {
      int descriptor;
      do
        descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
      while (descriptor < 0 && errno == EINTR);
      if (descriptor < 0)
        return false;
      const bool good = sync_descriptor(descriptor);
      ::close(descriptor);
      return good;
    }


    /// @return -1, with errno, if there is something of that name
    int
    create_new(const std::string &path)
    {
      int descriptor;
      do
        descriptor =
          ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      while (descriptor < 0 && errno == EINTR);
      return descriptor;
    }


    /// @return how many bytes were written; if not all, with errno
    std::size_t
    write_all(const int descriptor, const std::string &text)
    {
      // One call takes the whole text, unless the disk becomes full in it.
      std::size_t written = 0;
      while (written < text.size())
        {
          const ssize_t n =
            ::write(descriptor, text.data() + written, text.size() - written);
          if (n > 0)
            written += static_cast<std::size_t>(n);
          else if (n == 0 || errno != EINTR)
            {
              errno = n == 0 ? ENOSPC : errno;
              break;
            }
        }
      return written;
    }
  } // namespace



  void
  throw_cannot_write(const std::string &path, const int error)
  {
    // A place where nothing can be written is a mistake in the input; space
    // that ends, or a device that fails, is none.
    for (const int fault : {ENOSPC, EDQUOT, EFBIG, EIO})
      if (error == fault)
        throw FileError(path,
                        std::string("cannot be written: ") +
                          std::strerror(error));
    throw UserError("Output/Directory",
                    "cannot write '" + path + "': " + std::strerror(error),
                    "a writable folder with enough space");
  }



  void
  throw_no_regular_file(const std::string &path, const std::string &kind)
  {
    throw UserError("Output/Directory",
                    "'" + path + "' is no regular file, but " + kind +
                      ", in place of what a run writes",
                    "a folder without it: remove it, or take another folder");
  }



  void
  make_folder(const std::string &path)
  {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error)
      throw_cannot_write(path, error.value());
  }



  TemporaryFile::TemporaryFile(const std::string &path)
    : name(path + ".tmp")
    , descriptor(create_new(name))
  {
    for (unsigned int number = 1; descriptor < 0 && errno == EEXIST; ++number)
      {
        name       = path + "." + std::to_string(number) + ".tmp";
        descriptor = create_new(name);
      }
    error = descriptor < 0 ? errno : 0;
  }



  int
  append(const TemporaryFile &file, const std::string &text)
  {
    return write_all(file.descriptor, text) == text.size() ? 0 : errno;
  }



  int
  overwrite(const TemporaryFile &file,
            const std::size_t    at,
            const std::string   &text)
  {
    ssize_t n;
    do
      n = ::pwrite(file.descriptor,
                   text.data(),
                   text.size(),
                   static_cast<off_t>(at));
    while (n < 0 && errno == EINTR);
    if (n < 0)
      return errno;
    return static_cast<std::size_t>(n) == text.size() ? 0 : ENOSPC;
  }



  int
  finish(const TemporaryFile &file,
         const std::string   &path,
         const bool           to_disk,
         int                  error)
  {
    if (error == 0 && to_disk && !sync_descriptor(file.descriptor))
      error = errno;
    // A signal in it does not leave it open.
    if (::close(file.descriptor) != 0 && error == 0 && errno != EINTR)
      error = errno;
    if (error == 0 && std::rename(file.name.c_str(), path.c_str()) != 0)
      error = errno;
    if (error != 0)
      std::remove(file.name.c_str());
    // The new name is safe only once the folder is on the disk, too.
    if (error == 0 && to_disk)
      {
        const std::size_t slash = path.rfind('/');
        sync_path(slash == std::string::npos ? std::string(".")
                                             : path.substr(0, slash + 1));
      }
    return error;
  }



  void
  write_file(const std::string &path,
             const std::string &contents,
             const bool         to_disk)
  {
    const TemporaryFile file(path);
    if (file.error != 0)
      throw_cannot_write(file.name, file.error);
    const int error = finish(file, path, to_disk, append(file, contents));
    if (error != 0)
      throw_cannot_write(path, error);
  }



  std::string
  join_path(const std::string &folder, const std::string &name)
  {
    if (folder.empty())
      return name;
    return folder.back() == '/' ? folder + name : folder + "/" + name;
  }



  AppendFile::AppendFile(const std::string &path, const bool empty)
    : name(path)
  {
    const std::string kind = kind_of_irregular_file(path);
    if (!kind.empty())
      throw_no_regular_file(path, kind);
    // Not to wait for a reader of what has become a pipe since.
    do
      descriptor = ::open(path.c_str(),
                          O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC |
                            O_NOFOLLOW | O_NONBLOCK | (empty ? O_TRUNC : 0),
                          0666);
    while (descriptor < 0 && errno == EINTR);
    if (descriptor < 0)
      throw_cannot_write(path, errno);
    const off_t end = ::lseek(descriptor, 0, SEEK_END);
    length          = end > 0 ? static_cast<std::uint64_t>(end) : 0;
  }



  AppendFile::AppendFile(const std::string &path, const int descriptor)
    : name(path)
    , descriptor(descriptor)
  {}



  AppendFile::~AppendFile()
  {
    if (descriptor >= 0)
      ::close(descriptor);
  }



  bool
  AppendFile::write(const std::string &text)
  {
    if (write_all(descriptor, text) < text.size())
      {
        const int error = errno;
        // A part of a line would spoil the next one. If this fails, too, then
        // readers drop the part.
        if (::ftruncate(descriptor, static_cast<off_t>(length)) != 0)
          {}
        errno = error;
        return false;
      }
    length += text.size();
    return true;
  }



  bool
  AppendFile::sync()
  {
    // Some file systems cannot.
    return sync_descriptor(descriptor) || errno == EINVAL;
  }
} // namespace Waker
