// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/base/errors.h>
#include <waker/fields/conditioning.h>
#include <waker/fields/covariance_factor.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace Waker
{
  struct Conditioning::Kriging
  {
    FieldLattice             lattice;
    std::vector<std::size_t> cells; // with measurements, ascending
    std::size_t              n_measurements;
    Eigen::VectorXd          scores; // means of those in a cell
    Eigen::VectorXd          errors; // standard deviations of these means
    bool                     exact;  // no errors of measurement

    Eigen::LLT<Eigen::MatrixXd> covariance; // C_oo + E
    double                      common;     // variance

    /// Covariances for lags (l_x, l_y, l_z) with -n_x < l_x < n_x, the others
    /// from 0 on: row (l_y, l_z) starts with l_x = -(n_x - 1).
    std::vector<double>     lags;
    mutable Eigen::VectorXd residual; // work space of apply()
  };



  Conditioning::Conditioning(const FieldLattice               &lattice,
                             const Correlation                &correlation,
                             const std::vector<MeasuredScore> &measurements,
                             const double                      cell_variance,
                             const double                      error_variance,
                             const std::string                &path,
                             const double                      common_variance)
    : kriging(std::make_unique<Kriging>())
  {
    Assert(cell_variance + common_variance > 0.,
           dealii::ExcMessage("variance <= 0"));
    Assert(error_variance >= 0., dealii::ExcMessage("error variance < 0"));

    struct Mean
    {
      double       sum = 0.;
      unsigned int n   = 0;
    };
    std::map<std::size_t, Mean> means;
    for (const MeasuredScore &measurement : measurements)
      {
        AssertIndexRange(measurement.cell, lattice.n());
        means[measurement.cell].sum += measurement.score;
        ++means[measurement.cell].n;
      }
    if (means.size() > maximum_measured_cells)
      throw UserError(path + "/Measurements",
                      "measurements in " + std::to_string(means.size()) +
                        " cells",
                      "in at most " + std::to_string(maximum_measured_cells) +
                        " cells");

    Kriging &o       = *kriging;
    o.lattice        = lattice;
    o.n_measurements = measurements.size();
    o.exact          = error_variance == 0.;
    o.common         = common_variance;
    o.scores.resize(means.size());
    o.errors.resize(means.size());
    for (const auto &[cell, mean] : means)
      {
        o.scores[o.cells.size()] = mean.sum / mean.n;
        o.errors[o.cells.size()] = std::sqrt(error_variance / mean.n);
        o.cells.push_back(cell);
      }

    const auto         &n     = lattice.n_cells;
    std::vector<double> table = correlation.table(lattice.cell_size, n);
    const double        scale = cell_variance / table[0];
    for (double &c : table)
      c = scale * c + common_variance;
    o.lags.reserve((2 * n[0] - 1) * n[1] * n[2]);
    for (auto row = table.cbegin(); row != table.cend(); row += n[0])
      {
        o.lags.insert(o.lags.end(),
                      std::make_reverse_iterator(row + n[0]),
                      std::make_reverse_iterator(row + 1));
        o.lags.insert(o.lags.end(), row, row + n[0]);
      }

    Eigen::MatrixXd C(o.cells.size(), o.cells.size());
    for (std::size_t a = 0; a < o.cells.size(); ++a)
      for (std::size_t b = 0; b < o.cells.size(); ++b)
        C(a, b) = table[lag_index(
          lattice.index(o.cells[a]), lattice.index(o.cells[b]), n)];
    C.diagonal() += o.errors.cwiseAbs2();
    o.covariance.compute(C);
    if (o.cells.size() > 0 && (o.covariance.info() != Eigen::Success ||
                               !(o.covariance.rcond() > 1e-12)))
      throw UserError(path + "/Measurements",
                      "the measured values in " +
                        std::to_string(o.cells.size()) +
                        " cells cannot be kept exactly: their covariance is "
                        "singular in double precision",
                      "an error of measurement > 0, fewer measurements, or a "
                      "less smooth correlation");
    o.residual.resize(o.cells.size());
  }



  Conditioning::~Conditioning()               = default;
  Conditioning::Conditioning(Conditioning &&) = default;
  Conditioning &
  Conditioning::operator=(Conditioning &&) = default;



  std::size_t
  Conditioning::n_noise() const
  {
    return kriging->exact ? 0 : kriging->cells.size();
  }



  std::size_t
  Conditioning::n_measured_cells() const
  {
    return kriging->cells.size();
  }



  double
  Conditioning::apply(const double *noise, double *values) const
  {
    const Kriging &o = *kriging;
    for (std::size_t i = 0; i < o.cells.size(); ++i)
      {
        o.residual[i] = o.scores[i] - values[o.cells[i]];
        if (!o.exact)
          o.residual[i] -= o.errors[i] * noise[i];
      }
    o.covariance.solveInPlace(o.residual);

    const auto &n = o.lattice.n_cells;
    for (std::size_t i = 0; i < o.cells.size(); ++i)
      {
        const auto   at     = o.lattice.index(o.cells[i]);
        const double weight = o.residual[i];
        double      *row    = values;
        for (unsigned int z = 0; z < n[2]; ++z)
          for (unsigned int y = 0; y < n[1]; ++y, row += n[0])
            {
              const std::size_t lag_y = y > at[1] ? y - at[1] : at[1] - y;
              const std::size_t lag_z = z > at[2] ? z - at[2] : at[2] - z;
              const double     *lags  = o.lags.data() +
                                   (2 * n[0] - 1) * (lag_y + n[1] * lag_z) +
                                   (n[0] - 1 - at[0]);
              for (unsigned int x = 0; x < n[0]; ++x)
                row[x] += weight * lags[x];
            }
      }

    if (o.exact) // remove the rounding errors
      for (std::size_t i = 0; i < o.cells.size(); ++i)
        values[o.cells[i]] = o.scores[i];
    return o.common * o.residual.sum();
  }



  std::string
  Conditioning::description() const
  {
    return "conditioned on " + std::to_string(kriging->n_measurements) +
           " measurements in " + std::to_string(kriging->cells.size()) +
           " cells";
  }
} // namespace Waker
