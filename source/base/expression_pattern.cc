// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/expression_pattern.h>
#include <waker/base/text.h>

#include <charconv>
#include <cmath>

namespace Waker
{
  namespace
  {
    const char *const name = "[Expression]";
  }


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


  std::optional<double>
  plain_number(const std::string &text)
  {
    const std::string trimmed = tidy(text);
    const char *const end     = trimmed.data() + trimmed.size();
    const char *const begin =
      trimmed.data() + (trimmed.size() > 1 && trimmed[0] == '+' ? 1 : 0);
    double     number = 0.;
    const auto result = std::from_chars(begin, end, number);
    if (result.ec == std::errc() && result.ptr == end && std::isfinite(number))
      return number;
    return {};
  }
} // namespace Waker
