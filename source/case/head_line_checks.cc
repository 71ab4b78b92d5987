// SPDX-License-Identifier: LGPL-2.1-or-later
#include "head_line_checks.h"

#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/loads/quick_loads.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    void
    check_reach(const Parameters   &p,
                const PhreaticLine &line,
                const std::string  &path)
    {
      for (const LayerParameters &layer : p.layers)
        for (const auto &corner : layer.corners())
          if (corner[0] < line.begin() || corner[0] > line.end())
            throw UserError(path,
                            "reaches from x = " + in_digits(line.begin()) +
                              " to " + in_digits(line.end()) +
                              " m, the layer \"" + layer.name + "\" to " +
                              in_digits(corner[0]) + " m",
                            "a line over all soil");
    }


    void
    check_reach(const Parameters    &p,
                const PhreaticLines &lines,
                const std::string   &path)
    {
      for (const PhreaticLine &line : lines.all())
        check_reach(p, line, path);
    }


    void
    check_head_line(const Parameters &p, const HeadLineParameters &line)
    {
      const std::string path = "Head lines/" + line.name + "/";
      if (line.follows_water() && !p.water.stands())
        throw UserError(path + "Lines by level",
                        "is there, and no water stands outside",
                        "a Line, or Water/Side = left or right");
      check_reach(p,
                  line.lines(),
                  path + (line.follows_water() ? "Lines by level" : "Line"));
      check_reach(p, line.of_the_daily_water().lines(), path + "Daily line");
    }


    /// Of a reference line: is its head line one of those that there are?
    void
    check_head_name(const Parameters  &p,
                    const std::string &path,
                    const std::string &name)
    {
      std::string names;
      for (const HeadLineParameters &line : p.pore_water.head_lines)
        {
          if (line.name == tidy(name))
            return;
          names += (names.empty() ? "" : ", ") + line.name;
        }
      if (!tidy(name).empty())
        throw UserError(path,
                        "is " + in_quotes(name) +
                          ", which is none of Head lines/Names",
                        "nothing, for the phreatic line" +
                          (names.empty() ? "" : "; or one of " + names));
    }
  } // namespace


  void
  check_lines_of_water(const Parameters &p)
  {
    const PoreWaterParameters &water = p.pore_water;
    if (water.follows_water() && !p.water.stands())
      throw UserError("Pore water/Lines by level",
                      "is there, and no water stands outside",
                      "a Phreatic line, or Water/Side = left or right");
    check_reach(p,
                water.lines(),
                water.follows_water() ? "Pore water/Lines by level"
                                      : "Pore water/Phreatic line");
    check_reach(p,
                water.of_the_daily_water().lines(),
                "Pore water/Daily phreatic line");
    for (const HeadLineParameters &line : water.head_lines)
      check_head_line(p, line);
    for (const ReferenceLineParameters &line : water.reference_lines)
      {
        const std::string path = "Reference lines/" + line.name + "/";
        check_reach(p, line.place(), path + "Line");
        check_head_name(p, path + "Top head line", line.top_head_line);
        check_head_name(p, path + "Bottom head line", line.bottom_head_line);
      }
    from_top_to_bottom(water.reference_lines);
  }


  void
  check_without_line(const Parameters &p)
  {
    const std::string allowed =
      "none, or a phreatic line as well (Pore water/Phreatic line)";
    if (!p.pore_water.head_lines.empty())
      throw UserError("Head lines/Names",
                      "has " + in_quotes(p.pore_water.head_lines[0].name) +
                        ", and there is no phreatic line",
                      allowed);
    if (!p.pore_water.reference_lines.empty())
      throw UserError("Reference lines/Names",
                      "has " + in_quotes(p.pore_water.reference_lines[0].name) +
                        ", and there is no phreatic line",
                      allowed);
    for (const TractionParameters &traction : p.tractions)
      if (!tidy(traction.consolidation).empty())
        throw UserError("Tractions/" + traction.name + "/Consolidation",
                        "is " + in_quotes(traction.consolidation) +
                          ", and there is no phreatic line",
                        "nothing, or a phreatic line (Pore water/Phreatic "
                        "line)");
  }


  void
  check_quick_loads(const Parameters &p)
  {
    for (const TractionParameters &traction : p.tractions)
      {
        const std::string path = "Tractions/" + traction.name + "/";
        if (!(traction.spread >= 0. && traction.spread <= 80.))
          throw UserError(path + "Spread",
                          "is " + in_digits(traction.spread) + " degrees",
                          "0 to 80");
        if (tidy(traction.consolidation).empty())
          continue;
        degrees_of_consolidation(traction.consolidation,
                                 p.layers,
                                 path + "Consolidation");
        for (const LoadProgrammeParameters &programme : p.load_programmes)
          if (programme.drives == LoadTarget::traction &&
              programme.load == traction.name)
            throw UserError(programme.path() + "Load",
                            "is " + in_quotes(traction.name) +
                              ", which has a Consolidation: its pore pressure "
                              "is that of t = 0",
                            "a traction without, or no programme for it");
      }
  }
} // namespace Waker
