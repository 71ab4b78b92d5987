// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/patterns.h>

#include <waker/base/expression_pattern.h>
#include <waker/base/numbers.h>
#include <waker/program/declared_parameters.h>
#include <waker/program/prm_scanner.h>

#include <algorithm>
#include <limits>
#include <regex>

namespace Waker
{
  namespace
  {
    bool
    starts_with(const std::string &text, const std::string &start)
    {
      return text.rfind(start, 0) == 0;
    }


    constexpr std::ptrdiff_t most_entries = 10000; // of a list


    struct ListPattern
    {
      std::string element; // pattern
      std::string shortest;
      std::string longest;
      std::string separator;
    };


    /// "[List of <...> of length 2...3 (inclusive) separated by <;>]"
    bool
    parse_list(const std::string &pattern, ListPattern &list)
    {
      static const std::regex form(
        "\\[List of <(.*)> of length (\\d+)\\.\\.\\.(\\d+) \\(inclusive\\)"
        "(?: separated by <(.*)>)?\\]");
      std::smatch match;
      if (!std::regex_match(pattern, match, form))
        return false;
      list = {match[1], match[2], match[3], match[4]};
      if (list.separator.empty())
        list.separator = ",";
      return true;
    }


    /// Is one of the numbers like "0,25"? It may be a decimal comma, or stand
    /// between two numbers. "0, 25", "1,2,3", "0,-1" and "0,2.5" are clear.
    bool
    may_have_decimal_commas(const std::string &value)
    {
      const auto is_digit = [](const char c) { return c >= '0' && c <= '9'; };
      for (std::string word : split(value, ' '))
        {
          if (!word.empty() && word.back() == ',')
            word.pop_back();
          const std::size_t comma = word.find(',');
          if (comma != std::string::npos && comma > 0 &&
              comma + 1 < word.size() && is_digit(word[comma - 1]) &&
              is_digit(word[comma + 1]) &&
              word.find_first_of(",.", comma + 1) == std::string::npos &&
              word.find('.') == std::string::npos)
            return true;
        }
      return false;
    }


    /// Is it a list of numbers with commas between them?
    bool
    is_list_of_numbers(const ListPattern &list)
    {
      return list.separator == "," && starts_with(list.element, "[Double");
    }


    /// "[Double 0...MAX_DOUBLE (inclusive)]", "[Integer range 1...5
    /// (inclusive)]"
    std::string
    range_in_words(const std::string &pattern, const std::string &kind)
    {
      static const std::regex form(
        "\\[\\w+(?: range)? (\\S+?)\\.\\.\\.(\\S+) \\(inclusive\\)\\]");
      std::smatch match;
      if (!std::regex_match(pattern, match, form))
        return kind;
      const std::string lower = match[1], upper = match[2];
      const bool below = lower != "-MAX_DOUBLE" && lower != "-2147483648";
      const bool above = upper != "MAX_DOUBLE" && upper != "2147483647";
      if (below && above)
        return kind + " from " + lower + " to " + upper;
      if (below)
        return kind + " of at least " + lower;
      if (above)
        return kind + " of at most " + upper;
      return kind;
    }


    std::string
    list_in_words(const ListPattern &list)
    {
      const std::string element = pattern_in_words(list.element);
      std::string       count;
      if (list.shortest == list.longest)
        count = list.shortest + " ";
      else if (list.longest != "4294967295")
        count = list.shortest + " to " + list.longest + " ";
      else if (list.shortest != "0")
        count = "at least " + list.shortest + " ";
      return count + "entries separated by \"" + list.separator + "\", each " +
             element;
    }
  } // namespace


  std::string
  pattern_in_words(const std::string &pattern)
  {
    ListPattern list;
    if (parse_list(pattern, list))
      return list_in_words(list);
    if (starts_with(pattern, "[Double"))
      return range_in_words(pattern, "a number");
    if (starts_with(pattern, "[Integer"))
      return range_in_words(pattern, "a whole number");
    if (starts_with(pattern, "[Bool"))
      return "true or false";
    if (starts_with(pattern, "[Selection "))
      {
        std::string words;
        for (const std::string &choice :
             split(pattern.substr(11, pattern.size() - 12), '|'))
          words += (words.empty() ? "one of " : ", ") + choice;
        return words;
      }
    if (starts_with(pattern, "[FileName"))
      return "the name of a file";
    if (ExpressionPattern::is_description(pattern))
      return "a number or an expression";
    if (const auto word = NumberOrWordPattern::word_of(pattern))
      return "a number or " + *word;
    if (starts_with(pattern, "[Anything") ||
        starts_with(pattern, "[DirectoryName"))
      return "any text";
    return pattern;
  }


  std::string
  allowed_instead(const std::string &value, const std::string &pattern)
  {
    std::string words = pattern_in_words(pattern);
    const bool  is_whole_number =
      !value.empty() &&
      value.find_first_not_of("0123456789") == std::string::npos;
    if (pattern.find("[Double") != std::string::npos ||
        NumberOrWordPattern::word_of(pattern))
      {
        if (std::count(value.begin(), value.end(), ',') >= most_entries)
          words += ", at most " + std::to_string(most_entries);
        else if (value.find(',') != std::string::npos)
          {
            ListPattern list;
            if (parse_list(pattern, list) && is_list_of_numbers(list))
              words += " and blanks (0, 25)";
            words += decimals_with_a_point;
          }
        else if (starts_with(pattern, "[Double"))
          words += " that is finite and written like 2.5 or 1e-3";
      }
    else if (starts_with(pattern, "[Integer") && is_whole_number &&
             words.find(" to ") == std::string::npos)
      words += ", at most " + std::to_string(std::numeric_limits<int>::max());
    return words;
  }


  bool
  matches_pattern(const std::string &value, const std::string &pattern)
  {
    if (ExpressionPattern::is_description(pattern))
      return ExpressionPattern().match(value);
    if (const auto word = NumberOrWordPattern::word_of(pattern))
      return NumberOrWordPattern(*word).match(value);
    // The pattern takes a list apart in a time that grows with its square.
    ListPattern list;
    if (parse_list(pattern, list) &&
        std::count(value.begin(), value.end(), list.separator[0]) >=
          most_entries)
      return false;
    if (!list.element.empty() && is_list_of_numbers(list) &&
        may_have_decimal_commas(value))
      return false;
    return Patterns::pattern_factory(pattern)->match(value);
  }


  std::string
  normalised(const std::string &value, const std::string &pattern)
  {
    ListPattern list;
    if (parse_list(pattern, list))
      {
        std::string result;
        for (const std::string &element : split(value, list.separator[0]))
          result += (result.empty() ? "" : list.separator + " ") +
                    normalised(element, list.element);
        return result;
      }
    // The fewest digits that give the same number again.
    if (starts_with(pattern, "[Double") ||
        ExpressionPattern::is_description(pattern) ||
        NumberOrWordPattern::word_of(pattern))
      if (const auto number = plain_number(value))
        return in_digits(*number);
    return tidy(value);
  }
} // namespace Waker
