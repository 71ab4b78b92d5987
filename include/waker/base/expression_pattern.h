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


  /// For parameters that are a number or one word.
  class NumberOrWordPattern : public dealii::Patterns::PatternBase
  {
  public:
    explicit NumberOrWordPattern(const std::string &word);

    /// As read_number(), with blanks around it.
    bool
    match(const std::string &text) const override;

    std::string
    description(const OutputStyle style = Machine) const override;

    std::unique_ptr<PatternBase>
    clone() const override;

    /// The word of the pattern with this description, if it is one of these.
    static std::optional<std::string>
    word_of(const std::string &description);

  private:
    std::string word;
  };


  /// The finite number that the whole text is, but for blanks around it; none
  /// if it is an expression, or a word.
  std::optional<double>
  plain_number(const std::string &text);
} // namespace Waker

#endif
