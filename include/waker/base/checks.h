// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_checks_h
#define waker_base_checks_h

#include <string>

namespace Waker
{
  /**
   * For parameters that deal.II's Patterns::Double(0) admits, but not if they
   * are 0.
   *
   * @param path of the parameter, "Section/Name"
   * @param unit of the value, for the message; may be empty
   * @throws UserError unless value > 0
   */
  void
  require_positive(const std::string &path,
                   const double       value,
                   const std::string &unit = "");

  /**
   * For parameters of which much less or much more is a slip, and beyond what
   * can be computed with.
   *
   * @throws UserError unless least <= value <= most
   */
  void
  require_between(const std::string &path,
                  const double       value,
                  const double       least,
                  const double       most,
                  const std::string &unit = "");
} // namespace Waker

#endif
