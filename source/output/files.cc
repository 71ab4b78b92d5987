// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/output/files.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace Waker
{
  namespace
  {
    [[noreturn]] void
    throw_cannot_write(const std::string &path, const int error)
    {
      throw UserError("Output/Directory",
                      "cannot write '" + path + "': " + std::strerror(error),
                      "a writable folder with enough space");
    }



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
    std::ifstream      file(path, std::ios::binary);
    std::ostringstream contents;
    if (file)
      contents << file.rdbuf();
    if (!file)
      throw UserError(path, "cannot be read", "a readable file");
    return contents.str();
  }



  std::string
  join_path(const std::string &folder, const std::string &name)
  {
    if (folder.empty())
      return name;
    return folder.back() == '/' ? folder + name : folder + "/" + name;
  }
} // namespace Waker
