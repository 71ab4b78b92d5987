// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/loads/facet_load.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace loads_facet_load
{
  using namespace Waker;

  namespace
  {
    template <int dim>
    struct Resultant
    {
      Tensor<1, dim> force;
      Tensor<1, 3>   moment; // about the origin
    };


    template <int dim>
    Tensor<1, 3>
    in_space(const Tensor<1, dim> &a)
    {
      Tensor<1, 3> b;
      for (unsigned int d = 0; d < dim; ++d)
        b[d] = a[d];
      return b;
    }


    template <int dim>
    Resultant<dim>
    nodal_resultant(const BackgroundGrid<dim> &grid, const double *forces)
    {
      Resultant<dim> sum;
      for (unsigned int i = 0; i < grid.n_nodes(); ++i)
        {
          Tensor<1, dim> f;
          for (unsigned int d = 0; d < dim; ++d)
            f[d] = forces[dim * i + d];
          sum.force += f;
          sum.moment +=
            cross_product_3d(in_space<dim>(grid.node_position(i)), in_space(f));
        }
      return sum;
    }


    template <int dim>
    BackgroundGrid<dim>
    make_grid(const double h)
    {
      Point<dim> lower, upper;
      for (unsigned int d = 0; d < dim; ++d)
        {
          lower[d] = -h;
          upper[d] = (4. + d) * h;
        }
      return BackgroundGrid<dim>(lower, upper, h, MPI_COMM_SELF);
    }


    // Anywhere in grid and margin.
    template <int dim>
    Facet<dim>
    random_facet(const BackgroundGrid<dim> &grid, std::mt19937 &random)
    {
      std::array<Point<dim>, dim> vertices;
      for (Point<dim> &x : vertices)
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double n = grid.n_nodes_per_direction()[d] - 1;
            x[d]           = grid.origin()[d] +
                   grid.cell_size() *
                     std::uniform_real_distribution<double>(0., n)(random);
          }
      return make_facet<dim>(vertices);
    }


    template <int dim>
    Tensor<1, dim>
    linear_traction(const Point<dim> &x)
    {
      Tensor<1, dim> q;
      for (unsigned int d = 0; d < dim; ++d)
        {
          q[d] = 1. + d;
          for (unsigned int e = 0; e < dim; ++e)
            q[d] += (0.3 * d - 0.7 * e + 0.2) * x[e];
        }
      return q;
    }


    // A facet in n^(dim - 1) equal parts.
    Facets<2>
    subdivide(const Facet<2> &facet, const int n)
    {
      Facets<2>          parts;
      const Tensor<1, 2> along = facet.vertices[1] - facet.vertices[0];
      for (int k = 0; k < n; ++k)
        parts.push_back(
          make_facet<2>({{facet.vertices[0] + double(k) / n * along,
                          facet.vertices[0] + double(k + 1) / n * along}}));
      return parts;
    }


    Facets<3>
    subdivide(const Facet<3> &facet, const int n)
    {
      Facets<3>          parts;
      const Tensor<1, 3> a = (facet.vertices[1] - facet.vertices[0]) / n;
      const Tensor<1, 3> b = (facet.vertices[2] - facet.vertices[0]) / n;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n - i; ++j)
          {
            const Point<3> x =
              facet.vertices[0] + double(i) * a + double(j) * b;
            parts.push_back(make_facet<3>({{x, x + a, x + b}}));
            if (j + 1 < n - i)
              parts.push_back(make_facet<3>({{x + a, x + a + b, x + b}}));
          }
      return parts;
    }


    // Integral of a linear traction and of its moment.
    Resultant<2>
    exact_resultant(const Facet<2> &facet)
    {
      Resultant<2> sum;
      const auto  &v = facet.vertices;
      // Simpson's rule.
      for (const auto &[x, w] :
           {std::pair<Point<2>, double>(v[0], 1. / 6),
            std::pair<Point<2>, double>(v[0] + 0.5 * (v[1] - v[0]), 4. / 6),
            std::pair<Point<2>, double>(v[1], 1. / 6)})
        {
          const Tensor<1, 2> f = w * facet.measure() * linear_traction(x);
          sum.force += f;
          sum.moment += cross_product_3d(in_space<2>(x), in_space(f));
        }
      return sum;
    }


    Resultant<3>
    exact_resultant(const Facet<3> &facet)
    {
      Resultant<3> sum;
      // The mid-points of the sides.
      for (unsigned int k = 0; k < 3; ++k)
        {
          const Point<3>    &a = facet.vertices[k];
          const Point<3>     x = a + 0.5 * (facet.vertices[(k + 1) % 3] - a);
          const Tensor<1, 3> f = facet.measure() / 3. * linear_traction(x);
          sum.force += f;
          sum.moment += cross_product_3d(in_space<3>(x), in_space(f));
        }
      return sum;
    }


    template <int dim>
    void
    check_random_facets()
    {
      const BackgroundGrid<dim> grid = make_grid<dim>(0.5);
      FacetLoad<dim>            load(grid);
      std::mt19937              random(7);
      for (int k = 0; k < 1000; ++k)
        {
          const Facet<dim> facet = random_facet(grid, random);
          load.clear();
          load.add(facet, [](const Facet<dim> &, const Point<dim> &x) {
            return linear_traction(x);
          });
          const Resultant<dim> exact = exact_resultant(facet);
          const auto seen = nodal_resultant(grid, load.nodal_forces().data());
          ASSERT_LT((seen.force - exact.force).norm(), 1e-11);
          ASSERT_LT((seen.moment - exact.moment).norm(), 1e-11);
        }
    }


    // Node by node, against many small parts whose force acts at their centres.
    template <int dim>
    void
    check_fine_quadrature(const int n)
    {
      const BackgroundGrid<dim> grid = make_grid<dim>(0.5);
      FacetLoad<dim>            load(grid), fine(grid);
      std::mt19937              random(3);
      for (int k = 0; k < 20; ++k)
        {
          const Facet<dim> facet = random_facet(grid, random);
          load.clear();
          load.add(facet, [](const Facet<dim> &, const Point<dim> &x) {
            return linear_traction(x);
          });
          fine.clear();
          for (const Facet<dim> &part : subdivide(facet, n))
            {
              Point<dim> centre;
              for (const Point<dim> &x : part.vertices)
                centre += x / double(dim);
              fine.add(centre, part.measure() * linear_traction(centre));
            }
          for (unsigned int i = 0; i < load.nodal_forces().size(); ++i)
            ASSERT_NEAR(load.nodal_forces()[i], fine.nodal_forces()[i], 1e-3);
        }
    }


    // Facets in the faces and edges of the lattice, and a hair beside them, are
    // counted once, and on the nodes of that face only.
    template <int dim>
    void
    check_lattice_faces()
    {
      const double              h    = 0.3; // no binary fraction
      const BackgroundGrid<dim> grid = make_grid<dim>(h);
      FacetLoad<dim>            load(grid);
      for (const double shift : {0., 1e-15, -1e-15, 1e-10, -1e-10})
        for (unsigned int normal = 0; normal < dim; ++normal)
          for (unsigned int plane = 0;
               plane < grid.n_nodes_per_direction()[normal];
               ++plane)
            {
              // From cell 1 to 3 along the other directions.
              std::array<Point<dim>, dim> vertices;
              for (unsigned int k = 0; k < dim; ++k)
                for (unsigned int d = 0; d < dim; ++d)
                  {
                    const unsigned int along = (normal + k) % dim;
                    const double       cells =
                      d == normal ? plane : (k > 0 && d == along ? 3. : 1.);
                    vertices[k][d] = grid.origin()[d] + h * cells;
                  }
              // One vertex off the plane: round-off.
              vertices[0][normal] += shift;
              const Facet<dim> facet = make_facet<dim>(vertices);
              load.clear();
              load.add_pressure(facet, [](const Point<dim> &) { return 1.; });

              double sum = 0., on_plane = 0.;
              for (unsigned int i = 0; i < grid.n_nodes(); ++i)
                {
                  const double f = load.nodal_forces()[dim * i + normal];
                  sum += f;
                  if (grid.node_index(i)[normal] == int(plane))
                    on_plane += f;
                }
              const double size =
                -facet.normal[normal] * std::pow(2 * h, dim - 1.) / (dim - 1);
              ASSERT_NEAR(sum, size, 1e-14);
              ASSERT_NEAR(on_plane, size, 1e-14 + 2 * std::abs(shift));
            }
    }


    // Nodes without mass carry nothing; resultant and moment are kept.
    template <int dim>
    void
    check_distribution()
    {
      const BackgroundGrid<dim> grid = make_grid<dim>(0.5);
      FacetLoad<dim>            load(grid);
      std::mt19937              random(11);
      NodalVector               force(grid.n_dofs());
      for (int k = 0; k < 200; ++k)
        {
          // Mass below an inclined plane.
          Tensor<1, dim> slope;
          for (unsigned int d = 0; d < dim; ++d)
            slope[d] = std::uniform_real_distribution<double>(-1., 1.)(random);
          std::vector<double> mass(grid.n_nodes());
          for (unsigned int i = 0; i < grid.n_nodes(); ++i)
            mass[i] = slope * (grid.node_position(i) - Point<dim>()) < 0.3;

          const Facet<dim> facet = random_facet(grid, random);
          load.clear();
          load.add(facet, [](const Facet<dim> &, const Point<dim> &x) {
            return linear_traction(x);
          });
          force = 0.;
          load.distribute(mass, 0.5, force);
          for (unsigned int i = 0; i < grid.n_nodes(); ++i)
            for (unsigned int d = 0; d < dim && mass[i] < 0.5; ++d)
              ASSERT_EQ(force.begin()[dim * i + d], 0.);

          const Resultant<dim> exact = exact_resultant(facet);
          const auto           seen  = nodal_resultant(grid, force.begin());
          ASSERT_LT((seen.force - exact.force).norm(), 1e-10);
          ASSERT_LT((seen.moment - exact.moment).norm(), 1e-10);

          // Without a minimum every node keeps its own.
          force = 0.;
          load.distribute(mass, 0., force);
          for (unsigned int i = 0; i < grid.n_dofs(); ++i)
            ASSERT_EQ(force.begin()[i], load.nodal_forces()[i]);
        }
    }
  } // namespace



  TEST(Loads, facet_load_keeps_resultant_and_moment)
  {
    check_random_facets<2>();
    check_random_facets<3>();
  }



  TEST(Loads, facet_load_equals_fine_quadrature)
  {
    check_fine_quadrature<2>(1000);
    check_fine_quadrature<3>(200);
  }



  TEST(Loads, facet_load_on_faces_of_cells_is_counted_once)
  {
    check_lattice_faces<2>();
    check_lattice_faces<3>();
  }



  TEST(Loads, facet_load_leaves_nodes_without_mass)
  {
    check_distribution<2>();
    check_distribution<3>();
  }



  TEST(Loads, point_force_on_nodes)
  {
    const BackgroundGrid<3> grid = make_grid<3>(0.5);
    FacetLoad<3>            load(grid);
    Tensor<1, 3>            f;
    f[0] = 1.;
    f[2] = -2.;
    const Point<3> x(0.1, 0.7, 0.5);
    load.add(x, f);
    const auto seen = nodal_resultant(grid, load.nodal_forces().data());
    EXPECT_LT((seen.force - f).norm(), 1e-14);
    EXPECT_LT((seen.moment - cross_product_3d(Tensor<1, 3>(x), f)).norm(),
              1e-14);
    EXPECT_EQ(load.nodes().size(), 8u);
    load.clear();
    EXPECT_TRUE(load.nodes().empty());
    EXPECT_EQ(*std::max_element(load.nodal_forces().begin(),
                                load.nodal_forces().end()),
              0.);
  }
} // namespace loads_facet_load
