// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_named_expression_h
#define waker_base_named_expression_h

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace dealii
{
  template <int dim>
  class FunctionParser;
}

namespace Waker
{
  /**
   * A function of named variables that the user writes, with pi and the
   * functions of muParser. At most four of the variables may occur in it:
   * deal.II's parser has no room for more. Not for several threads at a time.
   */
  class NamedExpression
  {
  public:
    /// @param path of the parameter, for the error
    /// @param variables names, in the order of value()
    /// @param or_else what else the parameter takes, for the error
    /// @throws UserError if the text is no expression of them
    NamedExpression(const std::string              &text,
                    const std::string              &path,
                    const std::vector<std::string> &variables,
                    const std::string              &or_else = "");

    ~NamedExpression();
    NamedExpression(NamedExpression &&);

    /// @param values one per variable; those that do not occur are not read
    double
    value(const double *values) const;

    const std::string &
    text() const
    {
      return expression;
    }

    /// Does the variable of this number occur?
    bool
    uses(const unsigned int variable) const;

  private:
    static constexpr unsigned int n_slots = 4;

    std::string expression;
    /// Of each slot of the parser: the variable in it, or -1.
    std::array<int, n_slots>                   slots;
    std::unique_ptr<dealii::FunctionParser<3>> parser;
  };
} // namespace Waker

#endif
