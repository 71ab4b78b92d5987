// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/fields/cholesky_field.h>
#include <waker/fields/circulant_embedding.h>
#include <waker/fields/field_generator.h>
#include <waker/fields/local_average_subdivision.h>

namespace Waker
{
  std::unique_ptr<FieldGenerator>
  make_field_generator(const std::string  &method,
                       const FieldLattice &lattice,
                       const Correlation  &correlation,
                       const std::string  &path)
  {
    if (method == "circulant embedding")
      return std::make_unique<CirculantEmbedding>(lattice, correlation, path);
    if (method == "local average subdivision")
      return std::make_unique<LocalAverageSubdivision>(lattice,
                                                       correlation,
                                                       path);
    if (method == "Cholesky")
      return std::make_unique<CholeskyField>(lattice, correlation, path);
    throw UserError(path + "/Generator",
                    "is '" + method + "'",
                    "circulant embedding, local average subdivision or "
                    "Cholesky");
  }
} // namespace Waker
