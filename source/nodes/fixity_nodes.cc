// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fixity_nodes.h"

#include <waker/base/errors.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// Direction and side of a face.
    struct Face
    {
      unsigned int direction;
      bool         upper;
    };

    Face
    face_of(const FixityRegion region)
    {
      Assert(region != FixityRegion::box, ExcInternalError());
      const unsigned int f = static_cast<unsigned int>(region);
      return {f / 2, f % 2 == 1};
    }


    /// In which direction its limits have no node between them, and which are
    /// the nearest.
    template <int dim>
    [[noreturn]] void
    refuse_empty_region(const BackgroundGrid<dim> &grid,
                        const FixityParameters    &fixity)
    {
      const bool         is_box = fixity.region == FixityRegion::box;
      const double       h      = grid.cell_size();
      std::ostringstream what, allowed;
      for (unsigned int d = 0; d < dim; ++d)
        {
          if (!is_box && d == face_of(fixity.region).direction)
            continue;
          const double first = grid.lower_corner()[d] - grid.margin * h;
          const double n     = grid.n_nodes_per_direction()[d] - 1;
          const double from  = fixity.from.empty() ? first : fixity.from[d],
                       to    = fixity.to.empty() ? first + n * h : fixity.to[d];
          // Numbers of the lines between the limits.
          constexpr double tolerance = 1e-6;
          const double     lower =
            std::max(0., std::ceil((from - first) / h - tolerance));
          const double upper =
            std::min(n, std::floor((to - first) / h + tolerance));
          if (lower <= upper)
            continue;
          what << (what.str().empty() ? "" : ", and") << " along "
               << "xyz"[d] << " it reaches from "
               << (fixity.from.empty() ? "the end of the grid, " : "") << from
               << " m to " << (fixity.to.empty() ? "the end of the grid, " : "")
               << to << " m";
          // Those on both sides of it.
          const double below = std::clamp(upper, 0., n),
                       above = std::clamp(lower, 0., n);
          allowed << (allowed.str().empty() ? "" : ", and") << " at "
                  << "xyz"[d] << " = " << first + below * h;
          if (above > below)
            allowed << " and " << first + above * h;
          allowed << " m";
        }
      throw UserError("Boundary conditions/" + fixity.name,
                      "there is no node of the grid in its region:" +
                        what.str(),
                      "limits From and To with nodes between them; the nearest "
                      "lines of the grid are" +
                        allowed.str());
    }
  } // namespace


  template <int dim>
  std::vector<unsigned int>
  nodes_of(const BackgroundGrid<dim> &grid, const FixityParameters &fixity)
  {
    const bool   is_box    = fixity.region == FixityRegion::box;
    const Face   face      = is_box ? Face{dim, false} : face_of(fixity.region);
    const double tolerance = 1e-6 * grid.cell_size();

    std::vector<unsigned int> nodes;
    for (unsigned int n = 0; n < grid.n_nodes(); ++n)
      {
        const auto       index = grid.node_index(n);
        const Point<dim> x     = grid.node_position(n);
        bool             held  = true;
        for (unsigned int d = 0; d < dim && held; ++d)
          if (d == face.direction)
            {
              const int margin = grid.margin;
              const int last   = grid.n_nodes_per_direction()[d] - 1;
              held =
                face.upper ? index[d] >= last - margin : index[d] <= margin;
            }
          else
            held =
              (fixity.from.empty() || x[d] >= fixity.from[d] - tolerance) &&
              (fixity.to.empty() || x[d] <= fixity.to[d] + tolerance);
        if (held)
          nodes.push_back(n);
      }
    if (nodes.empty())
      refuse_empty_region(grid, fixity);
    return nodes;
  }


  template std::vector<unsigned int>
  nodes_of(const BackgroundGrid<2> &, const FixityParameters &);
  template std::vector<unsigned int>
  nodes_of(const BackgroundGrid<3> &, const FixityParameters &);
} // namespace Waker
