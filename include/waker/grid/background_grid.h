// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_grid_background_grid_h
#define waker_grid_background_grid_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/point.h>

#include <waker/grid/node_exchange.h>

#include <array>
#include <memory>
#include <utility>

namespace dealii
{
  template <int dim, int spacedim>
  class DoFHandler;
}

namespace Waker
{
  using namespace dealii;

  template <int dim>
  class NearCells;

  /**
   * The uniform background grid: cubic cells of one size, the nodes of which
   * are those of deal.II's vector-valued Q1 elements.
   *
   * The box [lower, upper] that the user gives is surrounded by a margin of
   * one layer of cells, so that the support domain of a point near a fixed
   * base or a wall keeps its partition of unity.
   *
   * Nodes are numbered lexicographically (x runs fastest), margin included,
   * and the degrees of freedom are renumbered to match: component c of node i
   * is dof `dim * i + c`. Every look-up is therefore arithmetic, O(1).
   */
  template <int dim>
  class BackgroundGrid
  {
  public:
    using Index = std::array<int, dim>;

    static constexpr unsigned int margin = 1;

    /**
     * @param lower, upper corners of the box (m); upper - lower must be a
     *        multiple of the cell size in each direction
     * @param cell_size h (m)
     * @param communicator of this realisation
     * @throws UserError (Grid/...) if the box is empty or not a multiple of h
     */
    BackgroundGrid(const Point<dim> &lower,
                   const Point<dim> &upper,
                   const double      cell_size,
                   const MPI_Comm    communicator);

    /**
     * A window of another grid: those nodes of it that one of several ranks has
     * to do with, numbered like a grid of their own. The user's box remains
     * that of the whole grid.
     *
     * @param first lattice index in `whole` of the window's node 0
     * @param n_nodes per direction
     */
    BackgroundGrid(const BackgroundGrid                &whole,
                   const Index                         &first,
                   const std::array<unsigned int, dim> &n_nodes);

    ~BackgroundGrid();

    double
    cell_size() const
    {
      return h;
    }

    /// 1 / h, for hot loops.
    double
    inverse_cell_size() const
    {
      return inverse_h;
    }

    /// Corners of the user's box, without the margin (m).
    const Point<dim> &
    lower_corner() const
    {
      return lower;
    }

    const Point<dim> &
    upper_corner() const
    {
      return upper;
    }

    /// Position of node 0, the outermost corner of the margin (m).
    const Point<dim> &
    origin() const
    {
      return node_origin;
    }

    /// That of node 0 of the whole grid: what places are measured from, so
    /// that a point has the same weights in every window.
    const Point<dim> &
    lattice_origin() const
    {
      return whole_origin;
    }

    /// Number of nodes in each direction, margin included.
    const std::array<unsigned int, dim> &
    n_nodes_per_direction() const
    {
      return n_nodes_1d;
    }

    /// Those of the whole grid.
    const std::array<unsigned int, dim> &
    lattice_nodes_per_direction() const
    {
      return n_whole_1d;
    }

    unsigned int
    n_nodes() const
    {
      return n_nodes_total;
    }

    unsigned int
    n_dofs() const
    {
      return dim * n_nodes_total;
    }

    unsigned int
    n_cells() const
    {
      return n_cells_total;
    }

    /// Distance in node numbers between neighbours in direction d.
    unsigned int
    stride(const unsigned int d) const
    {
      return strides[d];
    }

    unsigned int
    node(const Index &index) const
    {
      unsigned int n = 0;
      for (unsigned int d = 0; d < dim; ++d)
        n += strides[d] * index[d];
      return n;
    }

    Index
    node_index(const unsigned int node) const
    {
      Index        index;
      unsigned int rest = node;
      for (int d = dim - 1; d >= 0; --d)
        {
          index[d] = rest / strides[d];
          rest -= index[d] * strides[d];
        }
      return index;
    }

    Point<dim>
    node_position(const unsigned int node) const
    {
      const Index index = node_index(node);
      Point<dim>  x     = whole_origin;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] += h * (first_node[d] + index[d]);
      return x;
    }

    /// Lattice index of the cell that holds x; a cell has the index of its
    /// lower left node. Not checked against the grid's extent.
    Index
    cell_index(const Point<dim> &x) const;

    /// The same, of the whole grid's nearest cell if x is off it.
    Index
    nearest_cell(const Point<dim> &x) const;

    /// Is the cell, with all its nodes, in this window?
    bool
    has_cell(const Index &cell) const
    {
      for (unsigned int d = 0; d < dim; ++d)
        if (cell[d] < 0 || cell[d] + 1 >= static_cast<int>(n_nodes_1d[d]))
          return false;
      return true;
    }

    /// Is it this rank's own?
    bool
    owns_cell(const Index &cell) const
    {
      return has_cell(cell) && node_exchange->owns(node(cell));
    }

    /// Is x, with `clearance` (m) on all sides, inside grid and margin? In a
    /// window: inside the whole grid and its margin.
    bool
    contains(const Point<dim> &x, const double clearance = 0.) const;

    /// deal.II's view of it: made when it is first asked for, as nothing that a
    /// step needs takes so much memory.
    const DoFHandler<dim, dim> &
    dof_handler() const;

    /// Lattice index in the whole grid of node 0: not 0 in a window.
    const Index &
    offset() const
    {
      return first_node;
    }

    /// What the ranks tell each other of the nodes.
    const NodeExchange &
    exchange() const
    {
      return *node_exchange;
    }

    /// What they tell each other of points near their cells. In a window only:
    /// on one rank, which has all points, there is none.
    const NearCells<dim> &
    near_cells() const
    {
      return *cells_of_others;
    }

    /// For a window.
    void
    set_exchange(std::shared_ptr<const NodeExchange>   exchange,
                 std::shared_ptr<const NearCells<dim>> near)
    {
      node_exchange   = std::move(exchange);
      cells_of_others = std::move(near);
    }

    MPI_Comm
    communicator() const
    {
      return mpi_communicator;
    }

  private:
    Point<dim>                    lower;
    Point<dim>                    upper;
    Point<dim>                    node_origin;
    Point<dim>                    whole_origin;
    double                        h;
    double                        inverse_h;
    std::array<unsigned int, dim> n_nodes_1d;
    std::array<unsigned int, dim> n_whole_1d;
    std::array<unsigned int, dim> strides;
    unsigned int                  n_nodes_total;
    unsigned int                  n_cells_total;
    MPI_Comm                      mpi_communicator;
    Index                         first_node = {};

    std::shared_ptr<const NodeExchange>   node_exchange;
    std::shared_ptr<const NearCells<dim>> cells_of_others; // in a window

    struct DealII;
    mutable std::unique_ptr<DealII> deal_ii; // null until it is asked for
  };
} // namespace Waker

#endif
