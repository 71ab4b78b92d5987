// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/logarithmic_strain.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

namespace Waker
{
  namespace
  {
    /// Eigenvalues of a symmetric matrix, and its eigenvectors as columns.
    void
    spectrum(const Tensor<2, 2> &S, double (&values)[2], Tensor<2, 2> &Q)
    {
      const double mean = 0.5 * (S[0][0] + S[1][1]);
      const double half = 0.5 * (S[0][0] - S[1][1]);
      const double r    = std::hypot(half, S[0][1]);
      const double turn = 0.5 * std::atan2(S[0][1], half);
      values[0]         = mean + r;
      values[1]         = mean - r;
      Q[0][0] = Q[1][1] = std::cos(turn);
      Q[1][0]           = std::sin(turn);
      Q[0][1]           = -Q[1][0];
    }


    void
    spectrum(const Tensor<2, 3> &S, double (&values)[3], Tensor<2, 3> &Q)
    {
      Eigen::Matrix3d matrix;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          matrix(i, j) = S[i][j];
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
      for (unsigned int i = 0; i < 3; ++i)
        {
          values[i] = solver.eigenvalues()[i];
          for (unsigned int j = 0; j < 3; ++j)
            Q[i][j] = solver.eigenvectors()(i, j);
        }
    }


    /// Q diag(values) Q^T
    template <int dim>
    Tensor<2, dim>
    compose(const double (&values)[dim], const Tensor<2, dim> &Q)
    {
      Tensor<2, dim> S;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          for (unsigned int a = 0; a < dim; ++a)
            S[i][j] += values[a] * Q[i][a] * Q[j][a];
      return S;
    }


    /// (ln(1 + x) - ln(1 + y)) / (x - y), also for x = y.
    double
    slope_of_logarithm(const double x, const double y)
    {
      const double mean  = 1. + 0.5 * (x + y);
      const double delta = 0.5 * (x - y) / mean;
      return std::abs(delta) < 1e-3 ? (1. + delta * delta / 3.) / mean
                                    : (std::log1p(x) - std::log1p(y)) / (x - y);
    }


    /// Indices of the independent entries: a -> (i, j).
    template <int dim>
    constexpr unsigned int row_index[6] = {0, 1, dim == 2 ? 0 : 2, 0, 0, 1};
    template <int dim>
    constexpr unsigned int column_index[6] = {0, 1, dim == 2 ? 1 : 2, 1, 2, 2};
  } // namespace


  template <int dim>
  LogarithmicStep<dim>::LogarithmicStep(
    const Tensor<2, dim>        &H,
    const SymmetricTensor<2, 3> &elastic_strain)
  {
    Tensor<2, dim> dF = H;
    for (unsigned int d = 0; d < dim; ++d)
      dF[d][d] += 1.;
    ratio = determinant(dF);
    if (!(ratio > 0.))
      {
        // The step is too long: Newton will see it, and halve it.
        ratio                     = std::numeric_limits<double>::quiet_NaN();
        trial.access_raw_entry(0) = ratio;
        inverse[0][0]             = ratio;
        for (unsigned int d = 0; d < dim; ++d)
          c[d] = ratio;
        return;
      }
    inverse = invert(dF);

    // B = b - 1, from that at the start.
    Tensor<2, dim> e;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        e[i][j] = elastic_strain[i][j];
    double values[dim];
    spectrum(e, values, Q);
    for (unsigned int a = 0; a < dim; ++a)
      values[a] = std::expm1(2. * values[a]);
    const Tensor<2, dim> B       = compose(values, Q);
    const Tensor<2, dim> HB      = H + H * B;
    Tensor<2, dim>       B_trial = B + HB + transpose(HB) + HB * transpose(H);
    spectrum(B_trial, c, Q);
    for (unsigned int a = 0; a < dim; ++a)
      values[a] = 0.5 * std::log1p(c[a]);
    const Tensor<2, dim> strain = compose(values, Q);

    trial = elastic_strain; // zz stays in plane strain
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = i; j < dim; ++j)
        trial[i][j] = strain[i][j];
  }


  template <int dim>
  Tensor<2, dim>
  LogarithmicStep<dim>::first_piola(
    const SymmetricTensor<2, 3> &kirchhoff) const
  {
    Tensor<2, dim> P;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        for (unsigned int a = 0; a < dim; ++a)
          P[i][j] += kirchhoff[i][a] * inverse[j][a];
    return P;
  }


  template <int dim>
  void
  LogarithmicStep<dim>::derivative(
    const double (&D)[dim * (dim + 1) / 2][dim * (dim + 1) / 2],
    const SymmetricTensor<2, 3> &kirchhoff,
    const double                 scale,
    double (&A)[dim * dim][dim * dim]) const
  {
    constexpr unsigned int n = dim * (dim + 1) / 2;
    const Tensor<2, dim>   P = first_piola(kirchhoff);

    // d trial = 1/2 (d ln b / db) : (l b + b l^T), l = dH dF^-1; in the
    // eigenbasis entry by entry: weight[a][b] of l_ab.
    double weight[dim][dim];
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int b = 0; b < dim; ++b)
        weight[a][b] = 0.5 * slope_of_logarithm(c[a], c[b]) * (1. + c[b]);
    // R = dF^-1 Q: l in the eigenbasis is Q_ka R_lb for dH = e_k e_l.
    const Tensor<2, dim> R = inverse * Q;

    for (unsigned int k = 0; k < dim; ++k)
      for (unsigned int l = 0; l < dim; ++l)
        {
          Tensor<2, dim> s; // d trial in the eigenbasis
          for (unsigned int a = 0; a < dim; ++a)
            for (unsigned int b = 0; b < dim; ++b)
              {
                const double term = weight[a][b] * Q[k][a] * R[l][b];
                s[a][b] += term;
                s[b][a] += term;
              }
          const Tensor<2, dim> strain = Q * s * transpose(Q);

          Tensor<2, dim> stress; // d kirchhoff
          for (unsigned int a = 0; a < n; ++a)
            {
              double sum = 0.;
              for (unsigned int b = 0; b < n; ++b)
                {
                  const unsigned int i = row_index<dim>[b];
                  const unsigned int j = column_index<dim>[b];
                  sum += D[a][b] * (i == j ? strain[i][j] : 2. * strain[i][j]);
                }
              stress[row_index<dim>[a]][column_index<dim>[a]] = sum;
              stress[column_index<dim>[a]][row_index<dim>[a]] = sum;
            }

          // d(tau dF^-T) = d tau dF^-T - P dH^T dF^-T
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = 0; j < dim; ++j)
              {
                double sum = -P[i][l] * inverse[j][k];
                for (unsigned int a = 0; a < dim; ++a)
                  sum += stress[i][a] * inverse[j][a];
                A[dim * i + j][dim * k + l] = scale * sum;
              }
        }
  }


  template class LogarithmicStep<2>;
  template class LogarithmicStep<3>;
} // namespace Waker
