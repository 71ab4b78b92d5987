// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/base/random_numbers.h>
#include <waker/fields/marginal.h>

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <cmath>
#include <sstream>

namespace Waker
{
  namespace
  {
    double
    Phi(const double z)
    {
      return standard_normal_distribution(z);
    }


    /// Probability between two standard scores, also far out in a tail.
    double
    between(const double from, const double to)
    {
      return from > 0. ? Phi(-from) - Phi(-to) : Phi(to) - Phi(from);
    }


    /// The smallest probability of truncation that still leaves numbers to
    /// compute with.
    constexpr double smallest_share = 1e-100;


    /// The logarithm is mean + sd z. With mean m and standard deviation s of
    /// the values for standard normal z, and mean m for any variance of z.
    struct OfLogarithm
    {
      double mean, sd;

      OfLogarithm(const double m, const double s, const double variance_of_z)
      {
        const double variance = std::log1p((s / m) * (s / m));
        mean                  = std::log(m) - 0.5 * variance * variance_of_z;
        sd                    = std::sqrt(variance);
      }
    };


    /// The distribution on [0, 1] with the mean and standard deviation of the
    /// one on [minimum, maximum].
    boost::math::beta_distribution<double>
    unit_beta(const double minimum,
              const double maximum,
              const double mean,
              const double sd)
    {
      const double mu = (mean - minimum) / (maximum - minimum);
      const double s  = sd / (maximum - minimum);
      const double nu = mu * (1. - mu) / (s * s) - 1.;
      return boost::math::beta_distribution<double>(mu * nu, (1. - mu) * nu);
    }
  } // namespace


  Marginal::Marginal(const Kind   kind,
                     const double minimum,
                     const double maximum)
    : type(kind)
    , minimum(minimum)
    , maximum(maximum)
  {}


  std::string
  Marginal::problem(const double mean, const double sd) const
  {
    std::ostringstream text;
    if (!(std::isfinite(mean) && std::isfinite(sd) && sd >= 0.))
      text << "the mean " << mean << " and standard deviation " << sd
           << " must be finite, the second not negative";
    else if (!(minimum < maximum))
      text << "the minimum " << minimum << " is not below the maximum "
           << maximum;
    else if (type == Kind::lognormal && !(mean > 0.))
      text << "a lognormal distribution has a mean above 0, not " << mean;
    else if (type == Kind::lognormal && !(maximum > 0.))
      text << "a lognormal distribution has no values below the maximum "
           << maximum;
    else if (type == Kind::truncated_normal)
      {
        if (sd == 0. ? !(minimum <= mean && mean <= maximum)
                     : !(between((minimum - mean) / sd, (maximum - mean) / sd) >
                         smallest_share))
          text << "a normal distribution with mean " << mean
               << " and standard deviation " << sd << " has no values between "
               << minimum << " and " << maximum;
      }
    else if (type == Kind::beta)
      {
        if (!(std::isfinite(minimum) && std::isfinite(maximum)))
          text << "a beta distribution has a finite minimum and maximum, not "
               << minimum << " and " << maximum;
        else if (!(minimum < mean && mean < maximum))
          text << "the mean " << mean << " is not between the minimum "
               << minimum << " and the maximum " << maximum;
        else if (!(sd * sd < (mean - minimum) * (maximum - mean)))
          text << "the standard deviation " << sd
               << " is not below sqrt((mean - minimum) (maximum - mean)) = "
               << std::sqrt((mean - minimum) * (maximum - mean));
      }
    return text.str();
  }


  double
  Marginal::value(const double z,
                  const double mean,
                  const double sd,
                  const double variance) const
  {
    Assert(variance == 1. || type == Kind::normal || type == Kind::lognormal,
           dealii::ExcMessage("This distribution takes standard normal z."));
    if (sd == 0.)
      return std::clamp(mean, minimum, maximum);

    double x = 0.;
    switch (type)
      {
        case Kind::normal:
          x = mean + sd * z;
          break;

        case Kind::lognormal:
          {
            const OfLogarithm logarithm(mean, sd, variance);
            x = std::exp(logarithm.mean + logarithm.sd * z);
            break;
          }

        case Kind::truncated_normal:
          {
            // From the smaller of the two tail probabilities.
            const double from  = (minimum - mean) / sd;
            const double to    = (maximum - mean) / sd;
            const double share = between(from, to);
            const double below = Phi(from) + Phi(z) * share;
            const double above = Phi(-to) + Phi(-z) * share;
            if (below <= above)
              x = below > 0. ? mean + sd * standard_normal_quantile(below)
                             : minimum;
            else
              x = above > 0. ? mean - sd * standard_normal_quantile(above)
                             : maximum;
            break;
          }

        case Kind::beta:
          {
            const auto   beta = unit_beta(minimum, maximum, mean, sd);
            const double u =
              z < 0.
                ? boost::math::quantile(beta, Phi(z))
                : boost::math::quantile(boost::math::complement(beta, Phi(-z)));
            x = minimum + (maximum - minimum) * u;
            break;
          }
      }
    return std::clamp(x, minimum, maximum);
  }


  double
  Marginal::normal_score(const double value,
                         const double mean,
                         const double sd,
                         const double variance) const
  {
    double below = 0., above = 0.;
    switch (type)
      {
        case Kind::normal:
          return (value - mean) / sd;

        case Kind::lognormal:
          {
            const OfLogarithm logarithm(mean, sd, variance);
            return (std::log(value) - logarithm.mean) / logarithm.sd;
          }

        case Kind::truncated_normal:
          {
            const double from  = (minimum - mean) / sd;
            const double to    = (maximum - mean) / sd;
            const double here  = (value - mean) / sd;
            const double share = between(from, to);
            below              = between(from, here) / share;
            above              = between(here, to) / share;
            break;
          }

        case Kind::beta:
          {
            const auto   beta = unit_beta(minimum, maximum, mean, sd);
            const double u    = (value - minimum) / (maximum - minimum);
            below             = boost::math::cdf(beta, u);
            above = boost::math::cdf(boost::math::complement(beta, u));
            break;
          }
      }
    // Probabilities that round to 0 are not for the quantile function.
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (below <= above)
      return below > 0. ? standard_normal_quantile(below) : -infinity;
    return above > 0. ? -standard_normal_quantile(above) : infinity;
  }


  double
  Marginal::share_beyond(const double mean, const double sd) const
  {
    if (type == Kind::truncated_normal || type == Kind::beta || !(sd > 0.))
      return 0.;
    const auto below = [&](const double limit) {
      return std::isinf(limit) ? 0. : Phi(normal_score(limit, mean, sd));
    };
    const auto above = [&](const double limit) {
      return std::isinf(limit) ? 0. : Phi(-normal_score(limit, mean, sd));
    };
    const bool none_below = type == Kind::lognormal && !(minimum > 0.);
    return (none_below ? 0. : below(minimum)) + above(maximum);
  }


  std::string
  Marginal::value_problem(const double value,
                          const double mean,
                          const double sd) const
  {
    const bool open = type == Kind::truncated_normal || type == Kind::beta;
    std::ostringstream allowed;
    if (!(sd > 0.))
      allowed << "none: the distribution has no spread there";
    else if (type == Kind::lognormal && !(value > 0.))
      allowed << "above 0";
    else if (!(open ? value > minimum && value < maximum
                    : value >= minimum && value <= maximum))
      {
        const bool below = std::isfinite(minimum);
        const bool above = std::isfinite(maximum);
        if (below)
          allowed << (open ? "above " : "at least ") << minimum;
        if (above)
          allowed << (below ? ", " : "") << (open ? "below " : "at most ")
                  << maximum;
        if (!below && !above)
          allowed << "a number";
      }
    else if (!std::isfinite(normal_score(value, mean, sd)))
      allowed << "nearer to the mean, " << mean;
    return allowed.str();
  }
} // namespace Waker
