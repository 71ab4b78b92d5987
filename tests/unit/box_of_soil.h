// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_box_of_soil_h
#define waker_tests_box_of_soil_h

#include <waker/grid/partition.h>
#include <waker/mapping/transfer.h>
#include <waker/materials/linear_elastic.h>
#include <waker/mechanics/soil.h>
#include <waker/mechanics/system_operator.h>
#include <waker/nodes/fixities.h>

#include "mapping_lattice.h"
#include <array>

/// A box of soil, linearised, on one rank or shared by several.
namespace BoxOfSoil
{
  using namespace Waker;

  constexpr double h = 0.25, density = 1.5;

  using Box = std::array<unsigned int, 3>;


  /// What a body is like.
  struct Kind
  {
    double           reach    = 0.; // into the next cells, of a cell
    double           nu       = 0.3;
    double           softness = 1.; // of every second layer of cells, at most
    VolumetricStrain strain   = VolumetricStrain::standard;
    double           height   = 1e3; // m: no soil above it
  };


  /// A box of soil on a fixed base, its domains as they are at the start or
  /// moved; on this rank the points in its cells.
  template <int dim>
  struct Body
  {
    explicit Body(const Box     &cells,
                  const Kind    &kind         = Kind(),
                  const MPI_Comm communicator = MPI_COMM_SELF)
      : whole(Point<dim>(), corner(cells), h, communicator)
      , partition(whole, communicator)
      , window(Utilities::MPI::n_mpi_processes(communicator) > 1
                 ? partition.make_window()
                 : nullptr)
      , grid(window ? *window : whole)
      , fixities(grid, {FixityParameters()})
      , weights(grid, ShapeFunctions::gimp)
      , nodes(grid)
      , reached(grid)
    {
      const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
      Box                n    = {{1, 1, 1}};
      for (unsigned int d = 0; d < dim; ++d)
        n[d] = 2 * cells[d];
      for (unsigned int p = 0; p < n[0] * n[1] * n[2]; ++p)
        {
          const Box  i = {{p % n[0], p / n[0] % n[1], p / n[0] / n[1]}};
          Point<dim> x;
          for (unsigned int d = 0; d < dim; ++d)
            x[d] = h * (1. + 0.5 * (i[d] + 0.5) + kind.reach);
          x[1] -= h;
          if (x[1] > kind.height || partition.owner(x) != rank)
            continue;
          Lattice::add_point(
            points, x, std::pow(0.5 * h, dim), 0.25 * h, density);
          points.material.back() = i[0] / 2 % 2;
        }
      for (const double softness : {1., kind.softness})
        materials.push_back(
          std::make_unique<LinearElastic>(density, 1000. * softness, kind.nu));
      weights.reinit(points);
      to_nodes(points, weights, nodes);
      reached.reinit(nodes.mass);
      MappingParameters mapping;
      mapping.volumetric_strain = kind.strain;
      soil                      = std::make_unique<Soil<dim>>(
        weights,
        StressUpdate<dim>(materials, make_small_motion<dim>(mapping)),
        Tangent::consistent);
      soil->begin(points, nodes, 0., 0.);
      NodalVector u(grid.n_dofs()), force(u);
      soil->add_force(u, force);
      soil->linearise();
      resistances = {soil.get()};
      system      = std::make_unique<SystemOperator<dim>>(
        resistances, 1., 0., nodes.mass, reached, fixities.removed_list());
    }

    /// The soil, its base and a cell on each side.
    static Point<dim>
    corner(const Box &cells)
    {
      Point<dim> upper;
      for (unsigned int d = 0; d < dim; ++d)
        upper[d] = h * (cells[d] + 2);
      return upper;
    }

    /// The weight, as a right-hand side.
    NodalVector
    weight() const
    {
      NodalVector b(grid.n_dofs());
      for (unsigned int node = 0; node < grid.n_nodes(); ++node)
        if (grid.exchange().owns(node))
          b.begin()[dim * node + 1] = -10. * nodes.mass[node];
      for (const unsigned int dof : fixities.removed_list())
        b.begin()[dof] = 0.;
      return b;
    }

    double
    norm(const NodalVector &x) const
    {
      return std::sqrt(grid.exchange().sum(x * x));
    }

    BackgroundGrid<dim>                        whole;
    Partition<dim>                             partition;
    std::unique_ptr<const BackgroundGrid<dim>> window;
    const BackgroundGrid<dim>                 &grid;
    Fixities<dim>                              fixities;
    Weights<dim>                               weights;
    NodalState                                 nodes;
    ReachedNodes                               reached;
    MaterialPoints<dim>                        points;
    Materials                                  materials;
    std::unique_ptr<Soil<dim>>                 soil;
    Resistances<dim>                           resistances;
    std::unique_ptr<SystemOperator<dim>>       system;
  };
} // namespace BoxOfSoil

#endif
