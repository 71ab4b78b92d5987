// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_nodes_nodal_vector_h
#define waker_nodes_nodal_vector_h

#include <deal.II/lac/la_parallel_vector.h>

namespace Waker
{
  using namespace dealii;

  /// A vector over the degrees of freedom of the background grid: component c
  /// of node i stands at `dim * i + c` (see BackgroundGrid).
  using NodalVector = LinearAlgebra::distributed::Vector<double>;
} // namespace Waker

#endif
