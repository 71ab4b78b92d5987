// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/function_parser.h>
#include <deal.II/base/numbers.h>

#include <waker/base/errors.h>
#include <waker/base/expression_scan.h>
#include <waker/base/named_expression.h>
#include <waker/base/text.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <sstream>

namespace Waker
{
  using namespace dealii;

  namespace
  {
    /// muParser's error, whose number deal.II gives as a column, in our words.
    std::string
    in_words(const std::string &message)
    {
      const std::string intro = "Column ";
      const std::size_t at    = message.find(intro);
      const int         code =
        at == std::string::npos ? -1 : std::atoi(&message[at + intro.size()]);
      switch (code)
        {
          case 0: // unexpected operator
          case 3: // unexpected comma
            return "a value is missing before an operator or a comma";
          case 2: // unexpected end
            return "it ends too early";
          case 4:
          case 5:
          case 6:
          case 12: // unexpected argument, number, variable, function
            return "there is no operator between two values";
          case 7:
          case 11: // unexpected or missing parenthesis
            return "a parenthesis is out of place";
          case 14:
            return "a function has too many arguments";
          case 15:
            return "a function has too few arguments";
          case 32:
          case 33:
          case 34: // of "a ? b : c"
            return "\"?\" and \":\" do not match";
          default:
            return "it is no formula";
        }
    }


    std::string
    joined(const std::vector<std::string> &names)
    {
      std::string text;
      for (const std::string &name : names)
        text += (text.empty() ? "" : ", ") + name;
      return text;
    }
  } // namespace


  NamedExpression::NamedExpression(const std::string              &text,
                                   const std::string              &path,
                                   const std::vector<std::string> &variables,
                                   const std::string              &or_else)
    : expression(text)
    , parser(std::make_unique<FunctionParser<3>>(1))
  {
    const auto refuse = [&](const std::string &problem,
                            const std::string &advice = "") {
      throw UserError(path,
                      in_quotes(text) + " cannot be read (" + problem + ")",
                      "expressions of " + joined(variables) + or_else +
                        (advice.empty() ? "" : "; " + advice));
    };
    const ExpressionScan scan = scan_expression(text, variables);
    if (!scan.problem.empty())
      refuse(scan.problem, scan.advice);

    slots.fill(-1);
    unsigned int n_used = 0;
    for (unsigned int v = 0; v < variables.size(); ++v)
      if (scan.names.count(variables[v]) != 0)
        {
          if (n_used < n_slots)
            slots[n_used] = v;
          ++n_used;
        }
    if (n_used > n_slots)
      throw UserError(path,
                      in_quotes(text) + " has " + std::to_string(n_used) +
                        " variables in it",
                      "expressions of at most four of " + joined(variables) +
                        or_else);
    // The slots that are left over need names that nobody can mean: what is
    // no variable has been refused.
    std::vector<std::string> names;
    for (unsigned int s = 0; s < n_slots; ++s)
      names.push_back(slots[s] >= 0 ? variables[slots[s]]
                                    : "unused" + std::to_string(s));

    // deal.II also prints what is wrong: the error must say it, and only once.
    std::ostringstream    printed;
    std::streambuf *const screen = std::cerr.rdbuf(printed.rdbuf());
    std::string           reason;
    double                start = 0.;
    try
      {
        parser->initialize(joined(names), text, {{"pi", numbers::PI}}, true);
        // The parser reads its text when it is first asked for a value.
        start = value(std::vector<double>(variables.size()).data());
      }
    catch (const ExceptionBase &error)
      {
        std::ostringstream message;
        error.print_info(message);
        reason = in_words(message.str());
      }
    catch (...) // muParser's own errors are no std::exception
      {
        reason = in_words("");
      }
    std::cerr.rdbuf(screen);
    if (!reason.empty())
      refuse(reason);
    if (n_used == 0 && !std::isfinite(start))
      throw UserError(path,
                      in_quotes(text) + " is " +
                        (std::isnan(start) ? "not a number"
                                           : std::to_string(start)),
                      "finite numbers");
  }


  NamedExpression::~NamedExpression() = default;


  NamedExpression::NamedExpression(NamedExpression &&) = default;


  double
  NamedExpression::value(const double *values) const
  {
    const auto in_slot = [&](const unsigned int s) {
      return slots[s] >= 0 ? values[slots[s]] : 0.;
    };
    parser->set_time(in_slot(3));
    return parser->value(Point<3>(in_slot(0), in_slot(1), in_slot(2)));
  }


  bool
  NamedExpression::uses(const unsigned int variable) const
  {
    return std::find(slots.begin(), slots.end(), static_cast<int>(variable)) !=
           slots.end();
  }
} // namespace Waker
