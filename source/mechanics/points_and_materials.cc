// SPDX-License-Identifier: LGPL-2.1-or-later
// What points have of their materials.
#include <waker/mechanics/stress_update.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    /// The arrays of the variables of each material in `points`; -1: none.
    template <int dim>
    std::vector<std::vector<int>>
    arrays_of_variables(const Materials           &materials,
                        const MaterialPoints<dim> &points)
    {
      std::vector<std::vector<int>> arrays;
      for (const auto &material : materials)
        {
          arrays.emplace_back();
          for (const MaterialVariable &variable : material->variables())
            arrays.back().push_back(points.find_scalar(variable.name));
        }
      return arrays;
    }
  } // namespace


  template <int dim>
  void
  declare_material_variables(const Materials     &materials,
                             MaterialPoints<dim> &points)
  {
    for (unsigned int m = 0; m < materials.size(); ++m)
      for (const MaterialVariable &variable : materials[m]->variables())
        {
          std::vector<double> &values = points.scalar(variable.name);
          for (std::size_t p = 0; p < points.n_points(); ++p)
            if (points.material[p] == m)
              values[p] = variable.initial_value.number;
        }
  }


  template <int dim>
  double
  stiffness_ratio(const MaterialPoints<dim> &points,
                  const Materials           &materials,
                  const std::size_t          p)
  {
    if (!materials[points.material[p]]->stiffness_variable())
      return 1.;
    const int i = points.find_scalar("stiffness ratio");
    AssertThrow(i >= 0, ExcMessage("the points lack the stiffness ratio"));
    return points.scalars[i].values[p];
  }


  template <int dim>
  void
  consolidate(const Materials &materials, MaterialPoints<dim> &points)
  {
    const auto          arrays = arrays_of_variables(materials, points);
    std::vector<double> variables;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const std::vector<int> &own = arrays[points.material[p]];
        variables.resize(own.size());
        for (unsigned int v = 0; v < own.size(); ++v)
          variables[v] = points.scalars[own[v]].values[p];
        materials[points.material[p]]->consolidate(points.stress[p],
                                                   variables.data());
        for (unsigned int v = 0; v < own.size(); ++v)
          points.scalars[own[v]].values[p] = variables[v];
      }
  }


  double
  stress_excess(const Material              &law,
                const std::vector<double>   &variables,
                const SymmetricTensor<2, 3> &stress)
  {
    SymmetricTensor<2, 3> end   = stress;
    std::vector<double>   after = variables;
    law.consolidate(stress, after.data());
    law.update(SymmetricTensor<2, 3>(), end, after.data(), nullptr);
    return (end - stress).norm();
  }


  bool
  is_borne(const Material              &law,
           const std::vector<double>   &variables,
           const SymmetricTensor<2, 3> &stress)
  {
    // Further away than this, of the stress, is no round-off.
    constexpr double round_off = 1e-9, least = 1e-9; // -, kPa
    const double     size = stress.norm();           // squares may overflow
    return std::isfinite(size) &&
           stress_excess(law, variables, stress) <= round_off * size + least;
  }


  template <int dim>
  std::vector<double>
  variables_of(const MaterialPoints<dim> &points,
               const Materials           &materials,
               const std::size_t          p)
  {
    std::vector<double> values;
    for (const MaterialVariable &variable :
         materials[points.material[p]]->variables())
      values.push_back(
        points.scalars[points.find_scalar(variable.name)].values[p]);
    return values;
  }


  template <int dim>
  double
  elastic_energy(const MaterialPoints<dim> &points, const Materials &materials)
  {
    constexpr unsigned int N      = Material::block_size;
    const auto             arrays = arrays_of_variables(materials, points);
    std::vector<double>    memory;
    double                 sum = 0.;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const Material         &material = *materials[points.material[p]];
        const std::vector<int> &own      = arrays[points.material[p]];
        Material::Block         block    = {};
        double                  energy[N];
        memory.assign(N * own.size(), 0.);
        block.variables = reinterpret_cast<double(*)[N]>(memory.data());
        for (unsigned int v = 0; v < own.size(); ++v)
          if (own[v] >= 0)
            block.variables[v][0] = points.scalars[own[v]].values[p];
        for (unsigned int a = 0; a < 6; ++a)
          block.stress[a][0] = points.stress[p].access_raw_entry(a);
        material.elastic_energy(block, energy);
        sum +=
          points.volume[p] * energy[0] / stiffness_ratio(points, materials, p);
      }
    return sum;
  }


  template void
  declare_material_variables(const Materials &, MaterialPoints<2> &);
  template void
  declare_material_variables(const Materials &, MaterialPoints<3> &);
  template double
  stiffness_ratio(const MaterialPoints<2> &,
                  const Materials &,
                  const std::size_t);
  template double
  stiffness_ratio(const MaterialPoints<3> &,
                  const Materials &,
                  const std::size_t);
  template void
  consolidate(const Materials &, MaterialPoints<2> &);
  template void
  consolidate(const Materials &, MaterialPoints<3> &);
  template std::vector<double>
  variables_of(const MaterialPoints<2> &, const Materials &, const std::size_t);
  template std::vector<double>
  variables_of(const MaterialPoints<3> &, const Materials &, const std::size_t);
  template double
  elastic_energy(const MaterialPoints<2> &, const Materials &);
  template double
  elastic_energy(const MaterialPoints<3> &, const Materials &);
} // namespace Waker
