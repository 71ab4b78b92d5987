// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/nodes/wall_law.h>

#include "mapping_lattice.h"
#include <cmath>
#include <gtest/gtest.h>

namespace nodes_wall_law
{
  // The law of a spot of a frictional wall: Coulomb's, without tension.

  using namespace Waker;

  namespace
  {
    constexpr double k = 1000., mu = 0.4, a = 2.; // kPa/m, -, kPa


    template <int dim>
    WallLaw<dim>
    frictional()
    {
      return {WallType::frictional, k, mu, a};
    }


    /// Pressure and shear traction.
    template <int dim>
    std::pair<double, double>
    parts(const Tensor<1, dim> &t, const Tensor<1, dim> &n)
    {
      return {t * n, (t - (t * n) * n).norm()};
    }


    template <int dim>
    typename WallLaw<dim>::Start
    random_start(Lattice::Random &random)
    {
      typename WallLaw<dim>::Start start;
      start.normal = random.vector<dim>(-1., 1.);
      start.normal /= start.normal.norm();
      // On, or within, what the law allows; a third of them without contact.
      if (random(0., 1.) < 0.33)
        {
          start.gap = random(0., 0.01);
          return start;
        }
      start.gap            = 0.;
      const double   p     = random(0., 10.);
      Tensor<1, dim> along = random.vector<dim>(-1., 1.);
      along -= (along * start.normal) * start.normal;
      start.traction =
        p * start.normal + random(0., 1.) * (mu * p + a) * along / along.norm();
      return start;
    }
  } // namespace


  TEST(NodesWallLaw, ThreeRegimesInClosedForm)
  {
    const auto              law = frictional<2>();
    const Tensor<1, 2>      n({0., 1.});
    const WallLaw<2>::Start loaded{n, Tensor<1, 2>({1., 10.}), 0.};
    // It sticks: all components are springs.
    Tensor<1, 2> t = law.traction(loaded, Tensor<1, 2>({0.002, -0.003}));
    EXPECT_NEAR(t[0], 1. - 2., 1e-12);
    EXPECT_NEAR(t[1], 10. + 3., 1e-12);
    // It slides, against the motion, at friction and adhesion.
    t = law.traction(loaded, Tensor<1, 2>({0.1, -0.003}));
    EXPECT_NEAR(t[0], -(mu * 13. + a), 1e-12);
    EXPECT_NEAR(t[1], 13., 1e-12);
    // Lifted by more than its spring: nothing, nor shear from adhesion.
    t = law.traction(loaded, Tensor<1, 2>({0.1, 0.0101}));
    EXPECT_EQ(t.norm(), 0.);
    // A gap of 4 mm is closed first.
    const WallLaw<2>::Start open{n, Tensor<1, 2>(), 0.004};
    EXPECT_EQ(law.traction(open, Tensor<1, 2>({0.1, -0.0039})).norm(), 0.);
    t = law.traction(open, Tensor<1, 2>({0., -0.009}));
    EXPECT_NEAR(t[1], 5., 1e-12);
    // Without friction and adhesion the shear is none.
    WallLaw<2> slick = law;
    slick.friction = slick.adhesion = 0.;
    EXPECT_NEAR(slick.traction(loaded, Tensor<1, 2>({0.1, 0.}))[0], 0., 1e-12);
  }


  template <int dim>
  void
  check_derivative()
  {
    const auto      law = frictional<dim>();
    Lattice::Random random(dim);
    unsigned int    n_open = 0, n_stuck = 0, n_sliding = 0;
    for (unsigned int n = 0; n < 400; ++n)
      {
        const auto           start = random_start<dim>(random);
        const Tensor<1, dim> w     = random.vector<dim>(-0.02, 0.02);
        const Tensor<1, dim> t     = law.traction(start, w);
        const auto [p, s]          = parts(t, start.normal);
        EXPECT_GE(p, -1e-12);
        EXPECT_LE(s, p > 0. ? (mu * p + a) * (1. + 1e-12) : 0.);
        ++(p == 0. ? n_open : law.slides(start, w) ? n_sliding : n_stuck);

        const Tensor<2, dim> K   = law.derivative(start, w);
        constexpr double     eps = 1e-7;
        for (unsigned int d = 0; d < dim; ++d)
          {
            Tensor<1, dim> e;
            e[d] = eps;
            const Tensor<1, dim> slope =
              (law.traction(start, w + e) - law.traction(start, w - e)) /
              (2. * eps);
            for (unsigned int c = 0; c < dim; ++c)
              EXPECT_NEAR(K[c][d], -slope[c], 1e-4 * k); // of 1e-5 or so
          }
        EXPECT_EQ((K - transpose(K)).norm() > 1e-12 * k, law.slides(start, w));
        EXPECT_GE(law.dissipation(start, w), 0.);
      }
    EXPECT_GT(n_open, 50u);
    EXPECT_GT(n_stuck, 20u);
    EXPECT_GT(n_sliding, 50u);
  }


  TEST(NodesWallLaw, TheDerivativeIsThatOfTheTraction)
  {
    check_derivative<2>();
    check_derivative<3>();
  }


  // The work on a straight way under constant pressure, in many steps, is
  // stored in springs or lost.
  TEST(NodesWallLaw, WorkIsStoredOrLost)
  {
    const auto      law = frictional<2>();
    Lattice::Random random(7);
    unsigned int    n_sliding = 0;
    for (unsigned int n = 0; n < 100; ++n)
      {
        const auto start = random_start<2>(random);
        if (start.traction.norm() == 0.)
          continue;
        Tensor<1, 2> w = random.vector<2>(-0.05, 0.05);
        w -= (w * start.normal) * start.normal;
        constexpr unsigned int n_steps = 1000;
        auto                   now     = start;
        double                 work    = 0.;
        for (unsigned int i = 0; i < n_steps; ++i)
          {
            const Tensor<1, 2> next = law.traction(now, w / n_steps);
            work -= 0.5 * (now.traction + next) * w / n_steps;
            now.traction = next;
          }
        const Tensor<1, 2> end = law.traction(start, w);
        EXPECT_NEAR((now.traction - end).norm(), 0., 1e-9);
        const double stored =
          0.5 * (end.norm_square() - start.traction.norm_square()) / k;
        EXPECT_NEAR(work, stored + law.dissipation(start, w), 1e-5);
        n_sliding += law.slides(start, w);
      }
    EXPECT_GT(n_sliding, 20u);
  }


  // In many steps there and back: friction remembers, whatever the steps.
  TEST(NodesWallLaw, SlidingForthAndBack)
  {
    const auto         law = frictional<2>();
    const Tensor<1, 2> n({0., 1.});
    for (const unsigned int n_steps : {10u, 100u})
      {
        WallLaw<2>::Start start{n, Tensor<1, 2>({0., 10.}), 0.};
        double            lost = 0.;
        for (const double direction : {1., -1.})
          for (unsigned int i = 0; i < n_steps; ++i)
            {
              const Tensor<1, 2> w({direction * 0.1 / n_steps, 0.});
              lost += law.dissipation(start, w);
              start.traction = law.traction(start, w);
            }
        // Limit 6 kPa: 6 mm of spring there, 12 mm back.
        EXPECT_NEAR(start.traction[0], 6., 1e-12);
        EXPECT_NEAR(lost, 6. * (0.094 + 0.088), 1e-12);
      }
  }
} // namespace nodes_wall_law
