// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_program_parameter_hash_h
#define waker_program_parameter_hash_h

#include <waker/output/free_at_resume.h>
#include <waker/program/declared_parameters.h>

#include <string>
#include <vector>

namespace Waker
{
  /// Do the contents of files that parameters name count in a hash? They need
  /// not be there where nothing is computed.
  enum class FileContents
  {
    count,
    left_out
  };

  /**
   * Hash of all that decides how the state of a realisation goes on from one
   * step to the next: how it is watched and when it stops may change when a run
   * is resumed. Of input files the contents count, not the names.
   *
   * @throws UserError with the path of a parameter that names a file which
   * cannot be read: its contents count
   */
  std::string
  hash_of_steps(const std::vector<DeclaredParameter> &parameters,
                const FileContents contents = FileContents::count);

  /// Hash of all that decides the records of a campaign: also stop rules, end
  /// time and seed.
  std::string
  hash_of_records(const std::vector<DeclaredParameter> &parameters,
                  const FileContents contents = FileContents::count);
} // namespace Waker

#endif
