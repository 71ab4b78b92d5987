// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/simulation/strengths.h>

namespace Waker
{
  namespace
  {
    std::vector<std::string>
    strengths_of(const Material &material)
    {
      std::vector<std::string> names;
      for (const MaterialVariable &variable : material.variables())
        if (is_strength(variable.role))
          names.push_back(variable.name);
      return names;
    }
  } // namespace


  template <int dim>
  void
  divide_strengths(const Materials     &materials,
                   const double         factor,
                   MaterialPoints<dim> &points)
  {
    for (unsigned int m = 0; m < materials.size(); ++m)
      {
        std::vector<int> arrays;
        for (const MaterialVariable &variable : materials[m]->variables())
          arrays.push_back(points.find_scalar(variable.name));
        std::vector<double> values(arrays.size());
        for (std::size_t p = 0; p < points.n_points(); ++p)
          if (points.material[p] == m)
            {
              for (unsigned int v = 0; v < values.size(); ++v)
                values[v] = points.scalars[arrays[v]].values[p];
              materials[m]->divide_strengths(factor, values.data());
              for (unsigned int v = 0; v < values.size(); ++v)
                points.scalars[arrays[v]].values[p] = values[v];
            }
      }
  }


  std::vector<std::string>
  described_strengths(const Materials                       &materials,
                      const std::vector<MaterialParameters> &parameters)
  {
    std::vector<std::string> lines;
    bool                     any = false;
    for (unsigned int m = 0; m < materials.size(); ++m)
      {
        std::string names;
        for (const std::string &name : strengths_of(*materials[m]))
          names += (names.empty() ? "" : ", ") + name;
        any = any || !names.empty();
        lines.push_back("  reduced   " + parameters[m].name + ": " +
                        (names.empty()
                           ? "nothing, it has no strength and stays as it is"
                           : names));
      }
    if (!any)
      throw UserError(
        "Materials/Names",
        "no material has a strength to reduce",
        "a material with one: \"von Mises softening\", \"Mohr-Coulomb\" or "
        "\"modified Cam clay\"");
    return lines;
  }


  std::vector<std::string>
  kept_walls(const std::vector<WallParameters> &walls)
  {
    std::vector<std::string> lines;
    for (const WallParameters &wall : walls)
      if (wall.type == WallType::frictional &&
          (wall.friction() > 0. || wall.adhesion > 0.))
        lines.push_back("  reduced   Walls/" + wall.name +
                        ": nothing, its friction and adhesion are no strength "
                        "of the soil and stay as they are");
    return lines;
  }


  template void
  divide_strengths(const Materials &, const double, MaterialPoints<2> &);
  template void
  divide_strengths(const Materials &, const double, MaterialPoints<3> &);
} // namespace Waker
