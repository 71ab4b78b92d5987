// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_program_section_folder_h
#define waker_source_program_section_folder_h

#include <waker/program/prm_scanner.h>

namespace Waker
{
  /// A section that the command line asks for, of a file that names a folder
  /// for its case, gets a folder beside it: --overwrite would remove the
  /// results in space.
  void
  name_folder_of_section(PrmContents &contents);
} // namespace Waker

#endif
