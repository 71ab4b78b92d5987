// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/places.h>
#include <waker/case/k0_stress.h>
#include <waker/case/parameters.h>

#include <cmath>
#include <sstream>

namespace Waker
{
  namespace
  {
    constexpr double least_stress = 1e-9; // kPa: below, there is none
    /// Beyond this K0 is looked for no further.
    constexpr double largest_k0 = 1e3;


    /// K0 and a law at one place.
    struct AtRest
    {
      const Material     &material;
      std::vector<double> variables;
      double              vertical; // sigma'_v, kPa
      double              pressure; // of water that the law knows of, kPa

      SymmetricTensor<2, 3>
      stress(const double k0) const
      {
        SymmetricTensor<2, 3> result;
        for (unsigned int d = 0; d < 3; ++d)
          result[d][d] = -(d == 1 ? 1. : k0) * vertical - pressure;
        return result;
      }

      bool
      is_borne(const double k0) const
      {
        return Waker::is_borne(material, variables, stress(k0));
      }

      /// The K0 furthest from `inside` towards `outside` that is borne.
      double
      limit(double inside, double outside) const
      {
        if (is_borne(outside))
          return outside;
        for (unsigned int i = 0; i < 60; ++i)
          {
            const double middle                   = 0.5 * (inside + outside);
            (is_borne(middle) ? inside : outside) = middle;
          }
        return inside;
      }
    };


    std::string
    allowed_k0(const AtRest &at_rest)
    {
      if (!at_rest.is_borne(1.))
        return "more strength, or Initial stress/From = gravity: no K0 is borne "
               "there";
      const double       low  = at_rest.limit(1., 0.);
      const double       high = at_rest.limit(1., largest_k0);
      std::ostringstream text;
      text.precision(4);
      text
        << "from " << low << " to " << high
        << " there (in a drained soil the coefficients of active and passive "
           "earth pressure), or more strength";
      return text.str();
    }


    std::vector<std::string>
    symbols_of(const Material &law)
    {
      std::vector<std::string> symbols;
      for (const MaterialVariable &variable : law.variables())
        if (!variable.symbol.empty())
          symbols.push_back(variable.symbol);
      return symbols;
    }
  } // namespace


  template <int dim>
  K0OfPoints<dim>::K0OfPoints(const MaterialParameters  &parameters,
                              const Material            &law,
                              const Ground<dim>         &ground,
                              const MaterialPoints<dim> &points)
    : points(&points)
    , k0(parameters.k0_expression(),
         "Materials/" + parameters.name + "/K0",
         symbols_of(law),
         ", or a number")
  {
    for (const MaterialVariable &variable : law.variables())
      if (!variable.symbol.empty())
        known.push_back(points.find_scalar(variable.name));
    ground.check(k0, "Materials/" + parameters.name + "/K0");
  }


  template <int dim>
  double
  K0OfPoints<dim>::value(const std::size_t p, const InGround &place) const
  {
    std::vector<double> values;
    for (const int array : known)
      values.push_back(points->scalars[array].values[p]);
    return k0.value(points->initial_position[p], place, values);
  }


  template <int dim>
  void
  set_k0_stress(const std::vector<MaterialParameters> &parameters,
                const Materials                       &materials,
                const Ground<dim>                     &ground,
                const PoreWater<dim>                  &pore_water,
                const std::vector<unsigned int>       &layers,
                MaterialPoints<dim>                   &points)
  {
    ground.require_stress("Initial stress/From", "is K0", "gravity");
    for (unsigned int m = 0; m < parameters.size(); ++m)
      {
        const Material   &law  = *materials[m];
        const std::string path = "Materials/" + parameters[m].name + "/K0";
        const int of_loads     = points.find_scalar("pore pressure of loads");
        const K0OfPoints<dim> k0(parameters[m], law, ground, points);
        for (std::size_t p = 0; p < points.n_points(); ++p)
          {
            if (points.material[p] != m)
              continue;
            const Point<dim>  &x      = points.initial_position[p];
            const InGround     place  = ground.at(x, layers[p]);
            const double       factor = k0.value(p, place);
            std::ostringstream what;
            what.precision(4);
            what << "is " << factor << " at the point " << place_text(x)
                 << " m, where the effective vertical stress is "
                 << place.vertical_stress << " kPa";
            if (!(factor >= 0. && factor <= largest_k0))
              throw UserError(path,
                              what.str(),
                              "from 0 to 1000; soils have 0.3 to 2");
            if (place.vertical_stress < -least_stress)
              throw UserError(
                "Initial stress/From",
                "is K0, but " +
                  what.str().substr(what.str().find("at the "
                                                    "point")) +
                  ground.why_uplifted(x, layers[p], place),
                "soil that is heavy enough not to float up (Saturated unit "
                "weight), lower heads, or gravity");
            AtRest at_rest{law,
                           variables_of(points, materials, p),
                           place.vertical_stress,
                           law.is_of_effective_stress() || pore_water.empty()
                             ? 0.
                             : pore_water.pressure(x) +
                                 (of_loads < 0
                                    ? 0.
                                    : points.scalars[of_loads].values[p])};
            if (!at_rest.is_borne(factor))
              {
                what << ": this stress lies "
                     << stress_excess(law,
                                      at_rest.variables,
                                      at_rest.stress(factor))
                     << " kPa outside the yield surface";
                throw UserError(path, what.str(), allowed_k0(at_rest));
              }
            points.stress[p] = at_rest.stress(factor);
          }
      }
  }


  template class K0OfPoints<2>;
  template class K0OfPoints<3>;
  template void
  set_k0_stress(const std::vector<MaterialParameters> &,
                const Materials &,
                const Ground<2> &,
                const PoreWater<2> &,
                const std::vector<unsigned int> &,
                MaterialPoints<2> &);
  template void
  set_k0_stress(const std::vector<MaterialParameters> &,
                const Materials &,
                const Ground<3> &,
                const PoreWater<3> &,
                const std::vector<unsigned int> &,
                MaterialPoints<3> &);
} // namespace Waker
