// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/gradient_layout.h>
#include <waker/mechanics/grouped_tangents.h>
#include <waker/mechanics/step_motion.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    constexpr unsigned int N = Material::block_size;

    template <typename Lanes>
    using SymmetricGroupLayout = GroupGradientLayout<Lanes, 6>;
  } // namespace


  template <int dim>
  void
  StepMotion<dim>::gather(const Material &,
                          const MaterialPoints<dim> &,
                          const Weights<dim> &weights,
                          const PointRange   &range,
                          const double       *increment)
  {
    const Stencil<dim> stencil(weights.background_grid());
    for (std::size_t p = range.begin; p < range.end; ++p)
      gradients[p] = stencil.gradient(weights[p], increment);
  }


  template <int dim>
  void
  StepMotion<dim>::load_gradients(const PointRange &range,
                                  BlockMotion<dim> &motion) const
  {
    motion.objective_rate = objective;
    auto              &H  = motion.H;
    const unsigned int n  = range.size();
    for (unsigned int l = 0; l < n; ++l)
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          H[dim * i + j][l] = gradients[range.begin + l][i][j];
    for (unsigned int k = 0; k < dim * dim; ++k)
      std::fill(H[k] + n, H[k] + N, 0.);
  }


  template <int dim>
  void
  StepMotion<dim>::trial(const MaterialPoints<dim> &points,
                         const PointRange          &range,
                         Material::Block           &block) const
  {
    BlockMotion<dim> motion;
    load_gradients(range, motion);
    const unsigned int n = range.size();
    for (unsigned int l = 0; l < n; ++l)
      for (unsigned int a = 0; a < 6; ++a)
        block.stress[a][l] = points.stress[range.begin + l].access_raw_entry(a);
    for (unsigned int a = 0; a < 6; ++a)
      std::fill(block.stress[a] + n, block.stress[a] + N, 0.);
    motion.move(block);
  }


  template <int dim>
  void
  StepMotion<dim>::scatter(const Material &,
                           const MaterialPoints<dim> &points,
                           const Weights<dim>        &weights,
                           const PointRange          &range,
                           const Material::Block     &block,
                           double                    *force) const
  {
    const Stencil<dim> stencil(weights.background_grid());
    for (unsigned int l = 0; l < range.size(); ++l)
      {
        const std::size_t p = range.begin + l;
        Tensor<2, dim>    P;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            P[i][j] = points.volume[p] * block.stress[stress_row<3>(i, j)][l];
        stencil.scatter_gradient(weights[p], P, force);
      }
  }


  template <int dim>
  void
  StepMotion<dim>::add_force_of_stress(const MaterialPoints<dim> &points,
                                       const Weights<dim>        &weights,
                                       NodalVector               &force) const
  {
    const Stencil<dim> stencil(weights.background_grid());
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        Tensor<2, dim> P;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            P[i][j] = points.volume[p] * points.stress[p][i][j];
        stencil.scatter_gradient(weights[p], P, force.begin());
      }
  }


  template <int dim>
  void
  StepMotion<dim>::commit(const Material        &material,
                          const PointRange      &range,
                          const Material::Block &block,
                          MaterialPoints<dim>   &points,
                          StressReport          &report) const
  {
    double energy[1][N];
    material.elastic_energy(block, energy[0]);
    divide_by_stiffness(material, range.size(), block, 1, energy);
    for (unsigned int l = 0; l < range.size(); ++l)
      {
        const std::size_t p     = range.begin + l;
        const double      V     = points.volume[p];
        double            start = 0., end = 0.;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            {
              const double       H = gradients[p][i][j];
              const unsigned int a = stress_row<3>(i, j);
              start += points.stress[p].access_raw_entry(a) * H;
              end += block.stress[a][l] * H;
            }
        for (unsigned int a = 0; a < 6; ++a)
          points.stress[p].access_raw_entry(a) = block.stress[a][l];
        report.work_start += V * start;
        report.work_end += V * end;
        report.dissipation += V * block.dissipation[l];
        report.elastic_energy += V * energy[0][l];
      }
  }


  template <int dim>
  void
  StepMotion<dim>::derivative(const Material            &material,
                              const MaterialPoints<dim> &points,
                              const PointRange          &range,
                              Material::Block           &trial,
                              const Material::Block *,
                              double *A) const
  {
    constexpr unsigned int n = BlockMotion<dim>::n_stresses;
    BlockMotion<dim>       motion;
    load_gradients(range, motion);
    double D[n * n][N], turned[6][N], volume[N] = {};
    std::copy_n(&trial.stress[0][0], 6 * N, &turned[0][0]);
    // It counts over 2 G.
    divide_by_stiffness(material, range.size(), trial, 6, turned);
    std::fill_n(&D[0][0], n * n * N, 0.);
    material.tangent_block(
      range.size(), trial, n, BlockMotion<dim>::components, D);
    std::copy_n(points.volume.data() + range.begin, range.size(), volume);
    motion.stress_derivative(D,
                             turned,
                             material.shear_modulus(),
                             volume,
                             reinterpret_cast<double(*)[dim * dim][N]>(A));
  }


  template <int dim>
  std::unique_ptr<PointTangents<dim>>
  StepMotion<dim>::make_tangents(const Precision precision) const
  {
    return make_layout_tangents<dim, GradientLayout<3>, SymmetricGroupLayout>(
      precision);
  }


  template class StepMotion<2>;
  template class StepMotion<3>;
} // namespace Waker
