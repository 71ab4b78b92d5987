// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/stress_update.h>

#include <algorithm>

// What StressUpdate does with logarithmic strain.

namespace Waker
{
  template <int dim>
  double
  StressUpdate<dim>::natural_volume(const MaterialPoints<dim> &points,
                                    const std::size_t          p) const
  {
    return points.mass[p] / (*materials)[points.material[p]]->density();
  }


  template <int dim>
  SymmetricTensor<2, 3>
  StressUpdate<dim>::start_strain(const MaterialPoints<dim> &points,
                                  const std::size_t          p) const
  {
    const Material &material = *(*materials)[points.material[p]];
    const double    J        = points.volume[p] / natural_volume(points, p);
    return elastic_strain(J * points.stress[p],
                          material.bulk_modulus(),
                          material.shear_modulus());
  }


  template <int dim>
  void
  StressUpdate<dim>::load_logarithmic(const Range &range, Work &work) const
  {
    Material::Block &block = work.block;
    for (unsigned int l = 0; l < Material::block_size; ++l)
      {
        SymmetricTensor<2, 3> trial;
        if (range.begin + l < range.end)
          trial = steps[range.begin + l].trial_strain();
        for (unsigned int a = 0; a < 6; ++a)
          {
            block.strain_increment[a][l] = trial.access_raw_entry(a);
            block.stress[a][l]           = 0.;
          }
      }
  }


  template <int dim>
  void
  StressUpdate<dim>::accept_logarithmic(const Range           &range,
                                        const Material::Block &block,
                                        MaterialPoints<dim>   &points,
                                        StressReport          &report) const
  {
    for (std::size_t p = range.begin; p < range.end; ++p)
      {
        const unsigned int         l    = p - range.begin;
        const double               V0   = natural_volume(points, p);
        const Tensor<2, dim>      &H    = gradients[p];
        const LogarithmicStep<dim> step = steps[p];
        SymmetricTensor<2, 3>      tau;
        for (unsigned int a = 0; a < 6; ++a)
          tau.access_raw_entry(a) = block.stress[a][l];
        const Tensor<2, dim> P = step.first_piola(tau);
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
        report.elastic_energy += 0.5 * V0 * (tau * start_strain(points, p));
        report.dissipation += V0 * block.dissipation[l];
      }
  }


  template <int dim>
  void
  StressUpdate<dim>::tangent(const MaterialPoints<dim> &points,
                             const std::size_t          b,
                             FullBlockTangent          &tangent) const
  {
    constexpr unsigned int N    = Material::block_size;
    constexpr unsigned int n    = BlockMotion<dim>::n_stresses;
    const std::size_t      last = std::min((b + 1) * N, points.n_points());

    Work   work;
    double D[n * n][N];
    Range  range = {b * N, b * N};
    while (range.end < last)
      {
        range                       = range_from(points, range.end);
        const unsigned int n_points = range.end - range.begin;
        const Material &material = *(*materials)[points.material[range.begin]];
        // The block may be overwritten by the tangents: the stress comes first.
        load(points, range, work);
        material.update_block(n_points, work.block);
        SymmetricTensor<2, 3> kirchhoff[N];
        for (unsigned int l = 0; l < n_points; ++l)
          for (unsigned int a = 0; a < 6; ++a)
            kirchhoff[l].access_raw_entry(a) = work.block.stress[a][l];
        load(points, range, work);
        material.tangent_block(
          n_points, work.block, n, BlockMotion<dim>::components, D);

        for (unsigned int l = 0; l < n_points; ++l)
          {
            const std::size_t p = range.begin + l;
            double            point_D[n][n], A[dim * dim][dim * dim];
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int j = 0; j < n; ++j)
                point_D[i][j] = D[n * i + j][l];
            steps[p].derivative(point_D,
                                kirchhoff[l],
                                natural_volume(points, p),
                                A);
            for (unsigned int i = 0; i < dim * dim; ++i)
              for (unsigned int j = 0; j < dim * dim; ++j)
                tangent.A[i][j][p % N] = A[i][j];
          }
      }
    for (unsigned int l = last - b * N; l < N; ++l)
      for (unsigned int i = 0; i < dim * dim; ++i)
        for (unsigned int j = 0; j < dim * dim; ++j)
          tangent.A[i][j][l] = 0.;
  }


  template double
  StressUpdate<2>::natural_volume(const MaterialPoints<2> &,
                                  const std::size_t) const;
  template double
  StressUpdate<3>::natural_volume(const MaterialPoints<3> &,
                                  const std::size_t) const;
  template SymmetricTensor<2, 3>
  StressUpdate<2>::start_strain(const MaterialPoints<2> &,
                                const std::size_t) const;
  template SymmetricTensor<2, 3>
  StressUpdate<3>::start_strain(const MaterialPoints<3> &,
                                const std::size_t) const;
  template void
  StressUpdate<2>::load_logarithmic(const Range &, Work &) const;
  template void
  StressUpdate<3>::load_logarithmic(const Range &, Work &) const;
  template void
  StressUpdate<2>::accept_logarithmic(const Range &,
                                      const Material::Block &,
                                      MaterialPoints<2> &,
                                      StressReport &) const;
  template void
  StressUpdate<3>::accept_logarithmic(const Range &,
                                      const Material::Block &,
                                      MaterialPoints<3> &,
                                      StressReport &) const;
  template void
  StressUpdate<2>::tangent(const MaterialPoints<2> &,
                           const std::size_t,
                           FullBlockTangent &) const;
  template void
  StressUpdate<3>::tangent(const MaterialPoints<3> &,
                           const std::size_t,
                           FullBlockTangent &) const;
} // namespace Waker
