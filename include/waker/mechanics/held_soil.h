// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_mechanics_held_soil_h
#define waker_mechanics_held_soil_h

#include <waker/mechanics/soil.h>
#include <waker/mechanics/time_scheme.h>
#include <waker/nodes/springs.h>

namespace Waker
{
  /// What resists under every scheme: the soil, and what holds it.
  template <int dim>
  struct HeldSoil
  {
    /// @param in must outlive this object
    explicit HeldSoil(const SchemeInput<dim> &in)
      : soil(in.weights,
             StressUpdate<dim>(in.materials,
                               in.is_elastic
                                 ? make_small_motion<dim>(in.mapping)
                                 : make_point_motion<dim>(in.mapping)),
             in.newton.tangent)
      , springs(in.fixities,
                stiffest_modulus(in.materials),
                in.grid.cell_size())
      , supports(in.resistances)
    {
      if (!springs.empty())
        supports.push_back(&springs);
    }

    // The supports point into it.
    HeldSoil(const HeldSoil &) = delete;

    Soil<dim>        soil;
    Springs<dim>     springs;  // of penalty supports
    Resistances<dim> supports; // all but the soil
  };
} // namespace Waker

#endif
