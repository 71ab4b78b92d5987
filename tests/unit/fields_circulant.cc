// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/random_numbers.h>
#include <waker/fields/circulant_embedding.h>

#include "user_errors.h"
#include <array>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace fields_circulant
{
  namespace
  {
    using namespace Waker;
    using Function = Correlation::Function;

    const std::array<Function, 3> functions{
      {Function::markov, Function::separable_markov, Function::gaussian}};


    FieldLattice
    lattice(const std::vector<unsigned int> &n, const std::vector<double> &size)
    {
      FieldLattice l;
      l.dim = n.size();
      for (unsigned int d = 0; d < l.dim; ++d)
        {
          l.n_cells[d]   = n[d];
          l.cell_size[d] = size[d];
        }
      return l;
    }


    std::vector<double>
    field(const FieldGenerator &generator,
          const FieldLattice   &lattice,
          const std::uint64_t   realisation)
    {
      NoiseKey key;
      key.seed        = 11;
      key.realisation = realisation;
      std::vector<double> noise(generator.n_noise()), values(lattice.n());
      white_noise(key, 0, noise.size(), noise.data());
      generator.generate(noise.data(), values.data());
      return values;
    }


    /// Largest difference between the covariance of the generated fields (G
    /// G^T, column m of G being the field of unit noise m) and that of the
    /// cells.
    double
    covariance_error(const FieldLattice   &lattice,
                     const Correlation    &correlation,
                     const FieldGenerator &generator)
    {
      const std::size_t   n = lattice.n();
      std::vector<double> noise(generator.n_noise(), 0.), column(n),
        covariance(n * n, 0.);
      for (double &unit : noise)
        {
          unit = 1.;
          generator.generate(noise.data(), column.data());
          unit = 0.;
          for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j)
              covariance[i * n + j] += column[i] * column[j];
        }

      const std::vector<double> table =
        correlation.table(lattice.cell_size, lattice.n_cells);
      double worst = 0.;
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          {
            std::array<unsigned int, 3> lag;
            for (unsigned int d = 0; d < 3; ++d)
              lag[d] =
                std::abs(int(lattice.index(i)[d]) - int(lattice.index(j)[d]));
            const double expected =
              table[lag[0] + lattice.n_cells[0] *
                               (lag[1] + lattice.n_cells[1] * lag[2])];
            worst =
              std::max(worst, std::fabs(covariance[i * n + j] - expected));
          }
      return worst;
    }


    // The map from noise to field is linear, so its covariance is known
    // exactly.
    TEST(CirculantEmbedding, covariance_of_cells_is_exact)
    {
      for (const Function f : functions)
        {
          const std::vector<std::pair<FieldLattice, Correlation>> cases{
            {lattice({9}, {0.25}), Correlation(f, {0.8})},
            {lattice({7, 6}, {0.5, 0.25}), Correlation(f, {1., 0.5})},
            {lattice({1, 8}, {0.5, 0.25}), Correlation(f, {1., 0.5})},
            {lattice({4, 3, 5}, {0.5, 0.25, 1.}),
             Correlation(f, {0.7, 0.3, 1.4})}};
          for (const auto &[cells, correlation] : cases)
            {
              const CirculantEmbedding generator(cells, correlation, "test");
              EXPECT_LT(covariance_error(cells, correlation, generator), 1e-12)
                << int(f) << ": " << generator.description();
            }
        }
    }


    // Scales that are large compared with the box: the torus has to grow. What
    // is cut off changes no covariance by more than its share.
    TEST(CirculantEmbedding, torus_grows_until_the_share_is_small)
    {
      const FieldLattice       cells = lattice({10, 4}, {0.125, 0.125});
      const Correlation        markov(Function::markov, {2., 0.25});
      const CirculantEmbedding generator(cells, markov, "test");
      EXPECT_GT(generator.torus()[0], 18u);
      EXPECT_EQ(generator.n_noise(),
                std::size_t(generator.torus()[0]) * generator.torus()[1]);
      EXPECT_LT(generator.negative_share(), CirculantEmbedding::tolerance);
      EXPECT_LE(covariance_error(cells, markov, generator),
                2. * generator.negative_share() + 1e-12);
    }


    TEST(CirculantEmbedding, sizes_suit_the_transform)
    {
      const Correlation separable(Function::separable_markov, {4., 0.5});
      EXPECT_EQ(CirculantEmbedding(lattice({240, 40}, {0.125, 0.125}),
                                   separable,
                                   "test")
                  .torus(),
                (std::array<unsigned int, 3>{{480, 80, 1}}));
      EXPECT_EQ(CirculantEmbedding(lattice({72, 12}, {0.125, 0.125}),
                                   separable,
                                   "test")
                  .torus(),
                (std::array<unsigned int, 3>{{144, 24, 1}}));
    }


    TEST(CirculantEmbedding, is_refused_where_it_is_impossible)
    {
      const FieldLattice cells = lattice({40, 40}, {0.125, 0.125});
      const Correlation  wide(Function::markov, {500., 500.});
      try
        {
          CirculantEmbedding(cells, wide, "Random fields/strength", 40000);
          FAIL();
        }
      catch (const UserError &error)
        {
          EXPECT_EQ(error.where, "Random fields/strength/Generator");
          EXPECT_NE(error.problem.find("negative eigenvalues"),
                    std::string::npos);
          EXPECT_NE(error.allowed.find("local average subdivision"),
                    std::string::npos);
        }
      // And where the smallest torus is too large already.
      EXPECT_USER_ERROR(CirculantEmbedding(cells,
                                           Correlation(Function::markov,
                                                       {1., 1.}),
                                           "test",
                                           1000),
                        "test/Generator",
                        "needs a torus of 80 x 80");
    }


    TEST(CirculantEmbedding, field_is_a_function_of_the_noise)
    {
      const FieldLattice       cells = lattice({60, 20}, {0.125, 0.125});
      const Correlation        markov(Function::markov, {4., 0.5});
      const CirculantEmbedding one(cells, markov, "test");
      const CirculantEmbedding other(cells, markov, "test");

      const std::vector<double> second = field(one, cells, 1);
      const std::vector<double> first  = field(one, cells, 0);
      EXPECT_EQ(field(other, cells, 0), first);
      EXPECT_EQ(field(other, cells, 1), second);
      EXPECT_EQ(field(one, cells, 1), second);
      EXPECT_NE(first, second);

      // Noise at unaligned addresses gives the same bits.
      std::vector<double> noise(one.n_noise() + 1), values(cells.n() + 1);
      NoiseKey            key;
      key.seed = 11;
      white_noise(key, 0, one.n_noise(), noise.data() + 1);
      one.generate(noise.data() + 1, values.data() + 1);
      EXPECT_EQ(std::vector<double>(values.begin() + 1, values.end()), first);
    }


    TEST(CirculantEmbedding, lattice_finds_its_cells)
    {
      FieldLattice cells = lattice({4, 3, 5}, {0.5, 0.25, 1.});
      cells.origin       = {{-1., 2., 0.}};
      for (std::size_t i = 0; i < cells.n(); ++i)
        EXPECT_EQ(cells.cell_of(cells.centre(i)), i);
      EXPECT_EQ(cells.centre(0)[1], 2.125);
      EXPECT_EQ(cells.cell_of({{-9., 0., -9.}}), 0u);
      EXPECT_EQ(cells.cell_of({{9., 9., 9.}}), cells.n() - 1);

      const FieldLattice line = lattice({4}, {0.5});
      EXPECT_EQ(line.centre(2), (std::array<double, 3>{{1.25, 0., 0.}}));
      EXPECT_EQ(line.cell_of({{1.2, 77., -5.}}), 2u);
    }
  } // namespace
} // namespace fields_circulant
