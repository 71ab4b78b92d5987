// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/output/wall_writer.h>

#include "vtu.h"

namespace Waker
{
  template <int dim>
  std::string
  write_walls(const Walls<dim>                     &walls,
              const typename Walls<dim>::Tractions &tractions,
              const double                          time,
              const std::string                    &path)
  {
    VtuFile file(VtuFile::Cell::vertex);
    file.add_scalar("wall", "", VtuFile::Type::number);
    file.add_scalar("touches", "", VtuFile::Type::number);
    file.add_scalar("area", dim == 2 ? "m" : "m^2");
    file.add_vector("traction", "kPa");
    file.add_scalar("pressure", "kPa");
    const auto &spots = walls.all_spots();
    for (std::size_t q = 0; q < spots.size(); ++q)
      {
        file.add_point(spots[q].position);
        file.add_value(spots[q].wall);
        file.add_value(spots[q].touches ? 1. : 0.);
        file.add_value(spots[q].area);
        file.add_value(tractions[q]);
        file.add_value(tractions[q] * spots[q].normal);
      }
    return file.write(time, path);
  }


  template std::string
  write_walls(const Walls<2> &,
              const Walls<2>::Tractions &,
              const double,
              const std::string &);
  template std::string
  write_walls(const Walls<3> &,
              const Walls<3>::Tractions &,
              const double,
              const std::string &);
} // namespace Waker
