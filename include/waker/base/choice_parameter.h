// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_choice_parameter_h
#define waker_base_choice_parameter_h

#include <deal.II/base/parameter_handler.h>

#include <waker/base/choice.h>

#include <string>

namespace Waker
{
  using namespace dealii;

  /// Like ParameterHandler::add_parameter(), for a choice (base/choice.h):
  /// `choice` is the default, and changes with the entry.
  template <typename Choice>
  void
  add_choice(ParameterHandler  &prm,
             const std::string &entry,
             Choice            &choice,
             const std::string &documentation)
  {
    prm.declare_entry(entry,
                      name_of(choice),
                      Patterns::Selection(choice_list<Choice>("|")),
                      documentation);
    prm.add_action(entry, [&choice, entry](const std::string &name) {
      choice = choice_named<Choice>(name, entry);
    });
  }
} // namespace Waker

#endif
