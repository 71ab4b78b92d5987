// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/loads/facet_clip.h>
#include <waker/loads/facet_load.h>
#include <waker/loads/traction.h>

#include "named.h"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace loads_traction
{
  using namespace Waker;

  namespace
  {
    template <int dim>
    double
    measure(const Facets<dim> &facets)
    {
      double sum = 0.;
      for (const Facet<dim> &facet : facets)
        sum += facet.measure();
      return sum;
    }


    template <int dim>
    Facet<dim>
    random_facet(std::mt19937 &random)
    {
      std::uniform_real_distribution<double> uniform(-1., 1.);
      std::array<Point<dim>, dim>            x;
      for (Point<dim> &v : x)
        for (unsigned int d = 0; d < dim; ++d)
          v[d] = uniform(random);
      return make_facet<dim>(x);
    }


    /// Cutting loses and moves nothing: measure, first moment, sides, normals.
    template <int dim>
    void
    test_cut()
    {
      std::mt19937                           random(4);
      std::uniform_real_distribution<double> uniform(-0.5, 0.5);
      unsigned int                           n_cut = 0;
      for (unsigned int k = 0; k < 2000; ++k)
        {
          const Facet<dim> facet = random_facet<dim>(random);
          Tensor<1, dim>   n;
          for (unsigned int d = 0; d < dim; ++d)
            n[d] = uniform(random);
          double c = 0.3 * uniform(random);
          if (k % 4 == 0)
            c = n * facet.vertices[k % dim]; // through a vertex
          Facets<dim> below, above;
          cut_facet(facet, n, c, below, above);
          n_cut += !below.empty() && !above.empty();

          Tensor<1, dim> moment;
          for (const Facets<dim> *side : {&below, &above})
            for (const Facet<dim> &piece : *side)
              {
                const double   sign = side == &below ? 1. : -1.;
                Tensor<1, dim> centre;
                for (const Point<dim> &x : piece.vertices)
                  {
                    ASSERT_LE(sign * (n * x - c), 1e-14);
                    centre += x / dim;
                  }
                moment += piece.measure() * centre;
                if (piece.measure() <= 1e-9)
                  continue;
                ASSERT_LT((make_facet<dim>(piece.vertices).normal -
                           facet.normal)
                            .norm(),
                          1e-5);
              }
          ASSERT_NEAR(measure(below) + measure(above), facet.measure(), 1e-14);
          Tensor<1, dim> whole;
          for (const Point<dim> &x : facet.vertices)
            whole += facet.measure() / dim * x;
          ASSERT_LT((moment - whole).norm(), 1e-14);

          Facets<dim> kept = {facet}, work;
          keep_below(n, c, 0., kept, work);
          ASSERT_NEAR(measure(kept), measure(below), 1e-14);
        }
      EXPECT_GT(n_cut, 300u);
    }


    TractionParameters
    traction(const std::string &kind, const std::string &value)
    {
      TractionParameters parameters;
      parameters.name  = "load";
      parameters.kind  = Named{kind};
      parameters.value = value;
      return parameters;
    }


    /// An anticlockwise rectangle, its bottom on a closed face.
    Facets<2>
    rectangle(const double x0,
              const double y0,
              const double x1,
              const double y1)
    {
      const Point<2> x[4] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
      Facets<2>      facets;
      for (unsigned int k = 0; k < 4; ++k)
        facets.push_back(
          make_facet<2>({{x[k], x[(k + 1) % 4]}}, k == 0 ? 2 : -1));
      return facets;
    }


    Tensor<1, 2>
    resultant(const Traction<2> &t, const Facets<2> &facets)
    {
      const BackgroundGrid<2> grid(Point<2>(0, 0),
                                   Point<2>(8, 8),
                                   1.,
                                   MPI_COMM_SELF);
      FacetLoad<2>            load(grid);
      for (const Facet<2> &facet : facets)
        load.add(facet, [&](const Facet<2> &f, const Point<2> &x) {
          return t.value(f.normal, x);
        });
      Tensor<1, 2> sum;
      for (unsigned int i = 0; i < grid.n_nodes(); ++i)
        for (unsigned int d = 0; d < 2; ++d)
          sum[d] += load.nodal_forces()[2 * i + d];
      return sum;
    }
  } // namespace


  TEST(Loads, facets_are_cut_exactly)
  {
    test_cut<2>();
    test_cut<3>();
  }


  TEST(Loads, traction_of_each_kind)
  {
    const Facets<2> body = rectangle(1, 0, 4, 2);
    Facets<2>       part;

    // The bottom lies on a closed face: pressure has a resultant, downwards.
    Traction<2> pressure(traction("pressure", "3 + t"), 1e-9);
    EXPECT_TRUE(pressure.moves());
    pressure.set_time(2.);
    pressure.select(body, part);
    EXPECT_EQ(part.size(), 3u);
    Tensor<1, 2> f = resultant(pressure, part);
    EXPECT_NEAR(f[0], 0., 1e-13);
    EXPECT_NEAR(f[1], -15., 1e-13);

    Traction<2> vector(traction("vector", "2; -1"), 1e-9);
    EXPECT_FALSE(vector.moves());
    f = resultant(vector, part);
    EXPECT_NEAR(f[0], 14., 1e-12);
    EXPECT_NEAR(f[1], -7., 1e-12);

    // One that depends on the place: the integral of y over the two sides.
    Traction<2> shear(traction("vector", "y; x*t"), 1e-9);
    shear.set_time(1.);
    f = resultant(shear, part);
    EXPECT_NEAR(f[0], 2. + 2. + 3. * 2., 1e-12);
    EXPECT_NEAR(f[1], 2. * 1. + 2. * 4. + 7.5, 1e-12);

    // Water up to y = 1.5 on both sides, later over the top.
    TractionParameters water = traction("hydrostatic", "");
    water.level              = "0: 1.5, 10: 2.5";
    water.unit_weight        = 10.;
    water.to                 = {3.5, 9.};
    water.from               = {0., 0.};
    Traction<2> hydrostatic(water, 1e-9);
    EXPECT_TRUE(hydrostatic.moves());
    hydrostatic.select(body, part);
    EXPECT_NEAR(measure(part), 2. + 2.5, 1e-12);
    Facets<2> wet = part;
    hydrostatic.set_time(0.);
    hydrostatic.keep_loaded(wet);
    EXPECT_NEAR(measure(wet), 1.5, 1e-12);
    f = resultant(hydrostatic, wet);
    EXPECT_NEAR(f[0], 0.5 * 10. * 1.5 * 1.5, 1e-12);
    EXPECT_NEAR(f[1], 0., 1e-12);
    hydrostatic.set_time(10.);
    wet = part;
    hydrostatic.keep_loaded(wet);
    f = resultant(hydrostatic, wet);
    EXPECT_NEAR(f[0], 0.5 * 10. * (2.5 * 2.5 - 0.5 * 0.5), 1e-12);
    EXPECT_NEAR(f[1], -10. * 0.5 * 2.5, 1e-12);
  }


  TEST(Loads, traction_on_a_part_of_the_surface)
  {
    const Facets<2>    body = rectangle(1, 0, 4, 2);
    Facets<2>          part;
    TractionParameters p = traction("pressure", "1");
    p.from               = {0.5, 0.25};
    p.to                 = {2.25, 1.5};
    Traction<2>(p, 1e-9).select(body, part);
    ASSERT_EQ(part.size(), 1u);
    EXPECT_NEAR(measure(part), 1.25, 1e-14);
    EXPECT_EQ(part[0].normal[0], -1.);

    // The box's own edge counts, also with round-off in the surface.
    p.from = {1., 0.};
    p.to   = {1., 2.};
    Traction<2>(p, 1e-9).select(rectangle(1. - 1e-12, 0, 4, 2), part);
    EXPECT_NEAR(measure(part), 2., 1e-8);

    p.from.clear();
    p.to.clear();
    p.facing  = {1., 1.};
    p.opening = 45.;
    Traction<2>(p, 1e-9).select(body, part);
    EXPECT_NEAR(measure(part), 2. + 3., 1e-14);
    p.opening = 44.;
    Traction<2>(p, 1e-9).select(body, part);
    EXPECT_TRUE(part.empty());
  }


  TEST(Loads, traction_parameters_are_checked)
  {
    const auto complaint = [](const TractionParameters &p,
                              const unsigned int        dim = 2,
                              const ShapeFunctions      functions =
                                ShapeFunctions::gimp) {
      try
        {
          p.check(dim, functions);
        }
      catch (const UserError &error)
        {
          return error.where;
        }
      return std::string();
    };
    const TractionParameters good = traction("pressure", "1");
    EXPECT_EQ(complaint(good), "");

    TractionParameters p = good;
    p.method             = TractionMethod::volume;
    EXPECT_EQ(complaint(p), "Tractions/load/Method");
    EXPECT_EQ(complaint(p, 2, ShapeFunctions::linear), "");

    p        = good;
    p.method = TractionMethod::user_surface;
    EXPECT_EQ(complaint(p), "Tractions/load/Surface file");
    p              = good;
    p.surface_file = "a.txt";
    EXPECT_EQ(complaint(p), "Tractions/load/Surface file");

    p       = good;
    p.value = "1; 2";
    EXPECT_EQ(complaint(p), "Tractions/load/Value");
    p.kind = TractionKind::vector;
    EXPECT_EQ(complaint(p), "");
    EXPECT_EQ(complaint(p, 3), "Tractions/load/Value");
    p.value = "1; ";
    EXPECT_EQ(complaint(p), "Tractions/load/Value");
    p.value = "1; 2*w";
    EXPECT_EQ(complaint(p), "Tractions/load/Value");

    p      = good;
    p.kind = TractionKind::hydrostatic;
    EXPECT_EQ(complaint(p), "Tractions/load/Level");
    p.level = "0: 1, 1";
    EXPECT_EQ(complaint(p), "Tractions/load/Level");
    p.level = "1";
    EXPECT_EQ(complaint(p), "");

    p      = good;
    p.from = {1., 2.};
    EXPECT_EQ(complaint(p), "Tractions/load/To");
    p.to = {2., 1.};
    EXPECT_EQ(complaint(p), "Tractions/load/To");
    p.to = {2., 3.};
    EXPECT_EQ(complaint(p), "");
    EXPECT_EQ(complaint(p, 3), "Tractions/load/From");

    p        = good;
    p.facing = {0., 0.};
    EXPECT_EQ(complaint(p), "Tractions/load/Facing");
    p.facing = {0., 1., 0.};
    EXPECT_EQ(complaint(p), "Tractions/load/Facing");
  }
} // namespace loads_traction
