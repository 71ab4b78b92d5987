// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_quick_loads_h
#define waker_loads_quick_loads_h

#include <waker/loads/traction_parameters.h>
#include <waker/particles/soil_depths.h>
#include <waker/particles/soil_profile.h>

#include <string>
#include <vector>

namespace Waker
{
  using namespace dealii;

  /**
   * Loads on the ground that the soil has not consolidated under, such as
   * traffic: of the vertical stress q that they bring at t = 0, the grains have
   * taken over the degree of consolidation U of the layer, and
   *   u = (1 - U) q
   * is in the water, below the phreatic line. A load p on a strip of width B
   * spreads downwards at an angle a to the vertical, q = p B / (B + 2 z tan a)
   * at the depth z below it, and no more beside that; in space, if it has ends
   * along z, in that direction, too.
   */
  template <int dim>
  class QuickLoads
  {
  public:
    /// @param tractions those with a Consolidation count
    /// @throws UserError "Tractions/<name>/...": there is no soil below the
    /// load, or no layer of that name
    QuickLoads(const std::vector<TractionParameters> &tractions,
               const std::vector<LayerParameters>    &layers,
               const SoilDepths<dim>                 &depths);

    bool
    empty() const
    {
      return loads.empty();
    }

    /// The vertical stress (kPa) that they bring to a place.
    double
    stress(const Point<dim> &x) const;

    /// What of it is in the water, if there is any, in the layer of that
    /// number; in a layer that there is not nothing is.
    double
    pore_pressure(const Point<dim> &x, const unsigned int layer) const;

  private:
    struct Load
    {
      double              pressure;  // kPa, downwards
      double              top;       // m, of the ground below its middle
      double              tangent;   // of the angle
      std::vector<double> from, to;  // m, across: x, in space z
      std::vector<double> in_grains; // U by layer

      double
      stress(const Point<dim> &x) const;
    };

    std::vector<Load> loads;
  };


  /// The pressure (kPa) downwards of a traction with a Consolidation, that must
  /// be a number.
  /// @throws UserError "Tractions/<name>/..."
  double
  quick_pressure(const TractionParameters &traction, const unsigned int dim);


  /// Degrees of consolidation by layer.
  /// @param text a number for all, or "layer: degree, ..."; others have 1
  /// @param path of the parameter, for the error
  /// @throws UserError path
  std::vector<double>
  degrees_of_consolidation(const std::string                  &text,
                           const std::vector<LayerParameters> &layers,
                           const std::string                  &path);
} // namespace Waker

#endif
