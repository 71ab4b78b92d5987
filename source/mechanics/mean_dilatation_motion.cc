// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/centre_stencil.h>
#include <waker/mechanics/gradient_layout.h>
#include <waker/mechanics/grouped_tangents.h>
#include <waker/mechanics/step_motion.h>

#include <algorithm>

namespace Waker
{
  namespace
  {
    constexpr unsigned int N = Material::block_size;


    /// P grad S + p grad^c S for a stress times a volume.
    template <int dim>
    void
    scatter_stress(const CentreStencil<dim>    &stencil,
                   const PointWeights<dim>     &w,
                   const SymmetricTensor<2, 3> &stress,
                   double                      *force)
    {
      const double   p = trace(stress) / 3.;
      Tensor<2, dim> P;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          P[i][j] = stress[i][j] - (i == j ? p : 0.);
      stencil.scatter(w, {w, stencil.cell_size()}, P, p, force);
    }


    /**
     * The gradient of u and the correction d of its dilatation; V stress, of
     * which each component in dim dimensions is there once, and V p.
     */
    template <int dim>
    struct MeanDilatationLayout
    {
      static constexpr unsigned int n_stresses = dim * (dim + 1) / 2;
      static constexpr unsigned int n_in       = dim * dim + 1;
      static constexpr unsigned int n_out      = n_stresses + 1;

      explicit MeanDilatationLayout(const Weights<dim> &weights)
        : stencil(weights.background_grid())
      {}

      void
      gather(const PointWeights<dim> &w,
             const double            *u,
             const unsigned int       l,
             double (&in)[n_in][N]) const
      {
        double       H[dim][dim];
        const double mean = stencil.gradient(w, {w, stencil.cell_size()}, u, H);
        double       tr   = 0.;
        for (unsigned int c = 0; c < dim; ++c)
          {
            tr += H[c][c];
            for (unsigned int d = 0; d < dim; ++d)
              in[dim * c + d][l] = H[c][d];
          }
        in[dim * dim][l] = (mean - tr) / 3.;
      }

      void
      scatter(const PointWeights<dim> &w,
              const double (&out)[n_out][N],
              const unsigned int l,
              double            *f) const
      {
        const double   p = out[n_stresses][l];
        Tensor<2, dim> P;
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            P[c][d] = out[stress_row<dim>(c, d)][l] - (c == d ? p : 0.);
        stencil.scatter(w, {w, stencil.cell_size()}, P, p, f);
      }

      void
      add_diagonal(const PointWeights<dim> &w,
                   const double (&A)[n_out][n_in][N],
                   const unsigned int l,
                   double            *f) const
      {
        // The component c of one node moves by 1: the gradient is g in row c,
        // and 3 d the difference q of the two dilatations.
        double M[dim][dim][dim], r[dim][dim];
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int e = 0; e < dim; ++e)
            {
              for (unsigned int k = 0; k < dim; ++k)
                M[c][e][k] = A[stress_row<dim>(c, e)][dim * c + k][l];
              r[c][e] = A[stress_row<dim>(c, e)][dim * dim][l] / 3. +
                        A[n_stresses][dim * c + e][l];
            }
        const double pressure = A[n_stresses][dim * dim][l] / 3.;
        stencil.for_each_node(w,
                              {w, stencil.cell_size()},
                              [&](const unsigned int    node,
                                  const Tensor<1, dim> &g,
                                  const Tensor<1, dim> &centre) {
                                for (unsigned int c = 0; c < dim; ++c)
                                  {
                                    const double q   = centre[c] - g[c];
                                    double       sum = q * q * pressure;
                                    for (unsigned int e = 0; e < dim; ++e)
                                      {
                                        sum += q * r[c][e] * g[e];
                                        for (unsigned int k = 0; k < dim; ++k)
                                          sum += g[e] * M[c][e][k] * g[k];
                                      }
                                    f[dim * node + c] += sum;
                                  }
                              });
      }

      const CentreStencil<dim> stencil;
    };


    /// The same for groups of points (see GroupedTangents).
    struct GroupMeanDilatationLayout
    {
      static constexpr unsigned int n_in  = 10;
      static constexpr unsigned int n_out = 7;

      explicit GroupMeanDilatationLayout(const Weights<3> &weights)
        : stencil(weights.background_grid())
      {}

      void
      gather(const PointGroup &w, const float *u, Lanes *in) const
      {
        stencil.gradient(w, u, in);
        const Lanes tr = in[0] + in[4] + in[8];
        in[9]          = (stencil.mean_dilatation(w, u) - tr) * (1.f / 3.f);
      }

      void
      scatter(const PointGroup &w, const Lanes *out, float *f) const
      {
        Lanes P[9];
        for (unsigned int c = 0; c < 3; ++c)
          for (unsigned int d = 0; d < 3; ++d)
            P[3 * c + d] = out[stress_row<3>(c, d)];
        for (unsigned int c = 0; c < 3; ++c)
          P[4 * c] -= out[6];
        stencil.scatter(w, P, out[6], f);
      }

      void
      add_diagonal(const PointGroup &w, const Lanes *A, float *f) const
      {
        // As MeanDilatationLayout.
        Lanes r[3][3];
        for (unsigned int c = 0; c < 3; ++c)
          for (unsigned int e = 0; e < 3; ++e)
            r[c][e] = A[n_in * stress_row<3>(c, e) + 9] * (1.f / 3.f) +
                      A[n_in * 6 + 3 * c + e];
        const Lanes pressure = A[n_in * 6 + 9] * (1.f / 3.f);
        stencil.scatter_of_gradients(
          w,
          [&](const Lanes *const g,
              const Lanes *const centre,
              Lanes *const       sum) {
            for (unsigned int c = 0; c < 3; ++c)
              {
                const Lanes q     = centre[c] - g[c];
                Lanes       total = q * q * pressure;
                for (unsigned int e = 0; e < 3; ++e)
                  {
                    const Lanes *const row =
                      A + n_in * stress_row<3>(c, e) + 3 * c;
                    total += g[e] * (q * r[c][e] + row[0] * g[0] +
                                     row[1] * g[1] + row[2] * g[2]);
                  }
                sum[c] += total;
              }
          },
          f);
      }

      const GroupStencil stencil;
    };
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
        double d = stencil.gradient(w, {w, stencil.cell_size()}, increment, H);
        for (unsigned int i = 0; i < dim; ++i)
          d -= H[i][i];
        d /= 3.;
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
                       points.volume[p] * block_stress(block.stress, l),
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
    const CentreStencil<dim> stencil(weights.background_grid());
    for (std::size_t p = 0; p < points.n_points(); ++p)
      scatter_stress(stencil,
                     weights[p],
                     points.volume[p] * points.stress[p],
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
    using Layout                      = MeanDilatationLayout<dim>;
    constexpr unsigned int n_gradient = dim * dim;
    // All normal stresses are wanted, for p.
    constexpr unsigned int n             = dim == 2 ? 4 : 6;
    constexpr unsigned int components[6] = {0, 1, 2, 3, 4, 5};

    BlockMotion<dim> motion;
    this->load_gradients(range, motion);
    double D[n * n][N], turned[6][N], volume[N] = {};
    std::copy_n(&trial.stress[0][0], 6 * N, &turned[0][0]);
    std::fill_n(&D[0][0], n * n * N, 0.);
    material.tangent_block(range.size(), trial, n, components, D);
    std::copy_n(points.volume.data() + range.begin, range.size(), volume);

    // Of xx, yy, zz and the shear stresses over the gradient.
    double B[n][n_gradient][N];
    motion.full_stress_derivative(
      D, turned, material.shear_modulus(), volume, B);

    auto *const result = reinterpret_cast<double(*)[Layout::n_in][N]>(A);
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
    };
    for (unsigned int c = 0; c < dim; ++c)
      store(c, c);
    for (unsigned int a = 3; a < n; ++a)
      store(dim + a - 3, a);
    double(*const pressure)[N] = result[Layout::n_stresses];
    store(Layout::n_stresses, 2);
    for (unsigned int i = 0; i < Layout::n_in; ++i)
      for (unsigned int l = 0; l < N; ++l)
        {
          // In 3D zz is the third row already.
          const double zz = pressure[i][l];
          pressure[i][l]  = (result[0][i][l] + result[1][i][l] + zz) / 3.;
        }
  }


  template <int dim>
  std::unique_ptr<PointTangents<dim>>
  MeanDilatationMotion<dim>::make_tangents() const
  {
    return make_layout_tangents<dim,
                                MeanDilatationLayout<dim>,
                                GroupMeanDilatationLayout>();
  }


  template class MeanDilatationMotion<2>;
  template class MeanDilatationMotion<3>;
} // namespace Waker
