// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_node_matrix_h
#define waker_mechanics_node_matrix_h

#include <waker/grid/background_grid.h>
#include <waker/nodes/matrix_entries.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace Waker
{
  /**
   * A matrix over the nodes of the grid that mostly couples neighbours: 3^dim
   * blocks a node, and single entries for what reaches further. On several
   * ranks each adds what it has, and gets the rows of its own nodes.
   *
   * Nodes with an equation are numbered rank by rank; all dim dofs of such a
   * node have a row, n_components by n_components, as algebraic multigrid
   * wants it. A dof without an equation has its diagonal alone.
   */
  template <int dim>
  class NodeMatrix : public MatrixEntries
  {
  public:
    /**
     * Collective.
     * @param grid must outlive this object
     * @param is_equation of each dof; that of the owner counts
     */
    NodeMatrix(const BackgroundGrid<dim>        &grid,
               const std::vector<unsigned char> &is_equation);

    /// Entries of dofs without an equation are left out.
    void
    add(const ArrayView<const unsigned int> &nodes,
        const ArrayView<const double>       &matrix) override;

    /// All has been added: rows of others go to their owners. Collective.
    void
    compress();

    /// This rank's own nodes with an equation, in the order of their rows.
    const std::vector<unsigned int> &
    own_nodes() const
    {
      return owned;
    }

    /// Number of the first own row, and of rows on all ranks.
    std::uint64_t
    first_row() const
    {
      return dim * first;
    }

    std::uint64_t
    n_rows() const
    {
      return dim * n_all;
    }

    /// A row as it is stored: columns ascending, none twice.
    struct Row
    {
      std::vector<std::uint64_t> columns;
      std::vector<double>        values;
      double                     diagonal = 0.;
    };

    /// Row of component c of the k-th own node; without an equation empty.
    void
    get_row(const unsigned int k, const unsigned int c, Row &row) const;

  private:
    static constexpr unsigned int n_neighbours = dim == 2 ? 9 : 27;

    struct Entry
    {
      std::uint64_t row, column;
      double        value;

      bool
      operator<(const Entry &other) const
      {
        return row != other.row ? row < other.row : column < other.column;
      }
    };

    bool
    has_equation(const unsigned int node, const unsigned int c) const
    {
      return equations[node] >> c & 1;
    }

    /// Which of the neighbours of a node another one is; -1: none.
    int
    neighbour(const unsigned int node, const unsigned int other) const;

    /// The node's place among the stored ones, and its global number.
    const BackgroundGrid<dim>    *grid;
    std::vector<int>              place; // -1: none
    std::vector<std::uint64_t>    number;
    std::vector<unsigned char>    equations; // one bit a component
    std::vector<unsigned int>     owned, foreign;
    std::uint64_t                 first = 0, n_all = 0;
    std::vector<std::uint64_t>    first_of_rank;
    std::array<int, n_neighbours> distance; // in node numbers
    std::vector<double>           blocks;
    std::vector<Entry>            others; // what is in no block
  };
} // namespace Waker

#endif
