// SPDX-License-Identifier: LGPL-2.1-or-later
#include "long_step_checks.h"

#include <waker/base/errors.h>
#include <waker/base/text.h>
#include <waker/mechanics/time_scheme.h>

#include <string>

namespace Waker
{
  void
  check_long_steps(const Parameters &p)
  {
    if (!scheme_traits(p.time).has_long_steps)
      return;
    const auto refuse = [&](const std::string &path,
                            const std::string &problem,
                            const std::string &allowed = "none") {
      throw UserError(
        path,
        problem + ", with Time stepping/Scheme = " + name_of(p.time.scheme),
        allowed + ", or Time stepping/Scheme = " + name_of(Scheme::newmark));
    };
    if (!p.load_programmes.empty())
      refuse("Load programmes/Names",
             "has " + in_quotes(p.load_programmes.front().name) +
               ", which watches the dyke from short step to short step");
    for (const MaterialParameters &m : p.materials)
      if (m.softens() && m.regularisation == Regularisation::nonlocal)
        refuse("Materials/" + m.name + "/Regularisation",
               "is nonlocal, which softens soil after a step, when a long one "
               "is taken to be in balance",
               "a softening of each point (with Softening length)");
    if (!p.inflows.empty())
      refuse("Inflow/Names",
             "has " + in_quotes(p.inflows.front().name) +
               ", soil that never rests");
    if (!p.outlets.empty())
      refuse("Outflow/Names",
             "has " + in_quotes(p.outlets.front().name) +
               ", and long steps have no balance of momentum");
    if (!tidy(p.outflow.faces).empty())
      refuse("Outflow/Faces",
             "is " + in_quotes(p.outflow.faces) +
               ", and long steps have no balance of momentum");
  }
} // namespace Waker
