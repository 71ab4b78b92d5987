// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/weights.h>

#include "mapping_lattice.h"
#include "verification_data.h"
#include <gtest/gtest.h>
#include <map>

namespace mapping_weights
{
  using namespace Waker;

  namespace
  {
    constexpr double h = 0.3; // m, no binary number


    /// The textbook function of one direction (Bardenhagen & Kober 2004), d the
    /// distance of the point from the node; l = 0: the linear one.
    double
    textbook_value(const double d, const double l)
    {
      const double r = std::abs(d);
      if (r < l)
        return 1. - (d * d + l * l) / (2. * h * l);
      if (r < h - l)
        return 1. - r / h;
      if (r < h + l)
        return (h + l - r) * (h + l - r) / (4. * h * l);
      return 0.;
    }


    double
    textbook_gradient(const double d, const double l)
    {
      const double r = std::abs(d), sign = d < 0. ? -1. : 1.;
      if (r < l)
        return -d / (h * l);
      if (r < h - l)
        return -sign / h;
      if (r < h + l)
        return -sign * (h + l - r) / (2. * h * l);
      return 0.;
    }


    /// Points anywhere in grid and margin, with half-sizes of 0.05 h to h / 2
    /// that differ by direction.
    template <int dim>
    MaterialPoints<dim>
    random_points(const BackgroundGrid<dim> &grid, const unsigned int n)
    {
      Lattice::Random     random(7 + dim);
      MaterialPoints<dim> points;
      for (unsigned int p = 0; p < n; ++p)
        {
          Lattice::add_point(points, Point<dim>(), 1., 0.);
          for (unsigned int d = 0; d < dim; ++d)
            {
              const double l = p % 5 == 0 ? 0.5 * h : random(0.05 * h, 0.5 * h);
              points.half_size[p][d] = l;
              points.position[p][d] =
                grid.origin()[d] +
                random(l, h * (grid.n_nodes_per_direction()[d] - 1) - l);
            }
        }
      return points;
    }


    template <int dim>
    PointWeights<dim>
    weights_at(const BackgroundGrid<dim> &grid,
               const Point<dim>          &x,
               const double               l,
               const ShapeFunctions       functions)
    {
      MaterialPoints<dim> points;
      Lattice::add_point(points, x, 1., l);
      Weights<dim> weights(grid, functions);
      weights.reinit(points);
      return weights[0];
    }


    template <int dim>
    void
    check_consistency(const ShapeFunctions functions)
    {
      const Point<dim> lower(Lattice::Random(1).vector<dim>(-4., 4.));
      Point<dim>       upper = lower;
      for (unsigned int d = 0; d < dim; ++d)
        upper[d] += 5. * h;
      const BackgroundGrid<dim> grid(lower, upper, h, MPI_COMM_SELF);
      const auto                points = random_points(grid, 2000);
      const Stencil<dim>        stencil(grid);
      Weights<dim>              weights(grid, functions);
      const Tensor<2, dim>      identity = unit_symmetric_tensor<dim>();
      weights.reinit(points);
      ASSERT_EQ(weights.size(), points.n_points());

      std::map<std::string, double> worst;
      const auto note = [&](const std::string &what, const double error) {
        worst[what] = std::max(worst[what], error);
      };
      for (unsigned int p = 0; p < points.n_points(); ++p)
        {
          double         sum = 0.;
          Tensor<1, dim> sum_x, sum_gradient;
          Tensor<2, dim> sum_x_gradient;
          stencil.for_each_node(
            weights[p],
            [&](const unsigned int node, const double S, const auto &gradient) {
              const Point<dim> x = grid.node_position(node);
              sum += S;
              sum_x += S * x;
              sum_gradient += gradient;
              sum_x_gradient += outer_product(Tensor<1, dim>(x), gradient);

              // The function itself, against the textbook's.
              double         value = 1.;
              Tensor<1, dim> slope;
              for (unsigned int d = 0; d < dim; ++d)
                slope[d] = 1.;
              for (unsigned int d = 0; d < dim; ++d)
                {
                  const double r = points.position[p][d] - x[d];
                  const double l = functions == ShapeFunctions::gimp
                                     ? points.half_size[p][d]
                                     : 0.;
                  value *= textbook_value(r, l);
                  for (unsigned int e = 0; e < dim; ++e)
                    slope[e] *=
                      e == d ? textbook_gradient(r, l) : textbook_value(r, l);
                }
              note("textbook value", std::abs(S - value));
              note("textbook gradient times h", h * (gradient - slope).norm());
              EXPECT_GE(S, 0.);
            });
          note("sum S = 1", std::abs(sum - 1.));
          note("sum x S = x",
               (sum_x - Tensor<1, dim>(points.position[p])).norm());
          note("h sum grad S = 0", h * sum_gradient.norm());
          note("sum x grad S = I", (sum_x_gradient - identity).norm());
        }
      for (const auto &[what, error] : worst)
        {
          EXPECT_LT(error, 2e-13) << what << " in " << dim << "D";
          Verification::row("weights_errors",
                            "property,dimension,functions,largest error",
                            what,
                            dim,
                            functions == ShapeFunctions::gimp ? "GIMP"
                                                              : "linear",
                            error);
        }
    }
  } // namespace


  TEST(Mapping, functions_reproduce_linear_fields)
  {
    for (const auto functions : {ShapeFunctions::linear, ShapeFunctions::gimp})
      {
        check_consistency<2>(functions);
        check_consistency<3>(functions);
      }
  }


  TEST(Mapping, one_direction_over_its_whole_support)
  {
    // For the figure, and a check of the function far from the node: zero.
    const auto grid = Lattice::grid<2>(1.2, h);
    for (int k = -150; k <= 150; ++k)
      {
        const double d    = 0.01 * k * h;
        double       S[2] = {}, slope[2] = {};
        for (const auto f : {ShapeFunctions::linear, ShapeFunctions::gimp})
          {
            const auto w =
              weights_at(grid, Point<2>(0.6 + d, 0.6), 0.25 * h, f);
            const unsigned int row  = grid.stride(1);
            const int          base = w.base % row, node = 3; // x = 0.6
            if (node >= base && node < base + 3)
              {
                S[f == ShapeFunctions::gimp]     = w.value[0][node - base];
                slope[f == ShapeFunctions::gimp] = w.gradient[0][node - base];
              }
          }
        EXPECT_NEAR(S[0], textbook_value(d, 0.), 1e-14) << d;
        EXPECT_NEAR(S[1], textbook_value(d, 0.25 * h), 1e-14) << d;
        EXPECT_NEAR(slope[1], textbook_gradient(d, 0.25 * h), 1e-12) << d;
        Verification::row("weights_functions",
                          "d/h,linear S,linear h S',GIMP S,GIMP h S'",
                          d / h,
                          S[0],
                          h * slope[0],
                          S[1],
                          h * slope[1]);
      }
  }
} // namespace mapping_weights
