// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/fields/ellipsoidal_moments.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <vector>

namespace Waker
{
  namespace
  {
    /// Points and weights on [0, 1].
    struct Rule
    {
      std::vector<double> point, weight;
    };


    template <unsigned int n>
    Rule
    gauss()
    {
      // Boost gives the points x >= 0 of [-1, 1].
      const auto &x = boost::math::quadrature::gauss<double, n>::abscissa();
      const auto &w = boost::math::quadrature::gauss<double, n>::weights();
      Rule        rule;
      for (std::size_t i = 0; i < x.size(); ++i)
        for (const double sign : {-1., 1.})
          if (sign > 0. || x[i] > 0.)
            {
              rule.point.push_back(0.5 + 0.5 * sign * x[i]);
              rule.weight.push_back(0.5 * w[i]);
            }
      return rule;
    }
  } // namespace


  EllipsoidalMoments::EllipsoidalMoments(const unsigned int           dim,
                                         const std::array<double, 3> &a)
    : dim(dim)
    , a(a)
  {}


  std::array<double, 8>
  EllipsoidalMoments::operator()(const std::array<int, 3> &box) const
  {
    std::array<double, 8> moments{};
    add({{0., 0., 0.}}, {{1., 1., 1.}}, box, moments);
    return moments;
  }


  void
  EllipsoidalMoments::add(const std::array<double, 3> &low,
                          const std::array<double, 3> &length,
                          const std::array<int, 3>    &box,
                          std::array<double, 8>       &moments) const
  {
    double       distance = 0., size = 0., volume = 1.;
    unsigned int longest = 0;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double x = a[d] * (box[d] + low[d]);
        distance += x * x;
        if (a[d] * length[d] > size)
          {
            size    = a[d] * length[d];
            longest = d;
          }
        volume *= length[d];
      }
    distance = std::sqrt(distance);
    if (distance > 50.) // exp(-50) = 2e-22
      return;

    // The correlation has a kink at the origin: halve boxes that are
    // larger than their distance from it, or that are long compared with
    // the scale of fluctuation. A box at the origin ends as a tiny one.
    if ((size > distance || size > 4.) && !(volume * size < 1e-11))
      {
        std::array<double, 3> half = length, middle = low;
        half[longest] *= 0.5;
        middle[longest] += half[longest];
        add(low, half, box, moments);
        add(middle, half, box, moments);
        return;
      }

    // Error below 1e-10: see the convergence of Gauss's rule in a Bernstein
    // ellipse through the singularity at `distance`.
    static const Rule rule3 = gauss<3>(), rule4 = gauss<4>(),
                      rule6 = gauss<6>(), rule8 = gauss<8>();
    const Rule &rule = size < 0.1 && 32. * size < distance  ? rule3
                       : size < 0.8 && 8. * size < distance ? rule4
                       : size < 2. && 2. * size < distance  ? rule6
                                                            : rule8;

    const unsigned int                   n = rule.point.size();
    std::array<std::array<double, 8>, 3> square{}, w0{}, w1{};
    for (unsigned int d = 0; d < 3; ++d)
      for (unsigned int i = 0; i < n; ++i)
        {
          const double t = low[d] + length[d] * rule.point[i];
          const double x = d < dim ? a[d] * (box[d] + t) : 0.;
          square[d][i]   = x * x;
          w0[d][i]       = length[d] * rule.weight[i] * (1. - t);
          w1[d][i]       = length[d] * rule.weight[i] * t;
        }
    for (unsigned int k = 0; k < (dim > 2 ? n : 1); ++k)
      {
        std::array<double, 4> plane{};
        for (unsigned int j = 0; j < (dim > 1 ? n : 1); ++j)
          {
            double sum0 = 0., sum1 = 0.;
            for (unsigned int i = 0; i < n; ++i)
              {
                const double rho = std::exp(
                  -std::sqrt(square[0][i] + square[1][j] + square[2][k]));
                sum0 += w0[0][i] * rho;
                sum1 += w1[0][i] * rho;
              }
            const double u0 = dim > 1 ? w0[1][j] : 1.;
            const double u1 = dim > 1 ? w1[1][j] : 0.;
            plane[0] += u0 * sum0;
            plane[1] += u0 * sum1;
            plane[2] += u1 * sum0;
            plane[3] += u1 * sum1;
          }
        const double v0 = dim > 2 ? w0[2][k] : 1.;
        const double v1 = dim > 2 ? w1[2][k] : 0.;
        for (unsigned int m = 0; m < 4; ++m)
          {
            moments[m] += v0 * plane[m];
            moments[4 + m] += v1 * plane[m];
          }
      }
  }
} // namespace Waker
