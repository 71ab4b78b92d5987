// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mechanics/gmres.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    double
    dot(const std::vector<double> &a, const std::vector<double> &b)
    {
      // Four sums, so that the compiler may use vectors.
      double            sums[4] = {};
      const std::size_t n       = a.size();
      std::size_t       i       = 0;
      for (; i + 4 <= n; i += 4)
        for (unsigned int l = 0; l < 4; ++l)
          sums[l] += a[i + l] * b[i + l];
      for (; i < n; ++i)
        sums[0] += a[i] * b[i];
      return (sums[0] + sums[1]) + (sums[2] + sums[3]);
    }


    /// a += s b
    void
    add(std::vector<double> &a, const double s, const std::vector<double> &b)
    {
      for (std::size_t i = 0; i < a.size(); ++i)
        a[i] += s * b[i];
    }
  } // namespace


  void
  Gmres::prepare(const NodalVector &inverse_diagonal)
  {
    if (src.size() != inverse_diagonal.size())
      {
        src.reinit(inverse_diagonal);
        dst.reinit(inverse_diagonal);
      }
    src = 0.;
    dofs.clear();
    preconditioner.clear();
    const double *const d = inverse_diagonal.begin();
    for (unsigned int dof = 0; dof < inverse_diagonal.locally_owned_size();
         ++dof)
      if (d[dof] != 0.)
        {
          dofs.push_back(dof);
          preconditioner.push_back(d[dof]);
        }
  }


  void
  Gmres::precondition(const std::vector<double>  &v,
                      const Preconditioner *const strong,
                      NodalVector                &to)
  {
    if (strong == nullptr)
      {
        double *const x = to.begin();
        for (std::size_t k = 0; k < dofs.size(); ++k)
          x[dofs[k]] = preconditioner[k] * v[k];
        return;
      }
    plain.reinit(to);
    for (std::size_t k = 0; k < dofs.size(); ++k)
      plain.begin()[dofs[k]] = v[k];
    strong->vmult(to, plain);
  }


  void
  Gmres::product(const Operator             &A,
                 const std::vector<double>  &v,
                 const Preconditioner *const strong,
                 std::vector<double>        &w)
  {
    precondition(v, strong, src);
    A.vmult(dst, src);
    const double *const y = dst.begin();
    w.resize(dofs.size());
    for (std::size_t k = 0; k < dofs.size(); ++k)
      w[k] = y[dofs[k]];
  }


  double
  Gmres::orthogonalise(std::vector<double> &w,
                       const unsigned int   n,
                       double *const        h)
  {
    if (ranks->is_one_rank())
      {
        for (unsigned int i = 0; i < n; ++i)
          {
            h[i] = dot(w, basis[i]);
            add(w, -h[i], basis[i]);
          }
        return std::sqrt(dot(w, w));
      }
    std::fill_n(h, n, 0.);
    double sums[restart + 1];
    while (true)
      {
        for (unsigned int i = 0; i < n; ++i)
          sums[i] = dot(w, basis[i]);
        sums[n] = dot(w, w);
        ranks->sum(sums, n + 1);
        double rest = sums[n]; // Pythagoras
        for (unsigned int i = 0; i < n; ++i)
          {
            h[i] += sums[i];
            rest -= sums[i] * sums[i];
            add(w, -sums[i], basis[i]);
          }
        // Little of it remains: with the round-off of all of it.
        if (!(rest < 1e-2 * sums[n]) || !(sums[n] > 0.))
          return std::sqrt(std::max(rest, 0.));
      }
  }


  LinearReport
  Gmres::solve(const Operator             &A,
               NodalVector                &x,
               const NodalVector          &b,
               const double                tolerance,
               const unsigned int          max_iterations,
               const Preconditioner *const strong)
  {
    const std::size_t n = dofs.size();
    basis.resize(restart + 1);
    solution.assign(n, 0.);

    LinearReport report;
    double       target = 0.;
    while (true)
      {
        // The residual, and the first vector.
        std::vector<double> &r = basis[0];
        if (report.iterations == 0)
          r.assign(n, 0.);
        else
          product(A, solution, strong, r);
        for (std::size_t k = 0; k < n; ++k)
          r[k] = b.begin()[dofs[k]] - r[k];
        const double norm = std::sqrt(ranks->sum(dot(r, r)));
        if (report.iterations == 0)
          target = tolerance * norm;
        // Infinity is not below infinity times the tolerance.
        report.converged = std::isfinite(norm) && norm <= target;
        if (report.converged || report.iterations >= max_iterations ||
            !std::isfinite(norm))
          break;
        for (double &entry : r)
          entry /= norm;

        // H of Arnoldi, turned to a triangle by Givens rotations (c, s); g the
        // right-hand side, whose last entry is the norm of the residual.
        double       H[restart + 1][restart], c[restart], s[restart];
        double       g[restart + 1] = {norm};
        unsigned int m              = 0;
        while (m < restart && report.iterations < max_iterations &&
               !report.converged)
          {
            std::vector<double> &w = basis[m + 1];
            product(A, basis[m], strong, w);
            double       column[restart + 1];
            const double length = orthogonalise(w, m + 1, column);
            for (unsigned int i = 0; i <= m; ++i)
              H[i][m] = column[i];
            for (unsigned int i = 0; i < m; ++i)
              {
                const double upper = H[i][m];
                H[i][m]            = c[i] * upper + s[i] * H[i + 1][m];
                H[i + 1][m]        = -s[i] * upper + c[i] * H[i + 1][m];
              }
            const double radius = std::hypot(H[m][m], length);
            if (!(radius > 0. && std::isfinite(radius)))
              break; // A is singular, or no number: no more to be had
            c[m]     = H[m][m] / radius;
            s[m]     = length / radius;
            H[m][m]  = radius;
            g[m + 1] = -s[m] * g[m];
            g[m] *= c[m];
            report.converged = std::abs(g[m + 1]) <= target;
            ++m;
            ++report.iterations;
            if (!(length > 0.))
              break; // the space is exhausted
            for (double &entry : w)
              entry /= length;
          }

        for (unsigned int i = m; i-- > 0;)
          {
            for (unsigned int k = i + 1; k < m; ++k)
              g[i] -= H[i][k] * g[k];
            g[i] /= H[i][i];
            add(solution, g[i], basis[i]);
          }
        if (report.converged || m < restart)
          break;
      }

    x = 0.;
    precondition(solution, strong, x);
    return report;
  }
} // namespace Waker
