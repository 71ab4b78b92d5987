// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/checks.h>
#include <waker/base/choice_parameter.h>
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/materials/undrained_strength.h>

#include <cmath>

namespace Waker
{
  namespace
  {
    /// What an expression has room for.
    constexpr unsigned int most_pairs = 25;


    /// With all digits: a part of an expression.
    std::string
    exact(const double number)
    {
      return number < 0. ? "(" + in_digits(number) + ")" : in_digits(number);
    }
  } // namespace


  void
  UndrainedStrengthParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(prm,
               "Strength from",
               from,
               "What the undrained shear strength at the start follows from. "
               "initial strength: that parameter. SHANSEP: S vertical_stress "
               "OCR^m, with OCR = (daily_vertical_stress + POP) / "
               "vertical_stress, both effective; they are the weight of the "
               "column over the place, less the pressure of the water in "
               "the ground (Pore water). table: Strength table. depth: "
               "Strength at top + Strength growth times the depth below the "
               "highest soil over the place; depth in layer: below the top of "
               "its layer. The strength stays with the soil when it moves.");
    prm.add_parameter("Strength ratio",
                      ratio,
                      "SHANSEP: S (-), above 0, the strength of normally "
                      "consolidated soil divided by its vertical stress; "
                      "usual is 0.2 to 0.4.",
                      Patterns::Double(0.));
    prm.add_parameter("Strength exponent",
                      exponent,
                      "SHANSEP: m (-), from 0 to 1, power of the "
                      "overconsolidation ratio; usual is 0.8 to 0.95.",
                      Patterns::Double(0., 1.));
    prm.add_parameter("POP",
                      pop,
                      "SHANSEP: pre-overburden pressure (kPa), at least 0: by "
                      "how much the yield stress of the soil is above its "
                      "daily vertical stress.",
                      Patterns::Double(0.));
    prm.add_parameter("Strength table",
                      table,
                      "Strength by effective vertical stress, \"s0: c0, s1: "
                      "c1, ...\" (kPa), stresses ascending, with straight "
                      "lines between; constant below the first and above "
                      "the last.",
                      Patterns::Anything());
    prm.add_parameter("Strength at top",
                      at_top,
                      "depth, depth in layer: strength at depth 0 (kPa), at "
                      "least 0.",
                      Patterns::Double(0.));
    prm.add_parameter("Strength growth",
                      growth,
                      "depth, depth in layer: by how much the strength grows "
                      "with depth (kPa/m), at least 0; usual is 1 to 2.",
                      Patterns::Double(0.));
  }


  void
  UndrainedStrengthParameters::check(const std::string &path) const
  {
    if (!tidy(table).empty())
      entries(path); // wherever the strength comes from
    if (!(at_top >= 0. && std::isfinite(at_top)))
      throw UserError(path + "Strength at top",
                      "is " + in_digits(at_top) + " kPa",
                      "a strength (kPa) of at least 0");
    if (!(growth >= 0. && std::isfinite(growth)))
      throw UserError(path + "Strength growth",
                      "is " + in_digits(growth) + " kPa/m",
                      "a number (kPa/m) of at least 0");
    switch (from)
      {
        case StrengthFrom::place:
          return;
        case StrengthFrom::depth:
        case StrengthFrom::depth_in_layer:
          if (!(at_top + growth > 0.))
            throw UserError(path + "Strength at top",
                            "is 0 kPa, and Strength growth 0 kPa/m",
                            "one of them above 0");
          return;
        case StrengthFrom::shansep:
          if (!(exponent >= 0. && exponent <= 1.))
            throw UserError(path + "Strength exponent",
                            "is " + in_digits(exponent),
                            "from 0 to 1");
          if (!(pop >= 0. && std::isfinite(pop)))
            throw UserError(path + "POP",
                            "is " + in_digits(pop) + " kPa",
                            "a pressure (kPa) of at least 0");
          return;
        case StrengthFrom::table:
          entries(path);
          return;
      }
  }


  UndrainedStrengthParameters::Written
  UndrainedStrengthParameters::written(const bool symbolic) const
  {
    if (symbolic)
      return {"strength_ratio",
              "(1 - strength_exponent)",
              "strength_exponent",
              "yield_stress",
              "strength_at_top",
              "strength_growth"};
    return {exact(ratio),
            exact(1. - exponent),
            exact(exponent),
            "(daily_vertical_stress + " + exact(pop) + ")",
            exact(at_top),
            exact(growth)};
  }


  std::vector<MaterialVariable>
  UndrainedStrengthParameters::coefficients(const std::string &path) const
  {
    const auto one = [&](const std::string &name,
                         const std::string &unit,
                         const double       value,
                         const std::string &parameter,
                         const std::string &symbol) {
      return MaterialVariable{name,
                              unit,
                              InitialValue(value, path + parameter),
                              MaterialVariable::Role::coefficient,
                              symbol};
    };
    switch (from)
      {
        case StrengthFrom::place:
        case StrengthFrom::table:
          return {};
        case StrengthFrom::shansep:
          return {one("strength ratio",
                      "-",
                      ratio,
                      "Strength ratio",
                      "strength_ratio"),
                  one("strength exponent",
                      "-",
                      exponent,
                      "Strength exponent",
                      "strength_exponent"),
                  one("POP", "kPa", pop, "POP", "pop"),
                  {"yield stress",
                   "kPa",
                   InitialValue("daily_vertical_stress + pop",
                                path + name_of_parameter()),
                   MaterialVariable::Role::coefficient,
                   "yield_stress"}};
        case StrengthFrom::depth:
        case StrengthFrom::depth_in_layer:
          return {one("strength at top",
                      "kPa",
                      at_top,
                      "Strength at top",
                      "strength_at_top"),
                  one("strength growth",
                      "kPa/m",
                      growth,
                      "Strength growth",
                      "strength_growth")};
      }
    return {};
  }


  std::string
  UndrainedStrengthParameters::expression(const std::string &own,
                                          const std::string &path) const
  {
    return expression(own, path, written(false));
  }


  std::string
  UndrainedStrengthParameters::symbolic_expression(
    const std::string &own,
    const std::string &path) const
  {
    return expression(own, path, written(true));
  }


  std::string
  UndrainedStrengthParameters::expression(const std::string &own,
                                          const std::string &path,
                                          const Written     &c) const
  {
    switch (from)
      {
        case StrengthFrom::place:
          return own;
        case StrengthFrom::depth:
          return c.at_top + " + " + c.growth + "*depth";
        case StrengthFrom::depth_in_layer:
          return c.at_top + " + " + c.growth + "*depth_in_layer";
        case StrengthFrom::shansep:
          return c.ratio + "*vertical_stress^" + c.rest + "*" + c.yield + "^" +
                 c.exponent;
        case StrengthFrom::table:
          {
            // Of each line the part that the stress has gone.
            const auto  list = entries(path);
            std::string sum  = exact(list.front().second);
            for (std::size_t i = 1; i < list.size(); ++i)
              {
                const auto &[low, at_low]   = list[i - 1];
                const auto &[high, at_high] = list[i];
                sum += " + " + exact((at_high - at_low) / (high - low)) +
                       "*(min(max(vertical_stress, " + exact(low) + "), " +
                       exact(high) + ") - " + exact(low) + ")";
              }
            return sum;
          }
      }
    return own;
  }


  std::string
  UndrainedStrengthParameters::name_of_parameter() const
  {
    switch (from)
      {
        case StrengthFrom::place:
          return "Initial strength";
        case StrengthFrom::shansep:
          return "Strength from";
        case StrengthFrom::table:
          return "Strength table";
        case StrengthFrom::depth:
        case StrengthFrom::depth_in_layer:
          return "Strength at top";
      }
    return "";
  }


  std::string
  UndrainedStrengthParameters::overconsolidation(const bool symbolic) const
  {
    return from == StrengthFrom::shansep
             ? written(symbolic).yield + "/vertical_stress"
             : "";
  }


  std::vector<std::string>
  UndrainedStrengthParameters::unused() const
  {
    const UndrainedStrengthParameters usual;
    std::vector<std::string>          names;
    if (from != StrengthFrom::shansep)
      {
        if (ratio != usual.ratio)
          names.push_back("Strength ratio");
        if (exponent != usual.exponent)
          names.push_back("Strength exponent");
        if (pop != usual.pop)
          names.push_back("POP");
      }
    if (from != StrengthFrom::table && !tidy(table).empty())
      names.push_back("Strength table");
    if (from != StrengthFrom::depth && from != StrengthFrom::depth_in_layer)
      {
        if (at_top != usual.at_top)
          names.push_back("Strength at top");
        if (growth != usual.growth)
          names.push_back("Strength growth");
      }
    return names;
  }


  std::vector<std::pair<double, double>>
  UndrainedStrengthParameters::entries(const std::string &path) const
  {
    const std::string allowed =
      "2 to " + std::to_string(most_pairs) +
      " pairs, \"stress: strength, ...\" (kPa), stresses ascending "
      "from 0 or more, strengths at least 0";
    const auto refuse = [&](const std::string &problem) {
      throw UserError(path + "Strength table", problem, allowed);
    };
    std::vector<std::pair<double, double>> list;
    for (const std::string &entry : split(table, ','))
      {
        const std::vector<std::string> pair = split(entry, ':');
        double                         stress, strength;
        if (pair.size() != 2 || !read_number(pair[0], stress) ||
            !read_number(pair[1], strength))
          refuse("has the entry " + in_quotes(entry) + ", not two numbers");
        if (!(stress >= 0. && strength >= 0. && std::isfinite(stress) &&
              std::isfinite(strength)))
          refuse("has the entry " + in_quotes(entry));
        if (!list.empty() && !(stress > list.back().first))
          refuse("has the stress " + pair[0] + " kPa after " +
                 in_digits(list.back().first) + " kPa");
        list.emplace_back(stress, strength);
      }
    for (std::size_t i = 1; i < list.size(); ++i)
      if (!std::isfinite((list[i].second - list[i - 1].second) /
                         (list[i].first - list[i - 1].first)))
        refuse("is too steep at the stress " + in_digits(list[i].first) +
               " kPa");
    if (list.size() > most_pairs)
      refuse("has " + counted(list.size(), "pair"));
    if (list.size() < 2)
      refuse("has " + counted(list.size(), "pair"));
    return list;
  }
} // namespace Waker
