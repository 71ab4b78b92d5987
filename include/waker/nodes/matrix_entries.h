// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_nodes_matrix_entries_h
#define waker_nodes_matrix_entries_h

#include <deal.II/base/array_view.h>

#include <waker/nodes/nodal_vector.h>

#include <vector>

namespace Waker
{
  /**
   * What takes the entries of a matrix over the nodes: a sum of small matrices
   * of few nodes each.
   */
  class MatrixEntries
  {
  public:
    /// @param n_components of a node
    MatrixEntries(const unsigned int n_dofs, const unsigned int n_components)
      : n_dofs(n_dofs)
      , n_components(n_components)
    {}

    virtual ~MatrixEntries() = default;

    /// @param nodes n of them
    /// @param matrix rows of the nodes' dofs, component after component of the
    ///        first node, then of the next: (n n_components)^2 entries, kN/m
    virtual void
    add(const ArrayView<const unsigned int> &nodes,
        const ArrayView<const double>       &matrix) = 0;

    /// One of a single dof.
    void
    add_diagonal(const unsigned int dof, const double entry)
    {
      const unsigned int node = dof / n_components, c = dof % n_components;
      double             matrix[9]   = {};
      matrix[(n_components + 1) * c] = entry;
      add({&node, 1}, {matrix, n_components * n_components});
    }

    /// One that is known by its diagonal only.
    /// @param A has an add_diagonal(NodalVector &)
    template <typename Matrix>
    void
    add_diagonal_of(const Matrix &A)
    {
      NodalVector diagonal(n_dofs);
      A.add_diagonal(diagonal);
      for (unsigned int dof = 0; dof < diagonal.locally_owned_size(); ++dof)
        if (const double entry = diagonal.begin()[dof]; entry != 0.)
          add_diagonal(dof, entry);
    }

  private:
    unsigned int n_dofs, n_components;
  };
} // namespace Waker

#endif
