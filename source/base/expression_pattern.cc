// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/expression_pattern.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>

namespace Waker
{
  namespace
  {
    const char *const name       = "[Expression]";
    const std::string number_or_ = "[Number or ";
  } // namespace


  bool
  ExpressionPattern::match(const std::string &) const
  {
    return true;
  }


  std::string
  ExpressionPattern::description(const OutputStyle) const
  {
    return name;
  }


  std::unique_ptr<dealii::Patterns::PatternBase>
  ExpressionPattern::clone() const
  {
    return std::make_unique<ExpressionPattern>();
  }


  bool
  ExpressionPattern::is_description(const std::string &text)
  {
    return text == name;
  }


  NumberOrWordPattern::NumberOrWordPattern(const std::string &word)
    : word(word)
  {}


  bool
  NumberOrWordPattern::match(const std::string &text) const
  {
    return tidy(text) == word || plain_number(text);
  }


  std::string
  NumberOrWordPattern::description(const OutputStyle) const
  {
    return number_or_ + word + "]";
  }


  std::unique_ptr<dealii::Patterns::PatternBase>
  NumberOrWordPattern::clone() const
  {
    return std::make_unique<NumberOrWordPattern>(word);
  }


  std::optional<std::string>
  NumberOrWordPattern::word_of(const std::string &description)
  {
    if (description.rfind(number_or_, 0) != 0)
      return {};
    return description.substr(number_or_.size(),
                              description.size() - number_or_.size() - 1);
  }


  std::optional<double>
  plain_number(const std::string &text)
  {
    double number = 0.;
    if (read_number(tidy(text), number))
      return number;
    return {};
  }
} // namespace Waker
