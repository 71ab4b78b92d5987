// SPDX-License-Identifier: LGPL-2.1-or-later
// What points cannot have: of the means, and of what is drawn.
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/places.h>
#include <waker/campaign/random_properties.h>

#include <map>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// @throws UserError "Random fields/<name>/Mean"
    template <int dim>
    void
    check_mean_coefficient(const Case<dim>        &the_case,
                           const FieldTarget<dim> &target)
    {
      const RandomProperty &property = target.moments.varied();
      if (property.kind != RandomProperty::Kind::coefficient)
        return;
      const double least = the_case.materials[target.material]
                             ->coefficients()[property.number]
                             .least;
      for (std::size_t i = 0; i < target.points.size(); ++i)
        if (target.mean[i] < least)
          {
            const Point<dim> &x =
              the_case.initial_points.initial_position[target.points[i]];
            std::ostringstream text;
            text << "makes the " << property.name << " " << target.mean[i]
                 << " at " << place_text(x);
            throw UserError(target.path + "/Mean",
                            text.str(),
                            "at least " + in_digits(least));
          }
    }
  } // namespace


  template <int dim>
  void
  RandomProperties<dim>::check_means() const
  {
    using Kind                        = RandomProperty::Kind;
    const MaterialPoints<dim> &points = the_case->initial_points;
    for (const FieldTarget<dim> &target : targets)
      check_mean_coefficient(*the_case, target);
    for (unsigned int m = 0; m < the_case->materials.size(); ++m)
      {
        std::vector<std::size_t> fields_of; // numbers of the targets
        bool                     has_coefficients = false;
        for (std::size_t t = 0; t < targets.size(); ++t)
          if (targets[t].material == m)
            {
              const Kind kind  = targets[t].moments.varied().kind;
              has_coefficients = has_coefficients || kind == Kind::coefficient;
              if (kind == Kind::variable)
                fields_of.push_back(t);
            }
        // What follows from coefficients is looked at when it is drawn.
        if (fields_of.empty() || has_coefficients)
          continue;
        const Material &law  = *the_case->materials[m];
        const auto      list = law.variables();
        // Where each variable comes from: a field, or the share of one.
        std::vector<const FieldTarget<dim> *> field(list.size(), nullptr);
        std::vector<const Residual *>         share(list.size(), nullptr);
        for (const std::size_t t : fields_of)
          field[targets[t].moments.varied().number] = &targets[t];
        for (const Residual &residual : residuals)
          for (std::size_t v = 0; v < list.size(); ++v)
            if (targets[residual.target].material == m &&
                list[v].name == residual.name)
              {
                field[v] = &targets[residual.target];
                share[v] = &residual;
              }
        const auto &of_material = targets[fields_of[0]].points;
        std::vector<const std::vector<double> *> arrays(list.size(), nullptr);
        for (std::size_t v = 0; v < list.size(); ++v)
          if (field[v] == nullptr)
            arrays[v] = &points.scalar(list[v].name);
        std::vector<double> values(list.size());
        for (std::size_t i = 0; i < of_material.size(); ++i)
          {
            for (std::size_t v = 0; v < list.size(); ++v)
              values[v] = field[v] == nullptr
                            ? (*arrays[v])[of_material[i]]
                            : field[v]->mean[i] *
                                (share[v] == nullptr ? 1. : share[v]->ratio[i]);
            const auto problem = law.initial_problem(values);
            if (!problem)
              continue;
            const unsigned int      v = problem->first;
            const FieldTarget<dim> &from =
              field[v] != nullptr ? *field[v] : targets[fields_of[0]];
            std::ostringstream text;
            text << "makes the " << list[v].name << " " << values[v] << " "
                 << list[v].unit << " at "
                 << place_text(points.initial_position[of_material[i]]);
            throw UserError(from.path + "/Mean", text.str(), problem->second);
          }
      }
  }


  template <int dim>
  std::vector<typename RandomProperties<dim>::BeyondLaw>
  RandomProperties<dim>::beyond_laws(const State<dim> &state) const
  {
    std::map<unsigned int, const FieldTarget<dim> *> of_materials;
    for (const FieldTarget<dim> &target : targets)
      of_materials.emplace(target.material, &target);
    std::vector<BeyondLaw> all;
    for (const auto &[m, target] : of_materials)
      {
        const Material                          &law  = *the_case->materials[m];
        const auto                               list = law.variables();
        std::vector<const std::vector<double> *> arrays;
        for (const MaterialVariable &variable : list)
          arrays.push_back(
            &state.points.scalars[state.points.find_scalar(variable.name)]
               .values);
        // Drawn coefficients, and where points have them.
        std::vector<std::pair<MaterialVariable, const std::vector<double> *>>
          coefficients;
        for (const MaterialVariable &c : law.coefficients())
          if (has_field(m, c.name))
            coefficients.emplace_back(c, &state.points.scalar(c.name));
        std::map<unsigned int, BeyondLaw> beyond; // by variable, coefficient
        const auto                        count = [&](const unsigned int      number,
                               const MaterialVariable &what,
                               const double            value,
                               const std::string      &allowed) {
          ++beyond
              .try_emplace(
                number,
                BeyondLaw{m, target->points.size(), what, 0, value, allowed})
              .first->second.n;
        };
        std::vector<double> values(list.size());
        for (const std::size_t q : target->points)
          {
            for (std::size_t v = 0; v < list.size(); ++v)
              values[v] = (*arrays[v])[q];
            const auto problem = law.initial_problem(values);
            if (problem)
              {
                const auto [v, allowed] = *problem;
                count(v, list[v], values[v], allowed);
                continue;
              }
            // A point counts once.
            for (unsigned int c = 0; c < coefficients.size(); ++c)
              {
                const auto &[coefficient, drawn] = coefficients[c];
                if (!((*drawn)[q] < coefficient.least))
                  continue;
                count(list.size() + c,
                      coefficient,
                      (*drawn)[q],
                      "at least " + in_digits(coefficient.least));
                break;
              }
          }
        for (const auto &[v, b] : beyond)
          all.push_back(b);
      }
    return all;
  }


  template <int dim>
  std::optional<std::uint64_t>
  RandomProperties<dim>::n_beyond_law(const State<dim> &state) const
  {
    if (fields == nullptr)
      return {};
    std::uint64_t n = 0;
    for (const BeyondLaw &b : beyond_laws(state))
      n += b.n;
    return n;
  }


  template <int dim>
  std::vector<std::string>
  RandomProperties<dim>::cut_off(const State<dim> &state) const
  {
    using Role = MaterialVariable::Role;
    std::vector<std::string> lines;
    for (std::size_t t = 0; t < n_cut_off.size(); ++t)
      if (n_cut_off[t] > 0)
        lines.push_back(
          targets[t].path + ": " + std::to_string(n_cut_off[t]) + " of " +
          std::to_string(targets[t].points.size()) +
          " points of the material "
          "\"" +
          the_case->parameters.materials[targets[t].material].name +
          "\" are cut off at a limit");
    for (const BeyondLaw &b : beyond_laws(state))
      {
        const bool is_least = b.variable.role == Role::coefficient;
        const bool is_most  = b.variable.role == Role::dilatancy ||
                             b.variable.role == Role::residual_strength;
        std::ostringstream text;
        text << "Random fields: at " << b.n << " of " << b.n_of
             << " points of the material \""
             << the_case->parameters.materials[b.material].name << "\" the "
             << b.variable.name
             << (is_least  ? " counts as the least that its law takes"
                 : is_most ? " counts as the most that its law takes"
                           : " is none that its law would start with")
             << ": at the first of them it is " << b.value << ", allowed "
             << b.allowed;
        lines.push_back(text.str());
      }
    return lines;
  }


  template void
  RandomProperties<2>::check_means() const;
  template void
  RandomProperties<3>::check_means() const;
  template std::optional<std::uint64_t>
  RandomProperties<2>::n_beyond_law(const State<2> &) const;
  template std::optional<std::uint64_t>
  RandomProperties<3>::n_beyond_law(const State<3> &) const;
  template std::vector<std::string>
  RandomProperties<2>::cut_off(const State<2> &) const;
  template std::vector<std::string>
  RandomProperties<3>::cut_off(const State<3> &) const;
} // namespace Waker
