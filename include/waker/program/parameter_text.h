// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_program_parameter_text_h
#define waker_program_parameter_text_h

#include <waker/program/declared_parameters.h>

#include <string>
#include <vector>

namespace Waker
{
  /**
   * The .prm of all values: what is copied to the output folder, and runs again
   * from any folder. So input files have their absolute paths there.
   *
   * Comments at its end hold the hashes of the files' contents.
   *
   * @param prm gets its values back as they were
   * @param values of `prm` now
   */
  std::string
  text_of_parameters(ParameterHandler                     &prm,
                     const std::vector<DeclaredParameter> &values);
} // namespace Waker

#endif
