// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/loads/tractions.h>
#include <waker/output/traction_writer.h>

#include "vtu.h"

namespace Waker
{
  template <int dim>
  std::string
  write_tractions(const Tractions<dim> &tractions,
                  const double          time,
                  const std::string    &path)
  {
    VtuFile file(dim == 2 ? VtuFile::Cell::line : VtuFile::Cell::triangle);
    file.add_scalar("number", "", VtuFile::Type::number);
    file.add_vector("traction", "kPa");
    file.add_scalar("pressure", "kPa");
    for (std::size_t i = 0; i < tractions.size(); ++i)
      {
        const Facets<dim> &facets = *tractions.view(i).facets;
        for (std::size_t k = 0; k < facets.size(); ++k)
          for (const Point<dim> &x : facets[k].vertices)
            {
              const Tensor<1, dim> q = tractions.value(i, k, x);
              file.add_point(x);
              file.add_value(static_cast<double>(i));
              file.add_value(q);
              file.add_value(-(q * facets[k].normal));
            }
      }
    return file.write(time, path);
  }


  template std::string
  write_tractions<2>(const Tractions<2> &, const double, const std::string &);
  template std::string
  write_tractions<3>(const Tractions<3> &, const double, const std::string &);
} // namespace Waker
