// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_materials_factory_h
#define waker_materials_factory_h

#include <waker/materials/material.h>
#include <waker/materials/modified_cam_clay.h>
#include <waker/materials/mohr_coulomb.h>
#include <waker/materials/von_mises_softening.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

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
    von_mises_softening,
    mohr_coulomb,
    modified_cam_clay
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
        case MaterialModel::mohr_coulomb:
          return "Mohr-Coulomb";
        case MaterialModel::modified_cam_clay:
          return "modified Cam clay";
      }
    return nullptr;
  }


  /// Of nonlocal softening: in "Materials/<name>".
  struct NonlocalParameters
  {
    double          length      = 0.; // l, m
    double          over_weight = 2.; // n, -
    NeighbourWeight weight      = NeighbourWeight::galavi_schweiger;

    void
    add_parameters(ParameterHandler &prm);

    /// Whatever the regularisation.
    /// @param path "Materials/<name>/"
    /// @throws UserError path + ...
    void
    check(const std::string &path) const;

    /// If it is nonlocal.
    /// @param spacing of the points at the start (m)
    /// @param longest side of the grid (m)
    void
    check_used(const std::string &path,
               const double       spacing,
               const double       longest) const;
  };


  /// A material as the user writes it: subsection "Materials/<name>".
  struct MaterialParameters
  {
    std::string name; // of the subsection

    MaterialModel model       = MaterialModel::von_mises_softening;
    double        unit_weight = 15.; // kN/m^3
    /// Of the soil that lies below the phreatic line at t = 0; 0: the same.
    double saturated_unit_weight = 0.; // kN/m^3

    /// Name of the material that it is below the phreatic line at t = 0; empty:
    /// itself.
    std::string below_line;

    /// K_f (kPa) of the water in the pores of soil that does not drain; 0: it
    /// drains. See UndrainedSoil.
    double pore_fluid_stiffness = 0.;

    /// Horizontal over vertical effective stress at rest: a number, an
    /// expression of the place, or "elastic" or "Jaky".
    std::string k0 = "elastic";

    Regularisation regularisation = Regularisation::softening_length;

    /// l_s (m): width of the band that the softening belongs to; 0: a cell,
    /// whatever its size.
    double             softening_length = 0.;
    NonlocalParameters nonlocal;

    // Of the laws, those of others unread.
    LinearElasticParameters     elastic;
    VonMisesSofteningParameters von_mises;
    MohrCoulombParameters       mohr_coulomb; // its friction angle for both
    ModifiedCamClayParameters   cam_clay;

    /// The undrained shear strength as an expression of the place; nothing if
    /// the law has none.
    std::optional<std::string>
    undrained_strength() const;

    /// Does its strength follow from the stress in the ground at the start?
    bool
    strength_follows_stress() const;

    /// K0 as an expression of the place and of the law's variables.
    /// @throws UserError "Materials/<name>/K0": Jaky's without friction
    std::string
    k0_expression() const;

    /// Is its law one of effective stress (Material::is_of_effective_stress())?
    bool
    is_drained() const;

    /// Are its moduli those of Young's modulus and Poisson's ratio, whatever
    /// the pressure?
    bool
    has_constant_stiffness() const;

    /// Poisson's ratio (-) of the soil with its water in it, if it stays.
    double
    undrained_poissons_ratio() const;

    /// Does its strength grow with pressure?
    bool
    has_friction() const;

    void
    add_parameters(ParameterHandler &prm);

    /// The strain that softens it. A band of slip is some cells wide, so its
    /// plastic strain per displacement goes with 1/h: with a softening length
    /// it is multiplied by h / l_s, with an averaging length bands are wider.
    SofteningMeasure
    softening_measure(const double cell_size) const;

    /// Does it soften?
    bool
    softens() const;

    /// @throws UserError "Materials/<name>/..."
    void
    check(const unsigned int dim, const double cell_size) const;
  };

  /// The number of the material that one is below the phreatic line at t = 0.
  unsigned int
  material_below_line(const std::vector<MaterialParameters> &materials,
                      const unsigned int                     number);

  /// Its weight there (kN/m^3), with its water.
  double
  unit_weight_below_line(const std::vector<MaterialParameters> &materials,
                         const unsigned int                     number);

  /// @param gravity acceleration (m/s^2) that turns unit weight into density
  /// @param cell_size h (m), of the softening length
  std::unique_ptr<Material>
  make_material(const MaterialParameters &parameters,
                const double              gravity,
                const double              cell_size);
} // namespace Waker

#endif
