// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/random_numbers.h>
#include <waker/fields/local_average_subdivision.h>
#include <waker/fields/subdivision_stage.h>

#include "field_moments.h"
#include "linear_map.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace fields_subdivision
{
  using namespace Waker;

  TEST(Fields, one_subdivision_has_the_exact_variance)
  {
    // Also the covariance of children with the same parent, in all directions.
    struct Case
    {
      std::array<unsigned int, 3> n, stage_0;
      std::vector<double>         theta;
    };
    const std::array<double, 3> size{{0.25, 0.125, 0.5}};
    for (const Case &c :
         {Case{{{20, 1, 1}}, {{10, 1, 1}}, {1.}},
          Case{{{2, 1, 1}}, {{1, 1, 1}}, {1.}},
          Case{{{12, 8, 1}}, {{6, 4, 1}}, {4., 0.5}},
          Case{{{12, 2, 1}}, {{6, 1, 1}}, {4., 0.5}}, // one row of parents
          Case{{{8, 6, 6}}, {{4, 3, 3}}, {4., 0.5, 2.}}})
      for (const auto function : {Correlation::Function::markov,
                                  Correlation::Function::separable_markov,
                                  Correlation::Function::gaussian})
        {
          const FieldLattice            l = field_lattice(c.n, size);
          const Correlation             correlation(function, c.theta);
          const LocalAverageSubdivision las(
            l, correlation, "", c.stage_0[0] * c.stage_0[1] * c.stage_0[2]);
          ASSERT_EQ(las.n_subdivisions(), 1u);
          ASSERT_EQ(las.stage_0(), c.stage_0);
          ASSERT_EQ(las.n_noise(), l.n());

          const auto                  map = linear_map(las, l.n());
          std::array<unsigned int, 3> two{{1, 1, 1}};
          std::fill_n(two.begin(), l.dim, 2);
          const std::vector<double> exact = correlation.table(size, two);
          const std::size_t y = l.n_cells[0], z = l.n_cells[0] * l.n_cells[1];
          for (std::size_t cell = 0; cell < l.n(); ++cell)
            {
              const auto i = l.index(cell);
              EXPECT_NEAR(covariance(map, cell, cell), exact[0], 2e-9);
              if (i[0] % 2 == 1 || i[1] % 2 == 1 || i[2] % 2 == 1)
                continue; // not the first of the children
              EXPECT_NEAR(covariance(map, cell, cell + 1), exact[1], 2e-9);
              if (l.dim > 1)
                {
                  EXPECT_NEAR(covariance(map, cell, cell + y), exact[2], 2e-9);
                  EXPECT_NEAR(covariance(map, cell + 1, cell + y),
                              exact[3],
                              2e-9);
                }
              if (l.dim > 2)
                {
                  EXPECT_NEAR(covariance(map, cell, cell + z), exact[4], 2e-9);
                  EXPECT_NEAR(covariance(map, cell, cell + 1 + y + z),
                              exact[7],
                              2e-9);
                }
            }
        }
  }



  TEST(Fields, local_average_subdivision_is_exact_on_a_line_of_three_parents)
  {
    // Everything is in the neighbourhood of the cell in the middle: also its
    // children's covariances with the other parents are exact.
    const FieldLattice l = field_lattice({{6, 1, 1}});
    const Correlation  correlation(Correlation::Function::markov, {4.});
    const LocalAverageSubdivision las(l, correlation, "", 3);
    const auto                    map     = linear_map(las, l.n());
    const auto                    between = [&](const unsigned int child,
                             const unsigned int other) {
      return correlation.between_cells(l.cell_size,
                                       {{int(child) - int(other), 0, 0}});
    };
    for (const unsigned int child : {2u, 3u})
      for (const unsigned int parent : {0u, 2u, 4u})
        EXPECT_NEAR((covariance(map, child, parent) +
                     covariance(map, child, parent + 1)),
                    between(child, parent) + between(child, parent + 1),
                    1e-12);
  }



  TEST(Fields, children_have_the_mean_of_their_parent)
  {
    const Correlation correlation(Correlation::Function::markov, {4., 2., 3.});
    const std::array<unsigned int, 3> n{{4, 3, 2}};
    const SubdivisionStage stage(correlation, n, {{0.5, 0.25, 0.3}}, "");
    std::vector<double>    parents(24), noise(stage.n_noise()), children(192);
    ASSERT_EQ(noise.size(), 24u * 7u);
    white_noise({1, 0, 0}, 0, parents.size(), parents.data());
    white_noise({2, 0, 0}, 0, noise.size(), noise.data());
    stage.subdivide(parents.data(), noise.data(), children.data());

    const FieldLattice  fine = field_lattice({{8, 6, 4}});
    std::vector<double> sums(24, 0.);
    for (std::size_t c = 0; c < children.size(); ++c)
      {
        const auto i = fine.index(c);
        sums[i[0] / 2 + 4 * (i[1] / 2 + 3 * (i[2] / 2))] += children[c];
      }
    for (std::size_t p = 0; p < parents.size(); ++p)
      EXPECT_NEAR(sums[p] / 8., parents[p], 1e-14);
  }



  TEST(Fields, local_average_subdivision_knows_directions)
  {
    // The same field with exchanged axes has exchanged moments.
    const FieldLattice a = field_lattice({{24, 16, 1}}, {{0.25, 0.5, 1.}}),
                       b = field_lattice({{16, 24, 1}}, {{0.5, 0.25, 1.}});
    const Correlation correlation_a(Correlation::Function::markov, {6., 1.}),
      correlation_b(Correlation::Function::markov, {1., 6.});
    const Moments of_a(LocalAverageSubdivision(a, correlation_a, "", 24), a),
      of_b(LocalAverageSubdivision(b, correlation_b, "", 24), b);
    double spread = 0.;
    for (std::size_t c = 0; c < a.n(); ++c)
      {
        const auto        i = a.index(c);
        const std::size_t d = i[1] + 16 * i[0];
        EXPECT_NEAR(of_a.variance[c], of_b.variance[d], 1e-9);
        EXPECT_NEAR(of_a.next_x[c] * (i[0] < 23), of_b.next_y[d], 1e-9);
        spread = std::max(spread, std::abs(of_a.next_x[c] - of_a.next_y[c]));
      }
    EXPECT_GT(spread, 0.3); // not the trivial case
  }



  // Obtained with an independent program, `known_errors()` in
  // contrib/verification/local_average_subdivision.py (Markov): stage 0, m,
  // scales (cells), errors of variance and of covariance of neighbours in x
  // (%).
  struct Known
  {
    std::array<unsigned int, 2> k;
    unsigned int                m;
    std::vector<double>         theta;
    double least, largest, lag_1, least_lag_1, largest_lag_1;
  };

  TEST(Fields, local_average_subdivision_has_its_known_error)
  {
    for (const Known &known :
         {Known{{{8, 8}}, 2, {4., 4.}, -8.695, 5.620, -8.052, -29.47, 4.40},
          Known{{{8, 8}}, 3, {4., 4.}, -19.477, 11.363, -8.992, -44.55, 10.68},
          Known{{{8, 8}}, 3, {32., 32.}, -6.971, 4.140, -1.184, -10.10, 3.37},
          Known{{{6, 3}}, 3, {192., 4.}, -28.409, 32.671, -8.330, -45.35, 27.},
          Known{{{6, 3}}, 3, {32., 4.}, -24.564, 19.675, -8.311, -46.32, 15.5}})
      {
        const FieldLattice l =
          field_lattice({{known.k[0] << known.m, known.k[1] << known.m, 1}});
        const Correlation             correlation(Correlation::Function::markov,
                                      known.theta);
        const LocalAverageSubdivision las(l,
                                          correlation,
                                          "",
                                          known.k[0] * known.k[1]);
        const Errors                  e = errors({las, l}, l, correlation);
        EXPECT_NEAR(e.least_variance, known.least, 0.001);
        EXPECT_NEAR(e.largest_variance, known.largest, 0.001);
        EXPECT_NEAR(e.mean_lag_1, known.lag_1, 0.001);
        EXPECT_NEAR(e.least_lag_1, known.least_lag_1, 0.01);
        EXPECT_NEAR(e.largest_lag_1, known.largest_lag_1, 0.01);
      }
  }



  TEST(Fields, the_error_of_local_average_subdivision_is_symmetric)
  {
    // No direction is preferred, and no side, although the last child is not
    // drawn: in 3D, where the other tests subdivide once.
    const FieldLattice l = field_lattice({{8, 8, 8}});
    const Correlation  correlation(Correlation::Function::markov, {4., 4., 4.});
    const Moments moments(LocalAverageSubdivision(l, correlation, "", 8), l);
    for (std::size_t c = 0; c < l.n(); ++c)
      {
        const auto i = l.index(c);
        for (const std::size_t image : {(7 - i[0]) + 8 * (i[1] + 8 * i[2]),
                                        i[0] + 8 * ((7 - i[1]) + 8 * i[2]),
                                        i[0] + 8 * (i[1] + 8 * (7 - i[2])),
                                        i[1] + 8 * (i[0] + 8 * i[2]),
                                        i[2] + 8 * (i[1] + 8 * i[0])})
          EXPECT_NEAR(moments.variance[c], moments.variance[image], 1e-9);
      }
    const auto [least, largest] =
      std::minmax_element(moments.variance.begin(), moments.variance.end());
    EXPECT_GT(*largest - *least, 0.01); // m = 2: there is an error
  }



  TEST(Fields, lattices_of_any_size_are_part_of_a_subdivision)
  {
    struct Case
    {
      std::array<unsigned int, 3> part, all;
      std::vector<double>         theta;
    };
    for (const Case &size : {Case{{{257, 1, 1}}, {{258, 1, 1}}, {8.}},
                             Case{{{33, 17, 1}}, {{34, 18, 1}}, {8., 4.}},
                             Case{{{17, 9, 5}}, {{18, 10, 6}}, {8., 4., 6.}}})
      {
        const FieldLattice part = field_lattice(size.part),
                           all  = field_lattice(size.all);
        const Correlation             correlation(Correlation::Function::markov,
                                      size.theta);
        const LocalAverageSubdivision of_part(part, correlation, ""),
          of_all(all, correlation, "");
        ASSERT_EQ(of_part.n_subdivisions(), 1u);
        ASSERT_EQ(of_part.n_noise(), all.n());
        ASSERT_EQ(of_all.n_noise(), all.n());
        std::vector<double> noise(all.n()), a(part.n()), b(all.n());
        white_noise({3, 0, 0}, 0, noise.size(), noise.data());
        of_part.generate(noise.data(), a.data());
        of_all.generate(noise.data(), b.data());
        for (std::size_t c = 0; c < a.size(); ++c)
          {
            const auto i = part.index(c);
            EXPECT_EQ(a[c],
                      b[i[0] + size.all[0] * (i[1] + size.all[1] * i[2])]);
          }
      }
  }



  TEST(Fields, smooth_fields_are_subdivided_too)
  {
    // Neighbours determine a cell to 1e-12 and less: the matrices are singular
    // in double precision, but for the first case, which is compared with
    // known_errors() for the Gaussian correlation.
    struct Case
    {
      std::array<unsigned int, 3> n;
      std::vector<double>         theta;
      double                      least, largest, tolerance;
    };
    for (const Case &c : {Case{{{24, 24, 1}}, {10., 10.}, -2.504, 1.823, 0.001},
                          Case{{{24, 24, 1}}, {1000., 20.}, -0.1, 0.11, 0.02},
                          Case{{{24, 24, 1}}, {1000., 1000.}, 0., 0., 0.001},
                          Case{{{12, 12, 12}}, {2000., 40., 40.}, 0., 0., 1.}})
      {
        const FieldLattice l = field_lattice(c.n);
        const Correlation correlation(Correlation::Function::gaussian, c.theta);
        const Errors      e = errors(
          {LocalAverageSubdivision(l, correlation, "", l.dim == 3 ? 27 : 36),
                l},
          l,
          correlation);
        EXPECT_NEAR(e.least_variance, c.least, c.tolerance);
        EXPECT_NEAR(e.largest_variance, c.largest, c.tolerance);
      }
  }



  TEST(Fields, what_cannot_be_subdivided_is_refused)
  {
    const Correlation correlation(Correlation::Function::markov, {4., 4.});
    try
      {
        const LocalAverageSubdivision las(field_lattice({{1u << 26, 2, 1}}),
                                          correlation,
                                          "Random fields/strength");
        FAIL();
      }
    catch (const UserError &error)
      {
        EXPECT_EQ(error.where, "Random fields/strength/Generator");
        EXPECT_NE(error.problem.find("67108864 x 2"), std::string::npos);
      }
  }
} // namespace fields_subdivision
