// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/output/particle_writer.h>
#include <waker/particles/material_points.h>

#include "vtu.h"
#include <cmath>

namespace Waker
{
  template <int dim>
  void
  write_particles(const MaterialPoints<dim> &points,
                  const double               time,
                  const std::string         &path,
                  const PointVectors<dim>   &vectors)
  {
    VtuFields fields;
    fields.add_scalar("id", "");
    fields.add_scalar("material", "");
    fields.add_scalar("mass", "Mg");
    fields.add_scalar("volume", dim == 2 ? "m^2" : "m^3");
    fields.add_vector("displacement", "m", dim);
    fields.add_vector("velocity", "m/s", dim);
    for (const char *const name : {"stress_xx",
                                   "stress_yy",
                                   "stress_zz",
                                   "stress_xy",
                                   "stress_xz",
                                   "stress_yz",
                                   "mean_stress",
                                   "deviatoric_stress"})
      fields.add_scalar(name, "kPa");
    for (const NamedArray &scalar : points.scalars)
      fields.add_scalar(scalar.name, "");
    for (const PointVector<dim> &vector : vectors)
      {
        AssertDimension(vector.values->size(), points.n_points());
        fields.add_vector(vector.name, vector.unit, dim);
      }

    std::vector<DataOutBase::Patch<0, dim>> patches(points.n_points());
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        // Patch<0> knows by itself that it is a vertex.
        DataOutBase::Patch<0, dim> &patch = patches[p];
        patch.vertices[0]                 = points.position[p];
        patch.patch_index                 = p;
        patch.data.reinit(fields.n_components(), 1, true);

        unsigned int c   = 0;
        const auto   add = [&](const double value) {
          patch.data(c++, 0) = static_cast<float>(value);
        };
        add(static_cast<double>(points.id[p]));
        add(points.material[p]);
        add(points.mass[p]);
        add(points.volume[p]);
        for (unsigned int d = 0; d < dim; ++d)
          add(points.position[p][d] - points.initial_position[p][d]);
        for (unsigned int d = 0; d < dim; ++d)
          add(points.velocity[p][d]);

        const SymmetricTensor<2, 3> &stress = points.stress[p];
        for (unsigned int d = 0; d < 3; ++d)
          add(stress[d][d]);
        add(stress[0][1]);
        add(stress[0][2]);
        add(stress[1][2]);
        const SymmetricTensor<2, 3> s = deviator(stress);
        add(-trace(stress) / 3.);
        add(std::sqrt(1.5 * (s * s)));

        for (const NamedArray &scalar : points.scalars)
          add(scalar.values[p]);
        for (const PointVector<dim> &vector : vectors)
          for (unsigned int d = 0; d < dim; ++d)
            add((*vector.values)[p][d]);
      }

    fields.write(patches, time, path);
  }


  template void
  write_particles(const MaterialPoints<2> &,
                  const double,
                  const std::string &,
                  const PointVectors<2> &);
  template void
  write_particles(const MaterialPoints<3> &,
                  const double,
                  const std::string &,
                  const PointVectors<3> &);
} // namespace Waker
