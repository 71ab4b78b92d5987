// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_fields_statistics_h
#define waker_tests_fields_statistics_h

#include <waker/base/random_numbers.h>
#include <waker/fields/correlation.h>

#include "verification_data.h"
#include <algorithm>
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace FieldTests
{
  using namespace Waker;

  /// Sum of f(covariance) over all ordered pairs of cells.
  template <typename F>
  double
  sum_of_pairs(const FieldLattice        &lattice,
               const std::vector<double> &table,
               const F                   &f)
  {
    double sum = 0.;
    for (unsigned int j = 0; j < lattice.n_cells[1]; ++j)
      for (unsigned int i = 0; i < lattice.n_cells[0]; ++i)
        sum += (i > 0 ? 2. : 1.) * (j > 0 ? 2. : 1.) *
               (lattice.n_cells[0] - i) * (lattice.n_cells[1] - j) *
               f(table[i + std::size_t(lattice.n_cells[0]) * j]);
    return sum;
  }


  /**
   * Sums over many fields. The statistics that the test looks at are chi^2
   * distributed exactly: for a pair of cells with variance gamma and covariance
   * c, sum (x + y)^2 / (2 (gamma + c)) and sum (x - y)^2 / (2 (gamma - c)) with
   * N degrees of freedom, for a single cell sum x^2 / gamma.
   */
  class Statistics
  {
  public:
    Statistics(const FieldLattice      &lattice,
               const Correlation       &correlation,
               const std::array<int, 2> theta_in_cells)
      : lattice(lattice)
      , table(correlation.table(lattice.cell_size, lattice.n_cells))
      , sum(lattice.n(), 0.)
      , squares(lattice.n(), 0.)
    {
      // Lags 1, theta / 2 and theta in either direction, where they fit.
      for (unsigned int d = 0; d < 2; ++d)
        for (const int lag : {1, theta_in_cells[d] / 2, theta_in_cells[d]})
          if (lag > 0 && lag < int(lattice.n_cells[d]))
            {
              Lag l;
              l.direction = d;
              l.cells     = lag;
              l.plus.assign(lattice.n(), 0.);
              l.minus.assign(lattice.n(), 0.);
              lags.push_back(l);
            }
    }


    void
    add(const std::vector<double> &x)
    {
      ++n_fields;
      double mean_square = 0.;
      for (std::size_t i = 0; i < x.size(); ++i)
        {
          sum[i] += x[i];
          squares[i] += x[i] * x[i];
          mean_square += x[i] * x[i] / x.size();
        }
      sum_mean_square += mean_square;
      for (Lag &lag : lags)
        for_pairs(lag, [&](const std::size_t i, const std::size_t j) {
          lag.plus[i] += (x[i] + x[j]) * (x[i] + x[j]);
          lag.minus[i] += (x[i] - x[j]) * (x[i] - x[j]);
        });
      for (unsigned int d = 0; d < 2; ++d)
        for (unsigned int k = 0; k < n_plotted; ++k)
          {
            Lag lag;
            lag.direction       = d;
            lag.cells           = plotted_lag(d, k);
            double      product = 0.;
            std::size_t n       = 0;
            for_pairs(lag, [&](const std::size_t i, const std::size_t j) {
              product += x[i] * x[j];
              ++n;
            });
            plotted[d][k] += product / n;
          }
    }


    /**
     * Every position must lie between two quantiles that all positions together
     * leave with a probability of at most 1e-3: each with 1e-3 divided by the
     * number of positions (Bonferroni; true also for dependent positions). The
     * average over the positions, with its small error, within 4 standard
     * errors, which follow from the table: the variance of the mean of x^2
     * over a field is 2 / n^2 sum over all pairs c^2.
     */
    void
    check(const std::string &name) const
    {
      const double N = n_fields, gamma = table[0];

      double largest = 0.;
      for (const double s : sum)
        largest = std::max(largest, std::fabs(s) / std::sqrt(gamma * N));
      const double probability = 1e-3 / (2. * lattice.n());
      EXPECT_LT(largest, -standard_normal_quantile(probability)) << name;
      Verification::row("fields_checks",
                        header,
                        name,
                        "mean",
                        largest,
                        0.,
                        -standard_normal_quantile(probability),
                        N);

      check_chi2(name, "variance", squares, gamma, lattice.n());
      for (const Lag &lag : lags)
        {
          const double c =
            table[lag.direction == 0 ? lag.cells
                                     : lag.cells * lattice.n_cells[0]];
          std::vector<double> plus, minus;
          for_pairs(lag, [&](const std::size_t i, std::size_t) {
            plus.push_back(lag.plus[i]);
            minus.push_back(lag.minus[i]);
          });
          const std::string what = std::string(lag.direction == 0 ? "x" : "y") +
                                   " lag " + std::to_string(lag.cells);
          check_chi2(name, what + " sum", plus, 2. * (gamma + c), plus.size());
          check_chi2(
            name, what + " difference", minus, 2. * (gamma - c), plus.size());
        }

      const double c2 =
        sum_of_pairs(lattice, table, [](const double c) { return c * c; });
      const double error   = std::sqrt(2. * c2 / N) / lattice.n() / gamma;
      const double average = sum_mean_square / N / gamma;
      EXPECT_NEAR(average, 1., 4. * error) << name;
      Verification::row("fields_checks",
                        header,
                        name,
                        "average variance",
                        average,
                        1. - 4. * error,
                        1. + 4. * error,
                        N);
    }


    /// Variance map and covariance against lag.
    void
    write(const std::string &name) const
    {
      for (unsigned int j = 0; j < lattice.n_cells[1]; ++j)
        {
          std::string line;
          for (unsigned int i = 0; i < lattice.n_cells[0]; ++i)
            {
              char text[16];
              std::snprintf(text,
                            sizeof text,
                            i > 0 ? ",%.3f" : "%.3f",
                            squares[i + lattice.n_cells[0] * j] / n_fields /
                              table[0]);
              line += text;
            }
          Verification::row("fields_variance_" + name,
                            "# variance / theory, a line per row of cells",
                            line);
        }
      for (unsigned int d = 0; d < 2; ++d)
        for (unsigned int k = 0; k < n_plotted; ++k)
          {
            const int lag = plotted_lag(d, k);
            Verification::row("fields_covariance_" + name,
                              "direction,lag (m),covariance,theory",
                              d,
                              lag * lattice.cell_size[d],
                              plotted[d][k] / n_fields,
                              table[d == 0 ? lag : lag * lattice.n_cells[0]]);
          }
    }

  private:
    struct Lag
    {
      unsigned int        direction = 0;
      int                 cells     = 1;
      std::vector<double> plus, minus; // at the first cell of the pair
    };

    static constexpr unsigned int n_plotted = 20;
    static constexpr const char  *header =
      "case,statistic,obtained,lower,upper,fields";

    FieldLattice                                 lattice;
    std::vector<double>                          table;
    std::vector<double>                          sum, squares;
    std::vector<Lag>                             lags;
    std::array<std::array<double, n_plotted>, 2> plotted{};
    double                                       sum_mean_square = 0.;
    std::size_t                                  n_fields        = 0;


    int
    plotted_lag(const unsigned int d, const unsigned int k) const
    {
      return k * (lattice.n_cells[d] / 2) / (n_plotted - 1);
    }


    template <typename F>
    void
    for_pairs(const Lag &lag, const F &action) const
    {
      const unsigned int dx = lag.direction == 0 ? lag.cells : 0;
      const unsigned int dy = lag.direction == 1 ? lag.cells : 0;
      for (unsigned int j = 0; j + dy < lattice.n_cells[1]; ++j)
        for (unsigned int i = 0; i + dx < lattice.n_cells[0]; ++i)
          {
            const std::size_t first = i + std::size_t(lattice.n_cells[0]) * j;
            action(first, first + dx + std::size_t(lattice.n_cells[0]) * dy);
          }
    }


    void
    check_chi2(const std::string         &name,
               const std::string         &what,
               const std::vector<double> &sums,
               const double               variance,
               const std::size_t          n_positions) const
    {
      const boost::math::chi_squared chi2(n_fields);
      const double                   probability = 1e-3 / (2. * n_positions);
      const double lower = quantile(chi2, probability) / n_fields;
      const double upper = quantile(complement(chi2, probability)) / n_fields;
      const auto [smallest, largest] =
        std::minmax_element(sums.begin(), sums.end());
      EXPECT_GT(*smallest / n_fields / variance, lower) << name << ' ' << what;
      EXPECT_LT(*largest / n_fields / variance, upper) << name << ' ' << what;
      Verification::row("fields_checks",
                        header,
                        name,
                        what + " smallest",
                        *smallest / n_fields / variance,
                        lower,
                        upper,
                        n_fields);
      Verification::row("fields_checks",
                        header,
                        name,
                        what + " largest",
                        *largest / n_fields / variance,
                        lower,
                        upper,
                        n_fields);
    }
  };
} // namespace FieldTests

#endif
