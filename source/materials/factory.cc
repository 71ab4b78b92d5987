// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/materials/factory.h>
#include <waker/materials/von_mises_softening.h>

namespace Waker
{
  std::unique_ptr<Material>
  make_material(const MaterialParameters &p, const double gravity)
  {
    const double density = p.unit_weight / gravity;
    if (p.model == "linear elastic")
      return std::make_unique<LinearElastic>(density,
                                             p.youngs_modulus,
                                             p.poissons_ratio);
    if (p.model == "von Mises softening")
      return std::make_unique<VonMisesSoftening>(
        density,
        p.youngs_modulus,
        p.poissons_ratio,
        p.initial_strength,
        p.residual_strength,
        p.softening_modulus,
        p.plastic_strain_invariant == "half"
          ? VonMisesSoftening::Invariant::half
          : VonMisesSoftening::Invariant::equivalent);
    throw UserError("Materials/" + p.name + "/Model",
                    "is \"" + p.model + "\"",
                    "\"linear elastic\" or \"von Mises softening\"");
  }
} // namespace Waker
