// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/materials/undrained_soil.h>

#include <utility>

namespace Waker
{
  namespace
  {
    constexpr unsigned int N = Material::block_size;

    /// share times the pore pressure to the normal stresses of a block
    void
    add_pressure(const double share,
                 const double (&pressure)[N],
                 double (*const stress)[N])
    {
      for (unsigned int d = 0; d < 3; ++d)
        for (unsigned int l = 0; l < N; ++l)
          stress[d][l] += share * pressure[l];
    }
  } // namespace


  UndrainedSoil::UndrainedSoil(std::unique_ptr<Material> given,
                               const double              stiffness)
    : soil(std::move(given))
    , stiffness(stiffness)
    , number(soil->variables().size())
  {
    Assert(stiffness > 0., ExcMessage("water has a stiffness"));
  }


  std::vector<MaterialVariable>
  UndrainedSoil::variables() const
  {
    std::vector<MaterialVariable> all = soil->variables();
    all.push_back(
      {"excess pore pressure", "kPa", 0., MaterialVariable::Role::history});
    return all;
  }


  std::optional<std::pair<unsigned int, std::string>>
  UndrainedSoil::initial_problem(const std::vector<double> &variables) const
  {
    return soil->initial_problem(
      std::vector<double>(variables.begin(), variables.begin() + number));
  }


  void
  UndrainedSoil::divide_strengths(const double factor, double *variables) const
  {
    soil->divide_strengths(factor, variables);
  }


  void
  UndrainedSoil::consolidate(const SymmetricTensor<2, 3> &stress,
                             double                      *variables) const
  {
    soil->consolidate(stress + variables[number] * unit_symmetric_tensor<3>(),
                      variables);
  }


  double
  UndrainedSoil::update(const SymmetricTensor<2, 3> &strain_increment,
                        SymmetricTensor<2, 3>       &stress,
                        double                      *variables,
                        SymmetricTensor<4, 3>       *tangent) const
  {
    double &pressure = variables[number];
    for (unsigned int d = 0; d < 3; ++d)
      stress[d][d] += pressure;
    const double dissipation =
      soil->update(strain_increment, stress, variables, tangent);
    pressure -= stiffness * trace(strain_increment);
    for (unsigned int d = 0; d < 3; ++d)
      stress[d][d] -= pressure;
    if (tangent != nullptr)
      *tangent += stiffness * outer_product(unit_symmetric_tensor<3>(),
                                            unit_symmetric_tensor<3>());
    return dissipation;
  }


  void
  UndrainedSoil::update_block(const unsigned int n_points, Block &block) const
  {
    double(&pressure)[N]      = block.variables[number];
    const double(*const e)[N] = block.strain_increment;
    double after[N]           = {};
    for (unsigned int l = 0; l < N; ++l)
      after[l] = pressure[l] - stiffness * (e[0][l] + e[1][l] + e[2][l]);
    add_pressure(1., pressure, block.stress);
    soil->update_block(n_points, block);
    for (unsigned int l = 0; l < N; ++l)
      pressure[l] = after[l];
    add_pressure(-1., pressure, block.stress);
  }


  void
  UndrainedSoil::tangent_block(const unsigned int  n_points,
                               Block              &block,
                               const unsigned int  n_components,
                               const unsigned int *components,
                               double (*tangent)[block_size]) const
  {
    add_pressure(1., block.variables[number], block.stress);
    soil->tangent_block(n_points, block, n_components, components, tangent);
    for (unsigned int a = 0; a < n_components; ++a)
      for (unsigned int b = 0; b < n_components; ++b)
        if (components[a] < 3 && components[b] < 3)
          for (unsigned int l = 0; l < N; ++l)
            tangent[n_components * a + b][l] += stiffness;
  }


  void
  UndrainedSoil::elastic_energy(const Block &block,
                                double (&energy)[block_size]) const
  {
    const double(&pressure)[N] = block.variables[number];
    Block effective            = block;
    add_pressure(1., pressure, effective.stress);
    soil->elastic_energy(effective, energy);
    for (unsigned int l = 0; l < N; ++l)
      energy[l] += pressure[l] * pressure[l] * (0.5 / stiffness);
  }
} // namespace Waker
