// SPDX-License-Identifier: LGPL-2.1-or-later
#include "strange_b_bar.h"

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    /// Does soil lie within half a cell of a face of the box at t = 0?
    template <int dim>
    bool
    is_beside(const Case<dim> &the_case, const unsigned int face)
    {
      const unsigned int             d    = face / 2;
      const BackgroundGrid<dim>     &grid = the_case.grid;
      const std::vector<Point<dim>> &x    = the_case.initial_points.position;
      const double                   at =
        face % 2 == 0 ? grid.lower_corner()[d] : grid.upper_corner()[d];
      return std::any_of(x.begin(), x.end(), [&](const Point<dim> &point) {
        return std::abs(point[d] - at) < 0.5 * grid.cell_size();
      });
    }


    /// The first one with soil beside it, if no box may hold the nodes behind.
    template <int dim>
    const FixityParameters *
    free_roller(const Case<dim> &the_case)
    {
      const std::vector<FixityParameters> &fixities =
        the_case.parameters.fixities;
      const auto is_box = [](const FixityParameters &fixity) {
        return fixity.region == FixityRegion::box;
      };
      if (std::any_of(fixities.begin(), fixities.end(), is_box))
        return nullptr;
      const auto roller = std::find_if(
        fixities.begin(), fixities.end(), [&](const FixityParameters &fixity) {
          return fixity.type == FixityType::roller &&
                 fixity.region != FixityRegion::bottom &&
                 fixity.region != FixityRegion::top &&
                 is_beside(the_case, static_cast<unsigned int>(fixity.region));
        });
      return roller == fixities.end() ? nullptr : &*roller;
    }
  } // namespace


  template <int dim>
  void
  warn_of_b_bar(const Case<dim> &the_case, std::vector<std::string> &warnings)
  {
    const Parameters &p = the_case.parameters;
    if (p.mapping.volumetric_strain != VolumetricStrain::b_bar_everywhere)
      return;
    const std::string name =
      "Kinematics and mapping/Volumetric strain = B-bar in all cells: ";
    if (p.water.stands())
      warnings.push_back(name +
                         "soil in cells that it hardly fills may boil under "
                         "water; B-bar leaves those alone");
    if (const FixityParameters *const roller = free_roller(the_case))
      warnings.push_back(
        name + "soil beside the roller Boundary conditions/" + roller->name +
        " pushes the nodes behind it along it, and may sink or leave its "
        "balance; with B-bar it does not, nor if a box holds these nodes");
  }


  template void
  warn_of_b_bar(const Case<2> &, std::vector<std::string> &);
  template void
  warn_of_b_bar(const Case<3> &, std::vector<std::string> &);
} // namespace Waker
