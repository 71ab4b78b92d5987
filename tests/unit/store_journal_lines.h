// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_store_journal_lines_h
#define waker_tests_store_journal_lines_h

#include <waker/store/record_json.h>

#include "output_temporary_folder.h"
#include "store_records.h"

namespace Waker::JournalLines
{
  const std::string hash = "0123abcd";


  /// Without a checksum, as earlier versions wrote it.
  inline std::string
  plain_line(const std::uint64_t i)
  {
    return to_json(synthetic_record(0, i)) + "\n";
  }


  /// Each journal of the folder: a name, "journal-00000.jsonl" is 0.
  inline std::string
  journal(const TemporaryFolder &folder, const unsigned int number = 0)
  {
    return folder.file("journal-0000" + std::to_string(number) + ".jsonl");
  }
} // namespace Waker::JournalLines

#endif
