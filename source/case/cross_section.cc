// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/expression_pattern.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/case/cross_section.h>

#include <algorithm>
#include <string>

namespace Waker
{
  namespace
  {
    [[noreturn]] void
    refuse(const std::string &what)
    {
      throw UserError("Cross-section",
                      "is through a case with " + what,
                      "cases whose layers are prisms without initial stress "
                      "and velocity, without walls, inflows, point loads and "
                      "tractions");
    }


    /// Does the section meet what reaches from .. to in this direction? Empty:
    /// all does. As of two layers of cells it is the one above, so of what ends
    /// at its z and what begins there the latter; a plane has no end.
    bool
    is_met(const std::vector<double> &from,
           const std::vector<double> &to,
           const unsigned int         direction,
           const double               z)
    {
      const bool has_from = from.size() > direction,
                 has_to   = to.size() > direction;
      return (!has_from || from[direction] <= z) &&
             (!has_to || z < to[direction] ||
              (has_from && from[direction] == z && to[direction] == z));
    }


    void
    leave_z_away(std::vector<double> &numbers)
    {
      if (numbers.size() == 3)
        numbers.pop_back();
    }


    /// Of "a; b; c" the first two.
    void
    leave_z_away(std::string &components)
    {
      const std::vector<std::string> parts = split(components, ';');
      if (parts.size() == 3)
        components = parts[0] + ";" + parts[1];
    }


    bool
    is_across_z(const FixityRegion region)
    {
      return region == FixityRegion::back || region == FixityRegion::front;
    }


    template <typename Thing, typename Condition>
    void
    remove_if(std::vector<Thing> &things, const Condition &condition)
    {
      things.erase(std::remove_if(things.begin(), things.end(), condition),
                   things.end());
    }


    void
    cut_layers(std::vector<LayerParameters> &layers, const double z)
    {
      remove_if(layers, [=](const LayerParameters &layer) {
        return !layer.extent.empty() &&
               (layer.extent[0] > z || layer.extent[1] <= z);
      });
      for (LayerParameters &layer : layers)
        {
          if (!layer.top.empty() || !layer.bottom.empty())
            refuse("a height map (Soil profile/" + layer.name + ")");
          if (!tidy(layer.initial_stress).empty())
            refuse("an initial stress (Soil profile/" + layer.name + ")");
          if (!tidy(layer.velocity).empty())
            refuse("an initial velocity (Soil profile/" + layer.name + ")");
          layer.extent.clear();
        }
    }


    void
    cut_conditions(std::vector<FixityParameters> &conditions, const double z)
    {
      remove_if(conditions, [=](const FixityParameters &condition) {
        return is_across_z(condition.region) ||
               !is_met(condition.from, condition.to, 2, z);
      });
      for (FixityParameters &condition : conditions)
        {
          leave_z_away(condition.from);
          leave_z_away(condition.to);
          leave_z_away(condition.displacement);
        }
    }


    void
    cut_openings(Parameters &p, const double z)
    {
      std::string faces;
      for (const std::string &face : split(p.outflow.faces, ','))
        if (tidy(face) != "back" && tidy(face) != "front")
          faces += (faces.empty() ? "" : ", ") + tidy(face);
      p.outflow.faces = faces;
      remove_if(p.outlets, [=](const OutletParameters &outlet) {
        return is_across_z(region_of(outlet.face)) ||
               !is_met(outlet.from, outlet.to, 2, z);
      });
      for (OutletParameters &outlet : p.outlets)
        {
          leave_z_away(outlet.from);
          leave_z_away(outlet.to);
        }
    }


    void
    cut_loads(Parameters &p, const double z)
    {
      if (!p.tractions.empty())
        refuse("tractions");
      // Without its load the section would bear whatever comes: not meant. Of
      // the rectangle, z comes second.
      for (const LoadProgrammeParameters &load : p.load_programmes)
        if (load.drives == LoadTarget::weight &&
            !is_met(load.weight.from, load.weight.to, 1, z))
          throw UserError("Cross-section",
                          "is " + in_digits(z) +
                            " m, beside the load of Load " + "programmes/" +
                            load.name + ", which reaches from " +
                            in_digits(load.weight.from[1]) +
                            " m to less than " + in_digits(load.weight.to[1]) +
                            " m along z",
                          "a z under the load; or Load programmes/Names "
                          "without " +
                            load.name);
      for (LoadProgrammeParameters &load : p.load_programmes)
        if (load.drives == LoadTarget::weight)
          {
            load.weight.from.resize(1);
            load.weight.to.resize(1);
          }
    }
  } // namespace


  void
  take_cross_section(Parameters &p)
  {
    const std::string text = tidy(p.cross_section);
    if (text == "none")
      return;
    const double z = plain_number(text).value_or(nan);
    if (p.dimension != 3)
      throw UserError("Cross-section",
                      "is " + text + ", but Dimension is " +
                        std::to_string(p.dimension),
                      "none, or a case with Dimension = 3");
    const double low = p.grid.lower_corner[2], high = p.grid.upper_corner[2];
    if (!(z >= low && z < high))
      throw UserError("Cross-section",
                      "is " + text + " m",
                      "from " + in_digits(low) + " m to less than " +
                        in_digits(high) + " m, the box along z");
    if (!p.walls.empty())
      refuse("walls");
    if (!p.inflows.empty())
      refuse("inflows");
    if (!p.point_loads.empty())
      refuse("point loads");

    p.in_space  = std::make_shared<const Parameters>(p);
    p.section_z = z;
    p.dimension = 2;
    leave_z_away(p.grid.lower_corner);
    leave_z_away(p.grid.upper_corner);
    cut_layers(p.layers, z);
    if (p.layers.empty())
      throw UserError("Cross-section",
                      "is " + text + " m, where no layer is",
                      "a z in the extent of a layer");
    cut_conditions(p.fixities, z);
    cut_openings(p, z);
    cut_loads(p, z);
    p.surface.prismatic = false;
    p.check();
  }
} // namespace Waker
