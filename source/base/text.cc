// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/text.h>

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
} // namespace Waker
