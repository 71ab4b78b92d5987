// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/boundary/tractions.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    bool
    on_points(const TractionParameters &parameters)
    {
      return parameters.method == "fixed points" ||
             parameters.method == "updated points";
    }


    bool
    has_surface(const TractionParameters &parameters)
    {
      return parameters.method == "user surface" ||
             (on_points(parameters) && !parameters.surface_file.empty());
    }


    std::string
    array_name(const TractionParameters &parameters, const unsigned int d)
    {
      return "load_" + parameters.name + "_" + "xyz"[d];
    }
  } // namespace


  template <int dim>
  std::vector<UserSurface<dim>>
  read_surfaces(const std::vector<TractionParameters> &tractions,
                const BackgroundGrid<dim>             &grid)
  {
    std::vector<UserSurface<dim>> surfaces(tractions.size());
    for (std::size_t i = 0; i < tractions.size(); ++i)
      if (has_surface(tractions[i]))
        surfaces[i] = read_user_surface<dim>(tractions[i].surface_file,
                                             "Tractions/" + tractions[i].name +
                                               "/Surface file",
                                             grid);
    return surfaces;
  }


  template <int dim>
  Tractions<dim>::Tractions(const BackgroundGrid<dim>             &grid,
                            const std::vector<TractionParameters> &parameters,
                            const std::vector<UserSurface<dim>>   &surfaces)
    : grid(&grid)
    , load(grid)
    , shares(grid)
  {
    AssertDimension(surfaces.size(), parameters.size());
    const double tolerance = 1e-9 * grid.cell_size();
    for (std::size_t i = 0; i < parameters.size(); ++i)
      {
        items.push_back({parameters[i],
                         Traction<dim>(parameters[i], tolerance),
                         has_surface(parameters[i]) ? &surfaces[i] : nullptr,
                         {},
                         {},
                         {},
                         NodalVector(grid.n_dofs())});
      }
  }


  template <int dim>
  bool
  Tractions<dim>::moves() const
  {
    return std::any_of(items.begin(), items.end(), [](const Item &item) {
      return item.parameters.method != "fixed points" && item.traction.moves();
    });
  }


  template <int dim>
  void
  Tractions<dim>::find(const MaterialPoints<dim>  &points,
                       const SurfaceVertices<dim> &vertices,
                       SurfaceFinder<dim>         &finder)
  {
    bool sorted = false;
    for (std::size_t i = 0; i < items.size(); ++i)
      {
        Item              &item   = items[i];
        const std::string &method = item.parameters.method;
        // Loads that were fixed need no surface any more.
        if (method == "fixed points" &&
            points.find_scalar(array_name(item.parameters, 0)) >= 0)
          {
            item.part.clear();
            continue;
          }
        const std::string path = "Tractions/" + item.parameters.name;
        if (item.surface != nullptr)
          {
            for (const Point<dim> &x : vertices[i])
              if (!grid->contains(x))
                throw NumericalFailure(path +
                                       ": a vertex of the carried surface has "
                                       "left the grid");
            item.surface->to_facets(vertices[i], user_facets);
            item.traction.select(user_facets, item.part);
          }
        else
          item.traction.select(finder.facets(on_points(item.parameters)
                                               ? "contour"
                                               : method,
                                             path + "/Method"),
                               item.part);
        if (on_points(item.parameters) && !sorted)
          {
            shares.sort(points);
            sorted = true;
          }
      }
  }


  template <int dim>
  void
  Tractions<dim>::collect_point_loads(Item &item, const std::size_t n_points)
  {
    item.point_loads.assign(n_points, Tensor<1, dim>());
    for (const Facet<dim> &facet : item.loaded)
      shares.split(facet, [&](const Facet<dim> &piece, const std::uint32_t p) {
        // The mid-point rule is exact for what is linear.
        Point<dim> middle;
        for (const Point<dim> &x : piece.vertices)
          middle += x / static_cast<double>(dim);
        item.point_loads[p] +=
          piece.measure() * item.traction.value(piece.normal, middle);
      });
  }


  template <int dim>
  void
  Tractions<dim>::fix_point_loads(MaterialPoints<dim> &points)
  {
    for (Item &item : items)
      if (item.parameters.method == "fixed points")
        {
          item.traction.set_time(0.);
          item.loaded = item.part;
          item.traction.keep_loaded(item.loaded);
          collect_point_loads(item, points.n_points());
          for (unsigned int d = 0; d < dim; ++d)
            {
              std::vector<double> &values =
                points.scalar(array_name(item.parameters, d));
              for (std::size_t p = 0; p < points.n_points(); ++p)
                values[p] = item.point_loads[p][d];
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
        if (on_points(item.parameters))
          {
            const bool fixed = item.parameters.method == "fixed points";
            if (fixed &&
                points.find_scalar(array_name(item.parameters, 0)) >= 0)
              {
                item.point_loads.resize(points.n_points());
                for (unsigned int d = 0; d < dim; ++d)
                  {
                    const int a =
                      points.find_scalar(array_name(item.parameters, d));
                    const auto &values = points.scalars[a].values;
                    for (std::size_t p = 0; p < points.n_points(); ++p)
                      item.point_loads[p][d] = values[p];
                  }
              }
            else
              collect_point_loads(item, points.n_points());
            // Eq. 3.2, with linear functions also under GIMP.
            for (std::size_t p = 0; p < points.n_points(); ++p)
              if (item.point_loads[p] != Tensor<1, dim>())
                load.add(points.position[p], item.point_loads[p]);
          }
        else
          {
            const auto traction = [&](const Facet<dim> &facet,
                                      const Point<dim> &x) {
              return item.traction.value(facet.normal, x);
            };
            for (const Facet<dim> &facet : item.loaded)
              load.add(facet, traction);
          }
        item.force = 0.;
        load.distribute(node_mass,
                        item.parameters.minimum_support * full_node_mass,
                        item.force);
        force += item.force;
      }
  }


  template <int dim>
  typename Tractions<dim>::View
  Tractions<dim>::view(const std::size_t i) const
  {
    const Item &item = items[i];
    return {item.parameters.name,
            &item.loaded,
            &item.traction,
            &item.force,
            &item.point_loads};
  }


  template <int dim>
  void
  Tractions<dim>::check_something_is_loaded() const
  {
    for (const Item &item : items)
      {
        const std::string path = "Tractions/" + item.parameters.name;
        if (item.part.empty())
          throw UserError(path + "/Method",
                          "no part of the surface is selected: there is "
                          "nothing to load",
                          "From, To and Facing that leave a part of the "
                          "surface, and not only closed faces of the grid");
        if (!item.traction.is_hydrostatic() || item.traction.moves())
          continue;
        Traction<dim> traction(item.parameters, 0.);
        Facets<dim>   wet = item.part;
        traction.keep_loaded(wet);
        if (wet.empty())
          throw UserError(path + "/Level",
                          "is " + item.parameters.level +
                            " m: no part of the surface lies below",
                          "a level above the lowest place of the surface that "
                          "From, To and Facing leave");
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
