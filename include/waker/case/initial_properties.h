// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_case_initial_properties_h
#define waker_case_initial_properties_h

#include <waker/case/ground.h>
#include <waker/mechanics/stress_update.h>

#include <optional>
#include <vector>

namespace Waker
{
  /**
   * What the materials' variables are at the start, at any place: numbers, and
   * expressions of the place. The one source for all commands; random fields
   * put their values over it. Not for several threads at a time.
   */
  template <int dim>
  class InitialProperties
  {
  public:
    /// Both are kept by reference.
    /// @throws UserError an expression that cannot be read
    InitialProperties(const Materials &materials, const Ground<dim> &ground);

    /// The material's variables at a place in a layer, in the law's order. Not
    /// checked.
    std::vector<double>
    at(const unsigned int material,
       const Point<dim>  &x,
       const unsigned int layer) const;

    /// The same, of soil with coefficients of its own.
    /// @param place what the ground is like there
    /// @param coefficients as coefficients() gives them
    std::vector<double>
    at(const unsigned int         material,
       const Point<dim>          &x,
       const InGround            &place,
       const std::vector<double> &coefficients) const;

    /// The material's coefficients, in the law's order.
    const std::vector<double> &
    coefficients(const unsigned int material) const
    {
      return coefficient_values[material];
    }

    /// Does a variable of the material ask for a vertical stress?
    bool
    asks_for_stress(const unsigned int material) const;

    /**
     * Set the variables of all points whose material has expressions, by the
     * place of the points at t = 0.
     *
     * @param layers number of each point's layer
     * @throws UserError path of the parameter: the law cannot start with a
     *         value (Material::initial_problem())
     */
    void
    set(const std::vector<unsigned int> &layers,
        MaterialPoints<dim>             &points) const;

  private:
    struct Property
    {
      MaterialVariable                    variable;
      std::optional<PlaceExpression<dim>> expression; // none: a number
    };

    const Materials                   *materials;
    const Ground<dim>                 *ground;
    std::vector<std::vector<Property>> properties; // by material
    std::vector<std::vector<double>>   coefficient_values;
  };
} // namespace Waker

#endif
