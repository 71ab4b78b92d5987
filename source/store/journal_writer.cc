// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/file_error.h>
#include <waker/base/hash.h>
#include <waker/output/files.h>
#include <waker/store/campaign_files.h>
#include <waker/store/journal.h>
#include <waker/store/journal_header.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace Waker
{
  namespace
  {
    [[noreturn]] void
    throw_journal_full(const std::string &path, const int error)
    {
      throw FileError(path,
                      std::string("cannot be written: ") +
                        std::strerror(error));
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
    int descriptor = -1;
    for (unsigned int number = 0; descriptor < 0; ++number)
      {
        const std::string name = join_path(folder, journal_name(number));
        descriptor             = ::open(name.c_str(),
                            O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC,
                            0666);
        if (descriptor >= 0)
          file = std::make_unique<AppendFile>(name, descriptor);
        else if (errno != EEXIST && errno != EINTR)
          throw_journal_full(name, errno);
      }

    try
      {
        write_line(journal_header_line(campaign_hash));
      }
    catch (...)
      {
        ::unlink(path().c_str());
        throw;
      }
  }



  JournalWriter::~JournalWriter()
  {
    if (sync_interval >= 0.)
      file->sync();
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
        if (!file->sync())
          throw_journal_full(path(), errno);
        last_sync = now;
      }
  }



  const std::string &
  JournalWriter::path() const
  {
    return file->path();
  }



  void
  JournalWriter::write_line(const std::string &line)
  {
    if (!file->write(line + "\n"))
      throw_journal_full(path(), errno);
  }
} // namespace Waker
