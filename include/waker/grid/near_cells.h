// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_grid_near_cells_h
#define waker_grid_near_cells_h

#include <waker/grid/background_grid.h>
#include <waker/grid/cell_owners.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace Waker
{
  /**
   * What the ranks of one realisation have to tell each other of points that
   * lie near the cells of others: who sees the surroundings of its own points
   * needs no more than those. Which ranks have cells within some distance of a
   * cell is found once, and kept until cells are dealt out anew.
   */
  template <int dim>
  class NearCells
  {
  public:
    /// @param whole the grid; must outlive this object
    NearCells(const BackgroundGrid<dim>        &whole,
              std::shared_ptr<const CellOwners> owners,
              const MPI_Comm                    communicator);

    ~NearCells();

    /**
     * Each rank is told of the points of others that may lie within a distance
     * of its own points, or of its own cells; of some that lie up to two cells
     * further, too. Collective.
     *
     * @param positions of the own points. They lie in own cells, or some cells
     *        away, if they have moved since they went home.
     * @param reach the distance in each direction (m); the largest of all ranks
     *        counts
     * @param tell what is told of point p; false: nothing
     * @return what the others tell, rank by rank, of each in the order of its
     *         points
     */
    template <typename T>
    std::vector<T>
    gather(const std::vector<Point<dim>>                 &positions,
           const double                                   reach,
           const std::function<bool(std::size_t p, T &t)> tell) const
    {
      static_assert(std::is_trivially_copyable<T>::value,
                    "this is copied byte by byte");
      const Plan                 &plan = prepare(positions, reach);
      std::vector<std::vector<T>> to_send(plan.neighbours.size());
      for (std::size_t p = 0; p < positions.size(); ++p)
        {
          const std::size_t cell  = place(plan, positions[p]);
          const auto        begin = plan.begins[cell];
          const auto        end   = plan.begins[cell + 1];
          T                 t;
          if (begin < end && tell(p, t))
            for (auto k = begin; k < end; ++k)
              to_send[plan.lists[k]].push_back(t);
        }
      std::vector<T>            received;
      std::vector<const void *> data;
      std::vector<std::size_t>  n;
      for (const std::vector<T> &of_one : to_send)
        {
          data.push_back(of_one.data());
          n.push_back(of_one.size());
        }
      exchange(plan, sizeof(T), data, n, [&](const std::size_t n_more) {
        received.resize(received.size() + n_more);
        return static_cast<void *>(received.data() + received.size() - n_more);
      });
      return received;
    }

    /// What this rank has sent so far.
    const NodeExchange::Traffic &
    traffic() const
    {
      return sent;
    }

  private:
    using Index = typename BackgroundGrid<dim>::Index;

    /// A box of cells of the whole grid.
    struct CellBox
    {
      Index       first;
      Index       n;
      std::size_t size;
    };

    /// Who is told of what lies in which cell.
    struct Plan
    {
      CellBox                    box;        // own cells, and some around
      std::vector<std::uint32_t> begins;     // of each cell, in lists
      std::vector<std::uint32_t> lists;      // numbers of neighbours
      std::vector<unsigned int>  neighbours; // ranks: who tells, and is told
    };

    CellBox
    box_around(const CellBox &box, const int reach) const;

    /// The plan for these points. Collective.
    const Plan &
    prepare(const std::vector<Point<dim>> &positions, const double reach) const;

    Plan
    make_plan(const int reach, const int excursion) const;

    /// The ranks of the cells of a box.
    std::vector<std::uint32_t>
    ranks_in(const CellBox &box) const;

    /// How many cells the farthest point is from the own cells.
    int
    excursion(const std::vector<Point<dim>> &positions) const;

    /// Of the cell that holds x, in the plan's box.
    std::size_t
    place(const Plan &plan, const Point<dim> &x) const
    {
      return place(plan.box, whole->nearest_cell(x));
    }

    static std::size_t
    place(const CellBox &box, const Index &cell)
    {
      std::size_t number = cell[dim - 1] - box.first[dim - 1];
      for (int d = dim - 2; d >= 0; --d)
        number = number * box.n[d] + (cell[d] - box.first[d]);
      return number;
    }

    /// To each neighbour its values, `size` bytes each, and from it others.
    void
    exchange(const Plan                                 &plan,
             const std::size_t                           size,
             const std::vector<const void *>            &data,
             const std::vector<std::size_t>             &n,
             const std::function<void *(std::size_t n)> &make_room) const;

    const BackgroundGrid<dim>        *whole;
    std::shared_ptr<const CellOwners> owners;
    MPI_Comm                          communicator;
    unsigned int                      rank;
    CellBox                           own;    // around the own cells
    std::vector<unsigned char>        is_own; // of its cells

    mutable std::map<std::pair<int, int>, Plan> plans; // by reach, excursion
    mutable NodeExchange::Traffic               sent;
  };
} // namespace Waker

#endif
