// SPDX-License-Identifier: LGPL-2.1-or-later
// The loads that tractions give to points (eqs. 3.1 and 3.2 of Remmerswaal
// 2023).
#include <waker/grid/near_cells.h>
#include <waker/loads/tractions.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    /// What ranks tell each other of a point.
    template <int dim>
    struct LoadedPoint
    {
      std::uint64_t           id;
      std::array<double, dim> position, force; // m, kN
    };


    std::string
    array_name(const TractionParameters &parameters, const unsigned int d)
    {
      return "load_" + parameters.name + "_" + "xyz"[d];
    }
  } // namespace


  template <int dim>
  bool
  Tractions<dim>::has_fixed_loads(const Item                &item,
                                  const MaterialPoints<dim> &points) const
  {
    return item.placement->is_fixed() &&
           points.find_scalar(array_name(item.parameters, 0)) >= 0;
  }


  template <int dim>
  void
  Tractions<dim>::collect_point_loads(Item &item, const std::size_t n_points)
  {
    item.point_loads.assign(n_points, Tensor<1, dim>());
    for (const Facet<dim> &facet : item.loaded)
      surface_points.split(facet,
                           [&](const Facet<dim> &piece, const std::uint32_t p) {
                             // The mid-point rule is exact for what is linear.
                             item.point_loads[p] +=
                               piece.measure() *
                               item.traction.value(piece.normal,
                                                   piece.centroid());
                           });
  }


  template <int dim>
  void
  Tractions<dim>::fix_point_loads(MaterialPoints<dim> &points)
  {
    for (Item &item : items)
      if (item.placement->is_fixed())
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
  Tractions<dim>::add_point_loads(Item &item, const MaterialPoints<dim> &points)
  {
    if (has_fixed_loads(item, points))
      {
        item.point_loads.resize(points.n_points());
        for (unsigned int d = 0; d < dim; ++d)
          {
            const int   a = points.find_scalar(array_name(item.parameters, d));
            const auto &values = points.scalars[a].values;
            for (std::size_t p = 0; p < points.n_points(); ++p)
              item.point_loads[p][d] = values[p];
          }
      }
    else
      collect_point_loads(item, points.n_points());
    for (Tensor<1, dim> &force : item.point_loads)
      force *= item.factor;
    // Eq. 3.2, with linear functions also under GIMP.
    if (ranks->is_one_rank())
      {
        for (std::size_t p = 0; p < points.n_points(); ++p)
          if (item.point_loads[p] != Tensor<1, dim>())
            load.add(points.position[p], item.point_loads[p]);
        return;
      }
    // Own nodes get what is in cells of others, too: the next ones.
    const auto tell = [&](const std::size_t p, LoadedPoint<dim> &told) {
      told.id = points.id[p];
      for (unsigned int d = 0; d < dim; ++d)
        {
          told.position[d] = points.position[p][d];
          told.force[d]    = item.point_loads[p][d];
        }
      return item.point_loads[p] != Tensor<1, dim>();
    };
    std::vector<LoadedPoint<dim>> loaded =
      window->near_cells().template gather<LoadedPoint<dim>>(points.position,
                                                             0.,
                                                             tell);
    for (std::size_t p = 0; p < points.n_points(); ++p)
      if (LoadedPoint<dim> own; tell(p, own))
        loaded.push_back(own);
    std::sort(loaded.begin(), loaded.end(), [](const auto &a, const auto &b) {
      return a.id < b.id;
    });
    for (const LoadedPoint<dim> &told : loaded)
      {
        Point<dim>     x;
        Tensor<1, dim> force;
        for (unsigned int d = 0; d < dim; ++d)
          {
            x[d]     = told.position[d];
            force[d] = told.force[d];
          }
        load.add(x, force);
      }
  }


  template bool
  Tractions<2>::has_fixed_loads(const Item &, const MaterialPoints<2> &) const;
  template bool
  Tractions<3>::has_fixed_loads(const Item &, const MaterialPoints<3> &) const;
  template void
  Tractions<2>::fix_point_loads(MaterialPoints<2> &);
  template void
  Tractions<3>::fix_point_loads(MaterialPoints<3> &);
  template void
  Tractions<2>::add_point_loads(Item &, const MaterialPoints<2> &);
  template void
  Tractions<3>::add_point_loads(Item &, const MaterialPoints<3> &);
} // namespace Waker
