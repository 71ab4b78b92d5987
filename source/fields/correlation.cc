// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/base/errors.h>
#include <waker/fields/correlation.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

namespace Waker
{
  using namespace dealii;

  namespace
  {
    const double pi = boost::math::constants::pi<double>();

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


    /// Averages over two cells of a field along a line, correlation
    /// exp(-|x|), cells of length a, k cells apart.
    double
    exponential_line(const double a, const int k)
    {
      if (k == 0)
        return a < 1e-2
                 ? 1. - a / 3. * (1. - a / 4. * (1. - a / 5. * (1. - a / 6.)))
                 : 2. / (a * a) * (a + std::expm1(-a));
      const double f = -std::expm1(-a) / a;
      return f * f * std::exp(-(std::abs(k) - 1) * a);
    }


    /// The same for exp(-x^2) and cells of length b.
    double
    gaussian_line(const double b, const int k)
    {
      if (b < 4.)
        {
          // The closed form subtracts nearly equal numbers here.
          static const Rule rule = gauss<20>();
          double            sum  = 0.;
          for (unsigned int i = 0; i < rule.point.size(); ++i)
            {
              const double s = rule.point[i];
              sum += rule.weight[i] * (1. - s) *
                     (std::exp(-b * b * (k + s) * (k + s)) +
                      std::exp(-b * b * (k - s) * (k - s)));
            }
          return sum;
        }
      // Second difference of the second antiderivative, whose linear part
      // only counts in k = 0.
      const double root_pi = std::sqrt(pi);
      const auto   rest    = [&](const int i) {
        const double x = b * std::abs(i);
        return (std::exp(-x * x) - x * root_pi * std::erfc(x)) / (2. * b * b);
      };
      return (k == 0 ? root_pi / b : 0.) + rest(k + 1) - 2. * rest(k) +
             rest(k - 1);
    }


    /**
     * The eight (2^dim) integrals over a unit box of lags, first corner j, of
     *   prod w_d(t_d) exp(-|a (j + t)|), w = 1 - t (bit d of m is 0) or t (1),
     * for the ellipsoidal Markov correlation; a = 2 cell size / theta. The
     * covariance of two cells is a sum over the 2^dim boxes that meet at
     * their lag.
     */
    class EllipsoidalMoments
    {
    public:
      EllipsoidalMoments(const unsigned int dim, const std::array<double, 3> &a)
        : dim(dim)
        , a(a)
      {}

      std::array<double, 8>
      operator()(const std::array<int, 3> &box) const
      {
        std::array<double, 8> moments{};
        add({{0., 0., 0.}}, {{1., 1., 1.}}, box, moments);
        return moments;
      }

    private:
      unsigned int          dim;
      std::array<double, 3> a;

      /// Adds the integrals over the part [low, low + length] of the unit box.
      void
      add(const std::array<double, 3> &low,
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
    };
  } // namespace


  Correlation::Correlation(const Function             function,
                           const std::vector<double> &scales)
    : kind(function)
    , theta(scales)
  {
    Assert(theta.size() >= 1 && theta.size() <= 3, ExcMessage("1 to 3 scales"));
    for (const double scale : theta)
      {
        (void)scale;
        Assert(scale > 0., ExcMessage("Scales of fluctuation are above 0."));
      }
  }


  Correlation::Function
  Correlation::function(const std::string &name)
  {
    if (name == "Markov")
      return Function::markov;
    if (name == "separable Markov")
      return Function::separable_markov;
    if (name == "Gaussian")
      return Function::gaussian;
    throw UserError("Correlation",
                    "is '" + name + "'",
                    "Markov, separable Markov or Gaussian");
  }


  double
  Correlation::between_points(const std::array<double, 3> &lag) const
  {
    double sum = 0., squares = 0.;
    for (unsigned int d = 0; d < theta.size(); ++d)
      {
        const double x = lag[d] / theta[d];
        sum += std::fabs(x);
        squares += x * x;
      }
    switch (kind)
      {
        case Function::markov:
          return std::exp(-2. * std::sqrt(squares));
        case Function::separable_markov:
          return std::exp(-2. * sum);
        default:
          return std::exp(-pi * squares);
      }
  }


  double
  Correlation::between_cells(const std::array<double, 3> &cell_size,
                             const std::array<int, 3>    &lag) const
  {
    const unsigned int dim = theta.size();
    if (kind == Function::markov && dim > 1)
      {
        std::array<double, 3> a{{0., 0., 0.}};
        for (unsigned int d = 0; d < dim; ++d)
          a[d] = 2. * cell_size[d] / theta[d];
        const EllipsoidalMoments moments(dim, a);

        // Lag k: the boxes [k - 1, k] with weight t, [k, k + 1] with 1 - t; for
        // k = 0 the first is the mirror image of the second.
        double sum = 0.;
        for (unsigned int m = 0; m < (1u << dim); ++m)
          {
            std::array<int, 3> box{{0, 0, 0}};
            unsigned int       weights = 0;
            for (unsigned int d = 0; d < dim; ++d)
              {
                box[d] = std::abs(lag[d]);
                if ((m >> d & 1u) && box[d] > 0)
                  {
                    --box[d];
                    weights |= 1u << d;
                  }
              }
            sum += moments(box)[weights];
          }
        return sum;
      }

    double product = 1.;
    for (unsigned int d = 0; d < dim; ++d)
      product *=
        kind == Function::gaussian
          ? gaussian_line(std::sqrt(pi) * cell_size[d] / theta[d], lag[d])
          : exponential_line(2. * cell_size[d] / theta[d], lag[d]);
    return product;
  }


  std::vector<double>
  Correlation::table(const std::array<double, 3>       &cell_size,
                     const std::array<unsigned int, 3> &n) const
  {
    const unsigned int  dim = theta.size();
    std::vector<double> values(static_cast<std::size_t>(n[0]) * n[1] * n[2], 0.);
    const auto          number = [&](const std::array<int, 3> &i) {
      return i[0] + std::size_t(n[0]) * (i[1] + std::size_t(n[1]) * i[2]);
    };
    const auto for_all = [&](const auto &action) {
      std::array<int, 3> i;
      for (i[2] = 0; i[2] < int(n[2]); ++i[2])
        for (i[1] = 0; i[1] < int(n[1]); ++i[1])
          for (i[0] = 0; i[0] < int(n[0]); ++i[0])
            action(i);
    };

    if (kind == Function::markov && dim > 1)
      {
        // Every box serves the 2^dim lags at its corners.
        std::array<double, 3> a{{0., 0., 0.}};
        for (unsigned int d = 0; d < dim; ++d)
          a[d] = 2. * cell_size[d] / theta[d];
        const EllipsoidalMoments integrals(dim, a);
        for_all([&](const std::array<int, 3> &box) {
          const std::array<double, 8> moments = integrals(box);
          for (unsigned int m = 0; m < (1u << dim); ++m)
            {
              std::array<int, 3> lag    = box;
              double             factor = 1.;
              bool               inside = true;
              for (unsigned int d = 0; d < dim; ++d)
                if (m >> d & 1u)
                  inside = ++lag[d] < int(n[d]) && inside;
                else if (box[d] == 0)
                  factor *= 2.;
              if (inside)
                values[number(lag)] += factor * moments[m];
            }
        });
        return values;
      }

    // A product of lines.
    std::array<std::vector<double>, 3> line;
    for (unsigned int d = 0; d < 3; ++d)
      for (unsigned int k = 0; k < n[d]; ++k)
        line[d].push_back(
          d >= dim ? 1.
          : kind == Function::gaussian
            ? gaussian_line(std::sqrt(pi) * cell_size[d] / theta[d], k)
            : exponential_line(2. * cell_size[d] / theta[d], k));
    for_all([&](const std::array<int, 3> &i) {
      values[number(i)] = line[0][i[0]] * line[1][i[1]] * line[2][i[2]];
    });
    return values;
  }
} // namespace Waker
