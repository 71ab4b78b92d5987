// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_grid_partition_h
#define waker_grid_partition_h

#include <waker/grid/background_grid.h>
#include <waker/grid/cell_owners.h>
#include <waker/grid/near_cells.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace Waker
{
  /**
   * The nodes of a background grid, dealt out to the ranks of a realisation:
   * to each rank cells of a p4est forest (deal.II's
   * parallel::distributed::Triangulation) along its space-filling curve. A cell
   * has the number of its lower left node; who owns the cell has the points in
   * it, and the node. A rank may own nothing.
   *
   * All functions but the const ones are collective.
   */
  template <int dim>
  class Partition
  {
  public:
    /// Cells dealt out evenly.
    /// @param whole the grid; must outlive this object
    explicit Partition(const BackgroundGrid<dim> &whole,
                       const MPI_Comm             communicator);

    ~Partition();

    /**
     * Deal them out anew, by what they cost.
     * @param positions of the points in this rank's cells; others do not count
     */
    void
    balance(const std::vector<Point<dim>> &positions);

    /// The rank that owns the cell with this lower left node of the whole grid.
    unsigned int
    owner(const std::size_t node) const;

    /// The owner of a point's cell; that of the nearest cell if it is off the
    /// grid.
    unsigned int
    owner(const Point<dim> &x) const;

    /// How far a window reaches beyond a rank's own nodes.
    struct Reach
    {
      int below, above;
    };

    /// A support domain reaches a node below its point's cell and one above.
    static constexpr Reach of_points = {1, 2};

    /// This rank's window: its own nodes, and those around them; by default all
    /// that the support domains of points in its cells may reach.
    std::unique_ptr<const BackgroundGrid<dim>>
    make_window(const Reach reach = of_points) const;

    /**
     * The values of all nodes, from their owners.
     * @param window of this rank
     * @param values of its nodes, `n_components` each
     * @param all out: of the nodes of the whole grid
     */
    void
    gather(const BackgroundGrid<dim> &window,
           const double              *values,
           const unsigned int         n_components,
           double                    *all) const;

    /// The other way, from an array that each rank has; without exchange.
    void
    restrict_to(const BackgroundGrid<dim> &window,
                const double              *all,
                const unsigned int         n_components,
                double                    *values) const;

    /// What this rank has sent of points near the cells of others.
    NodeExchange::Traffic
    traffic() const
    {
      NodeExchange::Traffic sum = sent_before;
      sum += near_cells->traffic();
      return sum;
    }

    /// How many nodes this rank owns.
    std::size_t
    n_owned() const;

  private:
    struct Forest;

    /// Ask the forest, and tell each other.
    void
    share();

    const BackgroundGrid<dim>            *whole;
    MPI_Comm                              communicator;
    unsigned int                          rank, n_ranks;
    std::unique_ptr<Forest>               forest;
    std::shared_ptr<const CellOwners>     owners;
    std::shared_ptr<const NearCells<dim>> near_cells;
    NodeExchange::Traffic sent_before;      // to near cells that are others now
    std::uint64_t         first_number = 0; // of this rank's own nodes
  };
} // namespace Waker

#endif
