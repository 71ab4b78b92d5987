// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/text.h>

#include <algorithm>
#include <cctype>

namespace Waker
{
  std::string
  tidy(const std::string &text)
  {
    std::string result;
    for (const char c : text)
      {
        const bool blank = std::isspace(static_cast<unsigned char>(c)) != 0;
        if (!blank)
          result += c;
        else if (!result.empty() && result.back() != ' ')
          result += ' ';
      }
    if (!result.empty() && result.back() == ' ')
      result.pop_back();
    return result;
  }


  std::vector<std::string>
  split(const std::string &text, const char separator)
  {
    std::vector<std::string> parts;
    if (tidy(text).empty())
      return parts;
    std::size_t begin = 0;
    while (true)
      {
        const std::size_t end = text.find(separator, begin);
        parts.push_back(tidy(text.substr(begin, end - begin)));
        if (end == std::string::npos)
          return parts;
        begin = end + 1;
      }
  }


  namespace
  {
    /// Bytes of the character of UTF-8 that starts at `position`; 0 if none
    /// does. Overlong forms, surrogates and what lies beyond Unicode are none.
    std::size_t
    character_length(const std::string &text, const std::size_t position)
    {
      const auto byte = [&](const std::size_t i) {
        return position + i < text.size()
                 ? static_cast<unsigned char>(text[position + i])
                 : 0u;
      };
      const unsigned int first = byte(0);
      if (first < 0x80)
        return 1;
      const std::size_t length = first >= 0xC2 && first < 0xE0   ? 2
                                 : first >= 0xE0 && first < 0xF0 ? 3
                                 : first >= 0xF0 && first < 0xF5 ? 4
                                                                 : 0;
      for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xC0u) != 0x80)
          return 0;
      if ((first == 0xE0 && byte(1) < 0xA0) ||
          (first == 0xED && byte(1) >= 0xA0) ||
          (first == 0xF0 && byte(1) < 0x90) ||
          (first == 0xF4 && byte(1) >= 0x90))
        return 0;
      return length;
    }


    bool
    is_control(const char c)
    {
      return std::iscntrl(static_cast<unsigned char>(c)) != 0;
    }
  } // namespace


  std::string
  printable(const std::string &text, const std::size_t longest)
  {
    // The rest would not be shown: a value may have megabytes.
    const std::string begin = tidy(text.substr(0, 4 * longest));
    std::string       result;
    std::size_t       i = 0;
    while (i < begin.size() && result.size() < longest)
      {
        const std::size_t n = character_length(begin, i);
        result += n == 0 || is_control(begin[i]) ? "?" : begin.substr(i, n);
        i += std::max<std::size_t>(n, 1);
      }
    if (i < begin.size() || text.size() > 4 * longest)
      result += "...";
    return result;
  }


  std::string
  in_quotes(const std::string &text)
  {
    return "\"" + printable(text, 60) + "\"";
  }


  std::string
  either(const std::vector<std::string> &alternatives)
  {
    std::string text;
    for (std::size_t i = 0; i < alternatives.size(); ++i)
      text += (i == 0                        ? ""
               : i + 1 < alternatives.size() ? ", "
                                             : " or ") +
              alternatives[i];
    return text;
  }


  std::string
  counted(const std::size_t n, const std::string &noun)
  {
    return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
  }


  bool
  is_plain_text(const std::string &text)
  {
    for (std::size_t i = 0; i < text.size();)
      {
        const std::size_t n = character_length(text, i);
        if (n == 0 || (is_control(text[i]) && text[i] != '\t'))
          return false;
        i += n;
      }
    return true;
  }


  std::string
  without_byte_order_mark(const std::string &text)
  {
    return text.compare(0, 3, "\xEF\xBB\xBF") == 0 ? text.substr(3) : text;
  }
} // namespace Waker
