// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/errors.h>
#include <waker/particles/point_loads.h>

namespace Waker
{
  void
  PointLoadParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("From",
                      from,
                      "The points that lie in the box From .. To (m) at the "
                      "start share the force by their volumes. Without To: the "
                      "point nearest to From.",
                      Patterns::List(Patterns::Double(), 0, 3));
    prm.add_parameter("To",
                      to,
                      "Upper corner of that box (m).",
                      Patterns::List(Patterns::Double(), 0, 3));
    prm.add_parameter("Force",
                      force,
                      "Total force (kN; kN per m in 2D), constant in "
                      "direction; it rides on the points.",
                      Patterns::List(Patterns::Double(), 0, 3));
  }


  void
  PointLoadParameters::check(const unsigned int dim) const
  {
    (void)dim;
  }


  template <int dim>
  void
  apply_point_loads(const std::vector<PointLoadParameters> &loads,
                    MaterialPoints<dim>                    &points)
  {
    (void)loads;
    (void)points;
  }


  template void
  apply_point_loads(const std::vector<PointLoadParameters> &,
                    MaterialPoints<2> &);
  template void
  apply_point_loads(const std::vector<PointLoadParameters> &,
                    MaterialPoints<3> &);
} // namespace Waker
