// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/fields/covariance_factor.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace Waker
{
  namespace
  {
    /**
     * Cholesky factorisation with the largest remaining diagonal as pivot,
     * until nothing is left but rounding errors (Higham 2002, section 10.3).
     * Column by column, so that C remains as it is.
     */
    Eigen::MatrixXd
    pivoted_factor(const Eigen::MatrixXd &C,
                   const double           variance,
                   const std::string     &path)
    {
      const Eigen::Index n = C.rows();
      Eigen::VectorXd    left(C.diagonal()); // of the variance
      const double       negligible =
        n * std::numeric_limits<double>::epsilon() * variance;

      Eigen::MatrixXd L(n, std::min<Eigen::Index>(n, 64));
      Eigen::Index    rank = 0;
      for (Eigen::Index pivot; rank < n; ++rank)
        {
          const double largest = left.maxCoeff(&pivot);
          if (largest <= negligible)
            break;
          if (rank == L.cols())
            L.conservativeResize(n, std::min(n, 2 * rank));
          L.col(rank).noalias() =
            C.col(pivot) -
            L.leftCols(rank) * L.row(pivot).head(rank).transpose();
          L.col(rank) /= std::sqrt(largest);
          left -= L.col(rank).cwiseAbs2();
          left[pivot] = 0.;
        }
      L.conservativeResize(n, rank);

      // What is left of a positive semidefinite matrix is rounding errors.
      const double error = std::max(-left.minCoeff(), 0.) / variance;
      if (!(error < 1e-8)) // or not a number
        {
          std::ostringstream problem;
          problem << "the covariance of " << n << " cells is not positive "
                  << "semidefinite (the variance left after a factorisation "
                  << "of rank " << rank << " is " << -error
                  << " of the largest)";
          throw UserError(path + "/Generator",
                          problem.str(),
                          "another generator, correlation function or scale of "
                          "fluctuation");
        }
      return L;
    }
  } // namespace



  Eigen::MatrixXd
  covariance_matrix(const std::vector<double>         &table,
                    const std::array<unsigned int, 3> &n)
  {
    const FieldLattice cells{3, n, {}, {}};
    Eigen::MatrixXd    C(cells.n(), cells.n());
    for (std::size_t a = 0; a < cells.n(); ++a)
      for (std::size_t b = 0; b <= a; ++b)
        C(a, b) = C(b, a) = table[lag_index(cells.index(a), cells.index(b), n)];
    return C;
  }



  Eigen::MatrixXd
  covariance_factor(Eigen::MatrixXd    C,
                    const std::string &path,
                    const double       variance)
  {
    if (!C.allFinite())
      throw UserError(path + "/Scales of fluctuation",
                      "the covariance of the field's cells is not finite",
                      "scales and cells of sizes that one can measure");
    // In place: the factor takes the lower triangle, the upper one keeps C.
    const Eigen::VectorXd diagonal = C.diagonal();
    const double          reference =
      variance > 0. ? variance : diagonal.cwiseAbs().maxCoeff();
    Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> llt(C);
    // A pivot this small has no correct digit.
    const double negligible =
      C.rows() * std::numeric_limits<double>::epsilon() * reference;
    if (llt.info() == Eigen::Success &&
        C.diagonal().cwiseAbs2().minCoeff() > negligible)
      {
        C.triangularView<Eigen::StrictlyUpper>().setZero();
        return C;
      }
    C.triangularView<Eigen::StrictlyLower>() = C.transpose();
    C.diagonal()                             = diagonal;
    return pivoted_factor(C, reference, path);
  }
} // namespace Waker
