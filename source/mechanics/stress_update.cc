// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/stencil.h>
#include <waker/mechanics/kinematics.h>
#include <waker/mechanics/stress_update.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    /// Entry (i, j) of a symmetric 3x3 tensor.
    constexpr unsigned int
    entry(const unsigned int i, const unsigned int j)
    {
      return i == j ? i : i + j + 2;
    }


    /// Stress of the point l of a block.
    SymmetricTensor<2, 3>
    block_stress(const Material::Block &block, const unsigned int l)
    {
      SymmetricTensor<2, 3> stress;
      for (unsigned int a = 0; a < 6; ++a)
        stress.access_raw_entry(a) = block.stress[a][l];
      return stress;
    }


    /// Elastic energy per volume of a stress (kPa).
    inline double
    elastic_energy(const SymmetricTensor<2, 3> &stress,
                   const Material              &material)
    {
      const double p = trace(stress) / 3.;
      return p * p / (2. * material.bulk_modulus()) +
             (stress * stress - 3. * p * p) / (4. * material.shear_modulus());
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
  elastic_energy(const MaterialPoints<dim> &points, const Materials &materials)
  {
    double sum = 0.;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      sum += points.volume[p] *
             elastic_energy(points.stress[p], *materials[points.material[p]]);
    return sum;
  }


  template <int dim>
  StressUpdate<dim>::StressUpdate(const Materials &materials,
                                  const bool       objective_rate,
                                  const bool       logarithmic)
    : materials(&materials)
    , objective_rate(objective_rate)
    , logarithmic(logarithmic)
  {
    for (const auto &material : materials)
      {
        variable_names.emplace_back();
        for (const MaterialVariable &variable : material->variables())
          variable_names.back().push_back(variable.name);
        AssertThrow(variable_names.back().size() <= max_variables,
                    ExcMessage("a material declares too many variables"));
      }
  }


  template <int dim>
  void
  StressUpdate<dim>::find_variables(const MaterialPoints<dim> &points)
  {
    variable_arrays.resize(variable_names.size());
    for (unsigned int m = 0; m < variable_names.size(); ++m)
      {
        const std::vector<std::string> &names  = variable_names[m];
        std::vector<int>               &arrays = variable_arrays[m];
        arrays.resize(names.size());
        for (unsigned int v = 0; v < names.size(); ++v)
          {
            arrays[v] = points.find_scalar(names[v]);
            AssertThrow(arrays[v] >= 0,
                        ExcMessage("the points lack the variable " + names[v]));
          }
      }
    gradients.resize(points.n_points());
    if (logarithmic)
      steps.resize(points.n_points());
  }


  template <int dim>
  void
  StressUpdate<dim>::evaluate(const MaterialPoints<dim> &points,
                              const Weights<dim>        &weights,
                              const NodalVector         &increment,
                              NodalVector               &internal_force)
  {
    find_variables(points);
    internal_force = 0.;

    Range range = {0, 0};
    while (range.end < points.n_points())
      {
        range = range_from(points, range.end);
        evaluate_range(
          points, weights, range, increment.begin(), internal_force.begin());
      }
  }


  template <int dim>
  typename StressUpdate<dim>::Range
  StressUpdate<dim>::range_from(const MaterialPoints<dim> &points,
                                const std::size_t          begin)
  {
    const std::size_t next_block =
      (begin / Material::block_size + 1) * Material::block_size;
    const std::size_t last = std::min(next_block, points.n_points());
    std::size_t       end  = begin + 1;
    while (end < last && points.material[end] == points.material[begin])
      ++end;
    return {begin, end};
  }


  template <int dim>
  void
  StressUpdate<dim>::load(const MaterialPoints<dim> &points,
                          const Range               &range,
                          Work                      &work) const
  {
    constexpr unsigned int N        = Material::block_size;
    const unsigned int     n_points = range.end - range.begin;
    Material::Block       &block    = work.block;
    auto                  &H        = work.motion.H;
    block.variables                 = work.variables;
    work.motion.objective_rate      = objective_rate;

    for (unsigned int l = 0; l < n_points; ++l)
      {
        const std::size_t p = range.begin + l;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            H[dim * i + j][l] = gradients[p][i][j];
        for (unsigned int a = 0; a < 6; ++a)
          block.stress[a][l] = points.stress[p].access_raw_entry(a);
      }
    for (unsigned int l = n_points; l < N; ++l)
      {
        for (unsigned int k = 0; k < dim * dim; ++k)
          H[k][l] = 0.;
        for (unsigned int a = 0; a < 6; ++a)
          block.stress[a][l] = 0.;
      }
    const std::vector<int> &arrays =
      variable_arrays[points.material[range.begin]];
    for (unsigned int v = 0; v < arrays.size(); ++v)
      {
        const double *const values =
          points.scalars[arrays[v]].values.data() + range.begin;
        for (unsigned int l = 0; l < N; ++l)
          work.variables[v][l] = l < n_points ? values[l] : 0.;
      }
    if (logarithmic)
      load_logarithmic(range, work);
    else
      work.motion.move(block);
  }


  template <int dim>
  void
  StressUpdate<dim>::evaluate_range(const MaterialPoints<dim> &points,
                                    const Weights<dim>        &weights,
                                    const Range               &range,
                                    const double              *increment,
                                    double                    *force)
  {
    const Stencil<dim> stencil(weights.background_grid());
    const unsigned int m        = points.material[range.begin];
    const unsigned int n_points = range.end - range.begin;
    for (std::size_t p = range.begin; p < range.end; ++p)
      gradients[p] = stencil.gradient(weights[p], increment);
    if (logarithmic)
      for (std::size_t p = range.begin; p < range.end; ++p)
        steps[p] = LogarithmicStep<dim>(gradients[p], start_strain(points, p));

    Work             work;
    Material::Block &block = work.block;
    load(points, range, work);
    (*materials)[m]->update_block(n_points, block);

    if (logarithmic)
      {
        for (unsigned int l = 0; l < n_points; ++l)
          {
            const std::size_t    p = range.begin + l;
            const Tensor<2, dim> P =
              natural_volume(points, p) *
              steps[p].first_piola(block_stress(block, l));
            stencil.scatter_gradient(weights[p], P, force);
          }
        return;
      }
    for (unsigned int l = 0; l < n_points; ++l)
      {
        const std::size_t p = range.begin + l;
        Tensor<2, dim>    P;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            P[i][j] = points.volume[p] * block.stress[entry(i, j)][l];
        stencil.scatter_gradient(weights[p], P, force);
      }
  }


  template <int dim>
  void
  StressUpdate<dim>::tangent(const MaterialPoints<dim> &points,
                             const std::size_t          b,
                             BlockTangent              &tangent) const
  {
    constexpr unsigned int N    = Material::block_size;
    constexpr unsigned int n    = BlockMotion<dim>::n_stresses;
    const std::size_t      last = std::min((b + 1) * N, points.n_points());

    Work   work;
    double D[n * n][N] = {};
    double turned[6][N], volume[N] = {}, A[n][dim * dim][N];
    Range  range = {b * N, b * N};
    while (range.end < last)
      {
        range                       = range_from(points, range.end);
        const unsigned int n_points = range.end - range.begin;
        const Material &material = *(*materials)[points.material[range.begin]];
        load(points, range, work);
        std::copy_n(&work.block.stress[0][0], 6 * N, &turned[0][0]);
        material.tangent_block(
          n_points, work.block, n, BlockMotion<dim>::components, D);
        std::copy_n(points.volume.data() + range.begin, n_points, volume);
        work.motion.stress_derivative(
          D, turned, material.shear_modulus(), volume, A);

        const unsigned int first = range.begin % N;
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int k = 0; k < dim * dim; ++k)
            for (unsigned int l = 0; l < n_points; ++l)
              tangent.A[a][k][first + l] = A[a][k][l];
      }
    for (unsigned int l = last - b * N; l < N; ++l)
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int k = 0; k < dim * dim; ++k)
          tangent.A[a][k][l] = 0.;
  }


  template <int dim>
  void
  StressUpdate<dim>::material_tangents(
    const MaterialPoints<dim>          &points,
    std::vector<SymmetricTensor<4, 3>> &tangents) const
  {
    double variables[max_variables];
    tangents.resize(points.n_points());
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const unsigned int    m = points.material[p];
        const Kinematics<dim> motion(gradients[p], objective_rate);
        SymmetricTensor<2, 3> strain, stress;
        if (logarithmic)
          strain = steps[p].trial_strain();
        else
          {
            strain = motion.strain();
            stress = motion.turn(points.stress[p]);
          }
        for (unsigned int v = 0; v < variable_arrays[m].size(); ++v)
          variables[v] = points.scalars[variable_arrays[m][v]].values[p];
        (*materials)[m]->update(strain, stress, variables, &tangents[p]);
      }
  }


  template <int dim>
  StressReport
  StressUpdate<dim>::accept(MaterialPoints<dim> &points) const
  {
    const int              plastic = points.find_scalar("plastic strain");
    StressReport           report;
    Work                   work;
    const Material::Block &block = work.block;
    Range                  range = {0, 0};
    while (range.end < points.n_points())
      {
        range                       = range_from(points, range.end);
        const unsigned int m        = points.material[range.begin];
        const Material    &material = *(*materials)[m];
        const unsigned int n_points = range.end - range.begin;
        const double       bulk     = 0.5 / material.bulk_modulus();
        const double       shear    = 0.25 / material.shear_modulus();
        load(points, range, work);
        material.update_block(n_points, work.block);

        if (logarithmic)
          accept_logarithmic(range, block, points, report);
        for (unsigned int l = 0; l < n_points && !logarithmic; ++l)
          {
            const std::size_t p     = range.begin + l;
            const double      V     = points.volume[p];
            double            start = 0., end = 0., square = 0.;
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int j = 0; j < dim; ++j)
                {
                  const double       H = work.motion.H[dim * i + j][l];
                  const unsigned int a = entry(i, j);
                  start += points.stress[p].access_raw_entry(a) * H;
                  end += block.stress[a][l] * H;
                }
            for (unsigned int a = 0; a < 6; ++a)
              {
                const double s = block.stress[a][l];
                square += (a < 3 ? 1. : 2.) * s * s;
                points.stress[p].access_raw_entry(a) = s;
              }
            const double pressure =
              (block.stress[0][l] + block.stress[1][l] + block.stress[2][l]) /
              3.;
            report.work_start += V * start;
            report.work_end += V * end;
            report.dissipation += V * block.dissipation[l];
            report.elastic_energy +=
              V * (pressure * pressure * bulk +
                   (square - 3. * pressure * pressure) * shear);
          }
        for (unsigned int v = 0; v < variable_arrays[m].size(); ++v)
          {
            const int     array  = variable_arrays[m][v];
            double *const values = points.scalars[array].values.data();
            for (unsigned int l = 0; l < n_points; ++l)
              {
                double &value = values[range.begin + l];
                if (array == plastic)
                  report.plastic_strain += work.variables[v][l] - value;
                value = work.variables[v][l];
              }
          }
      }
    report.plastic_strain /= std::max<std::size_t>(points.n_points(), 1);
    return report;
  }


  template void
  declare_material_variables(const Materials &, MaterialPoints<2> &);
  template void
  declare_material_variables(const Materials &, MaterialPoints<3> &);
  template double
  elastic_energy(const MaterialPoints<2> &, const Materials &);
  template double
  elastic_energy(const MaterialPoints<3> &, const Materials &);
  template class StressUpdate<2>;
  template class StressUpdate<3>;
} // namespace Waker
