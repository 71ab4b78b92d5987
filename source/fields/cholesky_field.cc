// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/sizes.h>
#include <waker/fields/cholesky_field.h>
#include <waker/fields/covariance_factor.h>

#include <string>

namespace Waker
{
  struct CholeskyField::Factor
  {
    Eigen::MatrixXd L;
  };



  CholeskyField::CholeskyField(const FieldLattice &lattice,
                               const Correlation  &correlation,
                               const std::string  &path)
    : n(lattice.n())
    , factor(std::make_unique<Factor>())
  {
    if (n > maximum_cells)
      throw UserError(path + "/Generator",
                      "Cholesky is for small fields, and this one has " +
                        std::to_string(n) + " cells",
                      "at most " + std::to_string(maximum_cells) +
                        " cells, or another generator");
    // The matrix, its factor, and work space of one of them.
    require_memory(path + "/Generator",
                   "is Cholesky, with " + std::to_string(n) + " cells",
                   3. * sizeof(double) * n * n,
                   "larger cells, or another generator");
    factor->L =
      covariance_factor(covariance_matrix(correlation.table(lattice.cell_size,
                                                            lattice.n_cells),
                                          lattice.n_cells),
                        path);
  }



  CholeskyField::~CholeskyField() = default;



  std::size_t
  CholeskyField::n_noise() const
  {
    return n;
  }



  void
  CholeskyField::generate(const double *noise, double *values) const
  {
    const Eigen::MatrixXd                  &L = factor->L;
    const Eigen::Map<const Eigen::VectorXd> u(noise, L.cols());
    Eigen::Map<Eigen::VectorXd>             z(values, L.rows());
    if (L.rows() == L.cols())
      z.noalias() = L.triangularView<Eigen::Lower>() * u;
    else
      z.noalias() = L * u;
  }



  std::string
  CholeskyField::description() const
  {
    std::string text = "Cholesky, " + std::to_string(n) + " cells";
    if (factor->L.cols() < factor->L.rows())
      text += ", rank " + std::to_string(factor->L.cols());
    return text;
  }
} // namespace Waker
