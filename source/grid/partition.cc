// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>

#include <waker/grid/node_exchange.h>
#include <waker/grid/partition.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    /// Refinements of the forest's trees: few trees, as each rank knows all of
    /// them.
    constexpr unsigned int n_refinements = 3;

    /// What a point costs, and a cell without one.
    constexpr unsigned int point_weight = 16, cell_weight = 1;
  } // namespace


  template <int dim>
  struct Partition<dim>::Forest
  {
    explicit Forest(const MPI_Comm communicator)
      : triangulation(communicator)
    {}

    parallel::distributed::Triangulation<dim> triangulation;
  };


  namespace
  {
    /// The node of a cell's lower left corner; none beyond the grid's nodes,
    /// where the forest may reach.
    template <int dim, typename Cell>
    std::size_t
    node_of(const BackgroundGrid<dim> &grid, const Cell &cell)
    {
      const auto  index = grid.cell_index(cell->center());
      std::size_t node  = 0;
      for (unsigned int d = 0; d < dim; ++d)
        {
          if (index[d] >= static_cast<int>(grid.n_nodes_per_direction()[d]))
            return grid.n_nodes();
          node += std::size_t(grid.stride(d)) * index[d];
        }
      return node;
    }
  } // namespace


  template <int dim>
  Partition<dim>::Partition(const BackgroundGrid<dim> &whole,
                            const MPI_Comm             communicator)
    : whole(&whole)
    , communicator(communicator)
    , rank(Utilities::MPI::this_mpi_process(communicator))
    , n_ranks(Utilities::MPI::n_mpi_processes(communicator))
    , forest(std::make_unique<Forest>(communicator))
  {
    const double              size = whole.cell_size() * (1 << n_refinements);
    std::vector<unsigned int> n_trees(dim);
    Point<dim>                upper = whole.origin();
    for (unsigned int d = 0; d < dim; ++d)
      {
        const unsigned int n = whole.n_nodes_per_direction()[d];
        n_trees[d]           = (n + (1 << n_refinements) - 1) >> n_refinements;
        upper[d] += n_trees[d] * size;
      }
    GridGenerator::subdivided_hyper_rectangle(forest->triangulation,
                                              n_trees,
                                              whole.origin(),
                                              upper);
    forest->triangulation.refine_global(n_refinements);
    share();
  }


  template <int dim>
  Partition<dim>::~Partition() = default;


  template <int dim>
  void
  Partition<dim>::balance(const std::vector<Point<dim>> &positions)
  {
    // Of this rank's own cells, in the order of its own nodes.
    std::vector<unsigned int> n_points(n_owned(), 0);
    const auto                place = [&](const std::size_t node) {
      const CellOwners::Interval &interval = *owners->interval_of(node);
      return interval.rank == rank
                              ? static_cast<std::size_t>(interval.number - first_number +
                                          (node - interval.begin))
                              : n_points.size();
    };
    for (const Point<dim> &x : positions)
      {
        const std::size_t k = place(whole->node(whole->cell_index(x)));
        if (k < n_points.size())
          ++n_points[k];
      }

    auto &triangulation = forest->triangulation;
    const boost::signals2::scoped_connection weights =
      triangulation.signals.weight.connect(
        [&](const typename Triangulation<dim>::cell_iterator &cell,
            const auto /*status*/) -> unsigned int {
          const std::size_t node = node_of(*whole, cell);
          if (node == whole->n_nodes())
            return 0;
          const std::size_t k = place(node);
          return k < n_points.size() ? cell_weight + point_weight * n_points[k]
                                     : cell_weight;
        });
    triangulation.repartition();
    share();
  }


  template <int dim>
  void
  Partition<dim>::share()
  {
    std::vector<std::size_t> nodes;
    for (const auto &cell : forest->triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        if (const std::size_t node = node_of(*whole, cell);
            node < whole->n_nodes())
          nodes.push_back(node);
    std::sort(nodes.begin(), nodes.end());
    std::vector<std::uint64_t> ends; // begin, end, begin, end, ...
    for (const std::size_t node : nodes)
      if (!ends.empty() && ends.back() == node)
        ++ends.back();
      else
        {
          ends.push_back(node);
          ends.push_back(node + 1);
        }

    const std::vector<std::vector<std::uint64_t>> all =
      Utilities::MPI::all_gather(communicator, ends);
    auto          found     = std::make_shared<CellOwners>();
    auto         &intervals = found->intervals;
    std::uint64_t number    = 0;
    for (unsigned int r = 0; r < n_ranks; ++r)
      {
        if (r == rank)
          first_number = number;
        for (std::size_t k = 0; k < all[r].size(); k += 2)
          {
            intervals.push_back({all[r][k], all[r][k + 1], r, number});
            number += all[r][k + 1] - all[r][k];
          }
      }
    AssertThrow(number == whole->n_nodes(), ExcInternalError());
    std::sort(intervals.begin(),
              intervals.end(),
              [](const CellOwners::Interval &a, const CellOwners::Interval &b) {
                return a.begin < b.begin;
              });
    owners = std::move(found);
    if (near_cells != nullptr)
      sent_before += near_cells->traffic();
    near_cells =
      std::make_shared<const NearCells<dim>>(*whole, owners, communicator);
  }


  template <int dim>
  unsigned int
  Partition<dim>::owner(const std::size_t node) const
  {
    return owners->owner(node);
  }


  template <int dim>
  unsigned int
  Partition<dim>::owner(const Point<dim> &x) const
  {
    return owner(whole->node(whole->nearest_cell(x)));
  }


  template <int dim>
  std::size_t
  Partition<dim>::n_owned() const
  {
    std::size_t n = 0;
    for (const CellOwners::Interval &interval : owners->intervals)
      if (interval.rank == rank)
        n += interval.end - interval.begin;
    return n;
  }


  template <int dim>
  std::unique_ptr<const BackgroundGrid<dim>>
  Partition<dim>::make_window(const Reach reach) const
  {
    using Index     = typename BackgroundGrid<dim>::Index;
    const int below = reach.below, above = reach.above;

    // At least a stencil, of which nothing is owned.
    Index first, last;
    for (unsigned int d = 0; d < dim; ++d)
      {
        first[d] = whole->n_nodes_per_direction()[d];
        last[d]  = -1;
      }
    for (const CellOwners::Interval &interval : owners->intervals)
      if (interval.rank == rank)
        for (std::size_t node = interval.begin; node < interval.end; ++node)
          {
            const Index index = whole->node_index(node);
            for (unsigned int d = 0; d < dim; ++d)
              {
                first[d] = std::min(first[d], index[d]);
                last[d]  = std::max(last[d], index[d]);
              }
          }
    std::array<unsigned int, dim> n;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const int n_all = whole->n_nodes_per_direction()[d];
        if (last[d] < 0)
          first[d] = last[d] = 0;
        const int end = std::min(last[d] + above + 1, n_all);
        first[d]      = std::clamp(first[d] - below, 0, end - 1);
        n[d]          = end - first[d];
        // No direction has less than the nodes of a stencil.
        if (n[d] < 3)
          {
            first[d] = std::max(0, end - 3);
            n[d]     = std::min(3, n_all);
          }
      }

    auto window = std::make_unique<BackgroundGrid<dim>>(*whole, first, n);
    std::vector<unsigned int>  owned, foreign;
    std::vector<std::uint64_t> numbers;
    // 1: reached, 2: own
    std::vector<unsigned char> flags(window->n_nodes(), 0);
    for (const CellOwners::Interval &interval : owners->intervals)
      if (interval.rank == rank)
        for (std::size_t node = interval.begin; node < interval.end; ++node)
          {
            Index index = whole->node_index(node);
            for (unsigned int d = 0; d < dim; ++d)
              index[d] -= first[d];
            flags[window->node(index)] = 2;
            owned.push_back(window->node(index));
            Index low, high;
            for (unsigned int d = 0; d < dim; ++d)
              {
                low[d] = std::max(index[d] - below, 0);
                high[d] =
                  std::min(index[d] + above, static_cast<int>(n[d]) - 1);
              }
            Index i = low;
            while (i[dim - 1] <= high[dim - 1])
              {
                unsigned char &flag = flags[window->node(i)];
                flag                = std::max<unsigned char>(flag, 1);
                for (unsigned int d = 0; d < dim; ++d)
                  {
                    if (++i[d] <= high[d] || d == dim - 1)
                      break;
                    i[d] = low[d];
                  }
              }
          }
    for (unsigned int node = 0; node < window->n_nodes(); ++node)
      if (flags[node] == 1)
        {
          Index index = window->node_index(node);
          for (unsigned int d = 0; d < dim; ++d)
            index[d] += first[d];
          const std::size_t there    = whole->node(index);
          const auto        interval = owners->interval_of(there);
          foreign.push_back(node);
          numbers.push_back(interval->number + (there - interval->begin));
        }
    window->set_exchange(std::make_shared<const NodeExchange>(communicator,
                                                              window->n_nodes(),
                                                              owned,
                                                              foreign,
                                                              first_number,
                                                              whole->n_nodes(),
                                                              numbers),
                         near_cells);
    return window;
  }


  template <int dim>
  void
  Partition<dim>::gather(const BackgroundGrid<dim> &window,
                         const double *const        values,
                         const unsigned int         n_components,
                         double *const              all) const
  {
    std::vector<int> n(n_ranks, 0), begin(n_ranks, 0);
    for (const CellOwners::Interval &interval : owners->intervals)
      n[interval.rank] += n_components * (interval.end - interval.begin);
    for (unsigned int r = 1; r < n_ranks; ++r)
      begin[r] = begin[r - 1] + n[r - 1];
    std::vector<double> mine, received(begin.back() + n.back());
    mine.reserve(n[rank]);
    for (const CellOwners::Interval &interval : owners->intervals)
      if (interval.rank == rank)
        for (std::size_t node = interval.begin; node < interval.end; ++node)
          {
            auto index = whole->node_index(node);
            for (unsigned int d = 0; d < dim; ++d)
              index[d] -= window.offset()[d];
            const double *const value =
              values + std::size_t(n_components) * window.node(index);
            mine.insert(mine.end(), value, value + n_components);
          }
    MPI_Allgatherv(mine.data(),
                   mine.size(),
                   MPI_DOUBLE,
                   received.data(),
                   n.data(),
                   begin.data(),
                   MPI_DOUBLE,
                   communicator);
    // Each rank's intervals are ascending, as they are here.
    for (const CellOwners::Interval &interval : owners->intervals)
      std::copy_n(received.data() + n_components * interval.number,
                  n_components * (interval.end - interval.begin),
                  all + n_components * interval.begin);
  }


  template <int dim>
  void
  Partition<dim>::restrict_to(const BackgroundGrid<dim> &window,
                              const double *const        all,
                              const unsigned int         n_components,
                              double *const              values) const
  {
    const auto n_lines = window.n_nodes() / window.n_nodes_per_direction()[0];
    const auto length  = window.n_nodes_per_direction()[0];
    for (unsigned int line = 0; line < n_lines; ++line)
      {
        auto index = window.node_index(line * length);
        for (unsigned int d = 0; d < dim; ++d)
          index[d] += window.offset()[d];
        std::copy_n(all + std::size_t(n_components) * whole->node(index),
                    std::size_t(n_components) * length,
                    values + std::size_t(n_components) * line * length);
      }
  }


  template class Partition<2>;
  template class Partition<3>;
} // namespace Waker
