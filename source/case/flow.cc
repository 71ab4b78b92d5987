// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/case/flow.h>
#include <waker/case/rank_part.h>
#include <waker/case/state.h>
#include <waker/particles/removal.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    FixityRegion
    region_of(const unsigned int face)
    {
      return region_of(static_cast<BoxFace>(face));
    }


    /// Do its nodes fill more than an edge of the opening?
    template <int dim>
    bool
    overlaps(const FixityParameters &condition,
             const Opening<dim>     &opening,
             const double            h)
    {
      const bool is_box = condition.region == FixityRegion::box;
      if (!is_box && condition.region != region_of(opening.face))
        return false;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double low = opening.lower[d], high = opening.upper[d];
          const double from = condition.from.empty() ? low : condition.from[d];
          const double to   = condition.to.empty() ? high : condition.to[d];
          if (d == opening.face / 2)
            {
              if (is_box && (from > low || to < low))
                return false;
            }
          else if (!(std::min(to, high) - std::max(from, low) > 1e-6 * h))
            return false;
        }
      return true;
    }


    unsigned int
    material_number(const InflowParameters                &inflow,
                    const std::vector<MaterialParameters> &materials)
    {
      std::string names;
      for (unsigned int m = 0; m < materials.size(); ++m)
        {
          if (materials[m].name == inflow.material)
            return m;
          names += (names.empty() ? "" : ", ") + materials[m].name;
        }
      throw UserError("Inflow/" + inflow.name + "/Material",
                      "there is no material \"" + inflow.material + "\"",
                      "one of " + names);
    }


    /// The condition that moves the nodes of an inflow.
    template <int dim>
    FixityParameters
    pushing(const InflowParameters &inflow, const Feeder<dim> &feeder)
    {
      FixityParameters condition;
      condition.name   = "Inflow/" + inflow.name;
      condition.region = region_of(inflow.face);
      condition.type   = FixityType::prescribed;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double v = feeder.velocity()[d];
          condition.displacement +=
            (d > 0 ? "; " : "") + (v != 0. ? in_digits(v) + "*t" : "0");
          condition.from.push_back(feeder.mouth().lower[d]);
          condition.to.push_back(feeder.mouth().upper[d]);
        }
      return condition;
    }
  } // namespace


  template <int dim>
  Flow<dim>::Flow(const BackgroundGrid<dim> &grid,
                  const Materials           &materials,
                  const Parameters          &parameters)
    : grid(&grid)
    , materials(&materials)
    , scheme(scheme_traits(parameters.time))
    , ramp_duration(parameters.time.ramp_duration)
    , outlets(grid)
    , all_openings(grid)
    , all_conditions(parameters.fixities)
  {
    const std::vector<bool> faces = parameters.outflow.open_faces(dim);
    for (unsigned int f = 0; f < 2 * dim; ++f)
      if (faces[f])
        {
          OpeningParameters whole;
          whole.face = static_cast<BoxFace>(f);
          add_outlet(whole, "Outflow", "Outflow/Faces");
        }
    for (const OutletParameters &outlet : parameters.outlets)
      {
        const std::string path = "Outflow/" + outlet.name;
        add_outlet(outlet, path, path + "/Face");
      }
    for (const InflowParameters &inflow : parameters.inflows)
      add_inflow(inflow, parameters);
  }


  template <int dim>
  const FixityParameters *
  Flow<dim>::holder_of(const Opening<dim> &opening) const
  {
    for (const FixityParameters &condition : all_conditions)
      if (overlaps(condition, opening, grid->cell_size()) &&
          condition.holds(opening.face / 2))
        return &condition;
    return nullptr;
  }


  template <int dim>
  void
  Flow<dim>::add_outlet(const OpeningParameters &parameters,
                        const std::string       &path,
                        const std::string       &where)
  {
    const Opening<dim> opening = place_opening(*grid, parameters, path);
    if (const FixityParameters *const holder = holder_of(opening))
      throw UserError(where,
                      std::string(name_of(parameters.face)) +
                        " is closed there, or in a part, by Boundary "
                        "conditions/" +
                        holder->name,
                      "parts of faces (Outflow/Names) that no boundary "
                      "condition closes");
    outlets.add(opening);
    all_openings.add(opening);
  }


  template <int dim>
  void
  Flow<dim>::add_inflow(const InflowParameters &inflow,
                        const Parameters       &parameters)
  {
    const std::string  path = "Inflow/" + inflow.name + "/Face";
    const unsigned int m    = material_number(inflow, parameters.materials);
    require_implicit(parameters.time, "there is an inflow");
    typename Feeder<dim>::Variables variables;
    for (const MaterialVariable &variable : (*materials)[m]->variables())
      {
        const InitialValue &value = variable.initial_value;
        if (value.varies())
          throw UserError("Inflow/" + inflow.name + "/Material",
                          "is " + inflow.material + ", of which " + value.path +
                            " varies in space",
                          "a material with numbers: what flows in is the "
                          "same everywhere");
        variables.emplace_back(variable.name, value.number);
      }
    feeders.emplace_back(*grid,
                         inflow,
                         parameters.points.points_per_direction,
                         m,
                         (*materials)[m]->density(),
                         variables);
    const Feeder<dim> &feeder = feeders.back();
    if (outlets.meets(feeder.mouth()))
      throw UserError(path,
                      "is " + std::string(name_of(inflow.face)) +
                        ", where soil leaves (Outflow)",
                      "another face, or another part of it");
    if (!(inflow.velocity * parameters.time.time_step <=
          grid->cell_size() * (1. + 1e-9)))
      throw UserError("Inflow/" + inflow.name + "/Velocity",
                      "is " + in_digits(inflow.velocity) +
                        " m/s: more than a cell in a time step of " +
                        in_digits(parameters.time.time_step) + " s",
                      "at most " +
                        in_digits(grid->cell_size() /
                                  parameters.time.time_step) +
                        " m/s, or a shorter time step");
    if (const FixityParameters *const holder = holder_of(feeder.mouth()))
      throw UserError(path,
                      "the opening on " + std::string(name_of(inflow.face)) +
                        " is held by Boundary conditions/" + holder->name,
                      "an opening that no boundary condition and no other "
                      "inflow holds");
    all_conditions.push_back(pushing(inflow, feeder));
    all_openings.add(feeder.mouth());
  }


  template <int dim>
  void
  Flow<dim>::fill(MaterialPoints<dim> &points) const
  {
    std::uint64_t next_id = points.n_points();
    for (const Feeder<dim> &feeder : feeders)
      feeder.fill(points, next_id);
  }


  template <int dim>
  void
  Flow<dim>::start(State<dim> &state) const
  {
    if (!is_used())
      return;
    FlowAccount<dim>          &account = state.flow;
    const MaterialPoints<dim> &points  = state.points;
    account.next_id                    = points.n_points();
    account.rows.assign(feeders.size(), 0);
    account.momentum_start = momentum(points);
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        account.mass_start += points.mass[p];
        account.force += points.mass[p] * points.acceleration[p];
      }
  }


  template <int dim>
  Tensor<1, dim>
  Flow<dim>::force(const NodeExchange    &ranks,
                   const NodalState      &nodes,
                   const StepReport<dim> &report,
                   const double           t) const
  {
    if (!scheme.has_inertia)
      return Tensor<1, dim>(); // no inertia, no impulse
    Tensor<1, dim>      sum;
    const double *const external = nodes.external_force.begin();
    for (std::size_t i = 0; i < nodes.mass.size(); ++i)
      if (ranks.owns(i))
        for (unsigned int c = 0; c < dim; ++c)
          sum[c] += external[dim * i + c];
    ranks.sum(&sum[0], dim);
    return residual_ramp(t, ramp_duration) * (report.reaction + sum);
  }


  template <int dim>
  void
  Flow<dim>::exchange(const NodalState      &nodes,
                      const StepReport<dim> &report,
                      const double           dt,
                      State<dim>            &state,
                      RankPart<dim> *const   part) const
  {
    if (!is_used())
      return;
    const NodeExchange &ranks =
      part != nullptr ? part->grid->exchange() : grid->exchange();
    FlowAccount<dim>    &account = state.flow;
    const Tensor<1, dim> now     = force(ranks, nodes, report, state.time);
    account.impulse += dt * (scheme.start_of_impulse * account.force +
                             (1. - scheme.start_of_impulse) * now);
    account.force = now;

    if (!outlets.empty())
      remove(state, part);
    if (!feeders.empty())
      feed(state, part);
  }


  template <int dim>
  void
  Flow<dim>::feed(State<dim> &state, RankPart<dim> *const part) const
  {
    FlowAccount<dim>    &account = state.flow;
    MaterialPoints<dim> &points  = state.points;
    for (std::size_t k = 0; k < feeders.size(); ++k)
      {
        const std::size_t n_new =
          feeders[k].feed(state.time, account.rows[k], points, account.next_id);
        account.points_in += n_new;
        for (std::size_t p = points.n_points() - n_new; p < points.n_points();
             ++p)
          {
            const double kinetic =
              scheme.has_inertia
                ? 0.5 * points.mass[p] * points.velocity[p].norm_square()
                : 0.;
            account.mass_in += points.mass[p];
            account.momentum_in += points.mass[p] * points.velocity[p];
            state.energy.kinetic += kinetic;
            state.energy.inflow += kinetic;
          }
      }
    if (part != nullptr)
      part->take_new();
  }


  template <int dim>
  void
  Flow<dim>::remove(State<dim> &state, RankPart<dim> *const part) const
  {
    const MaterialPoints<dim> &points =
      part != nullptr ? part->points() : state.points;
    const std::vector<std::size_t> own_list = points_beyond(outlets, points);
    const double                   any      = own_list.empty() ? 0. : 1.;
    if ((part != nullptr ? part->grid->exchange().largest(any) : any) == 0.)
      return;
    // Only what the sums below ask for.
    MaterialPoints<dim> gone;
    gone.resize(own_list.size());
    for (const NamedArray &scalar : points.scalars)
      {
        std::vector<double> &values = gone.scalar(scalar.name);
        for (std::size_t k = 0; k < own_list.size(); ++k)
          values[k] = scalar.values[own_list[k]];
      }
    double         mass = 0.;
    Tensor<1, dim> inertia;
    for (std::size_t k = 0; k < own_list.size(); ++k)
      {
        const std::size_t p = own_list[k];
        gone.material[k]    = points.material[p];
        gone.mass[k]        = points.mass[p];
        gone.volume[k]      = points.volume[p];
        gone.velocity[k]    = points.velocity[p];
        gone.stress[k]      = points.stress[p];
        mass += points.mass[p];
        inertia += points.mass[p] * points.acceleration[p];
      }
    Tensor<1, dim> momentum_out = momentum(gone);
    double         kinetic = scheme.has_inertia ? kinetic_energy(gone) : 0.;
    double         elastic = elastic_energy(gone, *materials);
    std::vector<std::size_t> list = own_list;
    if (part != nullptr)
      {
        std::vector<double> sums{mass, kinetic, elastic};
        for (unsigned int d = 0; d < dim; ++d)
          {
            sums.push_back(inertia[d]);
            sums.push_back(momentum_out[d]);
          }
        part->grid->exchange().sum(sums.data(), sums.size());
        mass    = sums[0];
        kinetic = sums[1];
        elastic = sums[2];
        for (unsigned int d = 0; d < dim; ++d)
          {
            inertia[d]      = sums[3 + 2 * d];
            momentum_out[d] = sums[4 + 2 * d];
          }
        list = part->remove(own_list);
      }
    FlowAccount<dim> &account = state.flow;
    account.points_out += list.size();
    account.mass_out += mass;
    account.force -= inertia;
    account.momentum_out += momentum_out;
    state.energy.kinetic -= kinetic;
    state.energy.elastic -= elastic;
    state.energy.outflow += kinetic + elastic;
    remove_points(list, state.points);
  }


  template class Flow<2>;
  template class Flow<3>;
} // namespace Waker
