// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_places_h
#define waker_base_places_h

#include <deal.II/base/point.h>

#include <sstream>
#include <string>

namespace Waker
{
  /// "(-11.9, -1.9)", as places are written in messages.
  template <int dim>
  std::string
  place_text(const dealii::Point<dim> &x)
  {
    std::ostringstream text;
    for (unsigned int d = 0; d < dim; ++d)
      text << (d == 0 ? "(" : ", ") << x[d];
    text << ")";
    return text.str();
  }
} // namespace Waker

#endif
