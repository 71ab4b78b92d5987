// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_materials_undrained_strength_h
#define waker_materials_undrained_strength_h

#include <string>
#include <utility>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  /// What the undrained shear strength of a soil follows from.
  enum class StrengthFrom
  {
    place,   // as the user writes it
    shansep, // vertical stress, now and on a usual day
    table    // vertical stress now
  };

  constexpr const char *
  name_of(const StrengthFrom choice)
  {
    switch (choice)
      {
        case StrengthFrom::place:
          return "initial strength";
        case StrengthFrom::shansep:
          return "SHANSEP";
        case StrengthFrom::table:
          return "table";
      }
    return nullptr;
  }


  /**
   * Undrained shear strength s_u from effective vertical stress sigma'_v, in
   * "Materials/<name>". SHANSEP (Ladd & Foott 1974):
   *   s_u = S sigma'_v OCR^m,
   *   OCR = (sigma'_v,daily + POP) / sigma'_v;
   * or a table of s_u by sigma'_v, with straight lines between its entries and
   * constant beyond them.
   */
  struct UndrainedStrengthParameters
  {
    StrengthFrom from     = StrengthFrom::place;
    double       ratio    = 0.;  // S, of normally consolidated soil (-)
    double       exponent = 0.9; // m (-)
    /// How far the yield stress is above the daily stress (kPa).
    double      pop = 0.;
    std::string table; // "stress: strength, ..." (kPa)

    void
    add_parameters(dealii::ParameterHandler &prm);

    /// @param path "Materials/<name>/"
    /// @throws UserError path + ...
    void
    check(const std::string &path) const;

    /// The strength as an expression of the place.
    /// @param own as the user writes it
    /// @throws UserError path + "Strength table"
    std::string
    expression(const std::string &own, const std::string &path) const;

    /// The parameter that the strength comes from.
    std::string
    name_of_parameter() const;

    /// OCR as an expression of the place; empty: it plays no part.
    std::string
    overconsolidation() const;

    /// Parameters that are there, and have no part in the strength.
    std::vector<std::string>
    unused() const;

  private:
    /// Stress and strength (kPa), ascending in stress.
    std::vector<std::pair<double, double>>
    entries(const std::string &path) const;
  };
} // namespace Waker

#endif
