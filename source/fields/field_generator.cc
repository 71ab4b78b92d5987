// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/fields/cholesky_field.h>
#include <waker/fields/circulant_embedding.h>
#include <waker/fields/field_generator.h>
#include <waker/fields/local_average_subdivision.h>

namespace Waker
{
  std::unique_ptr<FieldGenerator>
  make_field_generator(const Generator     method,
                       const FieldLattice &lattice,
                       const Correlation  &correlation,
                       const std::string  &path)
  {
    switch (method)
      {
        case Generator::circulant_embedding:
          return std::make_unique<CirculantEmbedding>(lattice,
                                                      correlation,
                                                      path);
        case Generator::local_average_subdivision:
          return std::make_unique<LocalAverageSubdivision>(lattice,
                                                           correlation,
                                                           path);
        case Generator::cholesky:
          return std::make_unique<CholeskyField>(lattice, correlation, path);
      }
    AssertThrow(false, dealii::ExcInternalError());
    return nullptr;
  }
} // namespace Waker
