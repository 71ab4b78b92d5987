// SPDX-License-Identifier: LGPL-2.1-or-later
#include "strange_cam_clay.h"

#include <waker/base/expression_pattern.h>
#include <waker/base/places.h>
#include <waker/case/initial_properties.h>

#include "plausible_ranges.h"
#include <algorithm>
#include <cmath>
#include <sstream>

namespace Waker
{
  namespace
  {
    const double degree = std::acos(-1.) / 180.;


    void
    check_ranges(const std::string        &path,
                 const MaterialParameters &m,
                 std::vector<std::string> &warnings)
    {
      const ModifiedCamClayParameters &clay = m.cam_clay;
      Ranges                           ranges(warnings);
      ranges.check(
        path + "Lambda", clay.lambda, 0.03, 4., "", "clay and peat have");
      ranges.check(path + "Kappa by Lambda",
                   clay.kappa / clay.lambda,
                   0.05,
                   0.4,
                   "",
                   "clay and peat have");
      ranges.check(
        path + "Void ratio", clay.void_ratio, 0.4, 20., "", "soils have");
      ranges.check(path + "OCR", clay.ocr, 1., 10., "", "usual is");
      ranges.check(
        path + "POP", m.von_mises.strength.pop, 0., 100., " kPa", "usual is");
      ranges.check(path + "Least pressure",
                   clay.least_pressure,
                   0.1,
                   10.,
                   " kPa",
                   "usual is");
      if (const auto phi = plain_number(m.mohr_coulomb.friction_angle))
        ranges.check(path + "Friction angle",
                     *phi,
                     15.,
                     50.,
                     " degrees",
                     "at critical state soils have");
    }


    /// The circle in the deviatoric plane.
    void
    warn_of_plane_strain(const std::string        &path,
                         const MaterialParameters &m,
                         std::vector<std::string> &warnings)
    {
      const auto phi = plain_number(m.mohr_coulomb.friction_angle);
      if (!phi || m.cam_clay.holds != FrictionHolds::triaxial_compression)
        return;
      const double sine =
        critical_state_ratio(*phi, m.cam_clay.holds) / std::sqrt(3.);
      std::ostringstream text;
      text.precision(3);
      text << path << "Friction angle is " << *phi
           << " degrees in triaxial compression; as the yield surface is a "
              "circle, in plane strain it is ";
      if (sine < 1.)
        text << std::asin(sine) / degree << " degrees";
      else
        text << "without a limit";
      text << ". Friction angle holds in = plane strain keeps it there";
      warnings.push_back(text.str());
    }


    void
    warn_of_stiffness(const std::string        &path,
                      const MaterialParameters &m,
                      std::vector<std::string> &warnings)
    {
      constexpr double usual = 30., usual_largest = 500.; // p', p_c, kPa
      const double     G     = m.elastic.shear_modulus();
      const double     least = 2. / 3. * G * m.cam_clay.swelling(); // 3 K = 2 G
      if (least > usual)
        {
          std::ostringstream text;
          text << path << "Young's modulus gives a shear modulus of " << G
               << " kPa at any pressure, and Kappa a bulk modulus that grows "
                  "with it: below p' = "
               << least << " kPa Poisson's ratio is negative";
          warnings.push_back(text.str());
        }
      // Of an expression an angle that is rather large.
      const double limit = m.cam_clay.snap_back_pressure(
        m.elastic, plain_number(m.mohr_coulomb.friction_angle).value_or(40.));
      if (limit < usual_largest)
        {
          std::ostringstream text;
          text << path
               << "Model is modified Cam clay: points with a preconsolidation "
                  "pressure of more than "
               << limit
               << " kPa may lose it at once on the dry side (snap-back); not "
                  "with a larger Young's modulus, or Lambda further above "
                  "Kappa";
          warnings.push_back(text.str());
        }
    }
  } // namespace


  void
  warn_of_cam_clay(const MaterialParameters &m,
                   const unsigned int        dim,
                   std::vector<std::string> &warnings)
  {
    const std::string path = "Materials/" + m.name + "/";
    if (m.model != MaterialModel::modified_cam_clay)
      return;
    check_ranges(path, m, warnings);
    if (dim == 2)
      warn_of_plane_strain(path, m, warnings);
    warn_of_stiffness(path, m, warnings);
  }


  namespace
  {
    /// Points whose stress no preconsolidation pressure explains: above
    /// critical state, or in tension.
    template <int dim>
    void
    warn_of_stress_outside(const Case<dim>          &the_case,
                           const unsigned int        m,
                           std::vector<std::string> &warnings)
    {
      constexpr double           noticed = 1e-3; // kPa
      const MaterialPoints<dim> &points  = the_case.initial_points;
      const Material            &law     = *the_case.materials[m];
      std::vector<int>           arrays;
      for (const MaterialVariable &variable : law.variables())
        arrays.push_back(points.find_scalar(variable.name));
      std::vector<double> variables(arrays.size());
      std::size_t         n = 0, n_outside = 0;
      double              most = 0.;
      Point<dim>          at;
      for (std::size_t q = 0; q < points.n_points(); ++q)
        {
          if (points.material[q] != m)
            continue;
          ++n;
          for (std::size_t v = 0; v < arrays.size(); ++v)
            variables[v] = points.scalars[arrays[v]].values[q];
          SymmetricTensor<2, 3> stress = points.stress[q];
          law.update(SymmetricTensor<2, 3>(),
                     stress,
                     variables.data(),
                     nullptr);
          const double excess = (stress - points.stress[q]).norm();
          n_outside += excess > noticed ? 1 : 0;
          if (excess > most)
            {
              most = excess;
              at   = points.initial_position[q];
            }
        }
      if (n_outside == 0)
        return;
      std::ostringstream text;
      text.precision(3);
      text << "Materials/" << the_case.parameters.materials[m].name
           << "/Model is modified Cam clay, and at " << n_outside << " of " << n
           << " points the stress at the start lies beyond critical state, "
              "outside the yield surface, by up to "
           << most << " kPa at " << place_text(at)
           << " m: the run begins with its return. Initial stress/Laws = "
           << name_of(BalanceLaws::plastic) << " begins in balance";
      warnings.push_back(text.str());
    }
  } // namespace


  template <int dim>
  void
  warn_of_consolidation(const Case<dim>          &the_case,
                        std::vector<std::string> &warnings)
  {
    constexpr double           dry = 2., noticed = 1.1; // p_c over p', before
    const Parameters          &p      = the_case.parameters;
    const MaterialPoints<dim> &points = the_case.initial_points;
    const int number = points.find_scalar("preconsolidation pressure");
    if (number < 0)
      return;
    const InitialProperties<dim> given(the_case.materials, the_case.ground);
    for (unsigned int m = 0; m < p.materials.size(); ++m)
      {
        if (p.materials[m].model != MaterialModel::modified_cam_clay)
          continue;
        const double least = p.materials[m].cam_clay.least_pressure;
        std::size_t  n = 0, n_dry = 0, n_raised = 0;
        double       most = 0.;
        for (std::size_t q = 0; q < points.n_points(); ++q)
          {
            if (points.material[q] != m)
              continue;
            ++n;
            const double pc = points.scalars[number].values[q];
            n_dry += pc > least && pc > -dry * trace(points.stress[q]) / 3.;
            const double before =
              std::max(least,
                       given.at(m,
                                points.initial_position[q],
                                the_case.layers_of_points[q])[1]);
            n_raised += pc > noticed * before;
            most = std::max(most, pc - before);
          }
        const std::string  path = "Materials/" + p.materials[m].name + "/Model";
        std::ostringstream of_dry, of_raised;
        of_dry << path << " is modified Cam clay, and at " << n_dry << " of "
               << n
               << " points p_c is more than twice p': there soil that shears "
                  "softens, in bands as wide as the cells; no Regularisation "
                  "changes that";
        if (n_dry > 0)
          warnings.push_back(of_dry.str());
        of_raised << path << " is modified Cam clay, and at " << n_raised
                  << " of " << n
                  << " points the stress at the start needs a "
                     "preconsolidation pressure that is higher than the one "
                     "given, by up to "
                  << most << " kPa: they have it";
        if (n_raised > 0)
          warnings.push_back(of_raised.str());
        warn_of_stress_outside(the_case, m, warnings);
      }
  }


  template void
  warn_of_consolidation(const Case<2> &, std::vector<std::string> &);
  template void
  warn_of_consolidation(const Case<3> &, std::vector<std::string> &);
} // namespace Waker
