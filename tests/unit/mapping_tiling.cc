// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/mapping/weights.h>

#include "mapping_lattice.h"
#include "verification_data.h"
#include <gtest/gtest.h>

namespace mapping_tiling
{
  // Support domains that tile a body integrate the nodes' hat functions
  // exactly: sum_p V_p S_ip = int N_i dV over the body, wherever it lies on the
  // grid.

  using namespace Waker;

  namespace
  {
    constexpr double h = 0.25;


    /// The integral of the hat function of the node at 0 from -infinity to x.
    double
    hat_integral(const double x)
    {
      if (x <= -h)
        return 0.;
      if (x <= 0.)
        return 0.5 * (x + h) * (x + h) / h;
      if (x <= h)
        return h - 0.5 * (h - x) * (h - x) / h;
      return h;
    }


    double
    hat(const double x)
    {
      return std::max(0., 1. - std::abs(x) / h);
    }


    struct Errors
    {
      double value    = 0.; // relative to h^dim
      double gradient = 0.; // relative to h^(dim-1)
    };


    /// Largest differences at a node, over all nodes of the grid.
    template <int dim>
    Errors
    integrate(const BackgroundGrid<dim> &grid,
              const Point<dim>          &lower,
              const unsigned int         n,
              const double               spacing,
              const ShapeFunctions       functions)
    {
      const auto                  points = Lattice::box(lower, n, spacing);
      Weights<dim>                weights(grid, functions);
      std::vector<double>         sum(grid.n_nodes());
      std::vector<Tensor<1, dim>> sum_gradient(grid.n_nodes());
      weights.reinit(points);
      const Stencil<dim> stencil(grid);
      for (unsigned int p = 0; p < points.n_points(); ++p)
        stencil.for_each_node(
          weights[p],
          [&](const unsigned int node, const double S, const auto &gradient) {
            sum[node] += points.volume[p] * S;
            sum_gradient[node] += points.volume[p] * gradient;
          });

      Errors errors;
      for (unsigned int i = 0; i < grid.n_nodes(); ++i)
        {
          const Point<dim> x        = grid.node_position(i);
          double           integral = 1.;
          Tensor<1, dim>   gradient;
          for (unsigned int d = 0; d < dim; ++d)
            gradient[d] = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            {
              const double a = lower[d] - x[d], b = a + n * spacing;
              const double along = hat_integral(b) - hat_integral(a);
              integral *= along;
              for (unsigned int e = 0; e < dim; ++e)
                gradient[e] *= e == d ? hat(b) - hat(a) : along;
            }
          errors.value =
            std::max(errors.value,
                     std::abs(sum[i] - integral) / std::pow(h, dim));
          errors.gradient = std::max(errors.gradient,
                                     (sum_gradient[i] - gradient).norm() /
                                       std::pow(h, dim - 1));
        }
      return errors;
    }


    template <int dim>
    void
    check_tiling()
    {
      const auto      grid = Lattice::grid<dim>(2., h);
      Lattice::Random random(dim);
      Errors          worst;
      // Points per cell and direction: 1 (half-size h / 2, the largest), 2, 3,
      // and a size that does not fit the cells at all.
      for (const double spacing : {h, h / 2., h / 3., 0.7 * h})
        for (unsigned int offset = 0; offset < 50; ++offset)
          {
            const Point<dim>   lower(random.vector<dim>(-0.2, 0.2));
            const unsigned int n = dim == 2 ? 6 : 5;
            const Errors       e =
              integrate(grid, lower, n, spacing, ShapeFunctions::gimp);
            EXPECT_LT(e.value, 1e-13) << lower << ' ' << spacing;
            EXPECT_LT(e.gradient, 1e-12) << lower << ' ' << spacing;
            worst.value    = std::max(worst.value, e.value);
            worst.gradient = std::max(worst.gradient, e.gradient);
          }
      Verification::row("weights_tiling",
                        "dimension,error of int N / h^d,"
                        "error of int grad N / h^(d-1)",
                        dim,
                        worst.value,
                        worst.gradient);
    }
  } // namespace


  TEST(Mapping, tiled_domains_integrate_exactly)
  {
    check_tiling<2>();
    check_tiling<3>();
  }


  TEST(Mapping, linear_functions_integrate_only_some_lattices)
  {
    // A lattice of two points per cell, aligned: a hat is linear over each of
    // its sub-cells, so that their centres integrate it exactly.
    const auto   grid = Lattice::grid<2>(2., h);
    const Errors aligned =
      integrate(grid, Point<2>(h, h), 6, h / 2., ShapeFunctions::linear);
    EXPECT_LT(aligned.value, 1e-14);
    EXPECT_LT(aligned.gradient, 1e-13);

    // One that has been stretched to 0.7 h: a node sees one point on one side
    // and two on the other. This is the error of cell crossing; GIMP has none.
    double largest = 0.;
    for (unsigned int k = 0; k <= 200; ++k)
      {
        const Point<2> lower(h + 0.005 * k * h, h);
        const Errors   linear =
          integrate(grid, lower, 6, 0.7 * h, ShapeFunctions::linear);
        const Errors gimp =
          integrate(grid, lower, 6, 0.7 * h, ShapeFunctions::gimp);
        EXPECT_LT(gimp.gradient, 1e-12);
        largest = std::max(largest, linear.gradient);
        Verification::row("weights_offsets",
                          "offset / h,linear int N,GIMP int N,"
                          "linear int grad N,GIMP int grad N",
                          0.005 * k,
                          linear.value,
                          gimp.value,
                          linear.gradient,
                          gimp.gradient);
      }
    EXPECT_GT(largest, 0.4);
  }
} // namespace mapping_tiling
