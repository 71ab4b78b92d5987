// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_materials_undrained_strength_h
#define waker_materials_undrained_strength_h

#include <waker/materials/material.h>

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
    table,   // vertical stress now
    depth,   // below the surface
    depth_in_layer
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
        case StrengthFrom::depth:
          return "depth";
        case StrengthFrom::depth_in_layer:
          return "depth in layer";
      }
    return nullptr;
  }


  /**
   * Undrained shear strength s_u from effective vertical stress sigma'_v, in
   * "Materials/<name>". SHANSEP (Ladd & Foott 1974):
   *   s_u = S sigma'_v OCR^m,
   *   OCR = (sigma'_v,daily + POP) / sigma'_v;
   * or a table of s_u by sigma'_v, with straight lines between its entries and
   * constant beyond them; or from the depth z below the surface or the layer's
   * top:
   *   s_u = s_u,top + k z.
   */
  struct UndrainedStrengthParameters
  {
    StrengthFrom from     = StrengthFrom::place;
    double       ratio    = 0.;  // S, of normally consolidated soil (-)
    double       exponent = 0.9; // m (-)
    /// How far the yield stress is above the daily stress (kPa).
    double      pop = 0.;
    std::string table;        // "stress: strength, ..." (kPa)
    double      at_top = 10.; // s_u,top (kPa)
    double      growth = 0.;  // k (kPa/m)

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

    /// The same, of the place and the symbols of the coefficients.
    std::string
    symbolic_expression(const std::string &own, const std::string &path) const;

    /// What the law can tell a random field to vary.
    /// @param path "Materials/<name>/"
    std::vector<MaterialVariable>
    coefficients(const std::string &path) const;

    /// The parameter that the strength comes from.
    std::string
    name_of_parameter() const;

    /// OCR as an expression of the place; empty: it plays no part.
    /// @param symbolic of the place and the symbols of the coefficients
    std::string
    overconsolidation(const bool symbolic = false) const;

    /// Of the table: stress and strength (kPa), ascending in stress.
    /// @param path "Materials/<name>/"
    /// @throws UserError path + "Strength table"
    std::vector<std::pair<double, double>>
    entries(const std::string &path) const;

    /// Parameters that are there, and have no part in the strength.
    std::vector<std::string>
    unused() const;

  private:
    /// The coefficients, as numbers or symbols.
    struct Written
    {
      std::string ratio, rest, exponent, yield, at_top, growth; // rest: 1 - m
    };

    Written
    written(const bool symbolic) const;

    std::string
    expression(const std::string &own,
               const std::string &path,
               const Written     &coefficients) const;
  };
} // namespace Waker

#endif
