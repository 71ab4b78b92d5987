// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <waker/mechanics/node_matrix.h>

#include <algorithm>
#include <map>

namespace Waker
{
  template <int dim>
  NodeMatrix<dim>::NodeMatrix(const BackgroundGrid<dim>        &grid,
                              const std::vector<unsigned char> &is_equation)
    : MatrixEntries(grid.n_dofs(), dim)
    , grid(&grid)
    , place(grid.n_nodes(), -1)
    , number(grid.n_nodes(), 0)
    , equations(grid.n_nodes(), 0)
  {
    const NodeExchange &ranks = grid.exchange();
    for (unsigned int node = 0; node < grid.n_nodes(); ++node)
      if (ranks.owns(node))
        {
          for (unsigned int c = 0; c < dim; ++c)
            equations[node] |= (is_equation[dim * node + c] != 0) << c;
          if (equations[node] != 0)
            {
              place[node] = owned.size();
              owned.push_back(node);
            }
        }
    const std::vector<std::uint64_t> sizes =
      Utilities::MPI::all_gather(ranks.communicator(),
                                 static_cast<std::uint64_t>(owned.size()));
    first_of_rank = {0};
    for (const std::uint64_t size : sizes)
      first_of_rank.push_back(first_of_rank.back() + size);
    first =
      first_of_rank[Utilities::MPI::this_mpi_process(ranks.communicator())];
    n_all = first_of_rank.back();

    // Owners tell the numbers, as the exchange takes them: counted from 1.
    std::vector<double> told(2 * grid.n_nodes(), 0.);
    for (std::size_t k = 0; k < owned.size(); ++k)
      {
        number[owned[k]]       = first + k;
        told[2 * owned[k]]     = first + k + 1;
        told[2 * owned[k] + 1] = equations[owned[k]];
      }
    ranks.send_to_others({{told.data(), 2}});
    for (unsigned int node = 0; node < grid.n_nodes(); ++node)
      if (!ranks.owns(node) && told[2 * node] > 0.)
        {
          number[node]    = static_cast<std::uint64_t>(told[2 * node]) - 1;
          equations[node] = static_cast<unsigned char>(told[2 * node + 1]);
          place[node]     = owned.size() + foreign.size();
          foreign.push_back(node);
        }
    for (unsigned int m = 0; m < n_neighbours; ++m)
      {
        distance[m]       = 0;
        unsigned int rest = m;
        for (unsigned int d = 0; d < dim; ++d, rest /= 3)
          distance[m] +=
            (static_cast<int>(rest % 3) - 1) * static_cast<int>(grid.stride(d));
      }
    blocks.resize((owned.size() + foreign.size()) * n_neighbours * dim * dim,
                  0.);
  }


  template <int dim>
  int
  NodeMatrix<dim>::neighbour(const unsigned int node,
                             const unsigned int other) const
  {
    int          rest   = static_cast<int>(other) - static_cast<int>(node);
    int          result = 0;
    unsigned int power  = dim == 2 ? 3 : 9;
    for (unsigned int d = 0; d < dim; ++d)
      rest += grid->stride(d);
    for (int d = dim - 1; d >= 0; --d, power /= 3)
      {
        const int stride = grid->stride(d), step = rest / stride;
        if (rest < 0 || step > 2)
          return -1;
        result += step * power;
        rest -= step * stride;
      }
    return result;
  }


  template <int dim>
  void
  NodeMatrix<dim>::add(const ArrayView<const unsigned int> &nodes,
                       const ArrayView<const double>       &matrix)
  {
    const std::size_t n = nodes.size();
    for (std::size_t i = 0; i < n; ++i)
      {
        const int k = place[nodes[i]];
        if (k < 0)
          continue;
        for (std::size_t j = 0; j < n; ++j)
          {
            const double *const from = &matrix[dim * (dim * n * i + j)];
            const int           m    = neighbour(nodes[i], nodes[j]);
            if (m >= 0)
              {
                double *const block =
                  &blocks[(k * std::size_t(n_neighbours) + m) * dim * dim];
                for (unsigned int c = 0; c < dim; ++c)
                  for (unsigned int e = 0; e < dim; ++e)
                    block[dim * c + e] += from[dim * n * c + e];
                continue;
              }
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int e = 0; e < dim; ++e)
                if (const double value = from[dim * n * c + e];
                    value != 0. && has_equation(nodes[i], c) &&
                    has_equation(nodes[j], e))
                  others.push_back({dim * number[nodes[i]] + c,
                                    dim * number[nodes[j]] + e,
                                    value});
          }
      }
  }


  template <int dim>
  void
  NodeMatrix<dim>::compress()
  {
    const NodeExchange &ranks = grid->exchange();
    if (!ranks.is_one_rank())
      {
        // To each owner: row, column, value.
        std::map<unsigned int, std::vector<double>> parcels;
        std::vector<Entry>                          own, added;
        added.swap(others);
        const auto send = [&](const Entry &entry) {
          const auto behind = std::upper_bound(first_of_rank.begin(),
                                               first_of_rank.end(),
                                               entry.row / dim);
          auto      &parcel = parcels[behind - first_of_rank.begin() - 1];
          parcel.insert(parcel.end(),
                        {static_cast<double>(entry.row),
                         static_cast<double>(entry.column),
                         entry.value});
        };
        const auto is_own = [&](const Entry &entry) {
          return entry.row / dim >= first &&
                 entry.row / dim < first + owned.size();
        };
        for (const Entry &entry : added)
          if (is_own(entry))
            own.push_back(entry);
          else
            send(entry);
        Row row;
        for (unsigned int k = 0; k < foreign.size(); ++k)
          for (unsigned int c = 0; c < dim; ++c)
            {
              get_row(owned.size() + k, c, row);
              for (std::size_t l = 0; l < row.columns.size(); ++l)
                send({dim * number[foreign[k]] + c,
                      row.columns[l],
                      row.values[l]});
            }
        for (const auto &[rank, parcel] :
             Utilities::MPI::some_to_some(ranks.communicator(), parcels))
          for (std::size_t l = 0; l < parcel.size(); l += 3)
            own.push_back({static_cast<std::uint64_t>(parcel[l]),
                           static_cast<std::uint64_t>(parcel[l + 1]),
                           parcel[l + 2]});
        others = std::move(own);
      }
    std::stable_sort(others.begin(), others.end());
  }


  template <int dim>
  void
  NodeMatrix<dim>::get_row(const unsigned int k,
                           const unsigned int c,
                           Row               &row) const
  {
    row.columns.clear();
    row.values.clear();
    row.diagonal = 0.;
    const unsigned int node =
      k < owned.size() ? owned[k] : foreign[k - owned.size()];
    if (!has_equation(node, c))
      return;
    std::vector<std::pair<std::uint64_t, double>> entries;
    for (unsigned int m = 0; m < n_neighbours; ++m)
      {
        const double *const block =
          &blocks[((k * std::size_t(n_neighbours) + m) * dim + c) * dim];
        if (std::all_of(block, block + dim, [](const double x) {
              return x == 0.;
            }))
          continue; // not all neighbours are there
        const unsigned int other = node + distance[m];
        for (unsigned int e = 0; e < dim; ++e)
          if (place[other] >= 0 && has_equation(other, e) && block[e] != 0.)
            entries.emplace_back(dim * number[other] + e, block[e]);
      }
    const std::uint64_t this_row = dim * number[node] + c;
    for (auto entry = std::lower_bound(others.begin(),
                                       others.end(),
                                       Entry{this_row, 0, 0.});
         entry != others.end() && entry->row == this_row;
         ++entry)
      entries.emplace_back(entry->column, entry->value);
    std::sort(entries.begin(), entries.end());
    for (const auto &[column, value] : entries)
      {
        if (column == this_row)
          row.diagonal += value;
        if (!row.columns.empty() && row.columns.back() == column)
          row.values.back() += value;
        else
          {
            row.columns.push_back(column);
            row.values.push_back(value);
          }
      }
  }


  template class NodeMatrix<2>;
  template class NodeMatrix<3>;
} // namespace Waker
