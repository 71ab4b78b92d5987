// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/fields/correlation.h>
#include <waker/fields/ellipsoidal_moments.h>

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
          return boost::math::quadrature::gauss<double, 20>::integrate(
            [&](const double t) {
              return (1. - t) * (std::exp(-b * b * (k + t) * (k + t)) +
                                 std::exp(-b * b * (k - t) * (k - t)));
            },
            0.,
            1.);
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
        case Function::gaussian:
          return std::exp(-pi * squares);
      }
    AssertThrow(false, ExcInternalError());
    return 0.;
  }


  bool
  Correlation::is_product() const
  {
    switch (kind)
      {
        case Function::markov:
          return theta.size() == 1;
        case Function::separable_markov:
        case Function::gaussian:
          return true;
      }
    AssertThrow(false, ExcInternalError());
    return false;
  }


  double
  Correlation::line(const double       cell_size,
                    const unsigned int d,
                    const int          lag) const
  {
    switch (kind)
      {
        case Function::markov: // on a line it is its own separable form
        case Function::separable_markov:
          return exponential_line(2. * cell_size / theta[d], lag);
        case Function::gaussian:
          return gaussian_line(std::sqrt(pi) * cell_size / theta[d], lag);
      }
    AssertThrow(false, ExcInternalError());
    return 0.;
  }


  double
  Correlation::between_cells(const std::array<double, 3> &cell_size,
                             const std::array<int, 3>    &lag) const
  {
    const unsigned int dim = theta.size();
    if (!is_product())
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
      product *= line(cell_size[d], d, lag[d]);
    return product;
  }


  std::vector<double>
  Correlation::table(const std::array<double, 3>       &cell_size,
                     const std::array<unsigned int, 3> &n) const
  {
    const unsigned int  dim = theta.size();
    std::vector<double> values(static_cast<std::size_t>(n[0]) * n[1] * n[2],
                               0.);
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

    if (!is_product())
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
    std::array<std::vector<double>, 3> lines;
    for (unsigned int d = 0; d < 3; ++d)
      for (unsigned int k = 0; k < n[d]; ++k)
        lines[d].push_back(d < dim ? line(cell_size[d], d, k) : 1.);
    for_all([&](const std::array<int, 3> &i) {
      values[number(i)] = lines[0][i[0]] * lines[1][i[1]] * lines[2][i[2]];
    });
    return values;
  }
} // namespace Waker
