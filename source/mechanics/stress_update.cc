// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/stress_update.h>

#include <algorithm>
#include <utility>

namespace Waker
{
  template <int dim>
  StressUpdate<dim>::StressUpdate(const Materials                  &materials,
                                  std::unique_ptr<PointMotion<dim>> motion)
    : materials(&materials)
    , motion(std::move(motion))
    , nonlocal(materials)
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
  }


  template <int dim>
  void
  StressUpdate<dim>::begin(const MaterialPoints<dim> &points,
                           const Weights<dim>        &weights)
  {
    find_variables(points);
    motion->start(points, weights);
    n_begun = points.n_points();
  }


  template <int dim>
  void
  StressUpdate<dim>::evaluate(const MaterialPoints<dim> &points,
                              const Weights<dim>        &weights,
                              const NodalVector         &increment,
                              NodalVector               &internal_force)
  {
    AssertThrow(points.n_points() == n_begun,
                ExcMessage("begin() comes before evaluate()"));
    internal_force = 0.;

    Work       work;
    PointRange range = {0, 0};
    while (range.end < points.n_points())
      {
        range                    = range_from(points, range.end);
        const Material &material = *(*materials)[points.material[range.begin]];
        motion->gather(material, points, weights, range, increment.begin());
        load(points, range, work);
        material.update_block(range.size(), work.block);
        motion->scatter(
          material, points, weights, range, work.block, internal_force.begin());
      }
  }


  template <int dim>
  PointRange
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
                          const PointRange          &range,
                          Work                      &work) const
  {
    constexpr unsigned int  N = Material::block_size;
    const unsigned int      n = range.size();
    const std::vector<int> &arrays =
      variable_arrays[points.material[range.begin]];
    work.block.variables = work.variables;
    for (unsigned int v = 0; v < arrays.size(); ++v)
      {
        const double *const values =
          points.scalars[arrays[v]].values.data() + range.begin;
        std::copy_n(values, n, work.variables[v]);
        std::fill(work.variables[v] + n, work.variables[v] + N, 0.);
      }
    motion->trial(points, range, work.block);
  }


  template <int dim>
  void
  StressUpdate<dim>::tangent(const MaterialPoints<dim> &points,
                             const std::size_t          b,
                             double                    *A,
                             const unsigned int         n_out,
                             const unsigned int         n_in) const
  {
    constexpr unsigned int N           = Material::block_size;
    constexpr unsigned int max_entries = (dim * dim + 1) * (dim * dim + 1);
    const unsigned int     n_entries   = n_out * n_in;
    Assert(n_entries <= max_entries, ExcInternalError());
    const std::size_t last = std::min((b + 1) * N, points.n_points());

    Work       work, end;
    double     part[max_entries * N];
    PointRange range = {b * N, b * N};
    while (range.end < last)
      {
        range                    = range_from(points, range.end);
        const unsigned int n     = range.size();
        const Material &material = *(*materials)[points.material[range.begin]];
        if (motion->derivative_needs_stress())
          {
            load(points, range, end);
            material.update_block(n, end.block);
          }
        load(points, range, work);
        double *const to = n == N ? A : part;
        motion->derivative(material, points, range, work.block, &end.block, to);
        if (to == part)
          for (unsigned int k = 0; k < n_entries; ++k)
            std::copy_n(part + k * N, n, A + k * N + range.begin % N);
      }
    for (unsigned int k = 0; k < n_entries; ++k)
      std::fill(A + k * N + (last - b * N), A + (k + 1) * N, 0.);
  }


  template <int dim>
  template <typename Function>
  void
  StressUpdate<dim>::for_each_tangent(const MaterialPoints<dim> &points,
                                      const Function            &f) const
  {
    Work       work;
    PointRange range = {0, 0};
    while (range.end < points.n_points())
      {
        range                       = range_from(points, range.end);
        const unsigned int m        = points.material[range.begin];
        const Material    &material = *(*materials)[m];
        load(points, range, work);
        for (unsigned int l = 0; l < range.size(); ++l)
          {
            SymmetricTensor<2, 3> strain, stress;
            for (unsigned int a = 0; a < 6; ++a)
              {
                strain.access_raw_entry(a) = work.block.strain_increment[a][l];
                stress.access_raw_entry(a) = work.block.stress[a][l];
              }
            double variables[max_variables];
            for (unsigned int v = 0; v < variable_arrays[m].size(); ++v)
              variables[v] = work.variables[v][l];
            SymmetricTensor<4, 3> tangent;
            material.update(strain, stress, variables, &tangent);
            f(range.begin + l, material, tangent);
          }
      }
  }


  template <int dim>
  void
  StressUpdate<dim>::material_tangents(
    const MaterialPoints<dim>          &points,
    std::vector<SymmetricTensor<4, 3>> &tangents) const
  {
    tangents.resize(points.n_points());
    for_each_tangent(points,
                     [&](const std::size_t p,
                         const Material &,
                         const SymmetricTensor<4, 3> &tangent) {
                       tangents[p] = tangent;
                     });
  }


  template <int dim>
  void
  StressUpdate<dim>::isotropic_tangents(
    const MaterialPoints<dim>    &points,
    std::vector<IsotropicModuli> &moduli) const
  {
    constexpr double least = 1e-3;
    moduli.resize(points.n_points());
    for_each_tangent(
      points,
      [&](const std::size_t            p,
          const Material              &material,
          const SymmetricTensor<4, 3> &C) {
        double volumetric = 0., all = 0.; // 9 k, 3 k + 10 G
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            {
              volumetric += C[i][i][j][j];
              all += C[i][j][i][j];
            }
        const double k = volumetric / 9., G = (all - 3. * k) / 10.;
        // Not a number is not larger.
        const double k_least = least * material.bulk_modulus(),
                     G_least = least * material.shear_modulus();
        moduli[p] = {k > k_least ? k : k_least, G > G_least ? G : G_least};
      });
  }


  template <int dim>
  bool
  StressUpdate<dim>::has_symmetric_tangents() const
  {
    return std::all_of(materials->begin(),
                       materials->end(),
                       [](const auto &material) {
                         return material->has_symmetric_tangent();
                       });
  }


  template <int dim>
  StressReport
  StressUpdate<dim>::accept(MaterialPoints<dim> &points)
  {
    if (nonlocal.is_used())
      increments.assign(points.n_points(), 0.);
    const int    plastic = points.find_scalar("plastic strain");
    StressReport report;
    Work         work;
    PointRange   range = {0, 0};
    while (range.end < points.n_points())
      {
        range                       = range_from(points, range.end);
        const unsigned int m        = points.material[range.begin];
        const Material    &material = *(*materials)[m];
        load(points, range, work);
        material.update_block(range.size(), work.block);
        motion->commit(material, range, work.block, points, report);
        for (unsigned int v = 0; v < variable_arrays[m].size(); ++v)
          {
            const int     array  = variable_arrays[m][v];
            double *const values = points.scalars[array].values.data();
            for (unsigned int l = 0; l < range.size(); ++l)
              {
                double &value = values[range.begin + l];
                if (array == plastic)
                  {
                    const double increment = work.variables[v][l] - value;
                    report.plastic_strain += increment;
                    if (!increments.empty())
                      increments[range.begin + l] = increment;
                  }
                value = work.variables[v][l];
              }
          }
      }
    report.plastic_strain /= std::max<std::size_t>(points.n_points(), 1);
    return report;
  }


  template <int dim>
  void
  StressUpdate<dim>::soften(MaterialPoints<dim>       &points,
                            const BackgroundGrid<dim> &grid)
  {
    if (nonlocal.is_used())
      nonlocal.soften(increments, variable_arrays, grid, points);
  }


  template class StressUpdate<2>;
  template class StressUpdate<3>;
} // namespace Waker
