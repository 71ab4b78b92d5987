// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/hash.h>
#include <waker/output/files.h>
#include <waker/reliability/journal.h>
#include <waker/reliability/journal_header.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace Waker
{
  namespace
  {
    std::string
    journal_name(const unsigned int number)
    {
      char digits[16];
      std::snprintf(digits, sizeof(digits), "%05u", number);
      return "journal-" + std::string(digits) + ".jsonl";
    }


    [[noreturn]] void
    throw_cannot_write(const std::string &path, const int error)
    {
      throw UserError(path,
                      std::string("cannot be written: ") + std::strerror(error),
                      "a writable folder with enough space; what is finished "
                      "is kept, --resume goes on from there");
    }
  } // namespace



  std::string
  journal_line(const Record &record, const std::string &campaign_hash)
  {
    return sealed(to_json(record), campaign_hash);
  }



  JournalWriter::JournalWriter(const std::string &folder,
                               const std::string &campaign_hash,
                               const double       sync_interval)
    : campaign_hash(campaign_hash)
    , sync_interval(sync_interval)
    , last_sync(std::chrono::steady_clock::now())
  {
    // Only one of all writers can create a file: no lock is needed.
    for (unsigned int number = 0; descriptor < 0; ++number)
      {
        name       = join_path(folder, journal_name(number));
        descriptor = ::open(name.c_str(),
                            O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC,
                            0666);
        if (descriptor < 0 && errno != EEXIST && errno != EINTR)
          throw_cannot_write(name, errno);
      }

    try
      {
        write_line(journal_header_line(campaign_hash));
      }
    catch (...)
      {
        ::close(descriptor);
        ::unlink(name.c_str());
        throw;
      }
  }



  JournalWriter::~JournalWriter()
  {
    if (sync_interval >= 0.)
      ::fsync(descriptor);
    ::close(descriptor);
  }



  void
  JournalWriter::append(const Record &record)
  {
    write_line(journal_line(record, campaign_hash));

    const auto now = std::chrono::steady_clock::now();
    if (sync_interval >= 0. &&
        std::chrono::duration<double>(now - last_sync).count() >= sync_interval)
      {
        // Some file systems notice a full disk only here.
        if (::fsync(descriptor) != 0 && errno != EINVAL)
          throw_cannot_write(name, errno);
        last_sync = now;
      }
  }



  const std::string &
  JournalWriter::path() const
  {
    return name;
  }



  void
  JournalWriter::write_line(std::string line)
  {
    line += '\n';

    // One call takes the whole line, unless the disk becomes full in it.
    std::size_t written = 0;
    while (written < line.size())
      {
        const ssize_t n =
          ::write(descriptor, line.data() + written, line.size() - written);
        if (n > 0)
          written += static_cast<std::size_t>(n);
        else if (n == 0 || errno != EINTR)
          {
            const int error = n == 0 ? ENOSPC : errno;
            // A part of a line would spoil the next one. If this fails, too,
            // then readers drop the part.
            if (::ftruncate(descriptor, static_cast<off_t>(length)) != 0)
              {}
            throw_cannot_write(name, error);
          }
      }
    length += line.size();
  }
} // namespace Waker
