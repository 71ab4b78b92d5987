// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/material.h>

namespace Waker
{
  void
  Material::update_block(const unsigned int n_points, Block &block) const
  {
    const unsigned int    n_variables = variables().size();
    std::vector<double>   point_variables(n_variables);
    SymmetricTensor<2, 3> strain, stress;
    for (unsigned int l = 0; l < n_points; ++l)
      {
        for (unsigned int a = 0; a < 6; ++a)
          {
            strain.access_raw_entry(a) = block.strain_increment[a][l];
            stress.access_raw_entry(a) = block.stress[a][l];
          }
        for (unsigned int v = 0; v < n_variables; ++v)
          point_variables[v] = block.variables[v][l];
        block.dissipation[l] =
          update(strain, stress, point_variables.data(), nullptr);
        for (unsigned int a = 0; a < 6; ++a)
          block.stress[a][l] = stress.access_raw_entry(a);
        for (unsigned int v = 0; v < n_variables; ++v)
          block.variables[v][l] = point_variables[v];
      }
  }
} // namespace Waker
