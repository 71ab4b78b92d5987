// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/grid/partition.h>
#include <waker/loads/facet_load.h>
#include <waker/surface/user_surface.h>

#include <gtest/gtest.h>
#include <random>

// Of one rank and, by tests/cases/ranks.py, of several.

namespace loads_of_ranks
{
  using namespace Waker;

  constexpr double h = 0.3; // no binary fraction

  template <int dim>
  BackgroundGrid<dim>
  make_grid()
  {
    Point<dim> upper;
    for (unsigned int d = 0; d < dim; ++d)
      upper[d] = h * (d == 0 ? 20 : 9);
    return {Point<dim>(), upper, h, MPI_COMM_WORLD};
  }


  /// None on the left, so that loads there find no support nearby; a single
  /// node far from all others.
  template <int dim>
  std::vector<double>
  make_mass(const BackgroundGrid<dim> &grid)
  {
    std::mt19937                           random(5);
    std::uniform_real_distribution<double> number(0., 1.);
    std::vector<double>                    mass(grid.n_nodes());
    for (unsigned int i = 0; i < grid.n_nodes(); ++i)
      {
        const double m = number(random);
        mass[i]        = grid.node_index(i)[0] > 11 ? m : 0.;
      }
    mass[grid.n_nodes() / 2 + 1] = 1.;
    return mass;
  }


  /// Anywhere in the box, some of them on the faces of the cells.
  template <int dim>
  Facets<dim>
  make_facets(const BackgroundGrid<dim> &grid)
  {
    std::mt19937                           random(7);
    std::uniform_real_distribution<double> number(0., 1.);
    Facets<dim>                            facets;
    for (unsigned int k = 0; k < 60; ++k)
      {
        std::array<Point<dim>, dim> x;
        for (Point<dim> &vertex : x)
          for (unsigned int d = 0; d < dim; ++d)
            vertex[d] = grid.upper_corner()[d] * number(random);
        const unsigned int d = k % dim;
        if (k % 3 == 0)
          for (Point<dim> &vertex : x)
            vertex[d] = h * (k % 9);
        facets.push_back(make_facet<dim>(x));
      }
    return facets;
  }


  /// The sum of what the ranks have found, at a rank's own nodes.
  template <int dim>
  void
  is_that_of_the_whole(const BackgroundGrid<dim> &grid,
                       const BackgroundGrid<dim> &window,
                       NodalVector               &found,
                       const NodalVector         &expected)
  {
    window.exchange().add_to_owners({{found.begin(), dim}});
    for (unsigned int i = 0; i < window.n_nodes(); ++i)
      if (window.exchange().owns(i))
        {
          auto index = window.node_index(i);
          for (unsigned int d = 0; d < dim; ++d)
            index[d] += window.offset()[d];
          for (unsigned int d = 0; d < dim; ++d)
            EXPECT_NEAR(found.local_element(dim * i + d),
                        expected.local_element(dim * grid.node(index) + d),
                        1e-12);
        }
  }


  template <int dim>
  void
  check_facets(const double minimum_mass)
  {
    const BackgroundGrid<dim> grid = make_grid<dim>();
    const Partition<dim>      partition(grid, MPI_COMM_WORLD);
    const auto window = partition.make_window({support_reach, support_reach});
    const std::vector<double> all_mass = make_mass(grid);
    std::vector<double>       mass(window->n_nodes());
    partition.restrict_to(*window, all_mass.data(), 1, mass.data());

    FacetLoad<dim> whole(grid), part(*window);
    for (const Facet<dim> &facet : make_facets(grid))
      for (FacetLoad<dim> *load : {&whole, &part})
        load->add_pressure(facet,
                           [](const Point<dim> &x) { return 1. + x[1]; });
    NodalVector expected(grid.n_dofs()), found(window->n_dofs());
    whole.distribute(all_mass, minimum_mass, expected);
    part.distribute(mass, minimum_mass, found);
    // No node has so much.
    EXPECT_EQ(expected.l2_norm() > 1., minimum_mass <= 1.);
    is_that_of_the_whole(grid, *window, found, expected);
  }


  TEST(Ranks, LoadsOnFacetsAreThoseOfTheWhole)
  {
    for (const double minimum_mass : {0., 0.5, 0.98, 2.})
      {
        check_facets<2>(minimum_mass);
        check_facets<3>(minimum_mass);
      }
  }


  TEST(Ranks, LoadsOnSectionsAreThoseOfTheWhole)
  {
    const BackgroundGrid<3> grid = make_grid<3>();
    const BackgroundGrid<2> plane(Point<2>(),
                                  Point<2>(20 * h, 9 * h),
                                  h,
                                  MPI_COMM_SELF);
    const Partition<3>      partition(grid, MPI_COMM_WORLD);
    const auto window = partition.make_window({support_reach, support_reach});
    const std::vector<double> all_mass = make_mass(grid);
    std::vector<double>       mass(window->n_nodes());
    partition.restrict_to(*window, all_mass.data(), 1, mass.data());

    FacetLoad<2> whole(grid), part(*window);
    for (const Facet<2> &segment : make_facets(plane))
      for (FacetLoad<2> *load : {&whole, &part})
        load->add_pressure(segment,
                           [](const Point<2> &x) { return 1. + x[1]; });
    const auto planes = [&](const BackgroundGrid<3> &of) {
      std::vector<FacetLoad<2>::Plane> list;
      for (unsigned int k = 0; k < of.n_nodes_per_direction()[2]; ++k)
        if (const int z = of.offset()[2] + static_cast<int>(k); z > 1)
          list.push_back({k, 1. - 0.02 * z, 0.5 + 0.1 * z});
      return list;
    };
    for (const double minimum_mass : {0., 0.5, 0.98})
      {
        NodalVector expected(grid.n_dofs()), found(window->n_dofs());
        whole.distribute(all_mass, minimum_mass, expected, planes(grid));
        part.distribute(mass, minimum_mass, found, planes(*window));
        EXPECT_GT(expected.l2_norm(), 1.);
        is_that_of_the_whole(grid, *window, found, expected);
      }
  }


  template <int dim>
  void
  check_vertices()
  {
    const BackgroundGrid<dim> grid = make_grid<dim>();
    const Partition<dim>      partition(grid, MPI_COMM_WORLD);
    const auto window = partition.make_window({carrying_reach, carrying_reach});
    const std::vector<double>              all_mass = make_mass(grid);
    NodalVector                            all_increment(grid.n_dofs());
    std::mt19937                           random(3);
    std::uniform_real_distribution<double> number(0., 1.);
    for (double &u : all_increment)
      u = 0.1 * h * number(random);
    std::vector<double> mass(window->n_nodes());
    NodalVector         increment(window->n_dofs());
    partition.restrict_to(*window, all_mass.data(), 1, mass.data());
    partition.restrict_to(*window,
                          all_increment.begin(),
                          dim,
                          increment.begin());
    // Some outside the box, some on its very corners.
    std::vector<Point<dim>> expected;
    for (unsigned int k = 0; k < 200; ++k)
      {
        Point<dim> x;
        for (unsigned int d = 0; d < dim; ++d)
          x[d] = grid.upper_corner()[d] * (1.4 * number(random) - 0.2);
        expected.push_back(k == 0 ? grid.upper_corner() : x);
      }
    std::vector<Point<dim>> found = expected, start = expected;
    carry_vertices(grid, all_mass, 0., all_increment, expected);
    carry_vertices(*window, mass, 0., increment, found);
    double longest = 0.;
    for (std::size_t k = 0; k < found.size(); ++k)
      {
        EXPECT_NEAR(found[k].distance(expected[k]), 0., 1e-14);
        longest = std::max(longest, expected[k].distance(start[k]));
      }
    EXPECT_GT(longest, 0.05 * h);
  }


  TEST(Ranks, VerticesAreCarriedAsOnOneRank)
  {
    check_vertices<2>();
    check_vertices<3>();
  }
} // namespace loads_of_ranks
