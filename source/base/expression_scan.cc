// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/expression_scan.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>

#include <algorithm>

namespace Waker
{
  const std::vector<std::string> expression_functions = {
    "sin",   "cos",   "tan",   "asin",  "acos", "atan", "sinh", "cosh", "tanh",
    "asinh", "acosh", "atan2", "atanh", "cot",  "csc",  "sec",  "exp",  "ln",
    "log",   "log2",  "log10", "sqrt",  "pow",  "abs",  "sign", "rint", "int",
    "ceil",  "floor", "min",   "max",   "sum",  "avg",  "erfc", "if"};


  namespace
  {
    // muParser itself would take 20,000; nobody can check such a formula.
    constexpr std::size_t longest_expression = 4000;


    bool
    contains(const std::vector<std::string> &list, const std::string &name)
    {
      return std::find(list.begin(), list.end(), name) != list.end();
    }


    bool
    is_digit(const char c)
    {
      return c >= '0' && c <= '9';
    }


    bool
    in_name(const char c)
    {
      return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
             c == '_';
    }


    class Scanner
    {
    public:
      Scanner(const std::string              &text,
              const std::vector<std::string> &variables)
        : text(text)
        , variables(variables)
      {}

      ExpressionScan
      scan()
      {
        if (text.find_first_not_of(" \t") == std::string::npos)
          complain("is empty");
        if (text.size() > longest_expression)
          complain("has " + std::to_string(text.size()) + " characters",
                   "at most " + std::to_string(longest_expression) +
                     " characters");
        while (good() && i < text.size())
          {
            const char c = text[i];
            if (is_digit(c) || (c == '.' && is_digit(at(i + 1))))
              read_number_token();
            else if (in_name(c))
              read_name();
            else
              read_sign();
          }
        if (good() && !calls.empty())
          complain("a parenthesis is not closed");
        return result;
      }

    private:
      char
      at(const std::size_t position) const
      {
        return position < text.size() ? text[position] : '\0';
      }

      bool
      good() const
      {
        return result.problem.empty();
      }

      void
      complain(const std::string &problem, const std::string &advice = "")
      {
        if (good())
          {
            result.problem = problem;
            result.advice  = advice;
          }
      }

      void
      read_number_token()
      {
        const std::size_t begin  = i;
        const auto        digits = [&]() {
          while (is_digit(at(i)))
            ++i;
        };
        digits();
        if (at(i) == '.')
          ++i;
        digits();
        if (at(i) == 'e' || at(i) == 'E')
          {
            const bool sign = at(i + 1) == '+' || at(i + 1) == '-';
            if (is_digit(at(i + 1 + sign)))
              {
                i += 1 + sign;
                digits();
              }
          }
        double            number = 0.;
        const std::string token  = text.substr(begin, i - begin);
        if (!read_number(token, number))
          complain(in_quotes(token) + " is beyond the range of numbers");
        if (in_name(at(i)) || at(i) == '.')
          complain("there is no operator after " + in_quotes(token));
        after_function = false;
      }

      void
      read_name()
      {
        const std::size_t begin = i;
        while (in_name(at(i)))
          ++i;
        const std::string name = text.substr(begin, i - begin);
        while (at(i) == ' ' || at(i) == '\t')
          ++i;
        result.names.insert(name);
        const bool is_function = contains(expression_functions, name);
        if (name == "rand" || name == "rand_seed")
          complain(name + "() gives another value at every call: the results "
                          "would not repeat",
                   "random fields, which have a seed");
        else if (is_function && at(i) != '(')
          complain(in_quotes(name) + " has no parentheses with its arguments");
        else if (!is_function && at(i) == '(' && !is_value(name))
          complain("there is no function " + in_quotes(name),
                   functions_in_words());
        else if (!is_function && !is_value(name))
          complain(in_quotes(name) + " is unknown");
        after_function = is_function;
      }

      bool
      is_value(const std::string &name) const
      {
        return name == "pi" || contains(variables, name);
      }

      static std::string
      functions_in_words()
      {
        std::string list;
        for (const std::string &function : expression_functions)
          list += (list.empty() ? "the functions " : ", ") + function;
        return list;
      }

      void
      read_sign()
      {
        const char c = text[i];
        if (c == '(')
          calls.push_back(after_function);
        else if (c == ')')
          {
            if (calls.empty())
              complain("a parenthesis is closed that is not open");
            else
              calls.pop_back();
          }
        else if (c == ',')
          {
            // Only between arguments; elsewhere it may be a decimal comma.
            if (calls.empty() || !calls.back())
              complain("a comma stands where no arguments are separated",
                       "decimals with a point: 0.25, not 0,25");
          }
        else if (c == '=')
          {
            const char before = i > 0 ? text[i - 1] : '\0';
            if (at(i + 1) == '=' && before != '=')
              ++i;
            else if (before != '<' && before != '>' && before != '!')
              complain("\"=\" would change a value", "== to compare");
          }
        else if (std::string(" \t+-*/^<>!&|?:").find(c) == std::string::npos)
          complain(in_quotes(text.substr(i, 1)) + " has no meaning in it");
        if (c != ' ' && c != '\t')
          after_function = false;
        ++i;
      }

      const std::string              &text;
      const std::vector<std::string> &variables;
      std::size_t                     i = 0;
      std::vector<bool>               calls; // open parentheses: of a function?
      bool                            after_function = false;
      ExpressionScan                  result;
    };
  } // namespace


  ExpressionScan
  scan_expression(const std::string              &text,
                  const std::vector<std::string> &variables)
  {
    return Scanner(text, variables).scan();
  }
} // namespace Waker
