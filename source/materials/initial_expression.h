// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_materials_initial_expression_h
#define waker_source_materials_initial_expression_h

#include <waker/base/expression_pattern.h>
#include <waker/materials/material.h>
#include <waker/particles/place_expression.h>

#include <optional>
#include <string>
#include <vector>

namespace Waker
{
  /// A look at an expression before there is a place to evaluate it at.
  /// @throws UserError path
  inline void
  check_expression(const std::string              &path,
                   const std::string              &text,
                   const std::vector<std::string> &more,
                   const unsigned int              dim)
  {
    if (plain_number(text))
      return;
    if (dim == 2)
      PlaceExpression<2>(text, path, more, ", or a number");
    else
      PlaceExpression<3>(text, path, more, ", or a number");
  }


  /// What the user wrote, as a variable's start.
  inline InitialValue
  initial_value(const std::string &text, const std::string &path)
  {
    const std::optional<double> number = plain_number(text);
    return number ? InitialValue(*number, path) : InitialValue(text, path);
  }
} // namespace Waker

#endif
