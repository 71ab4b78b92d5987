// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_pore_water_h
#define waker_loads_pore_water_h

#include <waker/base/numbers.h>
#include <waker/loads/phreatic_line.h>
#include <waker/mapping/weights.h>
#include <waker/nodes/nodal_vector.h>
#include <waker/particles/material_points.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  using namespace dealii;

  /// Where the pore pressure of a point is taken.
  enum class PorePressureOf
  {
    place, // where it is
    soil   // where it was at t = 0
  };

  constexpr const char *
  name_of(const PorePressureOf choice)
  {
    switch (choice)
      {
        case PorePressureOf::place:
          return "place";
        case PorePressureOf::soil:
          return "soil";
      }
    return nullptr;
  }


  /// Section "Pore water".
  struct PoreWaterParameters
  {
    /// "x, y; x, y; ...": corners (m), x ascending. Empty: no pore water.
    std::string phreatic_line;
    /// Instead: "level: corners | level: corners ...", by the level of the
    /// water outside (m), ascending.
    std::string lines_by_level;
    /// Likewise, of the days on which the soil consolidated. Empty: the same.
    std::string    daily_phreatic_line;
    double         largest_suction = 0.; // kPa
    PorePressureOf pressure_of     = PorePressureOf::place;

    bool
    is_there() const;

    /// @throws UserError "Pore water/Phreatic line", ".../Lines by level"
    PhreaticLines
    lines() const;

    bool
    follows_water() const;

    /// The same with the daily line as the line.
    PoreWaterParameters
    of_the_daily_water() const;

    void
    add_parameters(ParameterHandler &prm);

    /// @throws UserError "Pore water/..."
    void
    check() const;
  };


  /**
   * Water in the ground: hydrostatic pressure u below a phreatic line, in space
   * the same along z. Above it there is suction, up to a limit. Beyond its ends
   * the line is level. What laws of effective stress s' compute is completed to
   * the total stress s' - u 1 (tension positive), so the nodes carry
   *   f_i = sum_p V_p u_p grad S_ip
   * of their points. Laws of total stress have no part in it.
   */
  template <int dim>
  class PoreWater
  {
  public:
    /// @param unit_weight of water (kN/m^3)
    /// @param of_effective_stress is the law of each material one?
    /// @param level of the water outside at t = 0 (m), if the line follows it
    PoreWater(const PoreWaterParameters &parameters,
              const double               unit_weight,
              const std::vector<bool>   &of_effective_stress,
              const double               level = nan);

    bool
    empty() const
    {
      return line_at_start.empty();
    }

    /// u at a place at t = 0 (kPa), negative where there is suction.
    double
    pressure(const Point<dim> &x) const;

    /// At t = 0.
    const PhreaticLine &
    line() const
    {
      return line_at_start;
    }

    /// The points' scalar "pore pressure" (kPa), of all materials; made if it
    /// is new. Does nothing without pore water.
    /// @param level of the water outside now (m), if the line follows it
    void
    record(MaterialPoints<dim> &points, const double level = nan) const;

    /// force += what the pressure that is recorded does (kN).
    void
    add_nodal_forces(const MaterialPoints<dim> &points,
                     const Weights<dim>        &weights,
                     NodalVector               &force) const;

  private:
    double
    pressure(const PhreaticLine &line, const Point<dim> &x) const;

    PhreaticLines     lines;
    PhreaticLine      line_at_start;
    double            unit_weight     = 0.;
    double            largest_suction = 0.;
    PorePressureOf    pressure_of     = PorePressureOf::place;
    std::vector<bool> takes_part; // by material
  };
} // namespace Waker

#endif
