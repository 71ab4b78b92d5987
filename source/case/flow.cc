// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/case/flow.h>
#include <waker/case/state.h>
#include <waker/particles/polygon.h>
#include <waker/particles/removal.h>

#include <algorithm>
#include <limits>

namespace Waker
{
  namespace
  {
    FixityRegion
    region_of(const unsigned int face)
    {
      return region_of(static_cast<BoxFace>(face));
    }


    /// Do its nodes fill more than an edge of the opening? On `face`.
    template <int dim>
    bool
    overlaps(const FixityParameters &condition,
             const unsigned int      face,
             const Point<dim>       &lower,
             const Point<dim>       &upper,
             const double            h)
    {
      if (condition.region != FixityRegion::box &&
          condition.region != region_of(face))
        return false;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double from =
            condition.from.empty() ? lower[d] : condition.from[d];
          const double to = condition.to.empty() ? upper[d] : condition.to[d];
          if (d == face / 2)
            {
              if (condition.region == FixityRegion::box &&
                  (from > lower[d] || to < lower[d]))
                return false;
            }
          else if (!(std::min(to, upper[d]) - std::max(from, lower[d]) >
                     1e-6 * h))
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
          condition.from.push_back(feeder.lower()[d]);
          condition.to.push_back(feeder.upper()[d]);
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
    , outflow_faces(parameters.outflow.open_faces(dim))
    , all_conditions(parameters.fixities)
  {
    has_outflow = std::find(outflow_faces.begin(), outflow_faces.end(), true) !=
                  outflow_faces.end();
    const auto is_whole_and_held = [&](const FixityParameters &condition,
                                       const unsigned int      f) {
      return condition.region == region_of(f) && condition.from.empty() &&
             condition.to.empty() && condition.holds(f / 2);
    };
    for (unsigned int f = 0; f < 2 * dim; ++f)
      for (const FixityParameters &condition : parameters.fixities)
        if (outflow_faces[f] && is_whole_and_held(condition, f))
          throw UserError("Outflow/Faces",
                          std::string(name_of(static_cast<BoxFace>(f))) +
                            " is closed by Boundary conditions/" +
                            condition.name,
                          "faces that no boundary condition closes");

    for (const InflowParameters &inflow : parameters.inflows)
      {
        const std::string  path = "Inflow/" + inflow.name + "/Face";
        const unsigned int face = inflow.face_number();
        const unsigned int m    = material_number(inflow, parameters.materials);
        if (outflow_faces[face])
          throw UserError(path,
                          "is " + std::string(name_of(inflow.face)) +
                            ", which is in Outflow/Faces",
                          "another face");
        require_implicit(parameters.time, "there is an inflow");
        typename Feeder<dim>::Variables variables;
        for (const MaterialVariable &variable : materials[m]->variables())
          {
            const InitialValue &value = variable.initial_value;
            if (value.varies())
              throw UserError("Inflow/" + inflow.name + "/Material",
                              "is " + inflow.material + ", of which " +
                                value.path + " varies in space",
                              "a material with numbers: what flows in is the "
                              "same everywhere");
            variables.emplace_back(variable.name, value.number);
          }
        feeders.emplace_back(grid,
                             inflow,
                             parameters.points.points_per_direction,
                             m,
                             materials[m]->density(),
                             variables);
        const Feeder<dim> &feeder = feeders.back();
        if (!(inflow.velocity * parameters.time.time_step <=
              grid.cell_size() * (1. + 1e-9)))
          throw UserError("Inflow/" + inflow.name + "/Velocity",
                          "is " + in_digits(inflow.velocity) +
                            " m/s: more than a cell in a time step of " +
                            in_digits(parameters.time.time_step) + " s",
                          "at most " +
                            in_digits(grid.cell_size() /
                                      parameters.time.time_step) +
                            " m/s, or a shorter time step");
        for (const FixityParameters &condition : all_conditions)
          if (overlaps<dim>(condition,
                            face,
                            feeder.lower(),
                            feeder.upper(),
                            grid.cell_size()) &&
              condition.holds(face / 2))
            throw UserError(path,
                            "the opening on " +
                              std::string(name_of(inflow.face)) +
                              " is held by Boundary conditions/" +
                              condition.name,
                            "an opening that no boundary condition and no "
                            "other inflow holds");
        all_conditions.push_back(pushing(inflow, feeder));
        inflow_faces.push_back(face);
      }
  }


  template <int dim>
  std::vector<bool>
  Flow<dim>::open_faces() const
  {
    std::vector<bool> faces = outflow_faces;
    for (const unsigned int face : inflow_faces)
      faces[face] = true;
    return faces;
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
  Flow<dim>::force(const NodalState      &nodes,
                   const StepReport<dim> &report,
                   const double           t) const
  {
    if (!scheme.has_inertia)
      return Tensor<1, dim>(); // no inertia, no impulse
    Tensor<1, dim>      sum      = report.reaction;
    const double *const external = nodes.external_force.begin();
    for (std::size_t i = 0; i < nodes.mass.size(); ++i)
      for (unsigned int c = 0; c < dim; ++c)
        sum[c] += external[dim * i + c];
    return residual_ramp(t, ramp_duration) * sum;
  }


  template <int dim>
  void
  Flow<dim>::exchange(const NodalState      &nodes,
                      const StepReport<dim> &report,
                      const double           dt,
                      State<dim>            &state) const
  {
    if (!is_used())
      return;
    FlowAccount<dim>    &account = state.flow;
    const Tensor<1, dim> now     = force(nodes, report, state.time);
    account.impulse +=
      scheme.is_implicit ? 0.5 * dt * (account.force + now) : dt * now;
    account.force = now;

    if (has_outflow)
      remove(state);
    for (std::size_t k = 0; k < feeders.size(); ++k)
      {
        MaterialPoints<dim> &points = state.points;
        const std::size_t    n_new =
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
  }


  template <int dim>
  void
  Flow<dim>::remove(State<dim> &state) const
  {
    MaterialPoints<dim>           &points = state.points;
    const std::vector<std::size_t> list =
      points_beyond(*grid, outflow_faces, points);
    if (list.empty())
      return;
    // Only what the sums below ask for.
    MaterialPoints<dim> gone;
    gone.resize(list.size());
    FlowAccount<dim> &account = state.flow;
    account.points_out += list.size();
    for (std::size_t k = 0; k < list.size(); ++k)
      {
        const std::size_t p = list[k];
        gone.material[k]    = points.material[p];
        gone.mass[k]        = points.mass[p];
        gone.volume[k]      = points.volume[p];
        gone.velocity[k]    = points.velocity[p];
        gone.stress[k]      = points.stress[p];
        account.mass_out += points.mass[p];
        account.force -= points.mass[p] * points.acceleration[p];
      }
    account.momentum_out += momentum(gone);
    const double kinetic = scheme.has_inertia ? kinetic_energy(gone) : 0.;
    const double elastic = elastic_energy(gone, *materials);
    state.energy.kinetic -= kinetic;
    state.energy.elastic -= elastic;
    state.energy.outflow += kinetic + elastic;
    remove_points(list, points);
  }


  template class Flow<2>;
  template class Flow<3>;
} // namespace Waker
