// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/output/top_view_writer.h>

#include "point_fields.h"
#include "vtu.h"
#include <array>

namespace Waker
{
  namespace
  {
    // Corners of a square, in sides from its lower one along x and z.
    template <int dim>
    std::vector<std::array<unsigned int, 2>>
    corners()
    {
      if (dim == 2)
        return {{{0, 0}}, {{1, 0}}};
      // Its normal points up.
      return {{{0, 0}}, {{0, 1}}, {{1, 1}}, {{1, 0}}};
    }
  } // namespace


  template <int dim>
  std::string
  write_top_view(const TopView<dim>        &view,
                 const MaterialPoints<dim> &points,
                 const OwnRows             &rows,
                 const double               time,
                 const std::string         &path)
  {
    const std::vector<int>     places = rows.places();
    std::vector<std::uint32_t> own; // corners
    std::uint32_t              n = 0;
    VtuFile file(dim == 2 ? VtuFile::Cell::line : VtuFile::Cell::quadrilateral);
    file.add_scalar("height", "m");
    const PointFields<dim> fields(points);
    fields.declare(file);
    for (unsigned int k = 0; k < view.n_z; ++k)
      for (unsigned int i = 0; i < view.n_x; ++i)
        if (view.has_soil(i, k))
          {
            const unsigned int square = k * view.n_x + i;
            const double       height = view.height[square];
            const int          p      = places[view.point[square]];
            for (const std::array<unsigned int, 2> &corner : corners<dim>())
              {
                const std::uint32_t number = n++;
                if (p < 0)
                  continue; // another rank has it
                own.push_back(number);
                file.add_point(Point<3>(view.x + (i + corner[0]) * view.side,
                                        height,
                                        view.z + (k + corner[1]) * view.side));
                file.add_value(height);
                fields.add_values(p, file);
              }
          }
    return rows.numbers == nullptr
             ? file.write(time, path)
             : file.write(time, path, {rows.communicator, n, own});
  }


  std::string
  write_ground_lines(const std::vector<GroundPolyline> &lines,
                     const double                       time,
                     const std::string                 &path)
  {
    VtuFile file(VtuFile::Cell::polyline);
    file.add_scalar("kind", "", VtuFile::Type::number);
    for (const GroundPolyline &line : lines)
      {
        for (const Point<3> &x : line.vertices)
          {
            file.add_point(x);
            file.add_value(static_cast<double>(line.kind));
          }
        file.end_polyline();
      }
    return file.write(time, path);
  }


  template std::string
  write_top_view(const TopView<2> &,
                 const MaterialPoints<2> &,
                 const OwnRows &,
                 const double,
                 const std::string &);
  template std::string
  write_top_view(const TopView<3> &,
                 const MaterialPoints<3> &,
                 const OwnRows &,
                 const double,
                 const std::string &);
} // namespace Waker
