// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/places.h>
#include <waker/campaign/field_target.h>
#include <waker/mechanics/time_scheme.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// More of a distribution than this beyond its limits is worth a warning.
    constexpr double largest_share_beyond = 0.01;
    /// Of the coefficients of variation of soils, with some room.
    constexpr double largest_variation = 1.;


    double
    upper_limit(const RandomFieldParameters &field)
    {
      return std::min(field.maximum < 1e299
                        ? field.maximum
                        : std::numeric_limits<double>::infinity(),
                      largest_possible(field.property));
    }
  } // namespace


  template <int dim>
  FieldTarget<dim>::FieldTarget(const Case<dim>             &the_case,
                                const RandomFieldParameters &parameters,
                                const unsigned int           field_number,
                                const unsigned int           material,
                                const FieldPlace<dim>       &place,
                                const FieldLattice          &lattice)
    : path("Random fields/" + parameters.name)
    , field(field_number)
    , material(material)
    , moments(the_case, parameters, material)
    , minimum(parameters.minimum)
    , maximum(upper_limit(parameters))
    , marginal(parameters.distribution, minimum, maximum)
  {
    check_stiffness(the_case, parameters);
    const MaterialPoints<dim> &all = the_case.initial_points;
    for (std::size_t q = 0; q < all.n_points(); ++q)
      if (all.material[q] == material)
        {
          const Point<dim> &x = all.initial_position[q];
          const auto [m, deviation] =
            moments.at(x, the_case.layers_of_points[q]);
          std::string problem;
          if (!moments.is_possible(m))
            problem = "is " + std::to_string(m);
          else if (!std::isfinite(deviation) || !(deviation >= 0.))
            throw UserError(path + "/Standard deviation",
                            "is " + std::to_string(deviation) + " at " +
                              place_text(x),
                            "a finite number of at least 0");
          else if (!(m >= minimum && m <= maximum))
            problem = "is " + std::to_string(m) + ", beyond the limits " +
                      std::to_string(minimum) + " and " +
                      std::to_string(maximum);
          else if (deviation > 0.)
            problem = marginal.problem(m, deviation);
          if (!problem.empty())
            throw UserError(path + "/Mean",
                            problem + " at " + place_text(x),
                            "a mean that fits distribution and limits, above "
                            "0 (0 or more but of an undrained shear strength, "
                            "a strength ratio, a unit weight and a Young's "
                            "modulus)");
          points.push_back(q);
          cells.push_back(lattice.cell_of(place.of(x)));
          mean.push_back(m);
          standard_deviation.push_back(deviation);
        }
  }


  template <int dim>
  void
  FieldTarget<dim>::check_stiffness(
    const Case<dim>             &the_case,
    const RandomFieldParameters &parameters) const
  {
    using Kind               = RandomProperty::Kind;
    const Kind        kind   = moments.varied().kind;
    const Parameters &given  = the_case.parameters;
    const auto        refuse = [&](const std::string &with,
                            const std::string &allowed) {
      throw UserError(path + "/Property",
                      "is \"" + moments.varied().name + "\", with " + with,
                      allowed);
    };
    if (kind != Kind::unit_weight && kind != Kind::stiffness)
      return;
    // These take density and moduli from the material.
    if (given.mapping.strain == StrainMeasure::logarithmic)
      refuse("logarithmic strain", "Strain = step, or another property");
    if (!scheme_traits(given.time).is_implicit)
      refuse("an explicit scheme", "an implicit scheme, or another property");
    if (kind == Kind::stiffness)
      {
        const double least =
          the_case.materials[material]->least_stiffness_ratio() *
          given.materials[material].elastic.youngs_modulus;
        if (least > 0. && !(minimum > least))
          throw UserError(path + "/Minimum",
                          "is " + in_digits(parameters.minimum) +
                            " kPa, where the softening of the material \"" +
                            given.materials[material].name +
                            "\" is steeper than the elastic unloading "
                            "(snap-back)",
                          "above " + in_digits(least) + " kPa");
      }
  }


  template <int dim>
  std::vector<std::string>
  FieldTarget<dim>::warnings(const std::string &material_name) const
  {
    const std::string        start = path + ", of \"" + material_name + "\": ";
    std::vector<std::string> lines;
    double                   most = 0., widest = 0.;
    std::size_t              at = 0, of_widest = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (standard_deviation[i] > 0.)
        {
          const double share =
            marginal.share_beyond(mean[i], standard_deviation[i]);
          if (share > most)
            {
              most = share;
              at   = i;
            }
          // Of a mean of 0, as at the surface, it says nothing.
          if (mean[i] > 0. && standard_deviation[i] > widest * mean[i])
            {
              widest    = standard_deviation[i] / mean[i];
              of_widest = i;
            }
        }
    if (most > largest_share_beyond)
      {
        std::ostringstream text;
        text << start << "with mean " << mean[at] << " and standard deviation "
             << standard_deviation[at] << " the limits cut off " << 100. * most
             << " % of the distribution, which becomes the limit itself: mean "
                "and deviation will be others";
        lines.push_back(text.str());
      }
    if (widest > largest_variation)
      {
        std::ostringstream text;
        text << start << "the standard deviation is "
             << standard_deviation[of_widest] << " where the mean is "
             << mean[of_widest] << ", a coefficient of variation of " << widest
             << "; soils have 0.02 to " << largest_variation;
        lines.push_back(text.str());
      }
    return lines;
  }


  template <int dim>
  MeasuredPlace<dim>
  measured_place(const Case<dim>                     &the_case,
                 const std::vector<FieldTarget<dim>> &targets,
                 const unsigned int                   field,
                 const std::size_t                    cell,
                 const Point<dim>                    &x)
  {
    const auto        &depths = the_case.ground.depths();
    MeasuredPlace<dim> found{nullptr, depths.n_layers()};
    for (const FieldTarget<dim> &target : targets)
      if (target.field == field)
        for (std::size_t i = 0; i < target.cells.size(); ++i)
          if (target.cells[i] == cell)
            {
              const unsigned int layer =
                the_case.layers_of_points[target.points[i]];
              found = {&target, layer};
              if (layer < depths.n_layers() && depths.holds(x, layer))
                return found;
            }
    return found;
  }


  template <int dim>
  double
  measured_score(const MeasuredPlace<dim> &at,
                 const std::string        &path,
                 const Point<dim>         &x,
                 const double              value,
                 const double              variance)
  {
    const std::string  where = path + "/Measurements";
    std::ostringstream what;
    what << "has the value " << value << " at " << place_text(x);
    if (at.target == nullptr)
      throw UserError(where,
                      what.str() + ", where the field has no points",
                      "measurements in soil of the field's material");
    const FieldTarget<dim> &target = *at.target;
    const auto [mean, deviation]   = target.moments.at(x, at.layer);
    std::string allowed;
    if (!target.moments.is_possible(mean) ||
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
  }


  template struct FieldTarget<2>;
  template struct FieldTarget<3>;
  template MeasuredPlace<2>
  measured_place(const Case<2> &,
                 const std::vector<FieldTarget<2>> &,
                 const unsigned int,
                 const std::size_t,
                 const Point<2> &);
  template MeasuredPlace<3>
  measured_place(const Case<3> &,
                 const std::vector<FieldTarget<3>> &,
                 const unsigned int,
                 const std::size_t,
                 const Point<3> &);
  template double
  measured_score(const MeasuredPlace<2> &,
                 const std::string &,
                 const Point<2> &,
                 const double,
                 const double);
  template double
  measured_score(const MeasuredPlace<3> &,
                 const std::string &,
                 const Point<3> &,
                 const double,
                 const double);
} // namespace Waker
