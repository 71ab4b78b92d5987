// SPDX-License-Identifier: LGPL-2.1-or-later
#include "point_fields.h"

#include <waker/particles/material_points.h>

#include <cmath>

namespace Waker
{
  template <int dim>
  PointFields<dim>::PointFields(const MaterialPoints<dim> &points,
                                const PointVectors<dim>   &vectors)
    : points(points)
    , vectors(vectors)
    , vertical_stress(points.find_scalar("initial vertical stress"))
    , overconsolidation_ratio(points.find_scalar("overconsolidation ratio"))
  {}


  template <int dim>
  void
  PointFields<dim>::declare(VtuFile &file) const
  {
    file.add_scalar("id", "", VtuFile::Type::id);
    file.add_scalar("material", "", VtuFile::Type::number);
    file.add_scalar("mass", "Mg");
    file.add_scalar("volume", dim == 2 ? "m^2" : "m^3");
    file.add_vector("displacement", "m");
    file.add_vector("velocity", "m/s");
    for (const char *const name : {"stress_xx",
                                   "stress_yy",
                                   "stress_zz",
                                   "stress_xy",
                                   "stress_xz",
                                   "stress_yz",
                                   "mean_stress",
                                   "deviatoric_stress"})
      file.add_scalar(name, "kPa");
    for (const NamedArray &scalar : points.scalars)
      file.add_scalar(scalar.name, "");
    if (vertical_stress >= 0 && overconsolidation_ratio >= 0)
      file.add_scalar("yield stress", "kPa");
    for (const PointVector<dim> &vector : vectors)
      {
        AssertDimension(vector.values->size(), points.n_points());
        file.add_vector(vector.name, vector.unit);
      }
  }


  template <int dim>
  void
  PointFields<dim>::add_values(const std::size_t p, VtuFile &file) const
  {
    file.add_value(static_cast<double>(points.id[p]));
    file.add_value(points.material[p]);
    file.add_value(points.mass[p]);
    file.add_value(points.volume[p]);
    file.add_value(points.position[p] - points.initial_position[p]);
    file.add_value(points.velocity[p]);

    const SymmetricTensor<2, 3> &stress = points.stress[p];
    for (unsigned int d = 0; d < 3; ++d)
      file.add_value(stress[d][d]);
    file.add_value(stress[0][1]);
    file.add_value(stress[0][2]);
    file.add_value(stress[1][2]);
    const SymmetricTensor<2, 3> s = deviator(stress);
    file.add_value(-trace(stress) / 3.);
    file.add_value(std::sqrt(1.5 * (s * s)));

    for (const NamedArray &scalar : points.scalars)
      file.add_value(scalar.values[p]);
    if (vertical_stress >= 0 && overconsolidation_ratio >= 0)
      file.add_value(points.scalars[vertical_stress].values[p] *
                     points.scalars[overconsolidation_ratio].values[p]);
    for (const PointVector<dim> &vector : vectors)
      file.add_value((*vector.values)[p]);
  }


  template class PointFields<2>;
  template class PointFields<3>;
} // namespace Waker
