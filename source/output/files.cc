// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/file_error.h>
#include <waker/output/files.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace Waker
{
  namespace
  {
    /// fsync of a file or folder, by name.
    bool
    sync_path(const std::string &path)
    {
      const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
      if (descriptor < 0)
        return false;
      const bool good = ::fsync(descriptor) == 0;
      ::close(descriptor);
      return good;
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
  make_folder(const std::string &path)
  {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error)
      throw_cannot_write(path, error.value());
  }



  void
  write_file(const std::string &path,
             const std::string &contents,
             const bool         to_disk)
  {
    // A name of our own: the tasks of a job array may write the same file at
    // the same time. One that a killed process has left stays.
    std::string temporary = path + ".tmp";
    std::FILE  *file      = std::fopen(temporary.c_str(), "wbx");
    for (unsigned int number = 1; file == nullptr && errno == EEXIST; ++number)
      {
        temporary = path + "." + std::to_string(number) + ".tmp";
        file      = std::fopen(temporary.c_str(), "wbx");
      }
    if (file == nullptr)
      throw_cannot_write(temporary, errno);

    bool good =
      std::fwrite(contents.data(), 1, contents.size(), file) == contents.size();
    good      = std::fflush(file) == 0 && good;
    good      = good && (!to_disk || ::fsync(::fileno(file)) == 0);
    int error = good ? 0 : errno;
    if (std::fclose(file) != 0 && good)
      {
        good  = false;
        error = errno;
      }
    if (!good || std::rename(temporary.c_str(), path.c_str()) != 0)
      {
        if (good)
          error = errno;
        std::remove(temporary.c_str());
        throw_cannot_write(path, error);
      }

    // The new name is safe only once the folder is on the disk, too.
    if (to_disk)
      {
        const std::size_t slash = path.rfind('/');
        sync_path(slash == std::string::npos ? std::string(".")
                                             : path.substr(0, slash + 1));
      }
  }



  std::string
  read_file(const std::string &path)
  {
    const auto refuse = [&path](const std::string &why) {
      throw UserError(path, "cannot be read" + why, "a readable file");
    };
    std::error_code error;
    if (std::filesystem::is_directory(path, error))
      refuse(": it is a folder");
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file)
      refuse(errno != 0 ? std::string(": ") + std::strerror(errno) : "");
    std::ostringstream contents;
    if (file.peek() != std::ifstream::traits_type::eof())
      contents << file.rdbuf();
    if (file.bad() || contents.fail())
      refuse(errno != 0 ? std::string(": ") + std::strerror(errno) : "");
    return contents.str();
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
    do
      descriptor = ::open(path.c_str(),
                          O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC |
                            O_NOFOLLOW | (empty ? O_TRUNC : 0),
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
            const int error = n == 0 ? ENOSPC : errno;
            // A part of a line would spoil the next one. If this fails, too,
            // then readers drop the part.
            if (::ftruncate(descriptor, static_cast<off_t>(length)) != 0)
              {}
            errno = error;
            return false;
          }
      }
    length += text.size();
    return true;
  }



  bool
  AppendFile::sync()
  {
    // Pipes and devices cannot.
    return ::fsync(descriptor) == 0 || errno == EINVAL;
  }
} // namespace Waker
