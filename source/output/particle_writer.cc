// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/output/particle_writer.h>
#include <waker/particles/material_points.h>

#include "point_fields.h"
#include "vtu.h"

namespace Waker
{
  template <int dim>
  std::string
  write_particles(const MaterialPoints<dim> &points,
                  const OwnRows             &rows,
                  const double               time,
                  const std::string         &path,
                  const PointVectors<dim>   &vectors)
  {
    VtuFile                file(VtuFile::Cell::vertex);
    const PointFields<dim> fields(points, vectors);
    fields.declare(file);
    file.reserve(points.n_points());
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        file.add_point(points.position[p]);
        fields.add_values(p, file);
      }
    return file.write(time, path, rows);
  }


  template std::string
  write_particles(const MaterialPoints<2> &,
                  const OwnRows &,
                  const double,
                  const std::string &,
                  const PointVectors<2> &);
  template std::string
  write_particles(const MaterialPoints<3> &,
                  const OwnRows &,
                  const double,
                  const std::string &,
                  const PointVectors<3> &);
} // namespace Waker
