// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_choice_h
#define waker_base_choice_h

#include <waker/base/errors.h>

#include <optional>
#include <string>
#include <vector>

namespace Waker
{
  // A choice of the user's is an `enum class` whose values count from 0. Beside
  // it stands the one place that knows the names in parameter files:
  //
  //   constexpr const char *
  //   name_of(const Scheme scheme)
  //   {
  //     switch (scheme) // all values and no default: -Wswitch is an error
  //       {
  //         case Scheme::newmark:
  //           return "Newmark";
  //         ...
  //       }
  //     return nullptr; // there are no more
  //   }
  //
  // The order of the values is that of the names in lists.

  /// All values, in their order.
  template <typename Choice>
  std::vector<Choice>
  all_choices()
  {
    std::vector<Choice> choices;
    for (int i = 0; name_of(static_cast<Choice>(i)) != nullptr; ++i)
      choices.push_back(static_cast<Choice>(i));
    return choices;
  }


  /// All names, in the order of the values.
  template <typename Choice>
  std::vector<std::string>
  choice_names()
  {
    std::vector<std::string> names;
    for (const Choice choice : all_choices<Choice>())
      names.emplace_back(name_of(choice));
    return names;
  }


  /// The same in a text: "Newmark, explicit, quasi-static".
  template <typename Choice>
  std::string
  choice_list(const std::string &separator = ", ")
  {
    std::string text;
    for (const std::string &name : choice_names<Choice>())
      text += (text.empty() ? "" : separator) + name;
    return text;
  }


  /// The value of that name, if there is one.
  template <typename Choice>
  std::optional<Choice>
  find_choice(const std::string &name)
  {
    for (const Choice choice : all_choices<Choice>())
      if (name == name_of(choice))
        return choice;
    return {};
  }


  /// The same for a name that must be one.
  /// @param path of the parameter, for the error
  /// @throws UserError unless it is
  template <typename Choice>
  Choice
  choice_named(const std::string &name, const std::string &path)
  {
    const std::optional<Choice> choice = find_choice<Choice>(name);
    if (!choice)
      throw UserError(path,
                      "is \"" + name + "\"",
                      "one of " + choice_list<Choice>());
    return *choice;
  }
} // namespace Waker

#endif
