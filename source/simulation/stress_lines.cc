// SPDX-License-Identifier: LGPL-2.1-or-later
#include "stress_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// @param follows another stage
    std::string
    stage_text(const StageReport             &stage,
               const InitialStressParameters &in,
               const bool                     follows)
    {
      std::ostringstream text;
      text.precision(3);
      text << "  stress    " << stage.name << ": "
           << (follows                     ? "of the daily stage"
               : in.from == StressFrom::k0 ? "K0"
                                           : "none at first")
           << ", out of balance by " << 100. * stage.imbalance
           << " % of the loads; ";
      if (stage.balance)
        text << "in balance with plastic laws after " << stage.balance->steps
             << " step(s), " << stage.balance->iterations << " iterations, "
             << 100. * stage.balance->yielding << " % of the soil yields";
      else
        text << "in balance after " << stage.gravity.residuals.size() - 1
             << " elastic solve(s), residual "
             << stage.gravity.residuals.back();
      if (std::isfinite(stage.difference_rms))
        text << "; sigma'_v is " << stage.difference_rms
             << " kPa (rms) from that of columns, whose mean is "
             << stage.mean_vertical_stress << " kPa";
      return text.str();
    }


    /// "1.2, 20, 41", and how many points there are.
    template <typename Value>
    std::string
    three_numbers(const std::vector<double> &volumes, const Value &value)
    {
      double least = std::numeric_limits<double>::max(), largest = -least,
             sum = 0., volume = 0.;
      for (std::size_t i = 0; i < volumes.size(); ++i)
        {
          const double x = value(i);
          least          = std::min(least, x);
          largest        = std::max(largest, x);
          sum += volumes[i] * x;
          volume += volumes[i];
        }
      std::ostringstream text;
      text.precision(4);
      text << least << ", " << sum / volume << ", " << largest;
      return text.str();
    }


    template <int dim>
    std::string
    material_text(const MaterialPoints<dim> &points,
                  const unsigned int         number,
                  const std::string         &name)
    {
      std::vector<std::size_t> there;
      std::vector<double>      volumes;
      for (std::size_t p = 0; p < points.n_points(); ++p)
        if (points.material[p] == number)
          {
            there.push_back(p);
            volumes.push_back(points.volume[p]);
          }
      const auto values = [&](const char *const scalar) {
        const int i = points.find_scalar(scalar);
        return i < 0 ? nullptr : points.scalars[i].values.data();
      };
      const double *const        stress   = values("initial vertical stress"),
                          *const strength = values("undrained shear strength"),
                          *const ratio    = values("overconsolidation ratio"),
                          *const isotropic =
                            values("preconsolidation pressure");
      if (there.empty() || stress == nullptr)
        return "";
      std::string text =
        "  at start  " + name + ": sigma'_v " +
        three_numbers(volumes,
                      [&](const std::size_t i) { return stress[there[i]]; }) +
        " kPa";
      // Of other materials the points have scalars, too, all of them 0.
      if (strength != nullptr && strength[there.front()] > 0.)
        text += "; s_u " +
                three_numbers(volumes,
                              [&](const std::size_t i) {
                                return strength[there[i]];
                              }) +
                " kPa";
      if (ratio != nullptr && ratio[there.front()] > 0.)
        text +=
          "; OCR " +
          three_numbers(volumes,
                        [&](const std::size_t i) { return ratio[there[i]]; }) +
          "; yield stress " +
          three_numbers(volumes,
                        [&](const std::size_t i) {
                          return ratio[there[i]] * stress[there[i]];
                        }) +
          " kPa";
      if (isotropic != nullptr && isotropic[there.front()] > 0.)
        text += "; p_c " +
                three_numbers(volumes,
                              [&](const std::size_t i) {
                                return isotropic[there[i]];
                              }) +
                " kPa";
      return text + " (least, mean, largest)";
    }
  } // namespace


  template <int dim>
  std::vector<std::string>
  stress_lines(const Case<dim> &the_case)
  {
    const Parameters        &p = the_case.parameters;
    std::vector<std::string> lines;
    if (!p.initial_stress.is_gravity_step())
      for (std::size_t s = 0; s < the_case.stages.size(); ++s)
        lines.push_back(
          stage_text(the_case.stages[s], p.initial_stress, s > 0));
    for (unsigned int m = 0; m < p.materials.size(); ++m)
      if (const std::string line =
            material_text(the_case.initial_points, m, p.materials[m].name);
          !line.empty())
        lines.push_back(line);
    return lines;
  }


  template std::vector<std::string>
  stress_lines(const Case<2> &);
  template std::vector<std::string>
  stress_lines(const Case<3> &);
} // namespace Waker
