// SPDX-License-Identifier: LGPL-2.1-or-later
#include "prismatic_warnings.h"

#include <waker/base/numbers.h>

#include <algorithm>
#include <array>
#include <sstream>

namespace Waker
{
  namespace
  {
    std::string
    warning(const std::string &what)
    {
      return "Surface/Prismatic is true, but " + what +
             ": the surface is an average along z, so H, W and the water are, "
             "too";
    }


    /// The most that the map varies along z (m), seen at some places.
    double
    variation(const HeightMap &map, const LayerBody &body)
    {
      constexpr unsigned int n     = 100;
      double                 begin = body.corners[0][0], end = begin;
      for (const auto &corner : body.corners)
        {
          begin = std::min(begin, corner[0]);
          end   = std::max(end, corner[0]);
        }
      double most = 0.;
      for (unsigned int i = 0; i <= n; ++i)
        {
          double low = 0., high = 0.;
          bool   is_first = true;
          for (unsigned int k = 0; k <= n; ++k)
            if (const auto y =
                  map.at(begin + (end - begin) * i / n,
                         body.begin + (body.end - body.begin) * k / n))
              {
                low      = is_first ? *y : std::min(low, *y);
                high     = is_first ? *y : std::max(high, *y);
                is_first = false;
              }
          most = std::max(most, high - low);
        }
      return most;
    }
  } // namespace


  std::vector<std::string>
  prismatic_warnings(const Parameters &p, const std::vector<LayerBody> &bodies)
  {
    std::vector<std::string> warnings;
    if (p.dimension != 3 || !p.surface.prismatic)
      return warnings;
    const double low = p.grid.lower_corner[2], high = p.grid.upper_corner[2];
    for (const LayerParameters &layer : p.layers)
      {
        if (layer.extent.empty())
          continue;
        // Others of the same polygon may go on where this one ends.
        std::vector<std::array<double, 2>> extents;
        for (const LayerParameters &other : p.layers)
          if (other.corners() == layer.corners() && !other.extent.empty())
            extents.push_back({{other.extent[0], other.extent[1]}});
        std::sort(extents.begin(), extents.end());
        double       end       = low;
        const double round_off = 1e-6 * p.grid.cell_size;
        for (const auto &extent : extents)
          if (extent[0] <= end + round_off)
            end = std::max(end, extent[1]);
        if (end < high - round_off)
          warnings.push_back(
            warning("Soil profile/" + layer.name + "/Extent reaches from " +
                    in_digits(layer.extent[0]) + " to " +
                    in_digits(layer.extent[1]) + " m, the box from " +
                    in_digits(low) + " to " + in_digits(high) + " m"));
      }
    for (std::size_t l = 0; l < std::min(bodies.size(), p.layers.size()); ++l)
      for (const bool is_top : {true, false})
        {
          const auto &map = is_top ? bodies[l].top : bodies[l].bottom;
          if (map == nullptr)
            continue;
          const double height = variation(*map, bodies[l]);
          // Much less than what the surface is found by.
          if (!(height > 1e-3 * p.grid.cell_size))
            continue;
          std::ostringstream text;
          text.precision(3);
          text << "Soil profile/" << p.layers[l].name << "/"
               << (is_top ? "Top" : "Bottom") << " varies by up to " << height
               << " m along z";
          warnings.push_back(warning(text.str()));
        }
    return warnings;
  }
} // namespace Waker
