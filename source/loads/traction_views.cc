// SPDX-License-Identifier: LGPL-2.1-or-later
// What tractions do, for those who look at them.
#include <waker/base/errors.h>
#include <waker/loads/tractions.h>

namespace Waker
{
  template <int dim>
  Tensor<1, dim>
  Tractions<dim>::Item::value(const std::size_t k, const Point<dim> &x) const
  {
    const Facet<dim> &facet = loaded[k];
    if (!rides())
      return factor * traction.value(facet.normal, x);
    const Facet<dim> &start = placed[k].piece->start;
    const Point<dim>  X =
      traction.is_uniform() ? x : start_place(facet, start, x);
    return factor * traction.force(start.measure(), placed[k].area, X) /
           facet.measure();
  }


  template <int dim>
  Tensor<1, dim>
  Tractions<dim>::value(const std::size_t i,
                        const std::size_t k,
                        const Point<dim> &x) const
  {
    return items[i].value(k, x);
  }


  template <int dim>
  typename Tractions<dim>::View
  Tractions<dim>::view(const std::size_t i) const
  {
    const Item &item     = items[i];
    const bool  is_alone = ranks->is_one_rank();
    return {item.parameters.name,
            &item.loaded,
            is_alone ? &item.force : &item.whole_force,
            item.placement->on_points() ? &item.point_loads : nullptr};
  }


  template <int dim>
  void
  Tractions<dim>::complete(
    const std::function<void(const NodalVector &, NodalVector &)> &gather)
  {
    for (Item &item : items)
      gather(item.force, item.whole_force);
  }


  template <int dim>
  typename Tractions<dim>::Resultant
  Tractions<dim>::resultant(const std::size_t i) const
  {
    const Item &item = items[i];
    Resultant   resultant{{}, 0.};
    for (unsigned int d = 0; d < dim; ++d)
      resultant.force[d] = item.on_mass[d];
    for (const Facet<dim> &facet : item.loaded)
      resultant.measure += facet.measure();
    // Loads that were fixed have no facets any more.
    if (item.placement->is_fixed() && item.loaded.empty())
      resultant.measure = item.riding->measure;
    return resultant;
  }


  template <int dim>
  void
  Tractions<dim>::record(const double                 t,
                         std::vector<TractionRecord> &records) const
  {
    records.resize(items.size());
    const auto note = [t](const bool happened, double &time) {
      if (happened && time < 0.)
        time = t;
    };
    for (std::size_t i = 0; i < items.size(); ++i)
      {
        const Item &item = items[i];
        note(item.part.empty() && !item.placement->is_fixed(),
             records[i].empty_time);
        note(item.rides() && item.part.size() < item.riding->pieces.size(),
             records[i].left_time);
        note(item.lost > 0.01 * item.total, records[i].lost_time);
      }
  }


  template <int dim>
  void
  Tractions<dim>::check_something_is_loaded() const
  {
    for (const Item &item : items)
      {
        const std::string path = "Tractions/" + item.parameters.name;
        if (item.placement->is_fixed() && item.traction.moves())
          throw UserError(path + (item.traction.is_hydrostatic() ? "/Level"
                                                                 : "/Value"),
                          "changes in time, but fixed points get their loads "
                          "once, at t = 0",
                          "what does not change (Load programmes may change "
                          "it), or another Method");
        if (item.part.empty())
          throw UserError(path + (!item.parameters.from.empty() ? "/From"
                                  : !item.parameters.facing.empty()
                                    ? "/Facing"
                                    : "/Method"),
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


  template Tensor<1, 2>
  Tractions<2>::Item::value(const std::size_t, const Point<2> &) const;
  template Tensor<1, 2>
  Tractions<2>::value(const std::size_t,
                      const std::size_t,
                      const Point<2> &) const;
  template Tractions<2>::View
  Tractions<2>::view(const std::size_t) const;
  template Tractions<2>::Resultant
  Tractions<2>::resultant(const std::size_t) const;
  template void
  Tractions<2>::complete(
    const std::function<void(const NodalVector &, NodalVector &)> &);
  template void
  Tractions<2>::record(const double, std::vector<TractionRecord> &) const;
  template void
  Tractions<2>::check_something_is_loaded() const;
  template Tensor<1, 3>
  Tractions<3>::Item::value(const std::size_t, const Point<3> &) const;
  template Tensor<1, 3>
  Tractions<3>::value(const std::size_t,
                      const std::size_t,
                      const Point<3> &) const;
  template Tractions<3>::View
  Tractions<3>::view(const std::size_t) const;
  template Tractions<3>::Resultant
  Tractions<3>::resultant(const std::size_t) const;
  template void
  Tractions<3>::complete(
    const std::function<void(const NodalVector &, NodalVector &)> &);
  template void
  Tractions<3>::record(const double, std::vector<TractionRecord> &) const;
  template void
  Tractions<3>::check_something_is_loaded() const;
} // namespace Waker
