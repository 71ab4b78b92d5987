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

    MaterialModel model          = MaterialModel::von_mises_softening;
    double        unit_weight    = 15.;   // kN/m^3
    double        youngs_modulus = 1000.; // kPa
    double        poissons_ratio = 0.45;  // -
    /// c_i (kPa): a number, or an expression of the place.
    std::string initial_strength = "13";
    /// c_r (kPa), likewise; it may contain "initial_strength".
    std::string residual_strength = "5";
    double      softening_modulus = -50.; // H_s = dc / d(plastic strain), kPa
    /// Which invariant softens (the thesis does not print it).
    VonMisesSoftening::Invariant plastic_strain_invariant =
      VonMisesSoftening::Invariant::equivalent;

    void
    add_parameters(ParameterHandler &prm);

    /// @throws UserError "Materials/<name>/..."
    void
    check(const unsigned int dim = 3) const;
  };

  /// @param gravity acceleration (m/s^2) that turns unit weight into density
  std::unique_ptr<Material>
  make_material(const MaterialParameters &parameters, const double gravity);
} // namespace Waker

#endif
