// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/expression_pattern.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/control/load_programme_parameters.h>

#include <cmath>
#include <limits>

namespace Waker
{
  LoadTargetFacts
  facts_of(const LoadTarget target)
  {
    LoadTargetFacts facts{"-"};
    switch (target)
      {
        case LoadTarget::weight:
          facts.unit       = "m";
          facts.has_points = true;
          return facts;
        case LoadTarget::traction:
          facts.section         = "Tractions";
          facts.may_be_negative = true;
          return facts;
        case LoadTarget::point_load:
          facts.section         = "Point loads";
          facts.has_points      = true;
          facts.may_be_negative = true;
          return facts;
        case LoadTarget::water:
          facts.unit            = "m";
          facts.may_be_negative = true;
          return facts;
      }
    Assert(false, ExcInternalError());
    return facts;
  }


  std::string
  LoadProgrammeParameters::path() const
  {
    return "Load programmes/" + name + "/";
  }


  void
  LoadProgrammeParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(prm,
               "Drives",
               drives,
               "What the factor is. weight: the height (m) of soil that is "
               "built up on a rectangle, as additional weight of the points "
               "below. traction, point load: a factor (-) on the one of that "
               "name. water: a rise (m) that is added to Water/Rise.");
    prm.add_parameter("Load",
                      load,
                      "Name of the traction or point load that is driven.",
                      Patterns::Anything());
    weight.add_parameters(prm);
    add_choice(prm,
               "Kind",
               kind,
               "growth: at a rate; it may wait, and be stopped for good. table "
               "of time: the factor by the time (s). table of a quantity: by "
               "what is watched at the end of the step before.");
    prm.add_parameter("Rate",
                      rate,
                      "Growth: units of the factor per s, not 0; a load grows "
                      "with it whatever the time step.",
                      Patterns::Double());
    prm.add_parameter("Start time",
                      start_time,
                      "Growth: nothing grows before (s).",
                      Patterns::Double(0.));
    prm.add_parameter("Up to",
                      up_to,
                      "Growth: the factor at which it ends, or none.",
                      NumberOrWordPattern("none"));
    add_choice(prm,
               "Held by",
               held_by,
               "Growth: it waits in a step if this was above Hold above at the "
               "end of the step before. Settlements, displacements and plastic "
               "strains are those since t = 0 of the point that has the "
               "largest; the rate is that in the last step; the settlement of "
               "the load is a mean over its points.");
    prm.add_parameter("Hold above",
                      hold_above,
                      "Limit of that quantity (m, m/s, -).",
                      Patterns::Double(0.));
    add_choice(prm,
               "Stopped by",
               stopped_by,
               "The factor is kept for good, as the ultimate load, from the "
               "step on at whose start this is above Stop above.");
    prm.add_parameter("Stop above",
                      stop_above,
                      "Limit of that quantity (m, m/s, -).",
                      Patterns::Double(0.));
    prm.add_parameter("Table",
                      table,
                      "\"q0: f0, q1: f1, ...\": factors by time (s) or "
                      "quantity (m, m/s, -), with straight lines between, "
                      "constant before and after.",
                      Patterns::Anything());
    add_choice(prm, "Quantity", quantity, "Table of a quantity: which one.");
  }


  double
  LoadProgrammeParameters::end_of_growth() const
  {
    const std::string text = tidy(up_to);
    if (text == "none")
      return std::copysign(std::numeric_limits<double>::infinity(), rate);
    const double end = plain_number(text).value_or(0.);
    if (!(end * rate > 0.))
      throw UserError(path() + "Up to",
                      "is \"" + text + "\", which growth from 0 at a rate of " +
                        in_digits(rate) + " does not reach",
                      rate < 0. ? "a number below 0, or none"
                                : "a number above 0, or none");
    return end;
  }


  TimeFunction
  LoadProgrammeParameters::read_table() const
  {
    const char *const allowed =
      "a table \"q0: f0, q1: f1, ...\" of at least two pairs";
    if (tidy(table).empty())
      throw UserError(path() + "Table",
                      std::string("is empty, but Kind is ") + name_of(kind),
                      allowed);
    const TimeFunction function = [&] {
      try
        {
          return TimeFunction(table, path() + "Table");
        }
      catch (const UserError &error)
        {
          throw UserError(error.where,
                          error.problem,
                          std::string(allowed) + ", with ascending q" +
                            decimals_with_a_point);
        }
    }();
    if (!function.moves() || function.last_change() == LastChange::unknown)
      throw UserError(path() + "Table",
                      "is \"" + tidy(table) + "\", which is no table",
                      allowed);
    return function;
  }


  namespace
  {
    /// A quantity that is watched, and its limit.
    void
    check_watched(const LoadProgrammeParameters &p,
                  const char *const              entry,
                  const Watched                  watched,
                  const bool                     points_move)
    {
      const WatchedFacts facts = facts_of(watched);
      const std::string  what  = std::string("is ") + name_of(watched);
      if (facts.needs_motion && !points_move)
        throw UserError(p.path() + entry,
                        what + ", but the points stay in place",
                        "largest plastic strain, or Time stepping/Move points "
                        "= true");
      if (facts.needs_load && !facts_of(p.drives).has_points)
        throw UserError(p.path() + entry,
                        what + ", but no points carry the load: Drives is " +
                          name_of(p.drives),
                        "another quantity; or Drives = weight or point load");
    }


    void
    check_limit(const LoadProgrammeParameters &p,
                const std::string             &entry,
                const Watched                  watched,
                const double                   limit)
    {
      if (watched != Watched::nothing && !(limit > 0.))
        throw UserError(p.path() + entry,
                        "is " + in_digits(limit) + " " +
                          facts_of(watched).unit + ", a limit of the " +
                          name_of(watched),
                        "above 0");
    }
  } // namespace


  void
  LoadProgrammeParameters::check(const unsigned int dim,
                                 const bool         points_move) const
  {
    const LoadTargetFacts facts = facts_of(drives);
    if (drives == LoadTarget::weight)
      weight.check(dim, path());
    if (kind == LoadProgrammeKind::growth)
      {
        if (rate == 0. || (rate < 0. && !facts.may_be_negative))
          throw UserError(path() + "Rate",
                          "is " + in_digits(rate) + " per s",
                          facts.may_be_negative
                            ? "a number other than 0"
                            : "above 0 (a weight only grows)");
        end_of_growth();
        check_watched(*this, "Held by", held_by, points_move);
        check_limit(*this, "Hold above", held_by, hold_above);
      }
    else
      {
        const TimeFunction function = read_table();
        if (!facts.may_be_negative && function.least() < 0.)
          throw UserError(path() + "Table",
                          "goes down to " + in_digits(function.least()) +
                            " m of soil",
                          "factors of at least 0");
      }
    if (kind == LoadProgrammeKind::table_of_quantity)
      {
        if (quantity == Watched::nothing)
          throw UserError(path() + "Quantity",
                          "is nothing, but Kind is table of a quantity",
                          "one of " + choice_list<Watched>());
        check_watched(*this, "Quantity", quantity, points_move);
      }
    check_watched(*this, "Stopped by", stopped_by, points_move);
    check_limit(*this, "Stop above", stopped_by, stop_above);
  }
} // namespace Waker
