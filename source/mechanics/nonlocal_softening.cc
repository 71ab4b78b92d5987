// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/nonlocal_softening.h>

#include <algorithm>

namespace Waker
{
  template <int dim>
  NonlocalSoftening<dim>::NonlocalSoftening(
    const std::vector<std::unique_ptr<Material>> &materials)
  {
    for (unsigned int m = 0; m < materials.size(); ++m)
      {
        const SofteningMeasure measure = materials[m]->softening_measure();
        if (!measure.is_local())
          averages.push_back(
            {m,
             materials[m].get(),
             measure,
             NonlocalAverage<dim>(measure.length, measure.weight)});
      }
  }


  template <int dim>
  void
  NonlocalSoftening<dim>::soften(
    const std::vector<double>           &increments,
    const std::vector<std::vector<int>> &variable_arrays,
    MaterialPoints<dim>                 &points)
  {
    std::vector<double> variables;
    for (MaterialAverage &of_material : averages)
      {
        members.clear();
        bool any = false;
        for (std::size_t p = 0; p < points.n_points(); ++p)
          if (points.material[p] == of_material.number)
            {
              members.push_back(p);
              any = any || increments[p] != 0.;
            }
        if (!any)
          continue;
        NonlocalAverage<dim> &average = of_material.average;
        average.reinit(members, points.position, points.volume, increments);

        std::vector<double *> arrays;
        for (const int array : variable_arrays[of_material.number])
          arrays.push_back(points.scalars[array].values.data());
        variables.resize(arrays.size());
        for (unsigned int k = 0; k < average.order().size(); ++k)
          {
            const std::uint32_t p = average.order()[k];
            for (unsigned int v = 0; v < arrays.size(); ++v)
              variables[v] = arrays[v][p];
            if (!of_material.material->can_soften(variables.data()))
              continue;
            const double increment =
              of_material.measure.own * increments[p] +
              of_material.measure.averaged * average.at(k);
            if (increment == 0.)
              continue;
            of_material.material->soften(increment, variables.data());
            for (unsigned int v = 0; v < arrays.size(); ++v)
              arrays[v][p] = variables[v];
          }
      }
  }


  template class NonlocalSoftening<2>;
  template class NonlocalSoftening<3>;
} // namespace Waker
