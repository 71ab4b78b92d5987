// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_materials_softening_measure_h
#define waker_materials_softening_measure_h

namespace Waker
{
  /// What keeps softening from belonging to the cells.
  enum class Regularisation
  {
    softening_length, // plastic strain scaled by the cells
    nonlocal          // plastic strain averaged over the surroundings
  };

  constexpr const char *
  name_of(const Regularisation choice)
  {
    switch (choice)
      {
        case Regularisation::softening_length:
          return "softening length";
        case Regularisation::nonlocal:
          return "nonlocal";
      }
    return nullptr;
  }


  /// How much a neighbour at a distance of x lengths counts.
  enum class NeighbourWeight
  {
    galavi_schweiger, // x exp(-x^2): Galavi & Schweiger 2010
    gaussian          // exp(-x^2)
  };

  constexpr const char *
  name_of(const NeighbourWeight choice)
  {
    switch (choice)
      {
        case NeighbourWeight::galavi_schweiger:
          return "Galavi-Schweiger";
        case NeighbourWeight::gaussian:
          return "Gaussian";
      }
    return nullptr;
  }


  /**
   * The strain that softens a point, of the plastic strain e in and around it:
   *   e* = own e + averaged <e>,   <e>(x) = int w e dV / int w dV,
   * over the soil of the same material that is there. Local: averaged = 0, and
   * the law softens within the step, with its tangent. Nonlocal
   * (Vermeer & Brinkgreve 1994): own = 1 - n, averaged = n; strengths are
   * constant in a step, and follow e* after it
   * (mechanics/nonlocal_softening.h).
   */
  struct SofteningMeasure
  {
    double          own      = 1.;
    double          averaged = 0.;
    double          length   = 0.; // l (m) of w
    NeighbourWeight weight   = NeighbourWeight::galavi_schweiger;

    bool
    is_local() const
    {
      return averaged == 0.;
    }

    /// e* / e where e is the same everywhere.
    double
    of_uniform_strain() const
    {
      return own + averaged;
    }
  };
} // namespace Waker

#endif
