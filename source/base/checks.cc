// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/checks.h>
#include <waker/base/errors.h>

#include <sstream>

namespace Waker
{
  void
  require_positive(const std::string &path,
                   const double       value,
                   const std::string &unit)
  {
    if (value > 0.)
      return;
    std::ostringstream problem;
    problem << "is " << value << (unit.empty() ? "" : " ") << unit;
    throw UserError(path, problem.str(), "a number above 0");
  }
} // namespace Waker
