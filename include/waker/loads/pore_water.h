// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_pore_water_h
#define waker_loads_pore_water_h

#include <waker/base/numbers.h>
#include <waker/loads/heads.h>
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
    std::string daily_phreatic_line;
    /// How long the line takes to follow the water outside: see LineDelay.
    std::string    delay           = "0";
    double         largest_suction = 0.; // kPa
    PorePressureOf pressure_of     = PorePressureOf::place;

    // Sections of their own.
    std::vector<HeadLineParameters>      head_lines;
    std::vector<ReferenceLineParameters> reference_lines;

    bool
    is_there() const;

    /// @throws UserError "Pore water/Phreatic line", ".../Lines by level"
    PhreaticLines
    lines() const;

    /// Does the phreatic line?
    bool
    follows_water() const;

    /// Does it, or any head line?
    bool
    anything_follows_water() const;

    /// The phreatic line as it follows, and how long that takes.
    FollowingLine
    following() const;

    /// What decides on the head at a place (m): "Head lines/deep"; "Pore
    /// water/Phreatic line"; of two between which it is interpolated both,
    /// with "and".
    std::string
    name_of_line_at(const double x, const double y) const;

    /// The same with the daily lines as the lines.
    PoreWaterParameters
    of_the_daily_water() const;

    void
    add_parameters(ParameterHandler &prm);

    /// @throws UserError "Pore water/..."
    void
    check() const;
  };


  /// What the lines have seen of the water outside.
  struct PoreWaterRecord
  {
    double level = nan; // outside, at the end of the last step (m)
    /// What of it has arrived (m): at the phreatic line, then at each head
    /// line, at the places of its delay.
    std::vector<std::vector<double>> arrived;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &level &arrived;
    }
  };


  /**
   * Water in the ground: its pressure is u = gamma_w (head - y), with the
   * Heads of a phreatic line and, if there are reference lines, of head lines;
   * in space the same along z. Where that is negative there is suction, up to a
   * limit. Beyond their ends the lines are level. What laws of effective stress
   * s' compute is completed to the total stress s' - u 1 (tension positive), so
   * the nodes carry f_i = sum_p V_p u_p grad S_ip of their points. Laws of
   * total stress have no part in it.
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

    /// The phreatic line at t = 0.
    const PhreaticLine &
    line() const
    {
      return line_at_start;
    }

    /// Of water that has always stood at `level` (m).
    PoreWaterRecord
    start(const double level) const;

    /// A step of dt (s) ends, and the water outside stands at `level` (m).
    void
    follow(const double level, const double dt, PoreWaterRecord &record) const;

    /// How long after the last change of the water outside the lines change
    /// (s): until a thousandth of it is left, 7 times their longest delay.
    double
    time_to_settle() const;

    /// The points' scalar "pore pressure" (kPa), of all materials, with that of
    /// loads on the ground if the points have it (loads/quick_loads.h); made
    /// if it is new. Does nothing without pore water.
    void
    record(MaterialPoints<dim> &points, const PoreWaterRecord &outside) const;

    /// Of a moment.
    Heads
    heads(const PoreWaterRecord &outside) const;

    /// u at a place (kPa) under such heads.
    double
    pressure(const Heads &heads, const Point<dim> &x) const;

    /// The same when the water outside has always stood at `level` (m).
    void
    record(MaterialPoints<dim> &points, const double level = nan) const
    {
      record(points, start(level));
    }

    /// force += what the pressure that is recorded does (kN).
    void
    add_nodal_forces(const MaterialPoints<dim> &points,
                     const Weights<dim>        &weights,
                     NodalVector               &force) const;

  private:
    /// A reference line, and the numbers of its head lines among `lines`.
    struct Reference
    {
      PhreaticLine line;
      unsigned int above, below;
    };

    std::vector<FollowingLine> lines;      // phreatic, then those of heads
    std::vector<Reference>     references; // from top to bottom
    PhreaticLine               line_at_start;
    Heads                      heads_at_start;
    double                     unit_weight     = 0.;
    double                     largest_suction = 0.;
    PorePressureOf             pressure_of     = PorePressureOf::place;
    std::vector<bool>          takes_part; // by material
  };
} // namespace Waker

#endif
