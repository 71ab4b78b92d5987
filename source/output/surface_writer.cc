// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/loads/liquid.h>
#include <waker/output/surface_writer.h>

#include "vtu.h"

namespace Waker
{
  template <int dim>
  std::string
  write_surface(const Facets<dim> &surface,
                const Facets<dim> &wetted,
                const Liquid      &water,
                const double       time,
                const std::string &path)
  {
    VtuFile file(dim == 2 ? VtuFile::Cell::line : VtuFile::Cell::triangle);
    file.add_scalar("chain", "", VtuFile::Type::number);
    file.add_scalar("on_face", "", VtuFile::Type::number);
    file.add_scalar("wetted", "", VtuFile::Type::number);
    file.add_scalar("pressure", "kPa");
    for (const Facets<dim> *const facets : {&surface, &wetted})
      for (const Facet<dim> &facet : *facets)
        for (const Point<dim> &x : facet.vertices)
          {
            const bool is_wet = facets == &wetted;
            file.add_point(x);
            file.add_value(is_wet ? -1 : facet.chain);
            file.add_value(is_wet ? -1 : facet.on_face);
            file.add_value(is_wet);
            file.add_value(is_wet ? water.pressure(x[1]) : 0.);
          }
    return file.write(time, path);
  }


  template std::string
  write_surface(const Facets<2> &,
                const Facets<2> &,
                const Liquid &,
                const double,
                const std::string &);
  template std::string
  write_surface(const Facets<3> &,
                const Facets<3> &,
                const Liquid &,
                const double,
                const std::string &);
} // namespace Waker
