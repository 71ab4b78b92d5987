// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_materials_factory_h
#define waker_materials_factory_h

#include <waker/materials/material.h>
#include <waker/materials/von_mises_softening.h>

#include <memory>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  /// The laws.
  enum class MaterialModel
  {
    linear_elastic,
    von_mises_softening
  };

  constexpr const char *
  name_of(const MaterialModel choice)
  {
    switch (choice)
      {
        case MaterialModel::linear_elastic:
          return "linear elastic";
        case MaterialModel::von_mises_softening:
          return "von Mises softening";
      }
    return nullptr;
  }


  /// A material as the user writes it: subsection "Materials/<name>".
  struct MaterialParameters
  {
    std::string name; // of the subsection

    MaterialModel model       = MaterialModel::von_mises_softening;
    double        unit_weight = 15.; // kN/m^3

    // Of the laws, those of others unread.
    LinearElasticParameters     elastic;
    VonMisesSofteningParameters von_mises;

    /// The strength as the user writes it; null if the law has none.
    const std::string *
    strength() const;

    void
    add_parameters(ParameterHandler &prm);

    /// @throws UserError "Materials/<name>/..."
    void
    check(const unsigned int dim) const;
  };

  /// @param gravity acceleration (m/s^2) that turns unit weight into density
  std::unique_ptr<Material>
  make_material(const MaterialParameters &parameters, const double gravity);
} // namespace Waker

#endif
