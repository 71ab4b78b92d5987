// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cam_clay_return.h"

#include <waker/base/errors.h>

#include <cmath>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// No step means more than that: only an iteration that is refused.
    constexpr double largest_exponent = 200.;

    constexpr double       round_off      = 1e-14;
    constexpr unsigned int max_iterations = 200;
  } // namespace


  double
  ExponentialElasticity::pressure(const double strain) const
  {
    const double z = strain / swelling;
    return z > 0. ? least * std::exp(std::min(z, largest_exponent))
                  : least * (1. + z);
  }


  double
  ExponentialElasticity::strain(const double pressure) const
  {
    return swelling * (pressure > least ? std::log(pressure / least)
                                        : pressure / least - 1.);
  }


  /// Of a plastic volumetric strain d.
  struct CamClayReturn::Point
  {
    double p, pc, pc_by_d, K;

    /// 2 p - p_c, along which volume flows, and its derivative by d.
    double
    flow() const
    {
      return 2. * p - pc;
    }

    double
    flow_by_d() const
    {
      return -2. * K - pc_by_d;
    }
  };


  CamClayReturn::Point
  CamClayReturn::at(const double d, const double strain, const double pc) const
  {
    Point point;
    point.p       = elasticity.pressure(strain - d);
    point.K       = elasticity.bulk_modulus(point.p);
    point.pc      = pc * std::exp(std::min(d / theta, largest_exponent));
    point.pc_by_d = point.pc / theta;
    if (!(point.pc > least))
      {
        point.pc      = least;
        point.pc_by_d = 0.;
      }
    return point;
  }


  // b (6 G / M^2) d = (1 - b) (2 p - p_c): the left side grows with d, the
  // right side falls.
  double
  CamClayReturn::volume_strain(const double b,
                               const double per_shear,
                               const double strain,
                               const double pc,
                               const double furthest,
                               const double guess) const
  {
    double       low = std::min(0., furthest), high = std::max(0., furthest);
    double       d = guess > low && guess < high ? guess : 0.5 * (low + high);
    const double close = 1e-16 * (std::abs(strain) + theta);
    for (unsigned int i = 0; i < max_iterations; ++i)
      {
        const Point  point       = at(d, strain, pc);
        const double rest        = b * per_shear * d - (1. - b) * point.flow();
        (rest > 0. ? high : low) = d;
        const double slope       = b * per_shear - (1. - b) * point.flow_by_d();
        double       next        = d - rest / slope;
        if (!(next >= low && next <= high))
          next = 0.5 * (low + high);
        const double change = std::abs(next - d);
        d                   = next;
        if (change <= close)
          break;
      }
    return d;
  }


  CamClayEnd
  CamClayReturn::operator()(const double strain,
                            const double q,
                            const double M,
                            const double given_pc) const
  {
    const double pc         = std::max(given_pc, least);
    CamClayEnd   end        = {};
    const Point  trial      = at(0., strain, pc);
    const double per_square = 1. / (M * M);
    const auto   excess     = [&](const double b, const Point &point) {
      return b * b * q * q * per_square + point.p * (point.p - point.pc);
    };
    end.pressure         = trial.p;
    end.bulk_modulus     = trial.K;
    end.shear_left       = 1.;
    end.preconsolidation = pc;
    // At a pressure of any size: it may be far outside.
    if (!(excess(1., trial) >
          1e-13 * (q * q * per_square + trial.p * trial.p + pc * pc)))
      return end;

    end.has_yielded = true;
    // There the flow has turned, whatever p_c does meanwhile.
    const double furthest  = strain - elasticity.strain(0.5 * pc);
    const double per_shear = 6. * G * per_square;
    double       low = 0., high = 1., d = 0.;
    double       b     = q > 0. ? std::min(0.9, 0.5 * M * pc / q) : 0.9;
    Point        point = trial;
    double       size = 1., f = 1.;
    double       d_by_b = 0.;
    for (unsigned int i = 0; i < max_iterations; ++i)
      {
        d     = volume_strain(b, per_shear, strain, pc, furthest, d);
        point = at(d, strain, pc);
        f     = excess(b, point);
        size =
          b * b * q * q * per_square + point.p * point.p + point.pc * point.pc;
        (f > 0. ? high : low) = b;
        const double of_d     = b * per_shear - (1. - b) * point.flow_by_d();
        d_by_b                = -(per_shear * d + point.flow()) / of_d;
        const double slope =
          2. * b * q * q * per_square -
          (point.flow() * point.K + point.p * point.pc_by_d) * d_by_b;
        double next = b - f / slope;
        if (!(next > low && next < high))
          next = 0.5 * (low + high);
        const double change = std::abs(next - b);
        if (std::abs(f) <= round_off * size || change <= 1e-16 * b)
          break;
        d += d_by_b * (next - b);
        b = next;
      }
    if (!(std::abs(f) <= 1e-9 * size))
      {
        std::ostringstream message;
        message << "modified Cam clay: no return from a volumetric strain of "
                << strain << " and q = " << q << " kPa with p_c = " << pc
                << " kPa";
        throw NumericalFailure(message.str());
      }

    end.pressure         = point.p;
    end.bulk_modulus     = point.K;
    end.shear_left       = b;
    end.volume_strain    = d;
    end.preconsolidation = point.pc;

    // The flow rule and f by b and d, and by x and q dq.
    const double flow        = point.flow();
    const double rule_b      = per_shear * d + flow;
    const double rule_d      = b * per_shear - (1. - b) * point.flow_by_d();
    const double f_b         = 2. * b * q * q * per_square;
    const double f_d         = -flow * point.K - point.p * point.pc_by_d;
    const double rule_x      = (1. - b) * 2. * point.K; // right-hand sides
    const double f_x         = -flow * point.K;
    const double f_shear     = -2. * b * b * per_square;
    const double per_det     = 1. / (rule_b * f_d - rule_d * f_b);
    end.shear_left_by_strain = (rule_x * f_d - rule_d * f_x) * per_det;
    end.shear_left_by_shear  = -rule_d * f_shear * per_det;
    end.volume_by_strain     = (rule_b * f_x - f_b * rule_x) * per_det;
    end.volume_by_shear      = rule_b * f_shear * per_det;
    return end;
  }
} // namespace Waker
