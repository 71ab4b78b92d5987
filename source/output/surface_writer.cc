// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/boundary/surface.h>
#include <waker/boundary/water_load.h>
#include <waker/output/surface_writer.h>

#include "vtu.h"
#include <algorithm>
#include <array>

namespace Waker
{
  namespace
  {
    using LinePatch = DataOutBase::Patch<1, 2>;

    /// @param data one row per end
    template <std::size_t n_fields>
    LinePatch
    make_line(const Point<2>                                    &from,
              const Point<2>                                    &to,
              const std::array<std::array<double, n_fields>, 2> &data)
    {
      LinePatch patch;
      patch.reference_cell = ReferenceCells::Line;
      patch.vertices[0]    = from;
      patch.vertices[1]    = to;
      patch.data.reinit(n_fields, 2);
      for (unsigned int end = 0; end < 2; ++end)
        for (unsigned int c = 0; c < n_fields; ++c)
          patch.data(c, end) = static_cast<float>(data[end][c]);
      return patch;
    }
  } // namespace


  void
  write_surface(const Surface                    &surface,
                const std::vector<LoadedSegment> &wetted_segments,
                const WaterParameters            &water,
                const double                      time,
                const std::string                &path)
  {
    VtuFields fields;
    fields.add_scalar("chain", "");
    fields.add_scalar("on_face", "");
    fields.add_scalar("wetted", "");
    fields.add_scalar("pressure", "kPa");
    using Row = std::array<double, 4>;

    std::vector<LinePatch> patches;
    for (std::size_t i = 0; i < surface.chains.size(); ++i)
      {
        const SurfaceChain &chain = surface.chains[i];
        const std::size_t   n     = chain.vertices.size();
        for (std::size_t k = 0; k < n; ++k)
          {
            const Row row = {{static_cast<double>(i),
                              static_cast<double>(chain.on_face[k]),
                              0.,
                              0.}};
            patches.push_back(make_line<4>(chain.vertices[k],
                                           chain.vertices[(k + 1) % n],
                                           {{row, row}}));
          }
      }

    for (const LoadedSegment &segment : wetted_segments)
      {
        const auto row = [&](const Point<2> &x) {
          return Row{{-1.,
                      -1.,
                      1.,
                      water.unit_weight * std::max(water.level - x[1], 0.)}};
        };
        patches.push_back(make_line<4>(segment.from,
                                       segment.to,
                                       {{row(segment.from), row(segment.to)}}));
      }

    for (std::size_t i = 0; i < patches.size(); ++i)
      patches[i].patch_index = i;
    fields.write(patches, time, path);
  }


  template <int dim>
  void
  write_surface(const Facets<dim>     &surface,
                const Facets<dim>     &wetted,
                const WaterParameters &water,
                const double           time,
                const std::string     &path)
  {
    VtuFields fields;
    fields.add_scalar("on_face", "");
    fields.add_scalar("wetted", "");
    fields.add_scalar("pressure", "kPa");

    std::vector<DataOutBase::Patch<dim - 1, dim>> patches;
    for (const Facets<dim> *const facets : {&surface, &wetted})
      for (const Facet<dim> &facet : *facets)
        {
          const bool                       is_wet = facets == &wetted;
          DataOutBase::Patch<dim - 1, dim> patch;
          patch.reference_cell =
            dim == 2 ? ReferenceCells::Line : ReferenceCells::Triangle;
          patch.patch_index = patches.size();
          patch.data.reinit(fields.n_components(), dim);
          for (unsigned int v = 0; v < dim; ++v)
            {
              const Point<dim> &x = facet.vertices[v];
              patch.vertices[v]   = x;
              patch.data(0, v)    = is_wet ? -1 : facet.on_face;
              patch.data(1, v)    = is_wet;
              patch.data(2, v) =
                is_wet ? water.unit_weight * std::max(water.level - x[1], 0.)
                       : 0.;
            }
          patches.push_back(std::move(patch));
        }
    fields.write(patches, time, path);
  }


  template void
  write_surface(const Facets<2> &,
                const Facets<2> &,
                const WaterParameters &,
                const double,
                const std::string &);
  template void
  write_surface(const Facets<3> &,
                const Facets<3> &,
                const WaterParameters &,
                const double,
                const std::string &);
} // namespace Waker
