// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_materials_shear_strength_table_h
#define waker_materials_shear_strength_table_h

#include <waker/materials/linear_elastic.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace Waker
{
  /**
   * Drained soil whose shear strength is a table of the effective normal stress
   * on the plane of slip, tau(sigma'): the circles of Mohr stay below an
   * envelope of straight lines whose slopes fall. Each line is Mohr-Coulomb's
   * surface with a cohesion and a friction angle of its own, and all of them
   * hold: so the law is exact, on faces, on the edges between two lines, and at
   * the apex. Beyond its last entry the envelope goes on with its last slope.
   *
   * The dilatancy angle is that of the law, but never above the friction angle
   * of the line; the tension cut-off as of MohrCoulomb. No softening.
   */
  class ShearStrengthTable final : public LinearElastic
  {
  public:
    /// Normal stress (kPa, compression positive) and shear strength (kPa).
    using Entry = std::pair<double, double>;

    /// A straight line of the envelope.
    struct Line
    {
      double cohesion; // kPa
      double tan_phi;
    };

    /// @param lines of falling slope, tan_phi >= 0
    /// @param dilatancy_angle degrees
    /// @param tensile_strength kPa; may be infinite
    ShearStrengthTable(const double             density,
                       const double             youngs_modulus,
                       const double             poissons_ratio,
                       const std::vector<Line> &lines,
                       const double             dilatancy_angle,
                       const double             tensile_strength);

    /// "strength factor" (-), at first 1, by which all strengths of the table
    /// are multiplied at the point; "plastic strain" (-).
    std::vector<MaterialVariable>
    variables() const override;

    std::optional<std::pair<unsigned int, std::string>>
    initial_problem(const std::vector<double> &variables) const override;

    double
    update(const SymmetricTensor<2, 3> &strain_increment,
           SymmetricTensor<2, 3>       &stress,
           double                      *variables,
           SymmetricTensor<4, 3>       *tangent) const override;

    bool
    is_of_effective_stress() const override
    {
      return true;
    }

    bool
    has_symmetric_tangent() const override
    {
      return false;
    }

    static constexpr unsigned int most_entries = 10;

  private:
    unsigned int
    n_own_variables() const override
    {
      return 2;
    }

    std::vector<Line> lines;
    double            sin_psi;
    double            tensile_strength;
  };


  /// The entries of "stress: strength, ..." (kPa): stresses ascending from 0,
  /// slopes from 0 on, and never steeper than the one before.
  /// @param path of the parameter
  /// @throws UserError path
  std::vector<ShearStrengthTable::Entry>
  shear_strength_entries(const std::string &text, const std::string &path);

  /// The lines through them.
  std::vector<ShearStrengthTable::Line>
  lines_through(const std::vector<ShearStrengthTable::Entry> &entries);
} // namespace Waker

#endif
