// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/random_numbers.h>
#include <waker/base/sizes.h>
#include <waker/campaign/field_moments.h>
#include <waker/campaign/field_place.h>
#include <waker/campaign/random_properties.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// More of a distribution than this beyond its limits is worth a warning.
    constexpr double largest_share_beyond = 0.01;


    template <int dim>
    unsigned int
    material_number(const Case<dim>             &the_case,
                    const RandomFieldParameters &field)
    {
      const auto &materials = the_case.parameters.materials;
      std::string names;
      for (unsigned int m = 0; m < materials.size(); ++m)
        {
          if (materials[m].name == field.material ||
              (field.material.empty() && materials.size() == 1))
            return m;
          names += (m > 0 ? ", " : "") + materials[m].name;
        }
      throw UserError("Random fields/" + field.name + "/Material",
                      "is \"" + field.material + "\"",
                      "one of the materials: " + names);
    }
  } // namespace


  template <int dim>
  RandomProperties<dim>::RandomProperties(
    const Case<dim>              &the_case,
    const RandomFieldsParameters &parameters)
  {
    if (parameters.fields.empty())
      return;

    const MaterialPoints<dim>     &points = the_case.initial_points;
    std::vector<unsigned int>      numbers; // of the fields' materials
    std::vector<FieldLattice>      lattices;
    std::vector<FieldMoments<dim>> moments;
    const FieldPlace<dim>          place(the_case);
    for (const RandomFieldParameters &field : parameters.fields)
      {
        const std::string  path     = "Random fields/" + field.name;
        const unsigned int material = material_number(the_case, field);
        // The check of the parameters knows names only, and one may be empty.
        for (std::size_t f = 0; f < numbers.size(); ++f)
          if (numbers[f] == material &&
              parameters.fields[f].property == field.property)
            throw UserError(path + "/Property",
                            "is \"" + std::string(name_of(field.property)) +
                              "\", of which the material \"" +
                              the_case.parameters.materials[material].name +
                              "\" has a field already, \"" +
                              parameters.fields[f].name + "\"",
                            "one field per property and material");
        numbers.push_back(material);
        moments.emplace_back(the_case, field, material);

        const double largest =
          std::min(field.maximum < 1e299
                     ? field.maximum
                     : std::numeric_limits<double>::infinity(),
                   largest_possible(field.property));
        Target target{path,
                      moments.back().variable_name(),
                      Marginal(field.distribution, field.minimum, largest),
                      {},
                      {},
                      {},
                      {},
                      {},
                      {}};
        lattices.push_back(place.lattice(field.cell_size, path));
        check_lattice_size(lattices.back(), path);
        for (std::size_t q = 0; q < points.n_points(); ++q)
          if (points.material[q] == material)
            {
              const Point<dim> &x = points.initial_position[q];
              const auto [mean, deviation] =
                moments.back().at(x, the_case.layers_of_points[q]);
              std::string problem;
              if (!moments.back().is_possible(mean))
                problem = "is " + std::to_string(mean);
              else if (!std::isfinite(deviation) || !(deviation >= 0.))
                throw UserError(path + "/Standard deviation",
                                "is " + std::to_string(deviation) + " at (" +
                                  place_text(dim, coordinates(x)) + ")",
                                "a finite number of at least 0");
              else if (!(mean >= field.minimum && mean <= largest))
                problem = "is " + std::to_string(mean) +
                          ", beyond the limits " +
                          std::to_string(field.minimum) + " and " +
                          std::to_string(largest);
              else if (deviation > 0.)
                problem = target.marginal.problem(mean, deviation);
              if (!problem.empty())
                throw UserError(path + "/Mean",
                                problem + " at (" +
                                  place_text(dim, coordinates(x)) + ")",
                                "a mean that fits distribution and limits, "
                                "above 0 (0 or more but of an undrained shear "
                                "strength)");
              target.points.push_back(q);
              target.cells.push_back(lattices.back().cell_of(place.of(x)));
              target.mean.push_back(mean);
              target.standard_deviation.push_back(deviation);
            }

        // What softening leaves goes along, unless it has its own field.
        for (const MaterialVariable &variable :
             the_case.materials[material]->variables())
          {
            if (targets.empty() && variable.name == target.property)
              unit_of_first = variable.unit;
            if (variable.goes_along_with != target.property)
              continue;
            bool alone = false;
            for (const RandomFieldParameters &other : parameters.fields)
              alone = alone || (name_of(other.property) == variable.name &&
                                material_number(the_case, other) == material);
            if (alone)
              continue;
            AssertThrow(target.residual.empty(),
                        ExcMessage("two variables go along with one"));
            const auto initial = [&](const std::string &name) {
              return points.scalars[points.find_scalar(name)].values.data();
            };
            const double *const c_i = initial(target.property);
            const double *const c_r = initial(variable.name);
            target.residual         = variable.name;
            for (const std::size_t q : target.points)
              target.residual_ratio.push_back(c_i[q] > 0. ? c_r[q] / c_i[q]
                                                          : 1.);
          }
        targets.push_back(std::move(target));
      }

    const auto score = [&](const unsigned int           f,
                           const std::array<double, 3> &place,
                           const double                 value,
                           const double                 variance) {
      const Target &target = targets[f];
      Point<dim>    x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = place[d];

      std::ostringstream what;
      what << "has the value " << value << " at (" << place_text(dim, place)
           << ")";
      const std::string        where = target.path + "/Measurements";
      const std::size_t        cell  = lattices[f].cell_of(place);
      std::vector<std::size_t> there; // points
      for (std::size_t i = 0; i < target.cells.size(); ++i)
        if (target.cells[i] == cell)
          there.push_back(target.points[i]);
      if (there.empty())
        throw UserError(where,
                        what.str() + ", where the field has no points",
                        "measurements in soil of the field's material");
      const auto [mean, deviation] =
        moments[f].at(x, moments[f].layer_at(x, there));
      std::string allowed;
      if (!moments[f].is_possible(mean) ||
          !target.marginal.problem(mean, deviation).empty())
        allowed = "none: there is no such distribution there";
      else
        allowed = target.marginal.value_problem(value, mean, deviation);
      if (!allowed.empty())
        throw UserError(where,
                        what.str(),
                        "a value that the distribution can take at that place, "
                        "with mean " +
                          std::to_string(mean) + " and standard deviation " +
                          std::to_string(deviation) + ": " + allowed);
      return target.marginal.normal_score(value, mean, deviation, variance);
    };
    fields = std::make_unique<RandomFields>(parameters, lattices, score);
  }


  template <int dim>
  void
  RandomProperties<dim>::apply(const double *noise, State<dim> &state) const
  {
    if (fields == nullptr)
      return;
    fields->generate(noise, scores);
    for (std::size_t f = 0; f < targets.size(); ++f)
      {
        const Target        &target   = targets[f];
        std::vector<double> &values   = state.points.scalar(target.property);
        const double         variance = fields->score_variance(f);
        for (std::size_t i = 0; i < target.points.size(); ++i)
          {
            const std::size_t q = target.points[i];
            values[q]           = target.standard_deviation[i] > 0.
                                    ? target.marginal.value(scores[f][target.cells[i]],
                                                  target.mean[i],
                                                  target.standard_deviation[i],
                                                  variance)
                                    : target.mean[i];
            if (!std::isfinite(values[q]))
              throw NumericalFailure(
                target.path + ": the " + target.property + " at (" +
                place_text(dim, coordinates(state.points.initial_position[q])) +
                ") is not finite");
          }
        set_residual(target, state);
      }
  }


  template <int dim>
  void
  RandomProperties<dim>::apply_means(State<dim> &state) const
  {
    for (const Target &target : targets)
      {
        std::vector<double> &values = state.points.scalar(target.property);
        for (std::size_t i = 0; i < target.points.size(); ++i)
          values[target.points[i]] = target.mean[i];
        set_residual(target, state);
      }
  }


  template <int dim>
  void
  RandomProperties<dim>::set_residual(const Target &target,
                                      State<dim>   &state) const
  {
    if (target.residual_ratio.empty())
      return;
    std::vector<double>       &residual = state.points.scalar(target.residual);
    const std::vector<double> &strength = state.points.scalar(target.property);
    for (std::size_t i = 0; i < target.points.size(); ++i)
      {
        const std::size_t q = target.points[i];
        residual[q]         = target.residual_ratio[i] * strength[q];
      }
  }


  template <int dim>
  std::pair<double, double>
  RandomProperties<dim>::mean_and_least(const State<dim> &state) const
  {
    if (targets.empty() || targets[0].points.empty())
      return {0., 0.};
    const int number = state.points.find_scalar(targets[0].property);
    const std::vector<double> &values = state.points.scalars[number].values;
    double sum = 0., mass = 0., least = values[targets[0].points[0]];
    for (const std::size_t q : targets[0].points)
      {
        sum += state.points.mass[q] * values[q];
        mass += state.points.mass[q];
        least = std::min(least, values[q]);
      }
    return {sum / mass, least};
  }


  template <int dim>
  std::vector<std::string>
  RandomProperties<dim>::description() const
  {
    return fields == nullptr ? std::vector<std::string>()
                             : fields->description();
  }


  template <int dim>
  std::vector<std::string>
  RandomProperties<dim>::warnings() const
  {
    if (fields == nullptr)
      return {};
    std::vector<std::string> lines = fields->warnings();
    for (const Target &target : targets)
      {
        double      most = 0.;
        std::size_t at   = 0;
        for (std::size_t i = 0; i < target.points.size(); ++i)
          if (target.standard_deviation[i] > 0.)
            {
              const double share =
                target.marginal.share_beyond(target.mean[i],
                                             target.standard_deviation[i]);
              if (share > most)
                {
                  most = share;
                  at   = i;
                }
            }
        if (!(most > largest_share_beyond))
          continue;
        std::ostringstream text;
        text << target.path << ": with mean " << target.mean[at]
             << " and standard deviation " << target.standard_deviation[at]
             << " the limits cut off " << 100. * most
             << " % of the distribution, which becomes the limit itself: mean "
                "and deviation will be others";
        lines.push_back(text.str());
      }
    return lines;
  }


  std::vector<double>
  realisation_noise(const std::uint64_t seed,
                    const std::uint64_t realisation,
                    const std::size_t   n)
  {
    std::vector<double> noise(n);
    white_noise({seed, realisation, 0}, 0, n, noise.data());
    return noise;
  }


  template class RandomProperties<2>;
  template class RandomProperties<3>;
} // namespace Waker
