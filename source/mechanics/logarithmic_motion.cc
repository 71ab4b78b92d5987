// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/block_motion.h>
#include <waker/mechanics/gradient_layout.h>
#include <waker/mechanics/grouped_tangents.h>
#include <waker/mechanics/logarithmic_motion.h>
#include <waker/mechanics/step_motion.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    constexpr unsigned int N = Material::block_size;

    template <typename Lanes>
    using FullGroupLayout = GroupGradientLayout<Lanes, 9>;


    /// Volume of point p without stress (m^dim).
    template <int dim>
    double
    natural_volume(const Material            &material,
                   const MaterialPoints<dim> &points,
                   const std::size_t          p)
    {
      return points.mass[p] / material.density();
    }


    /// The elastic logarithmic strain of point p.
    template <int dim>
    SymmetricTensor<2, 3>
    strain_of(const Material            &material,
              const MaterialPoints<dim> &points,
              const std::size_t          p)
    {
      const double J = points.volume[p] / natural_volume(material, points, p);
      return elastic_strain(J * points.stress[p],
                            material.bulk_modulus(),
                            material.shear_modulus());
    }
  } // namespace


  template <int dim>
  void
  LogarithmicMotion<dim>::start(const MaterialPoints<dim> &points,
                                const Weights<dim> &)
  {
    gradients.resize(points.n_points());
    steps.resize(points.n_points());
  }


  template <int dim>
  void
  LogarithmicMotion<dim>::gather(const Material            &material,
                                 const MaterialPoints<dim> &points,
                                 const Weights<dim>        &weights,
                                 const PointRange          &range,
                                 const double              *increment)
  {
    const Stencil<dim> stencil(weights.background_grid());
    for (std::size_t p = range.begin; p < range.end; ++p)
      {
        gradients[p] = stencil.gradient(weights[p], increment);
        steps[p] =
          LogarithmicStep<dim>(gradients[p], strain_of(material, points, p));
      }
  }


  template <int dim>
  void
  LogarithmicMotion<dim>::trial(const MaterialPoints<dim> &,
                                const PointRange &range,
                                Material::Block  &block) const
  {
    for (unsigned int l = 0; l < N; ++l)
      {
        SymmetricTensor<2, 3> strain;
        if (l < range.size())
          strain = steps[range.begin + l].trial_strain();
        for (unsigned int a = 0; a < 6; ++a)
          {
            block.strain_increment[a][l] = strain.access_raw_entry(a);
            block.stress[a][l]           = 0.;
          }
      }
  }


  template <int dim>
  void
  LogarithmicMotion<dim>::scatter(const Material            &material,
                                  const MaterialPoints<dim> &points,
                                  const Weights<dim>        &weights,
                                  const PointRange          &range,
                                  const Material::Block     &block,
                                  double                    *force) const
  {
    const Stencil<dim> stencil(weights.background_grid());
    for (unsigned int l = 0; l < range.size(); ++l)
      {
        const std::size_t    p = range.begin + l;
        const Tensor<2, dim> P =
          natural_volume(material, points, p) *
          steps[p].first_piola(block_stress(block.stress, l));
        stencil.scatter_gradient(weights[p], P, force);
      }
  }


  template <int dim>
  void
  LogarithmicMotion<dim>::add_force_of_stress(const MaterialPoints<dim> &points,
                                              const Weights<dim> &weights,
                                              NodalVector        &force) const
  {
    // At rest P is the stress, times V / V0.
    StepMotion<dim>(false).add_force_of_stress(points, weights, force);
  }


  template <int dim>
  void
  LogarithmicMotion<dim>::commit(const Material        &material,
                                 const PointRange      &range,
                                 const Material::Block &block,
                                 MaterialPoints<dim>   &points,
                                 StressReport          &report) const
  {
    for (std::size_t p = range.begin; p < range.end; ++p)
      {
        const unsigned int          l    = p - range.begin;
        const double                V0   = natural_volume(material, points, p);
        const Tensor<2, dim>       &H    = gradients[p];
        const LogarithmicStep<dim> &step = steps[p];
        const SymmetricTensor<2, 3> tau  = block_stress(block.stress, l);
        const Tensor<2, dim>        P    = step.first_piola(tau);
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            {
              report.work_start +=
                points.volume[p] * points.stress[p][i][j] * H[i][j];
              report.work_end += V0 * P[i][j] * H[i][j];
            }

        points.volume[p] *= step.volume_ratio();
        points.stress[p] = V0 / points.volume[p] * tau;
        if (!points.deformation.empty())
          {
            Tensor<2, dim> dF = H;
            for (unsigned int d = 0; d < dim; ++d)
              dF[d][d] += 1.;
            points.deformation[p] = dF * points.deformation[p];
          }
        // Half of stress times elastic strain, whatever the law.
        report.elastic_energy +=
          0.5 * V0 * (tau * strain_of(material, points, p));
        report.dissipation += V0 * block.dissipation[l];
      }
  }


  template <int dim>
  void
  LogarithmicMotion<dim>::derivative(const Material            &material,
                                     const MaterialPoints<dim> &points,
                                     const PointRange          &range,
                                     Material::Block           &trial,
                                     const Material::Block     *end,
                                     double                    *A) const
  {
    constexpr unsigned int n = BlockMotion<dim>::n_stresses;
    double                 D[n * n][N];
    material.tangent_block(
      range.size(), trial, n, BlockMotion<dim>::components, D);
    for (unsigned int l = 0; l < range.size(); ++l)
      {
        const std::size_t p = range.begin + l;
        double            point_D[n][n], point_A[dim * dim][dim * dim];
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            point_D[i][j] = D[n * i + j][l];
        steps[p].derivative(point_D,
                            block_stress(end->stress, l),
                            natural_volume(material, points, p),
                            point_A);
        for (unsigned int i = 0; i < dim * dim; ++i)
          for (unsigned int j = 0; j < dim * dim; ++j)
            A[(i * dim * dim + j) * N + l] = point_A[i][j];
      }
  }


  template <int dim>
  std::unique_ptr<PointTangents<dim>>
  LogarithmicMotion<dim>::make_tangents(const Precision precision) const
  {
    return make_layout_tangents<dim, GradientLayout<4>, FullGroupLayout>(
      precision);
  }


  template class LogarithmicMotion<2>;
  template class LogarithmicMotion<3>;
} // namespace Waker
