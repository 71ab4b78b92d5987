// SPDX-License-Identifier: LGPL-2.1-or-later
#include "strange_b_bar.h"

#include <algorithm>

namespace Waker
{
  namespace
  {
    /// The first one along a side face, if no box may hold the nodes behind it.
    const FixityParameters *
    free_roller(const std::vector<FixityParameters> &fixities)
    {
      const auto is_box = [](const FixityParameters &fixity) {
        return fixity.region == FixityRegion::box;
      };
      if (std::any_of(fixities.begin(), fixities.end(), is_box))
        return nullptr;
      const auto roller =
        std::find_if(fixities.begin(),
                     fixities.end(),
                     [](const FixityParameters &fixity) {
                       return fixity.type == FixityType::roller &&
                              fixity.region != FixityRegion::bottom &&
                              fixity.region != FixityRegion::top;
                     });
      return roller == fixities.end() ? nullptr : &*roller;
    }
  } // namespace


  void
  strange_b_bar(const Parameters &p, std::vector<std::string> &warnings)
  {
    if (p.mapping.volumetric_strain != VolumetricStrain::b_bar_everywhere)
      return;
    const std::string name =
      "Kinematics and mapping/Volumetric strain = B-bar in all cells: ";
    if (p.water.stands())
      warnings.push_back(name +
                         "soil in cells that it hardly fills may boil under "
                         "water; B-bar leaves those alone");
    if (const FixityParameters *const roller = free_roller(p.fixities))
      warnings.push_back(
        name + "soil beside the roller Boundary conditions/" + roller->name +
        " pushes the nodes behind it along it, and may sink or leave its "
        "balance; with B-bar it does not, nor if a box holds these nodes");
  }
} // namespace Waker
