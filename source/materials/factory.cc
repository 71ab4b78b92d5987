// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/factory.h>

namespace Waker
{
  std::unique_ptr<Material>
  make_material(const MaterialParameters &p, const double gravity)
  {
    const double density = p.unit_weight / gravity;
    switch (p.model)
      {
        case MaterialModel::linear_elastic:
          return std::make_unique<LinearElastic>(density,
                                                 p.elastic.youngs_modulus,
                                                 p.elastic.poissons_ratio);
        case MaterialModel::von_mises_softening:
          return make_von_mises_softening(density,
                                          p.elastic,
                                          p.von_mises,
                                          "Materials/" + p.name + "/");
      }
    AssertThrow(false, ExcInternalError());
    return nullptr;
  }
} // namespace Waker
