// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/centre_stencil.h>
#include <waker/mechanics/grouped_tangents.h>
#include <waker/mechanics/mean_dilatation_layout.h>
#include <waker/mechanics/step_motion.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    constexpr unsigned int N = Material::block_size;


    /// (S - b p I) grad S_i + b p grad^c S_i for a stress S times a volume.
    template <int dim>
    void
    scatter_stress(const CentreStencil<dim>    &stencil,
                   const PointWeights<dim>     &w,
                   const CentreWeights<dim>    &centre,
                   const SymmetricTensor<2, 3> &stress,
                   const double                 share,
                   double                      *force)
    {
      const double   p = share * trace(stress) / 3.;
      Tensor<2, dim> P;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          P[i][j] = stress[i][j] - (i == j ? p : 0.);
      stencil.scatter(w, centre, P, p, force);
    }
  } // namespace


  template <int dim>
  void
  MeanDilatationMotion<dim>::gather(const Material &,
                                    const MaterialPoints<dim> &,
                                    const Weights<dim> &weights,
                                    const PointRange   &range,
                                    const double       *increment)
  {
    const CentreStencil<dim> stencil(weights.background_grid());
    for (std::size_t p = range.begin; p < range.end; ++p)
      {
        const PointWeights<dim> &w = weights[p];
        double                   H[dim][dim];
        const CentreWeights<dim> centre(shares.first_shares(p));
        double                   d = stencil.gradient(w, centre, increment, H);
        for (unsigned int i = 0; i < dim; ++i)
          d -= H[i][i];
        d *= shares[p] / 3.;
        corrections[p] = d;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            this->gradients[p][i][j] = H[i][j] + (i == j ? d : 0.);
      }
  }


  template <int dim>
  void
  MeanDilatationMotion<dim>::trial(const MaterialPoints<dim> &points,
                                   const PointRange          &range,
                                   Material::Block           &block) const
  {
    StepMotion<dim>::trial(points, range, block);
    if (dim == 2)
      {
        // At mid-step, as the other components.
        const double half = this->objective ? 0.5 : 0.;
        for (unsigned int l = 0; l < range.size(); ++l)
          {
            const double d               = corrections[range.begin + l];
            block.strain_increment[2][l] = d / (1. + half * d);
          }
      }
  }


  template <int dim>
  void
  MeanDilatationMotion<dim>::scatter(const Material &,
                                     const MaterialPoints<dim> &points,
                                     const Weights<dim>        &weights,
                                     const PointRange          &range,
                                     const Material::Block     &block,
                                     double                    *force) const
  {
    const CentreStencil<dim> stencil(weights.background_grid());
    for (unsigned int l = 0; l < range.size(); ++l)
      {
        const std::size_t p = range.begin + l;
        scatter_stress(stencil,
                       weights[p],
                       CentreWeights<dim>(shares.first_shares(p)),
                       points.volume[p] * block_stress(block.stress, l),
                       shares[p],
                       force);
      }
  }


  template <int dim>
  void
  MeanDilatationMotion<dim>::add_force_of_stress(
    const MaterialPoints<dim> &points,
    const Weights<dim>        &weights,
    NodalVector               &force) const
  {
    AssertThrow(shares.size() == points.n_points(),
                ExcMessage("start() comes before add_force_of_stress()"));
    const CentreStencil<dim> stencil(weights.background_grid());
    for (std::size_t p = 0; p < points.n_points(); ++p)
      scatter_stress(stencil,
                     weights[p],
                     CentreWeights<dim>(shares.first_shares(p)),
                     points.volume[p] * points.stress[p],
                     shares[p],
                     force.begin());
  }


  template <int dim>
  void
  MeanDilatationMotion<dim>::commit(const Material        &material,
                                    const PointRange      &range,
                                    const Material::Block &block,
                                    MaterialPoints<dim>   &points,
                                    StressReport          &report) const
  {
    if (dim == 2)
      for (unsigned int l = 0; l < range.size(); ++l)
        {
          const std::size_t p  = range.begin + l;
          const double      Vd = points.volume[p] * corrections[p];
          report.work_start += Vd * points.stress[p][2][2];
          report.work_end += Vd * block.stress[2][l];
        }
    StepMotion<dim>::commit(material, range, block, points, report);
  }


  template <int dim>
  void
  MeanDilatationMotion<dim>::derivative(const Material            &material,
                                        const MaterialPoints<dim> &points,
                                        const PointRange          &range,
                                        Material::Block           &trial,
                                        const Material::Block *,
                                        double *A) const
  {
    constexpr unsigned int n_gradient = dim * dim, n_in = n_gradient + 1;
    constexpr unsigned int n_stresses = dim * (dim + 1) / 2;
    // All normal stresses are wanted, for p.
    constexpr unsigned int n             = dim == 2 ? 4 : 6;
    constexpr unsigned int components[6] = {0, 1, 2, 3, 4, 5};

    BlockMotion<dim> motion;
    this->load_gradients(range, motion);
    double D[n * n][N], turned[6][N], volume[N] = {}, share[N] = {};
    std::copy_n(&trial.stress[0][0], 6 * N, &turned[0][0]);
    // It counts over 2 G.
    divide_by_stiffness(material, range.size(), trial, 6, turned);
    std::fill_n(&D[0][0], n * n * N, 0.);
    material.tangent_block(range.size(), trial, n, components, D);
    std::copy_n(points.volume.data() + range.begin, range.size(), volume);
    for (unsigned int l = 0; l < range.size(); ++l)
      share[l] = shares[range.begin + l];

    // Of xx, yy, zz and the shear stresses over the gradient.
    double B[n][n_gradient][N];
    motion.full_stress_derivative(
      D, turned, material.shear_modulus(), volume, B);

    auto *const result = reinterpret_cast<double(*)[n_in][N]>(A);
    const auto  store  = [&](const unsigned int o, const unsigned int a) {
      std::copy_n(&B[a][0][0], n_gradient * N, &result[o][0][0]);
      double *const over_d = result[o][n_gradient];
      for (unsigned int l = 0; l < N; ++l)
        {
          over_d[l] = 0.;
          for (unsigned int c = 0; c < dim; ++c)
            over_d[l] += B[a][c * (dim + 1)][l];
        }
      if (dim == 2)
        for (unsigned int l = 0; l < range.size(); ++l)
          {
            const double half = this->objective ? 0.5 : 0.;
            const double m    = 1. + half * corrections[range.begin + l];
            over_d[l] += volume[l] * D[n * a + 2][l] / (m * m);
          }
      for (unsigned int l = 0; l < N; ++l)
        over_d[l] *= share[l];
    };
    for (unsigned int c = 0; c < dim; ++c)
      store(c, c);
    for (unsigned int a = 3; a < n; ++a)
      store(dim + a - 3, a);
    double(*const pressure)[N] = result[n_stresses];
    store(n_stresses, 2);
    for (unsigned int i = 0; i < n_in; ++i)
      for (unsigned int l = 0; l < N; ++l)
        {
          // In 3D zz is the third row already.
          const double zz = pressure[i][l];
          pressure[i][l] =
            share[l] * (result[0][i][l] + result[1][i][l] + zz) / 3.;
        }
  }


  template <int dim>
  std::unique_ptr<PointTangents<dim>>
  MeanDilatationMotion<dim>::make_tangents(const Precision precision) const
  {
    return make_layout_tangents<dim,
                                MeanDilatationLayout,
                                GroupMeanDilatationLayout>(precision);
  }


  template class MeanDilatationMotion<2>;
  template class MeanDilatationMotion<3>;
} // namespace Waker
