// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>

#include <waker/base/errors.h>
#include <waker/base/sizes.h>
#include <waker/grid/background_grid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace Waker
{
  template <int dim>
  struct BackgroundGrid<dim>::DealII
  {
    DealII()
      : fe(FE_Q<dim>(1), dim)
      , dof_handler(triangulation)
    {}

    Triangulation<dim> triangulation;
    FESystem<dim>      fe;
    DoFHandler<dim>    dof_handler;
  };


  namespace
  {
    /// Bytes per cell that fixities and a mass take, before the points are
    /// known and all else is estimated.
    template <int dim>
    constexpr double bytes_per_cell = 8. + 20. * dim;


    /// Number of cells of size h between a and b.
    double
    count_cells(const double a, const double b, const double h)
    {
      if (!(h > 0.))
        throw UserError("Grid/Cell size",
                        "is " + std::to_string(h) + " m",
                        "a positive length");
      const double n = std::round((b - a) / h);
      if (!(n >= 1.))
        throw UserError(
          "Grid/Upper corner",
          "the box has no cells: it reaches from " + std::to_string(a) +
            " to " + std::to_string(b) + " m with cells of " +
            std::to_string(h) + " m",
          "an upper corner above the lower one in each direction");
      checked_count("Grid/Cell size",
                    n,
                    "cells in one direction",
                    2147483647.,
                    "larger cells, or a smaller box");
      if (std::abs(b - a - n * h) > 1e-6 * h)
        throw UserError("Grid/Upper corner",
                        "the box from " + std::to_string(a) + " to " +
                          std::to_string(b) + " m is no multiple of the " +
                          "cell size " + std::to_string(h) + " m",
                        "an upper corner at a whole number of cells");
      return n;
    }


    /// The numbers of cells in each direction, margin included: all that is
    /// counted on the grid has to fit into 32 bits, and all of it into memory.
    template <int dim>
    std::vector<unsigned int>
    count_all_cells(const Point<dim> &lower,
                    const Point<dim> &upper,
                    const double      h)
    {
      constexpr unsigned int  margin = BackgroundGrid<dim>::margin;
      std::array<double, dim> n;
      double                  n_cells = 1., n_dofs = dim;
      for (unsigned int d = 0; d < dim; ++d)
        {
          n[d] = count_cells(lower[d], upper[d], h) + 2 * margin;
          n_cells *= n[d];
          n_dofs *= n[d] + 1;
        }
      const std::string where  = "Grid/Cell size";
      const std::string advice = "larger cells, or a smaller box";
      checked_count(where, n_dofs, "unknowns on the grid", 2147483647., advice);
      std::ostringstream what;
      what << "is " << h << " m: " << n_cells << " cells";
      require_memory(where, what.str(), bytes_per_cell<dim> * n_cells, advice);

      // So far away positions have too few digits left within a cell.
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double far = std::max(std::abs(lower[d]), std::abs(upper[d]));
          if (!(far <= 1e9 * h))
            {
              std::ostringstream place;
              place << "the box reaches to " << far << " m in direction "
                    << "xyz"[d] << ", with cells of " << h
                    << " m: too far from 0 for exact positions";
              throw UserError(where,
                              place.str(),
                              "coordinates up to 1e9 cells from 0");
            }
        }
      return std::vector<unsigned int>(n.begin(), n.end());
    }
  } // namespace


  template <int dim>
  BackgroundGrid<dim>::BackgroundGrid(const Point<dim> &lower,
                                      const Point<dim> &upper,
                                      const double      cell_size,
                                      const MPI_Comm    communicator)
    : lower(lower)
    , upper(upper)
    , h(cell_size)
    , inverse_h(1. / cell_size)
    , n_nodes_total(1)
    , n_cells_total(1)
    , mpi_communicator(communicator)
  {
    const std::vector<unsigned int> n_cells =
      count_all_cells<dim>(lower, upper, h);
    for (unsigned int d = 0; d < dim; ++d)
      {
        n_nodes_1d[d] = n_cells[d] + 1;
        strides[d]    = n_nodes_total;
        n_nodes_total *= n_nodes_1d[d];
        n_cells_total *= n_cells[d];
        node_origin[d] = lower[d] - margin * h;
      }
    whole_origin = node_origin;
    n_whole_1d   = n_nodes_1d;

    node_exchange = std::make_shared<const NodeExchange>(n_nodes_total);
  }


  template <int dim>
  BackgroundGrid<dim>::BackgroundGrid(
    const BackgroundGrid                &whole,
    const Index                         &first,
    const std::array<unsigned int, dim> &n_nodes)
    : lower(whole.lower)
    , upper(whole.upper)
    , node_origin(whole.node_origin)
    , whole_origin(whole.whole_origin)
    , h(whole.h)
    , inverse_h(whole.inverse_h)
    , n_nodes_1d(n_nodes)
    , n_whole_1d(whole.n_whole_1d)
    , n_nodes_total(1)
    , n_cells_total(1)
    , mpi_communicator(whole.mpi_communicator)
    , first_node(first)
  {
    for (unsigned int d = 0; d < dim; ++d)
      {
        strides[d] = n_nodes_total;
        n_nodes_total *= n_nodes_1d[d];
        n_cells_total *= n_nodes_1d[d] - 1;
        node_origin[d] += h * first[d];
      }
    node_exchange = std::make_shared<const NodeExchange>(n_nodes_total);
  }


  template <int dim>
  BackgroundGrid<dim>::~BackgroundGrid() = default;


  template <int dim>
  typename BackgroundGrid<dim>::Index
  BackgroundGrid<dim>::cell_index(const Point<dim> &x) const
  {
    Index index;
    for (unsigned int d = 0; d < dim; ++d)
      index[d] =
        static_cast<int>(std::floor((x[d] - whole_origin[d]) * inverse_h)) -
        first_node[d];
    return index;
  }


  template <int dim>
  typename BackgroundGrid<dim>::Index
  BackgroundGrid<dim>::nearest_cell(const Point<dim> &x) const
  {
    Index index = cell_index(x);
    for (unsigned int d = 0; d < dim; ++d)
      {
        const int last = static_cast<int>(n_whole_1d[d]) - 2;
        index[d] =
          std::clamp(index[d] + first_node[d], 0, last) - first_node[d];
      }
    return index;
  }


  template <int dim>
  bool
  BackgroundGrid<dim>::contains(const Point<dim> &x,
                                const double      clearance) const
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (!(x[d] - clearance >= whole_origin[d] &&
            x[d] + clearance <= whole_origin[d] + h * (n_whole_1d[d] - 1)))
        return false;
    return true;
  }


  template <int dim>
  const DoFHandler<dim, dim> &
  BackgroundGrid<dim>::dof_handler() const
  {
    if (deal_ii)
      return deal_ii->dof_handler;
    auto                      objects = std::make_unique<DealII>();
    std::vector<unsigned int> n_cells(dim);
    Point<dim>                outer_upper = node_origin;
    for (unsigned int d = 0; d < dim; ++d)
      {
        n_cells[d] = n_nodes_1d[d] - 1;
        outer_upper[d] += n_cells[d] * h;
      }
    GridGenerator::subdivided_hyper_rectangle(objects->triangulation,
                                              n_cells,
                                              node_origin,
                                              outer_upper);
    DoFHandler<dim> &dof_handler = objects->dof_handler;
    dof_handler.distribute_dofs(objects->fe);

    // From deal.II's numbering to the lattice's.
    std::vector<types::global_dof_index> renumbering(dof_handler.n_dofs());
    std::vector<types::global_dof_index> cell_dofs(
      objects->fe.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(cell_dofs);
        for (unsigned int i = 0; i < cell_dofs.size(); ++i)
          {
            const auto component = objects->fe.system_to_component_index(i);
            const Point<dim> x   = cell->vertex(component.second);
            Index            index;
            for (unsigned int d = 0; d < dim; ++d)
              index[d] =
                static_cast<int>(std::lround((x[d] - node_origin[d]) / h));
            renumbering[cell_dofs[i]] = dim * node(index) + component.first;
          }
      }
    dof_handler.renumber_dofs(renumbering);
    deal_ii = std::move(objects);
    return deal_ii->dof_handler;
  }


  template class BackgroundGrid<2>;
  template class BackgroundGrid<3>;
} // namespace Waker
