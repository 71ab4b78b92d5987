// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/utilities.h>

#include <waker/base/ranks.h>
#include <waker/grid/near_cells.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace Waker
{
  namespace
  {
    constexpr int tag = 4713;


    /// Cells within `reach` cells of one that is set, in each direction, are
    /// set.
    template <std::size_t dim>
    void
    dilate(const std::array<int, dim> &n,
           const int                   reach,
           std::vector<unsigned char> &cells)
    {
      std::size_t stride = 1;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const int                  length = n[d];
          std::vector<unsigned char> line(length);
          for (std::size_t first = 0; first < cells.size(); ++first)
            {
              if (first / stride % length != 0)
                continue;
              std::fill(line.begin(), line.end(), 0);
              int since = reach + 1; // the last one set
              for (int i = 0; i < length; ++i)
                {
                  since   = cells[first + i * stride] ? 0 : since + 1;
                  line[i] = since <= reach;
                }
              since = reach + 1;
              for (int i = length - 1; i >= 0; --i)
                {
                  since = cells[first + i * stride] ? 0 : since + 1;
                  line[i] |= since <= reach;
                }
              for (int i = 0; i < length; ++i)
                cells[first + i * stride] = line[i];
            }
          stride *= length;
        }
    }
  } // namespace


  template <int dim>
  NearCells<dim>::NearCells(const BackgroundGrid<dim>        &whole,
                            std::shared_ptr<const CellOwners> the_owners,
                            const MPI_Comm                    communicator)
    : whole(&whole)
    , owners(std::move(the_owners))
    , communicator(communicator)
    , rank(Utilities::MPI::this_mpi_process(communicator))
  {
    Index first, last;
    first.fill(std::numeric_limits<int>::max());
    last.fill(-1);
    const auto for_all_own = [&](const auto &visit) {
      for (const CellOwners::Interval &interval : owners->intervals)
        if (interval.rank == rank)
          for (std::size_t cell = interval.begin; cell < interval.end; ++cell)
            visit(whole.node_index(cell));
    };
    for_all_own([&](const Index &index) {
      for (unsigned int d = 0; d < dim; ++d)
        {
          first[d] = std::min(first[d], index[d]);
          last[d]  = std::max(last[d], index[d]);
        }
    });
    own.first = first;
    own.size  = 1;
    for (unsigned int d = 0; d < dim; ++d)
      {
        if (last[d] < 0)
          own.first[d] = 0; // no cell
        own.n[d] = last[d] < 0 ? 0 : last[d] - first[d] + 1;
        own.size *= own.n[d];
      }
    is_own.assign(own.size, 0);
    for_all_own([&](const Index &index) { is_own[place(own, index)] = 1; });
  }


  template <int dim>
  NearCells<dim>::~NearCells() = default;


  template <int dim>
  typename NearCells<dim>::CellBox
  NearCells<dim>::box_around(const CellBox &box, const int reach) const
  {
    if (box.size == 0)
      return box;
    CellBox larger;
    larger.size = 1;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const int n_all = whole->n_nodes_per_direction()[d];
        const int end   = std::min(box.first[d] + box.n[d] + reach, n_all);
        larger.first[d] = std::max(box.first[d] - reach, 0);
        larger.n[d]     = end - larger.first[d];
        larger.size *= larger.n[d];
      }
    return larger;
  }


  template <int dim>
  int
  NearCells<dim>::excursion(const std::vector<Point<dim>> &positions) const
  {
    int farthest = 0;
    for (const Point<dim> &x : positions)
      {
        const Index cell   = whole->nearest_cell(x);
        const auto  is_own = [&](const Index &index) {
          for (unsigned int d = 0; d < dim; ++d)
            if (index[d] < own.first[d] || index[d] >= own.first[d] + own.n[d])
              return false;
          return this->is_own[place(own, index)] != 0;
        };
        // In boxes around it: nearly always it is one's own. What is further
        // off is about to leave the grid; for it all ranks are near.
        constexpr int farthest_sought = 16;
        bool          found           = is_own(cell);
        for (int reach = 1; !found; ++reach)
          {
            if (reach > farthest_sought)
              {
                for (const unsigned int n : whole->n_nodes_per_direction())
                  farthest = std::max(farthest, static_cast<int>(n));
                break;
              }
            const unsigned int n = 2 * reach + 1;
            for (unsigned int k = 0; k < Utilities::pow(n, dim) && !found; ++k)
              {
                Index        index;
                unsigned int rest = k;
                for (unsigned int d = 0; d < dim; ++d)
                  {
                    index[d] = cell[d] - reach + static_cast<int>(rest % n);
                    rest /= n;
                  }
                found = is_own(index);
              }
            farthest = std::max(farthest, reach);
          }
      }
    return farthest;
  }


  template <int dim>
  const typename NearCells<dim>::Plan &
  NearCells<dim>::prepare(const std::vector<Point<dim>> &positions,
                          const double                   reach) const
  {
    double largest[] = {reach, static_cast<double>(excursion(positions))};
    MPI_Allreduce(MPI_IN_PLACE, largest, 2, MPI_DOUBLE, MPI_MAX, communicator);
    ++sent.reductions;
    sent.bytes += sizeof(largest);
    // So far the nearest places of two cells may be from each other, and where
    // the other rank's points are that have left its cells.
    const int away    = static_cast<int>(largest[1]);
    const int n_cells = static_cast<int>(
      std::min(std::floor(largest[0] * whole->inverse_cell_size() + 1e-9),
               1e9));
    const std::pair<int, int> key = {n_cells + 1 + away, away};
    const auto                old = plans.find(key);
    if (old != plans.end())
      return old->second;
    return plans.emplace(key, make_plan(key.first, key.second)).first->second;
  }


  template <int dim>
  std::vector<std::uint32_t>
  NearCells<dim>::ranks_in(const CellBox &box) const
  {
    std::vector<std::uint32_t> ranks(box.size);
    for (std::size_t k = 0; k < box.size; k += box.n[0])
      {
        Index       index = box.first;
        std::size_t rest  = k / box.n[0];
        for (unsigned int d = 1; d < dim; ++d)
          {
            index[d] += rest % box.n[d];
            rest /= box.n[d];
          }
        const std::size_t begin    = whole->node(index);
        auto              interval = owners->interval_of(begin);
        for (int i = 0; i < box.n[0]; ++i)
          {
            if (begin + i >= interval->end)
              ++interval;
            ranks[k + i] = interval->rank;
          }
      }
    return ranks;
  }


  template <int dim>
  typename NearCells<dim>::Plan
  NearCells<dim>::make_plan(const int reach, const int excursion) const
  {
    // Reaches beyond the grid are no farther than that.
    int longest = 0;
    for (unsigned int d = 0; d < dim; ++d)
      longest = std::max<int>(longest, whole->lattice_nodes_per_direction()[d]);
    const int far = std::min(reach, longest);

    Plan plan;
    plan.box = box_around(own, excursion);
    plan.begins.assign(plan.box.size + 2, 0);
    if (own.size == 0)
      return plan;
    const CellBox                    around = box_around(plan.box, far);
    const std::vector<std::uint32_t> ranks  = ranks_in(around);
    std::vector<unsigned char>       inner(around.size), cells(around.size);
    for (std::size_t k = 0; k < around.size; ++k)
      inner[k] = ranks[k] == rank;
    dilate(around.n, excursion, inner);

    std::vector<std::pair<std::uint32_t, std::uint32_t>> entries;
    std::set<std::uint32_t> others(ranks.begin(), ranks.end());
    others.erase(rank);
    for (const std::uint32_t other : others)
      {
        for (std::size_t k = 0; k < around.size; ++k)
          cells[k] = ranks[k] == other;
        dilate(around.n, far, cells);
        const std::size_t n_before = entries.size();
        for (std::size_t k = 0; k < around.size; ++k)
          if (cells[k] && inner[k])
            {
              Index       index = around.first;
              std::size_t rest  = k;
              for (unsigned int d = 0; d < dim; ++d)
                {
                  index[d] += rest % around.n[d];
                  rest /= around.n[d];
                }
              entries.emplace_back(place(plan.box, index),
                                   plan.neighbours.size());
            }
        if (entries.size() > n_before)
          plan.neighbours.push_back(other);
      }
    std::sort(entries.begin(), entries.end());
    for (const auto &[cell, neighbour] : entries)
      {
        ++plan.begins[cell + 1];
        plan.lists.push_back(neighbour);
      }
    for (std::size_t k = 1; k < plan.begins.size(); ++k)
      plan.begins[k] += plan.begins[k - 1];
    return plan;
  }


  template <int dim>
  void
  NearCells<dim>::exchange(
    const Plan                                 &plan,
    const std::size_t                           size,
    const std::vector<const void *>            &data,
    const std::vector<std::size_t>             &n,
    const std::function<void *(std::size_t n)> &make_room) const
  {
    const MpiBytes           value(size);
    std::vector<MPI_Request> requests(plan.neighbours.size());
    for (std::size_t k = 0; k < plan.neighbours.size(); ++k)
      {
        MPI_Isend(data[k],
                  static_cast<int>(n[k]),
                  value.type,
                  plan.neighbours[k],
                  tag,
                  communicator,
                  &requests[k]);
        ++sent.messages;
        sent.bytes += n[k] * size;
      }
    for (const unsigned int neighbour : plan.neighbours)
      {
        MPI_Status status;
        MPI_Probe(neighbour, tag, communicator, &status);
        int n_received = 0;
        MPI_Get_count(&status, value.type, &n_received);
        MPI_Recv(make_room(n_received),
                 n_received,
                 value.type,
                 neighbour,
                 tag,
                 communicator,
                 MPI_STATUS_IGNORE);
      }
    MPI_Waitall(requests.size(), requests.data(), MPI_STATUSES_IGNORE);
  }


  template class NearCells<2>;
  template class NearCells<3>;
} // namespace Waker
