// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/places.h>
#include <waker/base/random_numbers.h>
#include <waker/base/ranks.h>
#include <waker/base/sizes.h>
#include <waker/campaign/random_properties.h>
#include <waker/case/initial_stress.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Waker
{
  namespace
  {
    using Kind = RandomProperty::Kind;


    /// The check of the parameters knows names only, and one may be empty.
    template <int dim>
    void
    check_once(const Case<dim>                     &the_case,
               const std::vector<FieldTarget<dim>> &targets,
               const FieldTarget<dim>              &target,
               const RandomFieldsParameters        &parameters)
    {
      for (const FieldTarget<dim> &other : targets)
        if (other.material == target.material &&
            other.moments.varied().name == target.moments.varied().name)
          throw UserError(
            target.path + "/Property",
            "is \"" + target.moments.varied().name +
              "\", of which the material \"" +
              the_case.parameters.materials[target.material].name +
              "\" has a field already, \"" +
              parameters.fields[other.field].name + "\"",
            "one field per property and material");
    }


    /// The names of the materials that have none of these numbers.
    template <int dim>
    std::string
    names_not_in(const Case<dim>                 &the_case,
                 const std::vector<unsigned int> &numbers)
    {
      std::string names;
      for (unsigned int m = 0; m < the_case.parameters.materials.size(); ++m)
        if (std::find(numbers.begin(), numbers.end(), m) == numbers.end())
          names +=
            (names.empty() ? "" : ", ") + the_case.parameters.materials[m].name;
      return names;
    }


    /// What changes the stress at the start of each realisation must leave it
    /// one that a realisation finds by itself.
    template <int dim>
    void
    check_stress(const Case<dim> &the_case, const FieldTarget<dim> &target)
    {
      const RandomProperty &property = target.moments.varied();
      if ((property.kind == RandomProperty::Kind::unit_weight ||
           property.kind == RandomProperty::Kind::stiffness) &&
          !the_case.parameters.initial_stress.is_gravity_step())
        throw UserError(target.path + "/Property",
                        "is \"" + property.name +
                          "\", which changes the stress at the start, and "
                          "Initial stress asks for more than a gravity step",
                        "Initial stress/From = gravity, Laws = elastic and "
                        "Daily stage = false; or another property");
    }
  } // namespace


  template <int dim>
  RandomProperties<dim>::RandomProperties(
    const Case<dim>              &the_case,
    const RandomFieldsParameters &parameters)
    : the_case(&the_case)
  {
    if (parameters.fields.empty())
      return;
    std::vector<FieldLattice> lattices;
    const FieldPlace<dim>     place(the_case);
    for (unsigned int f = 0; f < parameters.fields.size(); ++f)
      {
        const RandomFieldParameters &field = parameters.fields[f];
        const std::string            path  = "Random fields/" + field.name;
        names.push_back(field.name);
        average_deviations.push_back(std::sqrt(1. - field.local_share));
        const std::vector<unsigned int> of_field =
          materials_of(the_case, field);
        if (const std::string others = names_not_in(the_case, of_field);
            field.material_names() == std::vector<std::string>{"all"} &&
            !others.empty())
          left_out.push_back("Random field \"" + field.name + "\": not of " +
                             others + ", whose law has no " +
                             name_of(field.property));
        for (const unsigned int material : of_field)
          {
            if (lattices.size() == f)
              {
                // What is wrong with the property comes first.
                FieldMoments<dim>(the_case, field, material);
                lattices.push_back(place.lattice(field.cell_size, path));
                check_lattice_size(lattices.back(), path);
              }
            FieldTarget<dim> target(
              the_case, field, f, material, place, lattices.back());
            check_once(the_case, targets, target, parameters);
            check_stress(the_case, target);
            targets.push_back(std::move(target));
          }
      }
    unit_of_first = targets[0].moments.varied().unit;
    find_residuals();
    check_means();
    dependent.emplace(the_case, targets);

    const auto score = [&](const unsigned int           f,
                           const std::array<double, 3> &at,
                           const double                 value,
                           const double                 variance) {
      Point<dim> x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = at[d];
      return measured_score(
        measured_place(the_case, targets, f, lattices[f].cell_of(at), x),
        "Random fields/" + names[f],
        x,
        value,
        variance);
    };
    const MPI_Comm ranks = the_case.grid.communicator();
    first_rank_does(ranks, [&]() {
      fields = std::make_unique<RandomFields>(parameters, lattices, score);
    });
    if (!fields)
      fields =
        std::make_unique<RandomFields>(parameters, lattices, score, false);
  }


  template <int dim>
  bool
  RandomProperties<dim>::has_field(const unsigned int material,
                                   const std::string &name) const
  {
    return std::any_of(targets.begin(), targets.end(), [&](const auto &target) {
      return target.material == material &&
             target.moments.varied().name == name;
    });
  }


  template <int dim>
  void
  RandomProperties<dim>::find_residuals()
  {
    // What softening leaves goes along, unless it has its own field.
    const MaterialPoints<dim> &points = the_case->initial_points;
    for (std::size_t t = 0; t < targets.size(); ++t)
      for (const MaterialVariable &variable :
           the_case->materials[targets[t].material]->variables())
        {
          const std::string &property = targets[t].moments.varied().name;
          if (variable.goes_along_with != property ||
              has_field(targets[t].material, variable.name))
            continue;
          Residual                   residual{t, variable.name, {}};
          const std::vector<double> &c_i = points.scalar(property);
          const std::vector<double> &c_r = points.scalar(variable.name);
          for (const std::size_t q : targets[t].points)
            residual.ratio.push_back(c_i[q] > 0. ? c_r[q] / c_i[q] : 1.);
          residuals.push_back(std::move(residual));
        }
  }


  template <int dim>
  std::vector<double> &
  RandomProperties<dim>::scalar_of(const RandomProperty &property,
                                   State<dim>           &state) const
  {
    const bool           is_new = state.points.find_scalar(property.name) < 0;
    std::vector<double> &values = state.points.scalar(property.name);
    // Elsewhere a coefficient is that of the point's material.
    if (is_new)
      for (unsigned int m = 0; m < the_case->materials.size(); ++m)
        for (const auto &c : the_case->materials[m]->coefficients())
          if (c.name == property.name)
            for (std::size_t q = 0; q < values.size(); ++q)
              if (state.points.material[q] == m)
                values[q] = c.initial_value.number;
    return values;
  }


  template <int dim>
  void
  RandomProperties<dim>::apply(const double *noise, State<dim> &state) const
  {
    if (fields == nullptr)
      return;
    const MPI_Comm ranks = the_case->grid.communicator();
    if (is_first_rank(ranks))
      fields->generate(noise, scores, averages);
    scores.resize(fields->n_fields());
    averages.resize(fields->n_fields());
    for (unsigned int f = 0; f < fields->n_fields(); ++f)
      {
        scores[f].resize(fields->lattice(f).n());
        share(ranks, scores[f]);
      }
    share(ranks, averages);
    set(true, state);
  }


  template <int dim>
  void
  RandomProperties<dim>::apply_means(State<dim> &state) const
  {
    if (fields != nullptr)
      set(false, state);
  }


  template <int dim>
  double
  RandomProperties<dim>::value(const FieldTarget<dim> &target,
                               const std::size_t       i,
                               const bool              is_random) const
  {
    return is_random ? target.value(i,
                                    scores[target.field][target.cells[i]],
                                    fields->score_variance(target.field))
                     : target.mean[i];
  }


  template <int dim>
  void
  RandomProperties<dim>::set(const bool is_random, State<dim> &state) const
  {
    n_cut_off.assign(targets.size(), 0);
    std::vector<CellWeights> weights;
    set_weights(is_random, weights, state);
    for (const Kind kind : {Kind::coefficient, Kind::variable})
      {
        for (std::size_t t = 0; t < targets.size(); ++t)
          {
            const FieldTarget<dim> &target   = targets[t];
            const RandomProperty   &property = target.moments.varied();
            if (property.kind != kind)
              continue;
            std::vector<double> &values = scalar_of(property, state);
            for (std::size_t i = 0; i < target.points.size(); ++i)
              {
                const std::size_t q = target.points[i];
                values[q]           = value(target, i, is_random);
                if (!std::isfinite(values[q]))
                  throw NumericalFailure(
                    target.path + ": the " + property.name + " at " +
                    place_text(state.points.initial_position[q]) +
                    " is not finite");
                n_cut_off[t] += target.is_cut_off(values[q]);
              }
          }
        if (kind == Kind::coefficient)
          dependent->set(weight_ratio(*the_case, weights), state);
      }
    // What depends on coefficients sets all variables of its points.
    const bool is_stiffness_set = set_stiffness(is_random, state);
    for (const Residual &residual : residuals)
      {
        const FieldTarget<dim>    &target = targets[residual.target];
        std::vector<double>       &left   = state.points.scalar(residual.name);
        const std::vector<double> &strength =
          state.points.scalar(target.moments.varied().name);
        for (std::size_t i = 0; i < target.points.size(); ++i)
          left[target.points[i]] =
            residual.ratio[i] * strength[target.points[i]];
      }
    if (!weights.empty() || is_stiffness_set)
      renew_initial_stress(*the_case, state);
    else
      consolidate(the_case->materials, state.points);
  }


  template <int dim>
  std::pair<double, double>
  RandomProperties<dim>::mean_and_least(const unsigned int field,
                                        const State<dim>  &state) const
  {
    double sum = 0., mass = 0., least = std::numeric_limits<double>::infinity();
    for (const FieldTarget<dim> &target : targets)
      if (target.field == field)
        {
          const std::vector<double> &values =
            state.points.scalar(target.moments.varied().name);
          for (const std::size_t q : target.points)
            {
              sum += state.points.mass[q] * values[q];
              mass += state.points.mass[q];
              least = std::min(least, values[q]);
            }
        }
    return mass > 0. ? std::make_pair(sum / mass, least)
                     : std::make_pair(0., 0.);
  }


  template <int dim>
  std::pair<double, double>
  RandomProperties<dim>::mean_and_least(const State<dim> &state) const
  {
    return mean_and_least(0, state);
  }


  template <int dim>
  std::vector<std::string>
  RandomProperties<dim>::description() const
  {
    if (fields == nullptr)
      return {};
    std::vector<std::string> lines = fields->description();
    lines.insert(lines.end(), left_out.begin(), left_out.end());
    return lines;
  }


  template class RandomProperties<2>;
  template class RandomProperties<3>;
} // namespace Waker
