// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/utilities.h>

#include <waker/base/errors.h>
#include <waker/loads/tractions.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Waker
{
  template <int dim>
  std::vector<UserSurface<dim>>
  read_surfaces(const std::vector<TractionParameters> &tractions,
                const BackgroundGrid<dim>             &grid)
  {
    std::vector<UserSurface<dim>> surfaces(tractions.size());
    for (std::size_t i = 0; i < tractions.size(); ++i)
      if (tractions[i].has_user_surface())
        surfaces[i] = read_user_surface<dim>(tractions[i].surface_file,
                                             "Tractions/" + tractions[i].name +
                                               "/Surface file",
                                             grid);
    return surfaces;
  }


  template <int dim>
  Tractions<dim>::Tractions(const BackgroundGrid<dim>             &grid,
                            const BackgroundGrid<dim>             &window,
                            const std::vector<TractionParameters> &parameters,
                            const std::vector<UserSurface<dim>>   &surfaces,
                            const std::vector<RidingLoad<dim>>    &riding)
    : grid(&grid)
    , window(&window)
    , ranks(&window.exchange())
    , load(window)
    , surface_points(grid, window)
  {
    AssertDimension(surfaces.size(), parameters.size());
    AssertDimension(riding.size(), parameters.size());
    const double tolerance = 1e-9 * grid.cell_size();
    for (std::size_t i = 0; i < parameters.size(); ++i)
      {
        items.push_back({parameters[i],
                         Traction<dim>(parameters[i], tolerance),
                         &riding[i],
                         make_placement(parameters[i], surfaces[i]),
                         {},
                         {},
                         {},
                         NodalVector(window.n_dofs()),
                         {},
                         {}});
        // The input was checked by the facts: the placement must agree.
        const MethodFacts             facts = facts_of(parameters[i].method);
        const TractionPlacement<dim> &placement = *items.back().placement;
        AssertThrow(placement.on_points() == facts.on_points &&
                      placement.is_fixed() == facts.is_fixed &&
                      placement.is_carried() ==
                        parameters[i].has_user_surface(),
                    ExcMessage("facts_of() and the placement of \"" +
                               std::string(name_of(parameters[i].method)) +
                               "\" disagree"));
      }
  }


  template <int dim>
  bool
  Tractions<dim>::moves() const
  {
    return std::any_of(items.begin(), items.end(), [](const Item &item) {
      return !item.placement->is_fixed() && item.traction.moves();
    });
  }


  template <int dim>
  double
  Tractions<dim>::last_change() const
  {
    double last = LastChange::never;
    for (const Item &item : items)
      if (!item.placement->is_fixed())
        last = std::max(last, item.traction.last_change());
    return last;
  }


  template <int dim>
  std::string
  Tractions<dim>::varying(const double from, const double to) const
  {
    for (const Item &item : items)
      if (!item.placement->is_fixed() &&
          item.traction.varies(item.part, from, to))
        return "Tractions/" + item.parameters.name;
    return "";
  }


  template <int dim>
  void
  Tractions<dim>::find(const MaterialPoints<dim>  &points,
                       const SurfaceVertices<dim> &vertices,
                       const SurfaceFinder<dim>   &finder)
  {
    std::vector<const Facets<dim> *> on_points;
    for (std::size_t i = 0; i < items.size(); ++i)
      {
        Item &item = items[i];
        // Loads that were fixed need no surface any more.
        if (has_fixed_loads(item, points))
          {
            item.part.clear();
            continue;
          }
        const std::string path = "Tractions/" + item.parameters.name;
        if (item.placement->is_carried() ||
            (item.rides() && !item.riding->on_points))
          {
            for (const Point<dim> &x : vertices[i])
              if (!grid->contains(x))
                throw NumericalFailure(path +
                                       ": a vertex of the carried surface has "
                                       "left the grid");
          }
        if (item.rides())
          item.riding->place(
            *ranks, points, vertices[i], item.part, item.placed);
        else
          item.traction.select(
            item.placement->surface(vertices[i], finder, path), item.part);
        if (item.placement->on_points())
          on_points.push_back(&item.part);
      }
    if (!on_points.empty())
      surface_points.find(points, on_points);
  }


  template <int dim>
  void
  Tractions<dim>::ride(const MaterialPoints<dim>    &points,
                       std::vector<RidingLoad<dim>> &riding)
  {
    PointShares<dim> shares(*grid);
    shares.sort(points.position);
    for (std::size_t i = 0; i < items.size(); ++i)
      {
        const Item &item = items[i];
        Assert(item.riding == &riding[i], ExcInternalError());
        if (item.placement->is_fixed())
          for (const Facet<dim> &facet : item.loaded)
            riding[i].measure += facet.measure();
        if (!item.parameters.rides())
          continue;
        if (item.placement->is_carried())
          riding[i].ride_on_vertices(item.part);
        else
          {
            riding[i].ride_on_points(item.part, points, shares);
            // A pressure must know how the surface turns.
            riding[i].has_vertices =
              item.parameters.kind == TractionKind::pressure;
          }
      }
  }


  template <int dim>
  void
  Tractions<dim>::add(const double               t,
                      const MaterialPoints<dim> &points,
                      const std::vector<double> &node_mass,
                      const double               full_node_mass,
                      NodalVector               &force)
  {
    for (Item &item : items)
      {
        item.traction.set_time(t);
        item.loaded = item.part;
        item.traction.keep_loaded(item.loaded);
        load.clear();
        if (item.placement->on_points())
          add_point_loads(item, points);
        else
          add_facets(item);
        item.force = 0.;
        load.distribute(node_mass,
                        item.parameters.minimum_support * full_node_mass,
                        item.force);
        add_up(node_mass, item);
        force += item.force;
      }
  }


  template <int dim>
  void
  Tractions<dim>::add_up(const std::vector<double> &node_mass, Item &item) const
  {
    std::array<double, 2 + dim> sums{};
    for (const unsigned int node : load.nodes())
      {
        if (!ranks->owns(node))
          continue;
        double square = 0.;
        for (unsigned int d = 0; d < dim; ++d)
          square +=
            Utilities::fixed_power<2>(load.nodal_forces()[dim * node + d]);
        const double size = std::sqrt(square);
        sums[0] += size;
        if (!(node_mass[node] > 0.) && item.parameters.minimum_support == 0.)
          sums[1] += size;
      }
    for (unsigned int node = 0; node < node_mass.size(); ++node)
      if (node_mass[node] > 0.)
        for (unsigned int d = 0; d < dim; ++d)
          sums[2 + d] += item.force.local_element(dim * node + d);
    ranks->sum(sums.data(), sums.size());
    item.total = sums[0];
    item.lost  = sums[1];
    for (unsigned int d = 0; d < dim; ++d)
      item.on_mass[d] = sums[2 + d];
  }


  template <int dim>
  void
  Tractions<dim>::add_facets(const Item &item)
  {
    for (std::size_t k = 0; k < item.loaded.size(); ++k)
      {
        const Facet<dim> &facet = item.loaded[k];
        // Vertices that have met: what rides on them does not vanish.
        if (item.rides() &&
            !(facet.measure() > 1e-9 * item.placed[k].piece->start.measure()))
          {
            const auto  &placed = item.placed[k];
            const double start  = placed.piece->start.measure();
            load.add(facet.vertices[0],
                     item.factor *
                       item.traction.force(start,
                                           placed.area,
                                           placed.piece->start.vertices[0]));
            continue;
          }
        load.add(facet, [&](const Facet<dim> &, const Point<dim> &x) {
          return item.value(k, x);
        });
      }
  }


  template std::vector<UserSurface<2>>
  read_surfaces(const std::vector<TractionParameters> &,
                const BackgroundGrid<2> &);
  template std::vector<UserSurface<3>>
  read_surfaces(const std::vector<TractionParameters> &,
                const BackgroundGrid<3> &);
  template class Tractions<2>;
  template class Tractions<3>;
} // namespace Waker
