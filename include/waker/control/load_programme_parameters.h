// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_control_load_programme_parameters_h
#define waker_control_load_programme_parameters_h

#include <waker/base/time_function.h>
#include <waker/loads/weight_load.h>
#include <waker/measures/watched.h>

#include <string>

namespace Waker
{
  /// How a load programme finds its factor.
  enum class LoadProgrammeKind
  {
    growth,           // at a rate; waits, and stops for good
    table_of_time,    // s
    table_of_quantity // of what is watched
  };

  constexpr const char *
  name_of(const LoadProgrammeKind choice)
  {
    switch (choice)
      {
        case LoadProgrammeKind::growth:
          return "growth";
        case LoadProgrammeKind::table_of_time:
          return "table of time";
        case LoadProgrammeKind::table_of_quantity:
          return "table of a quantity";
      }
    return nullptr;
  }

  /// Is the factor read from a table?
  constexpr bool
  has_table(const LoadProgrammeKind kind)
  {
    switch (kind)
      {
        case LoadProgrammeKind::growth:
          return false;
        case LoadProgrammeKind::table_of_time:
        case LoadProgrammeKind::table_of_quantity:
          return true;
      }
    return false;
  }


  /// What the factor of a load programme drives.
  enum class LoadTarget
  {
    weight,     // on a rectangle: height of soil, m
    traction,   // an existing one: its factor
    point_load, // the same
    water       // its rise, m
  };

  constexpr const char *
  name_of(const LoadTarget choice)
  {
    switch (choice)
      {
        case LoadTarget::weight:
          return "weight";
        case LoadTarget::traction:
          return "traction";
        case LoadTarget::point_load:
          return "point load";
        case LoadTarget::water:
          return "water";
      }
    return nullptr;
  }


  struct LoadTargetFacts
  {
    const char *unit; // of the factor
    /// Section of the loads of which it drives one; empty: none.
    const char *section = "";
    /// Is it known which points carry the load?
    bool has_points = false;
    /// May the factor be below 0?
    bool may_be_negative = false;
  };

  LoadTargetFacts
  facts_of(const LoadTarget target);


  /// A load that depends on what happens: subsection "Load programmes/<name>".
  struct LoadProgrammeParameters
  {
    std::string name; // of the subsection

    LoadTarget           drives = LoadTarget::weight;
    std::string          load; // name of the traction or point load
    WeightLoadParameters weight;

    LoadProgrammeKind kind = LoadProgrammeKind::growth;
    /// Of growth: units of the factor per s.
    double rate       = 0.;
    double start_time = 0.; // s
    /// Factor at which growth ends, or "none".
    std::string up_to      = "none";
    Watched     held_by    = Watched::nothing;
    double      hold_above = 0.;
    /// Of all kinds.
    Watched stopped_by = Watched::nothing;
    double  stop_above = 0.;
    /// "q0: f0, q1: f1, ..." with straight lines between.
    std::string table;
    Watched     quantity = Watched::nothing; // of a table

    /// Factor at which growth ends; infinite without.
    /// @throws UserError "Load programmes/<name>/Up to"
    double
    end_of_growth() const;

    /// @throws UserError "Load programmes/<name>/Table"
    TimeFunction
    read_table() const;

    /// "Load programmes/<name>/"
    std::string
    path() const;

    void
    add_parameters(ParameterHandler &prm);

    /// @param points_move do they, with the soil?
    /// @throws UserError "Load programmes/<name>/..."
    void
    check(const unsigned int dim, const bool points_move) const;
  };
} // namespace Waker

#endif
