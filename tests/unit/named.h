// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_named_h
#define waker_tests_named_h

#include <waker/base/choice.h>

#include <string>

namespace Waker
{
  /// A choice by its name in parameter files, of the type that is asked for.
  /// @throws UserError "Named" if it has no such name
  struct Named
  {
    std::string name;

    template <typename Choice>
    operator Choice() const
    {
      return choice_named<Choice>(name, "Named");
    }
  };
} // namespace Waker

#endif
