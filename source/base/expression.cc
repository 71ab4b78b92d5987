// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/expression.h>

#include <array>

namespace Waker
{
  namespace
  {
    template <int dim>
    std::vector<std::string>
    place_and_time()
    {
      if (dim == 2)
        return {"x", "y", "t"};
      return {"x", "y", "z", "t"};
    }
  } // namespace


  template <int dim>
  Expression<dim>::Expression(const std::string &text,
                              const std::string &path,
                              const std::string &or_else)
    : expression(text, path, place_and_time<dim>(), or_else)
  {}


  template <int dim>
  double
  Expression<dim>::value(const Point<dim> &x, const double t) const
  {
    std::array<double, dim + 1> values;
    for (unsigned int d = 0; d < dim; ++d)
      values[d] = x[d];
    values[dim] = t;
    return expression.value(values.data());
  }


  template <int dim>
  bool
  Expression<dim>::varies(const Point<dim> &x,
                          const double      from,
                          const double      to) const
  {
    return moves() &&
           Waker::varies([&](const double t) { return value(x, t); }, from, to);
  }


  template <int dim>
  bool
  Expression<dim>::is_uniform() const
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (expression.uses(d))
        return false;
    return true;
  }


  template class Expression<2>;
  template class Expression<3>;
} // namespace Waker
