// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/last_change.h>
#include <waker/case/load_programmes.h>
#include <waker/particles/point_loads.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace Waker
{
  namespace
  {
    std::string
    array_name(const LoadProgrammeParameters &programme)
    {
      return "programme_" + programme.name;
    }


    const PointLoadParameters &
    driven_load(const LoadProgrammeParameters          &programme,
                const std::vector<PointLoadParameters> &loads)
    {
      return *std::find_if(loads.begin(),
                           loads.end(),
                           [&](const PointLoadParameters &load) {
                             return load.name == programme.load;
                           });
    }


    bool
    becomes_mass(const LoadProgrammeParameters &programme)
    {
      return programme.drives == LoadTarget::weight &&
             programme.weight.mass == LoadMass::with_mass;
    }
  } // namespace


  template <int dim>
  const std::vector<double> &
  carried_load(const LoadProgrammeParameters &programme,
               const MaterialPoints<dim>     &points)
  {
    static const std::vector<double> nothing;
    return facts_of(programme.drives).has_points
             ? points.scalar(array_name(programme))
             : nothing;
  }


  template <int dim>
  LoadProgrammes<dim>::LoadProgrammes(const Parameters &parameters)
    : gravity(parameters.gravity.acceleration)
  {
    for (const LoadProgrammeParameters &p : parameters.load_programmes)
      {
        programmes.emplace_back(p);
        load_names.push_back({p.name, facts_of(p.drives).unit});
      }
  }


  template <int dim>
  void
  LoadProgrammes<dim>::prepare(const Parameters    &parameters,
                               MaterialPoints<dim> &points) const
  {
    const double h = parameters.grid.cell_size;
    for (const LoadProgramme &programme : programmes)
      {
        const LoadProgrammeParameters &p = programme.parameters();
        if (p.drives == LoadTarget::point_load)
          points.scalar(array_name(p)) =
            shares_of_points(driven_load(p, parameters.point_loads), h, points);
        if (p.drives == LoadTarget::weight)
          {
            const std::vector<double> weight =
              weight_per_metre(p.weight, p.path(), h, points);
            points.scalar(array_name(p)) = weight;
            if (becomes_mass(p))
              for (std::size_t q = 0; q < points.n_points(); ++q)
                points.mass[q] +=
                  weight[q] * programme.start().factor / gravity;
          }
      }
  }


  template <int dim>
  void
  LoadProgrammes<dim>::check_watched(const MaterialPoints<dim> &points,
                                     const double measuring_level) const
  {
    for (const LoadProgramme &programme : programmes)
      {
        const LoadProgrammeParameters &p = programme.parameters();
        for (const auto &[entry, watched] :
             {std::make_pair("Held by", p.held_by),
              std::make_pair("Stopped by", p.stopped_by),
              std::make_pair("Quantity", p.quantity)})
          {
            const std::string what = std::string("is ") + name_of(watched);
            if (watched != Watched::nothing && points.n_points() == 0)
              throw UserError(p.path() + entry,
                              what + ", but there is no soil at the start",
                              "nothing");
            if (watched == Watched::plastic_strain &&
                points.find_scalar("plastic strain") < 0)
              throw UserError(p.path() + entry,
                              what + ", but no material has any",
                              "another quantity, or a material that yields");
            if (watched == Watched::loss_of_width &&
                std::isnan(measuring_level))
              throw UserError(p.path() + entry,
                              what + ", but there is no dyke whose width is "
                                     "measured",
                              "another quantity, or a Water/Level within the "
                              "height of the soil");
          }
      }
  }


  template <int dim>
  std::vector<LoadRecord>
  LoadProgrammes<dim>::start() const
  {
    std::vector<LoadRecord> records;
    for (const LoadProgramme &programme : programmes)
      records.push_back(programme.start());
    return records;
  }


  template <int dim>
  void
  LoadProgrammes<dim>::watch(const Body<dim> &body, State<dim> &state) const
  {
    for (std::size_t i = 0; i < programmes.size(); ++i)
      {
        const LoadProgrammeParameters &p     = programmes[i].parameters();
        const auto                     value = [&](const Watched watched) {
          return watched_value(watched,
                               body,
                               state.failure,
                               state.settlement_rate,
                               carried_load(p, body.own()));
        };
        programmes[i].watch({value(p.held_by),
                             value(p.stopped_by),
                             value(p.quantity)},
                            state.loads[i]);
      }
  }


  template <int dim>
  void
  LoadProgrammes<dim>::proceed(const NodeExchange  &ranks,
                               MaterialPoints<dim> &points,
                               State<dim>          &state) const
  {
    for (std::size_t i = 0; i < programmes.size(); ++i)
      {
        const LoadProgrammeParameters &p      = programmes[i].parameters();
        LoadRecord                    &record = state.loads[i];
        const double                   before = record.factor;
        programmes[i].proceed(state.time, record);
        if (becomes_mass(p))
          add_mass(p, record.factor - before, ranks, points, state);
      }
  }


  template <int dim>
  void
  LoadProgrammes<dim>::add_mass(const LoadProgrammeParameters &programme,
                                const double                   height,
                                const NodeExchange            &ranks,
                                MaterialPoints<dim>           &points,
                                State<dim>                    &state) const
  {
    if (height == 0.)
      return;
    const std::vector<double> &weight = carried_load(programme, points);
    // Mass, energy, momentum, force.
    std::array<double, 2 + 2 * dim> sums{};
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        if (weight[p] == 0.)
          continue;
        const double mass = weight[p] * height / gravity;
        points.mass[p] += mass;
        sums[0] += mass;
        sums[1] += 0.5 * mass * points.velocity[p].norm_square();
        for (unsigned int d = 0; d < dim; ++d)
          {
            sums[2 + d] += mass * points.velocity[p][d];
            sums[2 + dim + d] += mass * points.acceleration[p][d];
          }
      }
    ranks.sum(sums.data(), sums.size());
    state.flow.mass_in += sums[0];
    state.energy.kinetic += sums[1];
    state.energy.inflow += sums[1];
    for (unsigned int d = 0; d < dim; ++d)
      {
        state.flow.momentum_in[d] += sums[2 + d];
        state.flow.force[d] += sums[2 + dim + d];
      }
  }


  template <int dim>
  double
  LoadProgrammes<dim>::last_change(const std::vector<LoadRecord> &records) const
  {
    double last = LastChange::never;
    for (std::size_t i = 0; i < programmes.size(); ++i)
      last = std::max(last, programmes[i].last_change(records[i]));
    return last;
  }


  template <int dim>
  std::string
  LoadProgrammes<dim>::changing_after(const double time) const
  {
    for (const LoadProgramme &programme : programmes)
      if (programme.changes_after(time))
        return programme.parameters().path() + "Table";
    return "";
  }


  template <int dim>
  std::vector<double>
  LoadProgrammes<dim>::shares_lost(const Body<dim> &body) const
  {
    std::vector<double> shares;
    for (const LoadProgramme &programme : programmes)
      {
        const LoadProgrammeParameters &p       = programme.parameters();
        const std::vector<double>     &carried = carried_load(p, body.own());
        shares.push_back(std::accumulate(carried.begin(), carried.end(), 0.));
      }
    body.sum(shares.data(), shares.size());
    for (std::size_t i = 0; i < shares.size(); ++i)
      {
        const LoadProgrammeParameters &p   = programmes[i].parameters();
        const double                   all = p.drives == LoadTarget::weight
                                               ? p.weight.unit_weight * p.weight.area()
                                               : 1.;
        shares[i] = facts_of(p.drives).has_points ? 1. - shares[i] / all : 0.;
      }
    return shares;
  }


  template const std::vector<double> &
  carried_load(const LoadProgrammeParameters &, const MaterialPoints<2> &);
  template const std::vector<double> &
  carried_load(const LoadProgrammeParameters &, const MaterialPoints<3> &);
  template class LoadProgrammes<2>;
  template class LoadProgrammes<3>;
} // namespace Waker
