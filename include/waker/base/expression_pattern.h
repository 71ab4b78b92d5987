// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_expression_pattern_h
#define waker_base_expression_pattern_h

#include <deal.II/base/patterns.h>

#include <memory>
#include <optional>
#include <string>

namespace Waker
{
  /// For parameters that are a number or an expression. Any text fits: what is
  /// wrong with an expression is seen where it is read.
  class ExpressionPattern : public dealii::Patterns::PatternBase
  {
  public:
    bool
    match(const std::string &text) const override;

    std::string
    description(const OutputStyle style = Machine) const override;

    std::unique_ptr<PatternBase>
    clone() const override;

    /// Is it the description of this pattern?
    static bool
    is_description(const std::string &text);
  };


  /// The number that the whole text is; none if it is an expression.
  std::optional<double>
  plain_number(const std::string &text);
} // namespace Waker

#endif
