// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/loads/liquid.h>
#include <waker/loads/wetted_surface.h>
#include <waker/output/surface_writer.h>
#include <waker/surface/shape/surface.h>

#include "vtu.h"

namespace Waker
{
  namespace
  {
    void
    add_surface_fields(VtuFile &file)
    {
      file.add_scalar("on_face", "", VtuFile::Type::number);
      file.add_scalar("wetted", "", VtuFile::Type::number);
      file.add_scalar("pressure", "kPa");
    }

  } // namespace


  std::string
  write_surface(const Surface                    &surface,
                const std::vector<LoadedSegment> &wetted_segments,
                const Liquid                     &water,
                const double                      time,
                const std::string                &path)
  {
    VtuFile file(VtuFile::Cell::line);
    file.add_scalar("chain", "", VtuFile::Type::number);
    add_surface_fields(file);
    for (std::size_t i = 0; i < surface.chains.size(); ++i)
      {
        const SurfaceChain &chain = surface.chains[i];
        const std::size_t   n     = chain.vertices.size();
        for (std::size_t k = 0; k < n; ++k)
          for (const std::size_t v : {k, (k + 1) % n})
            {
              file.add_point(chain.vertices[v]);
              file.add_value(i);
              file.add_value(chain.on_face[k]);
              file.add_value(0.);
              file.add_value(0.);
            }
      }
    for (const LoadedSegment &segment : wetted_segments)
      for (const Point<2> &x : {segment.from, segment.to})
        {
          file.add_point(x);
          file.add_value(-1.);
          file.add_value(-1.);
          file.add_value(1.);
          file.add_value(water.pressure(x[1]));
        }
    return file.write(time, path);
  }


  template <int dim>
  std::string
  write_surface(const Facets<dim> &surface,
                const Facets<dim> &wetted,
                const Liquid      &water,
                const double       time,
                const std::string &path)
  {
    VtuFile file(dim == 2 ? VtuFile::Cell::line : VtuFile::Cell::triangle);
    add_surface_fields(file);
    for (const Facets<dim> *const facets : {&surface, &wetted})
      for (const Facet<dim> &facet : *facets)
        for (const Point<dim> &x : facet.vertices)
          {
            const bool is_wet = facets == &wetted;
            file.add_point(x);
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
