// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_fields_marginal_h
#define waker_fields_marginal_h

#include <limits>
#include <string>

namespace Waker
{
  /**
   * The distribution of a property at a place, as a monotone function of a
   * standard normal z (translation field).
   *   normal            mean + sd z, cut off (censored) at the limits
   *   lognormal         with this mean and sd, then cut off likewise
   *   truncated normal  normal(mean, sd) under the condition of the limits:
   *                     mean and sd are those before the truncation
   *   beta              on [minimum, maximum] with this mean and sd
   *
   * If the spread is that of points, and z that of their averages over cells,
   * z has a variance below 1. The median of the lognormal distribution is then
   * such that the mean stays what it is; normal values keep it anyway. The
   * other two distributions take standard normal z only.
   */
  class Marginal
  {
  public:
    enum class Kind
    {
      normal,
      lognormal,
      truncated_normal,
      beta
    };

    Marginal(const Kind   kind,
             const double minimum = 0.,
             const double maximum = std::numeric_limits<double>::infinity());

    /// Is there such a distribution? Empty, or what is wrong with it.
    std::string
    problem(const double mean, const double standard_deviation) const;

    /// The value whose probability of non-exceedance is Phi(z / sqrt(v)).
    /// @param variance v of z
    double
    value(const double z,
          const double mean,
          const double standard_deviation,
          const double variance = 1.) const;

    /// z of a value (of measurements): the inverse of value(). Only for values
    /// of which value_problem() finds nothing wrong.
    double
    normal_score(const double value,
                 const double mean,
                 const double standard_deviation,
                 const double variance = 1.) const;

    /// Has the value a score? Empty, or which values have one: "above 0". The
    /// distribution itself must be possible (problem()).
    std::string
    value_problem(const double value,
                  const double mean,
                  const double standard_deviation) const;

    /// Probability that a normal or lognormal value with standard normal score
    /// lies beyond a limit and becomes it; 0 for the others.
    double
    share_beyond(const double mean, const double sd) const;

  private:
    Kind   type;
    double minimum;
    double maximum;
  };

  constexpr const char *
  name_of(const Marginal::Kind kind)
  {
    switch (kind)
      {
        case Marginal::Kind::normal:
          return "normal";
        case Marginal::Kind::lognormal:
          return "lognormal";
        case Marginal::Kind::truncated_normal:
          return "truncated normal";
        case Marginal::Kind::beta:
          return "beta";
      }
    return nullptr;
  }
} // namespace Waker

#endif
