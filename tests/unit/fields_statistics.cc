// SPDX-License-Identifier: LGPL-2.1-or-later
// Thousands of fields, position by position. Set WAKER_VERIFICATION_DATA for
// the data of doc/verification/fields.md.
#include "fields_statistics.h"

#include <waker/base/random_numbers.h>
#include <waker/fields/field_generator.h>
#include <waker/fields/marginal.h>

#include "named.h"
#include "verification_data.h"
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/special_functions/owens_t.hpp>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace fields_statistics
{
  namespace
  {
    using namespace Waker;
    using namespace FieldTests;

    /// Share of the cells below a score.
    struct Share
    {
      double      score;
      double      sum = 0.;
      std::size_t n   = 0;

      void
      add(const std::vector<double> &standard_normal)
      {
        for (const double z : standard_normal)
          sum += (z < score) / double(standard_normal.size());
        ++n;
      }

      /**
       * Within 4 standard errors of the probability, if cells below the score
       * are frequent enough for the central limit theorem. The error is that of
       * theory (far out, that of the sample is much too small as long as few
       * patches have been seen): two cells with correlation rho are both below
       * s with probability Phi(s) - 2 T(s, sqrt((1 - rho) / (1 + rho))), T of
       * Owen.
       */
      void
      check(const std::string         &name,
            const FieldLattice        &lattice,
            const std::vector<double> &table) const
      {
        const double expected = standard_normal_distribution(score);
        const double pairs =
          sum_of_pairs(lattice, table, [&](const double covariance) {
            const double rho = covariance / table[0];
            return expected - expected * expected -
                   2. *
                     boost::math::owens_t(std::fabs(score),
                                          std::sqrt((1. - rho) / (1. + rho)));
          });
        const double error = std::sqrt(pairs / n) / lattice.n();
        if (score > -3.5)
          {
            EXPECT_NEAR(sum / n, expected, 4. * error) << name << ' ' << score;
          }
        Verification::row(
          "fields_truncation",
          "case,score,probability,obtained,standard error,fields",
          name,
          score,
          expected,
          sum / n,
          error,
          n);
      }
    };


    void
    show(const std::string                &name,
         const std::string                &method,
         const Correlation::Function       function,
         const double                      theta_h,
         const std::array<unsigned int, 2> n_cells,
         const unsigned int                n_fields)
    {
      FieldLattice lattice;
      lattice.n_cells           = {{n_cells[0], n_cells[1], 1}};
      lattice.cell_size         = {{0.125, 0.125, 1.}};
      const double      theta_v = 0.5;
      const Correlation correlation(function, {theta_h, theta_v});
      const auto        generator =
        make_field_generator(Named{method}, lattice, correlation, "test");
      const double sd =
        std::sqrt(correlation.between_cells(lattice.cell_size, {{0, 0, 0}}));

      Statistics         statistics(lattice,
                            correlation,
                            {{int(theta_h / 0.125), int(theta_v / 0.125)}});
      std::vector<Share> shares{{-2.}, {-3.}, {-4.}, {-5.}};

      const Marginal      marginal(Marginal::Kind::normal);
      std::vector<double> noise(generator->n_noise()), x(lattice.n());
      NoiseKey            key;
      key.seed = 2026;
      for (unsigned int i = 0; i < n_fields; ++i)
        {
          key.realisation = i;
          white_noise(key, 0, noise.size(), noise.data());
          generator->generate(noise.data(), x.data());
          statistics.add(x);

          for (double &value : x)
            value /= sd;
          for (Share &share : shares)
            share.add(x);
          // The first field as strength, at sizes worth a picture.
          if (i == 0 && lattice.n() == 9600)
            for (unsigned int row = 0; row < n_cells[1]; ++row)
              {
                std::string line;
                for (unsigned int column = 0; column < n_cells[0]; ++column)
                  {
                    char text[16];
                    std::snprintf(text,
                                  sizeof text,
                                  column > 0 ? ",%.2f" : "%.2f",
                                  marginal.value(x[column + n_cells[0] * row],
                                                 13.,
                                                 2.6));
                    line += text;
                  }
                Verification::row("fields_picture_" + name,
                                  "# kPa, a line per row of cells",
                                  line);
              }
        }
      statistics.check(name);
      if (lattice.n() == 9600)
        statistics.write(name);
      for (const Share &share : shares)
        share.check(name,
                    lattice,
                    correlation.table(lattice.cell_size, lattice.n_cells));
    }


    TEST(Long, circulant_fields_of_chapter_5)
    {
      show("circulant_24",
           "circulant embedding",
           Correlation::Function::markov,
           24.,
           {{240, 40}},
           5000);
    }


    TEST(Long, circulant_fields_with_a_short_scale)
    {
      show("circulant_4",
           "circulant embedding",
           Correlation::Function::markov,
           4.,
           {{240, 40}},
           5000);
    }


    TEST(Long, cholesky_fields)
    {
      show("cholesky_4",
           "Cholesky",
           Correlation::Function::markov,
           4.,
           {{40, 24}},
           5000);
    }
  } // namespace
} // namespace fields_statistics
