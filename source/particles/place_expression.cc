// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/particles/place_expression.h>

namespace Waker
{
  namespace
  {
    template <int dim>
    std::vector<std::string>
    place_variables(const std::vector<std::string> &more)
    {
      std::vector<std::string> names = {"x", "y"};
      if (dim == 3)
        names.push_back("z");
      names.insert(names.end(), {"depth", "depth_in_layer"});
      names.insert(names.end(), more.begin(), more.end());
      return names;
    }
  } // namespace


  template <int dim>
  PlaceExpression<dim>::PlaceExpression(const std::string              &text,
                                        const std::string              &path,
                                        const std::vector<std::string> &more,
                                        const std::string              &or_else)
    : expression(text, path, place_variables<dim>(more), or_else)
  {}


  template <int dim>
  double
  PlaceExpression<dim>::value(const Point<dim>          &x,
                              const Depths              &depths,
                              const std::vector<double> &more) const
  {
    std::vector<double> values(x.begin_raw(), x.end_raw());
    values.push_back(depths.below_surface);
    values.push_back(depths.in_layer);
    values.insert(values.end(), more.begin(), more.end());
    return expression.value(values.data());
  }


  template class PlaceExpression<2>;
  template class PlaceExpression<3>;
} // namespace Waker
