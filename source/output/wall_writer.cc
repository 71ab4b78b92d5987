// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/output/wall_writer.h>

#include "vtu.h"

namespace Waker
{
  template <int dim>
  void
  write_walls(const Walls<dim>                     &walls,
              const typename Walls<dim>::Tractions &tractions,
              const double                          time,
              const std::string                    &path)
  {
    VtuFields fields;
    fields.add_scalar("wall", "");
    fields.add_scalar("touches", "");
    fields.add_scalar("area", dim == 2 ? "m" : "m^2");
    fields.add_vector("traction", "kPa", dim);
    fields.add_scalar("pressure", "kPa");

    const auto                             &spots = walls.all_spots();
    std::vector<DataOutBase::Patch<0, dim>> patches(spots.size());
    for (std::size_t q = 0; q < spots.size(); ++q)
      {
        auto &patch       = patches[q];
        patch.patch_index = q;
        patch.vertices[0] = spots[q].position;
        patch.data.reinit(fields.n_components(), 1);
        unsigned int c   = 0;
        const auto   add = [&](const double value) {
          patch.data(c++, 0) = static_cast<float>(value);
        };
        add(spots[q].wall);
        add(spots[q].touches ? 1. : 0.);
        add(spots[q].area);
        for (unsigned int d = 0; d < dim; ++d)
          add(tractions[q][d]);
        add(tractions[q] * spots[q].normal);
      }
    fields.write(patches, time, path);
  }


  template void
  write_walls(const Walls<2> &,
              const Walls<2>::Tractions &,
              const double,
              const std::string &);
  template void
  write_walls(const Walls<3> &,
              const Walls<3>::Tractions &,
              const double,
              const std::string &);
} // namespace Waker
