// SPDX-License-Identifier: LGPL-2.1-or-later
#include "strange_strengths.h"

#include "plausible_ranges.h"
#include <algorithm>
#include <limits>

namespace Waker
{
  namespace
  {
    /// Strengths without drainage: the least and the largest of the points.
    template <int dim>
    void
    check_undrained_strengths(const Case<dim> &the_case, Ranges &ranges)
    {
      const MaterialPoints<dim>             &points = the_case.initial_points;
      const std::vector<MaterialParameters> &materials =
        the_case.parameters.materials;
      for (std::size_t m = 0;
           m < std::min(materials.size(), the_case.materials.size());
           ++m)
        {
          const auto strength = variable_of(*the_case.materials[m],
                                            MaterialVariable::Role::strength);
          if (!strength || !strength->initial_value.varies() ||
              !materials[m].undrained_strength())
            continue;
          const auto &values =
            points.scalars[points.find_scalar(strength->name)].values;
          double least = std::numeric_limits<double>::max(), largest = 0.;
          for (std::size_t p = 0; p < points.n_points(); ++p)
            if (points.material[p] == m)
              {
                least   = std::min(least, values[p]);
                largest = std::max(largest, values[p]);
              }
          if (!(largest >= least))
            continue; // no points
          const std::string path = "Materials/" + materials[m].name + "/";
          for (const double value : {least, largest})
            check_strength(path,
                           materials[m].von_mises.strength.name_of_parameter(),
                           value,
                           materials[m].elastic.youngs_modulus,
                           ranges);
        }
    }


    /// Cohesions and friction angles that are expressions, likewise.
    template <int dim>
    void
    check_friction_of_points(const Case<dim> &the_case, Ranges &ranges)
    {
      const MaterialPoints<dim>             &points = the_case.initial_points;
      const std::vector<MaterialParameters> &materials =
        the_case.parameters.materials;
      for (std::size_t m = 0;
           m < std::min(materials.size(), the_case.materials.size());
           ++m)
        for (const MaterialVariable &variable :
             the_case.materials[m]->variables())
          {
            const bool is_cohesion = variable.symbol == "cohesion";
            const int  array       = points.find_scalar(variable.name);
            if (array < 0 || !variable.initial_value.varies() ||
                !(is_cohesion || variable.symbol == "friction_angle"))
              continue;
            double least = std::numeric_limits<double>::max(), largest = 0.;
            for (std::size_t p = 0; p < points.n_points(); ++p)
              if (points.material[p] == m)
                {
                  const double value = points.scalars[array].values[p];
                  least              = std::min(least, value);
                  largest            = std::max(largest, value);
                }
            for (const double value : {least, largest})
              if (largest >= least) // there are points
                ranges.check("Materials/" + materials[m].name +
                               (is_cohesion ? "/Cohesion" : "/Friction angle"),
                             value,
                             is_cohesion ? 0.1 : 10.,
                             is_cohesion ? 200. : 50.,
                             is_cohesion ? " kPa" : " degrees",
                             "soils have");
          }
    }
  } // namespace


  template <int dim>
  void
  check_strengths_of_points(const Case<dim>          &the_case,
                            std::vector<std::string> &warnings)
  {
    Ranges ranges(warnings);
    check_undrained_strengths(the_case, ranges);
    check_friction_of_points(the_case, ranges);
  }


  template void
  check_strengths_of_points(const Case<2> &, std::vector<std::string> &);
  template void
  check_strengths_of_points(const Case<3> &, std::vector<std::string> &);
} // namespace Waker
