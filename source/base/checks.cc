// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/checks.h>
#include <waker/base/errors.h>
#include <waker/base/numbers.h>

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


  void
  require_between(const std::string &path,
                  const double       value,
                  const double       least,
                  const double       most,
                  const std::string &unit)
  {
    const std::string of_unit = unit.empty() ? "" : " " + unit;
    if (!(value >= least && value <= most))
      throw UserError(path,
                      "is " + in_digits(value) + of_unit,
                      "from " + in_digits(least) + " to " + in_digits(most) +
                        of_unit);
  }
} // namespace Waker
