// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/expression_pattern.h>
#include <waker/materials/factory.h>

namespace Waker
{
  namespace
  {
    InitialValue
    initial_value(const std::string &text, const std::string &path)
    {
      const std::optional<double> number = plain_number(text);
      return number ? InitialValue(*number, path) : InitialValue(text, path);
    }
  } // namespace


  std::unique_ptr<Material>
  make_material(const MaterialParameters &p, const double gravity)
  {
    const double density = p.unit_weight / gravity;
    switch (p.model)
      {
        case MaterialModel::linear_elastic:
          return std::make_unique<LinearElastic>(density,
                                                 p.youngs_modulus,
                                                 p.poissons_ratio);
        case MaterialModel::von_mises_softening:
          return std::make_unique<VonMisesSoftening>(
            density,
            p.youngs_modulus,
            p.poissons_ratio,
            initial_value(p.initial_strength,
                          "Materials/" + p.name + "/Initial strength"),
            initial_value(p.residual_strength,
                          "Materials/" + p.name + "/Residual strength"),
            p.softening_modulus,
            p.plastic_strain_invariant);
      }
    AssertThrow(false, ExcInternalError());
    return nullptr;
  }
} // namespace Waker
