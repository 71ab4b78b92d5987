// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/function_parser.h>
#include <deal.II/base/numbers.h>

#include <waker/base/errors.h>
#include <waker/base/expression.h>

#include <cctype>
#include <iostream>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// Does an expression contain this variable?
    bool
    uses(const std::string &expression, const std::string &variable)
    {
      const auto in_name = [](const char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
      };
      std::size_t begin = 0;
      while (begin < expression.size())
        {
          std::size_t end = begin;
          while (end < expression.size() && in_name(expression[end]))
            ++end;
          if (expression.compare(begin, end - begin, variable) == 0)
            return true;
          begin = end + (end == begin);
        }
      return false;
    }
  } // namespace


  template <int dim>
  Expression<dim>::Expression(const std::string &text,
                              const std::string &path,
                              const std::string &or_else)
    : expression(text)
    , parser(std::make_unique<FunctionParser<dim>>(1))
    , moving(uses(text, "t"))
    , uniform(!uses(text, "x") && !uses(text, "y") && !uses(text, "z"))
  {
    const std::string variables =
      FunctionParser<dim>::default_variable_names() + ",t";
    parser->initialize(variables, text, {{"pi", numbers::PI}}, true);
    // The parser reads its text when it is first asked for a value. deal.II
    // then also prints what is wrong: the error must say it, and only once.
    std::ostringstream    printed;
    std::streambuf *const screen = std::cerr.rdbuf(printed.rdbuf());
    std::string           reason;
    try
      {
        value(Point<dim>(), 0.);
      }
    catch (const ExceptionBase &e)
      {
        std::ostringstream message;
        e.print_info(message);
        // Its column is really the number of the error.
        const std::string intro = "The parser said: ";
        reason                  = message.str();
        if (reason.find(intro) != std::string::npos)
          reason.erase(0, reason.find(intro) + intro.size());
        reason.erase(reason.find_last_not_of(" \n") + 1);
      }
    catch (const std::exception &e)
      {
        reason = e.what();
      }
    std::cerr.rdbuf(screen);
    if (!reason.empty())
      throw UserError(path,
                      "\"" + text + "\" cannot be read (" + reason + ")",
                      "expressions of " + variables + or_else);
  }


  template <int dim>
  Expression<dim>::~Expression() = default;


  template <int dim>
  Expression<dim>::Expression(Expression &&) = default;


  template <int dim>
  double
  Expression<dim>::value(const Point<dim> &x, const double t) const
  {
    parser->set_time(t);
    return parser->value(x);
  }


  template <int dim>
  bool
  Expression<dim>::varies(const Point<dim> &x,
                          const double      from,
                          const double      to) const
  {
    return moving &&
           Waker::varies([&](const double t) { return value(x, t); }, from, to);
  }


  template class Expression<2>;
  template class Expression<3>;
} // namespace Waker
