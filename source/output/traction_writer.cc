// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/boundary/tractions.h>
#include <waker/output/traction_writer.h>

#include "vtu.h"

namespace Waker
{
  template <int dim>
  void
  write_tractions(const Tractions<dim> &tractions,
                  const double          time,
                  const std::string    &path)
  {
    VtuFields fields;
    fields.add_scalar("number", "");
    fields.add_vector("traction", "kPa", dim);
    fields.add_scalar("pressure", "kPa");

    std::vector<DataOutBase::Patch<dim - 1, dim>> patches;
    for (std::size_t i = 0; i < tractions.size(); ++i)
      {
        const typename Tractions<dim>::View view = tractions.view(i);
        for (const Facet<dim> &facet : *view.facets)
          {
            DataOutBase::Patch<dim - 1, dim> patch;
            patch.reference_cell =
              dim == 2 ? ReferenceCells::Line : ReferenceCells::Triangle;
            patch.patch_index = patches.size();
            patch.data.reinit(fields.n_components(), dim);
            for (unsigned int v = 0; v < dim; ++v)
              {
                const Point<dim>    &x = facet.vertices[v];
                const Tensor<1, dim> q = view.traction->value(facet.normal, x);
                patch.vertices[v]      = x;
                unsigned int c         = 0;
                const auto   add       = [&](const double value) {
                  patch.data(c++, v) = static_cast<float>(value);
                };
                add(static_cast<double>(i));
                for (unsigned int d = 0; d < dim; ++d)
                  add(q[d]);
                add(-(q * facet.normal));
              }
            patches.push_back(std::move(patch));
          }
      }
    fields.write(patches, time, path);
  }


  template void
  write_tractions<2>(const Tractions<2> &, const double, const std::string &);
  template void
  write_tractions<3>(const Tractions<3> &, const double, const std::string &);
} // namespace Waker
