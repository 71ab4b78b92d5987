// SPDX-License-Identifier: LGPL-2.1-or-later
#include "stiffness_checks.h"

#include <waker/base/errors.h>
#include <waker/mechanics/time_scheme.h>

namespace Waker
{
  void
  check_stiffness(const Parameters &p)
  {
    for (const MaterialParameters &m : p.materials)
      {
        if (m.has_constant_stiffness())
          continue;
        const std::string path = "Materials/" + m.name + "/Model";
        const std::string law  = std::string("is ") + name_of(m.model) +
                                ", whose stiffness grows with the pressure";
        // The strain of the start would not be that of its moduli.
        if (p.mapping.strain == StrainMeasure::logarithmic)
          throw UserError(path,
                          law + ", with logarithmic strain",
                          "another law, or Kinematics and mapping/Strain = "
                          "step");
        // No step is short enough for any pressure.
        if (!scheme_traits(p.time).is_implicit)
          throw UserError(path,
                          law + ", with Time stepping/Scheme = " +
                            name_of(p.time.scheme) +
                            ", whose step follows from a constant one",
                          "another law, or an implicit scheme");
      }
  }
} // namespace Waker
