// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/read_file.h>
#include <waker/base/text.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <istream>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace Waker
{
  namespace
  {
    [[noreturn]] void
    refuse(const std::string &path, const std::string &why)
    {
      throw UserError(path, why, "a readable file");
    }


    [[noreturn]] void
    refuse(const std::string &path, const int error)
    {
      refuse(path, std::string("cannot be read: ") + std::strerror(error));
    }


    std::string
    megabytes(const std::uint64_t bytes)
    {
      return bytes < 1000000 ? std::to_string(bytes) + " bytes"
                             : std::to_string(bytes / 1000000) + " MB";
    }


    [[noreturn]] void
    refuse_size(const std::string  &path,
                const std::string  &size,
                const std::uint64_t largest)
    {
      throw UserError(path,
                      "has " + size,
                      "at most " + megabytes(largest) +
                        ": is it another file than was meant?");
    }


    std::string
    kind(const struct stat &status)
    {
      switch (status.st_mode & S_IFMT)
        {
          case S_IFREG:
            return "";
          case S_IFDIR:
            return "a folder";
          case S_IFIFO:
            return "a pipe";
          case S_IFSOCK:
            return "a socket";
          case S_IFCHR:
          case S_IFBLK:
            return "a device";
          default:
            return "none that we know";
        }
    }


    void
    require_regular(const std::string &path, const struct stat &status)
    {
      const std::string other = kind(status);
      if (S_ISDIR(status.st_mode))
        refuse(path, "cannot be read: it is a folder");
      if (!other.empty())
        throw UserError(path,
                        "is no regular file, but " + other,
                        "a file on the disk");
    }


    /// Closes what it holds.
    struct Descriptor
    {
      explicit Descriptor(const std::string &path)
      {
        // A pipe that has become of the file meanwhile must not block.
        do
          number = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
        while (number < 0 && errno == EINTR);
        if (number < 0)
          refuse(path, errno);
      }

      ~Descriptor()
      {
        ::close(number);
      }

      Descriptor(const Descriptor &) = delete;
      Descriptor &
      operator=(const Descriptor &) = delete;

      int number;
    };
  } // namespace



  std::string
  kind_of_irregular_file(const std::string &path)
  {
    struct stat status;
    return ::stat(path.c_str(), &status) == 0 ? kind(status) : "";
  }



  std::string
  read_file(const std::string &path, const std::uint64_t largest)
  {
    // Before it is opened: that alone may move a device.
    struct stat status;
    if (::stat(path.c_str(), &status) != 0)
      refuse(path, errno);
    require_regular(path, status);
    const Descriptor file(path);
    if (::fstat(file.number, &status) != 0)
      refuse(path, errno);
    require_regular(path, status);
    const auto size = static_cast<std::uint64_t>(status.st_size);
    if (size > largest)
      refuse_size(path, megabytes(size), largest);

    // Its size is a hint only: it may grow, and those of /proc have none.
    constexpr std::uint64_t piece = 1 << 16;
    std::string             contents;
    std::uint64_t           n = 0;
    while (true)
      {
        contents.resize(std::max(n + piece, n == 0 ? size + 1 : n));
        const ssize_t got =
          ::read(file.number, &contents[n], contents.size() - n);
        if (got < 0 && errno == EINTR)
          continue;
        if (got < 0)
          refuse(path, errno);
        n += static_cast<std::uint64_t>(got);
        if (n > largest)
          refuse_size(path, "more than " + megabytes(largest), largest);
        if (got == 0)
          break;
      }
    contents.resize(n);
    return contents;
  }



  std::string
  read_input_file(const std::string &path)
  {
    return read_file(path, largest_input);
  }


  std::string
  read_named_file(const std::string &file,
                  const std::string &path,
                  const std::string &holds)
  {
    if (file.empty())
      throw UserError(path, "is empty", "the file with " + holds);
    try
      {
        const std::string text = read_input_file(file);
        if (text.empty())
          throw UserError(file, "holds nothing", "a file that holds one");
        return without_byte_order_mark(text);
      }
    catch (const UserError &error)
      {
        throw UserError(path,
                        "\"" + file + "\" " + error.problem,
                        error.allowed +
                          "; names are relative to the folder in which waker "
                          "is started");
      }
  }



  std::string
  read_input(std::istream       &stream,
             const std::string  &name,
             const std::uint64_t largest)
  {
    std::string       contents;
    std::vector<char> piece(1 << 16);
    do
      {
        stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
        contents.append(piece.data(),
                        static_cast<std::size_t>(stream.gcount()));
        if (contents.size() > largest)
          refuse_size(name, "more than " + megabytes(largest), largest);
    } while (stream);
    if (stream.bad())
      refuse(name, "cannot be read");
    return contents;
  }
} // namespace Waker
