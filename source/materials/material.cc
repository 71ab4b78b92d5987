// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/materials/material.h>

#include <cmath>

namespace Waker
{
  namespace
  {
    void
    get_point(const Material::Block &block,
              const unsigned int     l,
              SymmetricTensor<2, 3> &strain,
              SymmetricTensor<2, 3> &stress,
              std::vector<double>   &variables)
    {
      for (unsigned int a = 0; a < 6; ++a)
        {
          strain.access_raw_entry(a) = block.strain_increment[a][l];
          stress.access_raw_entry(a) = block.stress[a][l];
        }
      for (unsigned int v = 0; v < variables.size(); ++v)
        variables[v] = block.variables[v][l];
    }
  } // namespace


  bool
  is_strength(const MaterialVariable::Role role)
  {
    switch (role)
      {
        case MaterialVariable::Role::strength:
        case MaterialVariable::Role::residual_strength:
          return true;
        case MaterialVariable::Role::dilatancy:
        case MaterialVariable::Role::stiffness:
        case MaterialVariable::Role::history:
        case MaterialVariable::Role::coefficient:
          return false;
      }
    AssertThrow(false, ExcInternalError());
    return false;
  }


  std::optional<MaterialVariable>
  variable_of(const Material &material, const MaterialVariable::Role role)
  {
    for (const MaterialVariable &variable : material.variables())
      if (variable.role == role)
        return variable;
    return {};
  }


  std::optional<std::pair<unsigned int, std::string>>
  Material::initial_problem(const std::vector<double> &variables) const
  {
    for (unsigned int v = 0; v < variables.size(); ++v)
      if (!std::isfinite(variables[v]))
        return {{v, "a finite number at every point"}};
    return {};
  }


  void
  Material::divide_strengths(const double factor, double *values) const
  {
    const std::vector<MaterialVariable> list = variables();
    for (unsigned int v = 0; v < list.size(); ++v)
      if (is_strength(list[v].role))
        values[v] /= factor;
  }


  void
  divide_by_stiffness(const Material        &material,
                      const unsigned int     n_points,
                      const Material::Block &block,
                      const unsigned int     n_rows,
                      double (*rows)[Material::block_size])
  {
    const auto variable = material.stiffness_variable();
    if (!variable)
      return;
    for (unsigned int l = 0; l < n_points; ++l)
      {
        const double per_ratio = 1. / block.variables[*variable][l];
        for (unsigned int a = 0; a < n_rows; ++a)
          rows[a][l] *= per_ratio;
      }
  }


  void
  Material::update_block(const unsigned int n_points, Block &block) const
  {
    const unsigned int    n_variables = variables().size();
    std::vector<double>   point_variables(n_variables);
    SymmetricTensor<2, 3> strain, stress;
    for (unsigned int l = 0; l < n_points; ++l)
      {
        get_point(block, l, strain, stress, point_variables);
        block.dissipation[l] =
          update(strain, stress, point_variables.data(), nullptr);
        for (unsigned int a = 0; a < 6; ++a)
          block.stress[a][l] = stress.access_raw_entry(a);
        for (unsigned int v = 0; v < n_variables; ++v)
          block.variables[v][l] = point_variables[v];
      }
  }


  void
  Material::elastic_energy(const Block &block,
                           double (&energy)[block_size]) const
  {
    const double bulk = 0.5 / bulk_modulus(), shear = 0.25 / shear_modulus();
    const double(*const s)[block_size] = block.stress;
    for (unsigned int l = 0; l < block_size; ++l)
      {
        double square = 0.;
        for (unsigned int a = 0; a < 6; ++a)
          square += (a < 3 ? 1. : 2.) * s[a][l] * s[a][l];
        const double p = (s[0][l] + s[1][l] + s[2][l]) / 3.;
        energy[l]      = p * p * bulk + (square - 3. * p * p) * shear;
      }
  }


  void
  Material::tangent_block(const unsigned int  n_points,
                          Block              &block,
                          const unsigned int  n_components,
                          const unsigned int *components,
                          double (*tangent)[block_size]) const
  {
    std::vector<double>   point_variables(variables().size());
    SymmetricTensor<2, 3> strain, stress;
    SymmetricTensor<4, 3> C;
    for (unsigned int l = 0; l < n_points; ++l)
      {
        get_point(block, l, strain, stress, point_variables);
        update(strain, stress, point_variables.data(), &C);
        for (unsigned int a = 0; a < n_components; ++a)
          for (unsigned int b = 0; b < n_components; ++b)
            tangent[n_components * a + b][l] =
              C.access_raw_entry(6 * components[a] + components[b]);
      }
  }
} // namespace Waker
