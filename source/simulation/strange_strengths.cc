// SPDX-License-Identifier: LGPL-2.1-or-later
#include "strange_strengths.h"

#include <deal.II/base/numbers.h>

#include <waker/base/expression_pattern.h>
#include <waker/case/k0_stress.h>
#include <waker/materials/shear_strength_table.h>

#include "plausible_ranges.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// The least and the largest of numbers of a material's points.
    class Extent
    {
    public:
      template <int dim>
      Extent(const MaterialPoints<dim> &points,
             const unsigned int         material,
             const std::vector<double> &values)
      {
        for (std::size_t p = 0; p < points.n_points(); ++p)
          if (points.material[p] == material)
            add(values[p]);
      }

      Extent() = default;

      void
      add(const double value)
      {
        least   = std::min(least, value);
        largest = std::max(largest, value);
      }

      /// Both, or the one that all are; none if there are no points.
      std::vector<double>
      ends() const
      {
        if (!(largest >= least))
          return {};
        if (largest == least)
          return {least};
        return {least, largest};
      }

      double least = std::numeric_limits<double>::infinity(), largest = -least;
    };


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
          const Extent extent(
            points,
            m,
            points.scalars[points.find_scalar(strength->name)].values);
          const std::string path = "Materials/" + materials[m].name + "/";
          for (const double value : extent.ends())
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
            const Extent      extent(points, m, points.scalars[array].values);
            const std::string path = "Materials/" + materials[m].name + "/";
            for (const double value : extent.ends())
              if (is_cohesion)
                check_cohesion(path, value, ranges);
              else
                check_friction_angle(path, value, ranges);
          }
    }


    /// What is left of strengths without drainage.
    template <int dim>
    void
    check_sensitivity(const Case<dim>          &the_case,
                      const MaterialParameters &m,
                      const unsigned int        number,
                      std::vector<std::string> &warnings)
    {
      constexpr double usual = 16.; // more has quick clay
      if (m.model != MaterialModel::von_mises_softening || !m.softens())
        return;
      const MaterialPoints<dim> &points = the_case.initial_points;
      const Material            &law    = *the_case.materials[number];
      const auto before = variable_of(law, MaterialVariable::Role::strength);
      const auto after =
        variable_of(law, MaterialVariable::Role::residual_strength);
      if (!before || !after)
        return;
      const auto &c_i = points.scalars[points.find_scalar(before->name)].values;
      const auto &c_r = points.scalars[points.find_scalar(after->name)].values;
      std::size_t worst = points.n_points();
      for (std::size_t p = 0; p < points.n_points(); ++p)
        if (points.material[p] == number &&
            (worst == points.n_points() ||
             c_i[p] * c_r[worst] > c_i[worst] * c_r[p]))
          worst = p;
      if (worst == points.n_points() || c_i[worst] <= usual * c_r[worst])
        return;
      std::ostringstream text;
      text << "Materials/" << m.name << "/Residual strength leaves "
           << c_r[worst] << " kPa of " << c_i[worst] << " kPa, a sensitivity ";
      if (c_r[worst] > 0.)
        text << "of " << c_i[worst] / c_r[worst];
      else
        text << "without a limit";
      text << "; clay and peat have 1 to " << usual << ", quick clay more";
      warnings.push_back(text.str());
    }


    /// A cut-off beyond the apex.
    template <int dim>
    void
    check_tensile_strength(const Case<dim>          &the_case,
                           const MaterialParameters &m,
                           const unsigned int        number,
                           std::vector<std::string> &warnings)
    {
      constexpr double round_off = 1e-6;
      const auto       given = plain_number(m.mohr_coulomb.tensile_strength);
      if (m.model != MaterialModel::mohr_coulomb || !given)
        return;
      const MaterialPoints<dim> &points   = the_case.initial_points;
      const int                  cohesion = points.find_scalar("cohesion"),
                angle      = points.find_scalar("friction angle");
      const bool has_table = m.mohr_coulomb.has_table();
      if (!has_table && (cohesion < 0 || angle < 0))
        return; // a program's own law
      ShearStrengthTable::Line of_table = {0., 0.};
      if (has_table)
        of_table =
          lines_through(shear_strength_entries(m.mohr_coulomb.strength_table,
                                               "Materials/" + m.name +
                                                 "/Shear strength table"))
            .front();
      Extent      cut;
      std::size_t n = 0, n_cut = 0;
      for (std::size_t p = 0; p < points.n_points(); ++p)
        {
          if (points.material[p] != number)
            continue;
          ++n;
          double c = of_table.cohesion, tan_phi = of_table.tan_phi;
          if (!has_table)
            {
              c = points.scalars[cohesion].values[p];
              tan_phi =
                std::tan(points.scalars[angle].values[p] * numbers::PI / 180.);
            }
          // Without friction there is no apex.
          if (!(*given * tan_phi > c * (1. + round_off)))
            continue;
          ++n_cut;
          cut.add(c / tan_phi);
        }
      if (n_cut == 0)
        return;
      std::ostringstream text;
      text << "Materials/" << m.name << "/Tensile strength is " << *given
           << " kPa, at " << n_cut << " of " << n
           << " points more than c cot(phi), to which it is cut: " << cut.least;
      if (cut.largest > cut.least * (1. + round_off))
        text << " to " << cut.largest;
      text << " kPa";
      warnings.push_back(text.str());
    }


    /// Horizontal stress at rest.
    template <int dim>
    void
    check_k0(const Case<dim>          &the_case,
             const MaterialParameters &m,
             const unsigned int        number,
             Ranges                   &ranges)
    {
      const InitialStressParameters &in = the_case.parameters.initial_stress;
      if (in.from != StressFrom::k0)
        return;
      const MaterialPoints<dim> &points = the_case.initial_points;
      const K0OfPoints<dim>      k0(m,
                               *the_case.materials[number],
                               the_case.ground,
                               points);
      if (in.daily_stage && k0.follows_stress())
        return; // of which the stress is not that of now
      Extent extent;
      for (std::size_t p = 0; p < points.n_points(); ++p)
        if (points.material[p] == number)
          extent.add(
            k0.value(p,
                     the_case.ground.at(points.initial_position[p],
                                        the_case.layers_of_points[p])));
      for (const double value : extent.ends())
        ranges.check(
          "Materials/" + m.name + "/K0", value, 0.3, 2., "", "soils have");
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
    const auto &materials = the_case.parameters.materials;
    for (unsigned int m = 0;
         m < std::min(materials.size(), the_case.materials.size());
         ++m)
      {
        check_sensitivity(the_case, materials[m], m, warnings);
        check_tensile_strength(the_case, materials[m], m, warnings);
        check_k0(the_case, materials[m], m, ranges);
      }
  }


  template void
  check_strengths_of_points(const Case<2> &, std::vector<std::string> &);
  template void
  check_strengths_of_points(const Case<3> &, std::vector<std::string> &);
} // namespace Waker
