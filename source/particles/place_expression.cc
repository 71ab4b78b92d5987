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
      names.insert(names.end(),
                   {"depth",
                    "depth_in_layer",
                    "vertical_stress",
                    "daily_vertical_stress"});
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
                              const InGround            &ground,
                              const std::vector<double> &more) const
  {
    std::vector<double> values(x.begin_raw(), x.end_raw());
    values.insert(values.end(),
                  {ground.depth,
                   ground.depth_in_layer,
                   ground.vertical_stress,
                   ground.daily_vertical_stress});
    values.insert(values.end(), more.begin(), more.end());
    return expression.value(values.data());
  }


  template <int dim>
  bool
  PlaceExpression<dim>::asks_for_stress() const
  {
    return expression.uses(dim + 2) || expression.uses(dim + 3);
  }


  template class PlaceExpression<2>;
  template class PlaceExpression<3>;
} // namespace Waker
