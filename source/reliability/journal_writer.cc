// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/output/files.h>
#include <waker/reliability/journal.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <nlohmann/json.hpp>
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



  JournalWriter::JournalWriter(const std::string &folder,
                               const std::string &campaign_hash,
                               const double       sync_interval)
    : sync_interval(sync_interval)
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

    const Machine                machine = this_machine();
    const nlohmann::ordered_json header  = {{"schema_version",
                                             journal_schema_version},
                                            {"campaign", campaign_hash},
                                            {"version", machine.version},
                                            {"compiler", machine.compiler},
                                            {"build_flags", machine.build_flags},
                                            {"host", machine.host},
                                            {"processor", machine.processor},
                                            {"cores", machine.n_cores},
                                            {"start", utc_time()}};
    try
      {
        // A host may have any name.
        write_line(header.dump(
          -1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
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
    write_line(to_json(record));

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
