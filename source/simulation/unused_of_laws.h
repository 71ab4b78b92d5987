// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_simulation_unused_of_laws_h
#define waker_source_simulation_unused_of_laws_h

#include <waker/materials/factory.h>

#include <string>
#include <vector>

namespace Waker
{
  /// Append what is set of a material, but is of no effect with its law, or
  /// with what has been chosen of it.
  void
  warn_of_unused_of_law(const MaterialParameters &material,
                        std::vector<std::string> &warnings);
} // namespace Waker

#endif
