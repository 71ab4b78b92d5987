// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_stress_in_ground_h
#define waker_tests_stress_in_ground_h

#include <waker/base/errors.h>
#include <waker/case/case.h>
#include <waker/program/parameter_reader.h>

#include "level_ground.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <vector>

/// Ground at rest, for the tests of its stress at the start.
namespace StressInGround
{
  using namespace Waker;

  /// 2 m of sand on 2 m of clay, 4 m wide, level, water at `line`; rollers.
  inline const std::string level_ground =
    LevelGround::text_of({4.,
                          5.,
                          {{"top", "sand", 2., 4.}, {"below", "clay", 0., 2.}},
                          R"(
subsection Materials
  set Names = sand, clay
  subsection sand
    set Model                 = Mohr-Coulomb
    set Unit weight           = 18
    set Saturated unit weight = 20
    set Young's modulus       = 20000
    set Poisson's ratio       = 0.3
    set Cohesion              = 0.5
    set Friction angle        = 33
    set K0                    = Jaky
  end
  subsection clay
    set Unit weight       = 14
    set Young's modulus   = 2000
    set Poisson's ratio   = 0.45
    set Initial strength  = 40
    set Residual strength = 20
    set K0                = 0.7 + 0.01*y
  end
end
)",
                          R"(
subsection Pore water
  set Phreatic line = 0, 3; 4, 3
end
subsection Kinematics and mapping
  set Volumetric strain = B-bar
end
subsection Initial stress
  set From = K0
end
)"});

  inline std::unique_ptr<Parameters>
  read(const std::string &text, const std::vector<std::string> &more = {})
  {
    return read_parameters(LevelGround::written(text), more);
  }

  /// The function must throw a UserError that says both: where, with or without
  /// the file, and what.
  template <typename Function>
  void
  expect_refused(const Function    &function,
                 const std::string &where,
                 const std::string &what)
  {
    try
      {
        function();
      }
    catch (const UserError &error)
      {
        const std::string text = error.what();
        EXPECT_NE(text.find(where + ": "), std::string::npos) << text;
        EXPECT_NE(text.find(what), std::string::npos)
          << what << " is not in " << text;
        EXPECT_FALSE(error.allowed.empty());
        return;
      }
    ADD_FAILURE() << "no error at " << where << ": " << what;
  }

  /// The level ground in space.
  inline std::vector<std::string>
  in_space(std::vector<std::string> more = {})
  {
    for (const char *const setting :
         {"Dimension=3",
          "Grid/Lower corner=0, 0, 0",
          "Grid/Upper corner=4, 5, 1",
          "Boundary conditions/Names=base, left side, right side, rear, near",
          "Boundary conditions/rear/Region=back",
          "Boundary conditions/rear/Type=roller",
          "Boundary conditions/near/Region=front",
          "Boundary conditions/near/Type=roller"})
      more.insert(more.begin(), setting);
    return more;
  }

  /// sigma'_v (kPa) of the level ground at the height y.
  inline double
  vertical_stress(const double y, const double line = 3.)
  {
    constexpr double gamma_w = 10.;
    const auto       length  = [](const double from, const double to) {
      return std::max(to - from, 0.);
    };
    const double low = std::max(y, 2.);
    return 18. * length(std::max(low, line), 4.) +
           20. * length(low, std::min(line, 4.)) + 14. * length(y, 2.) +
           gamma_w * length(4., line) - gamma_w * length(y, line);
  }

  /// How far outside its law's yield surface the worst point lies (kPa).
  template <int dim>
  double
  largest_excess(const Case<dim> &the_case)
  {
    const MaterialPoints<dim> &points = the_case.initial_points;
    double                     worst  = 0.;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const Material     &law = *the_case.materials[points.material[p]];
        std::vector<double> variables;
        for (const MaterialVariable &variable : law.variables())
          variables.push_back(points.scalar(variable.name)[p]);
        auto stress = points.stress[p];
        law.update({}, stress, variables.data(), nullptr);
        worst = std::max(worst, (stress - points.stress[p]).norm());
      }
    return worst;
  }
} // namespace StressInGround

#endif
