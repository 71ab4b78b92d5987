// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/function_parser.h>
#include <deal.II/base/numbers.h>

#include <waker/base/errors.h>
#include <waker/base/named_expression.h>

#include <algorithm>
#include <cctype>
#include <iostream>
#include <sstream>

namespace Waker
{
  using namespace dealii;

  namespace
  {
    /// Does an expression contain this variable?
    bool
    contains(const std::string &expression, const std::string &variable)
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


    std::string
    joined(const std::vector<std::string> &names)
    {
      std::string text;
      for (const std::string &name : names)
        text += (text.empty() ? "" : ",") + name;
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
    slots.fill(-1);
    unsigned int n_used = 0;
    for (unsigned int v = 0; v < variables.size(); ++v)
      if (contains(text, variables[v]))
        {
          if (n_used < n_slots)
            slots[n_used] = v;
          ++n_used;
        }
    if (n_used > n_slots)
      throw UserError(path,
                      "\"" + text + "\" has " + std::to_string(n_used) +
                        " variables in it",
                      "expressions of at most four of " + joined(variables) +
                        or_else);
    // The slots that are left over need names that nobody can mean.
    std::vector<std::string> names;
    for (unsigned int s = 0; s < n_slots; ++s)
      {
        std::string name = "unused" + std::to_string(s);
        while (contains(text, name))
          name += "_";
        names.push_back(slots[s] >= 0 ? variables[slots[s]] : name);
      }
    parser->initialize(joined(names), text, {{"pi", numbers::PI}}, true);

    // The parser reads its text when it is first asked for a value. deal.II
    // then also prints what is wrong: the error must say it, and only once.
    std::ostringstream    printed;
    std::streambuf *const screen = std::cerr.rdbuf(printed.rdbuf());
    std::string           reason;
    try
      {
        value(std::vector<double>(variables.size()).data());
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
                      "expressions of " + joined(variables) + or_else);
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
