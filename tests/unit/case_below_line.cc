// SPDX-License-Identifier: LGPL-2.1-or-later
// Vertical stress in the ground at the start, and strengths that follow from
// it.
#include <waker/base/errors.h>
#include <waker/case/case.h>
#include <waker/case/state.h>
#include <waker/program/parameter_reader.h>
#include <waker/simulation/plausibility.h>

#include "clay_on_peat.h"
#include "level_ground.h"
#include "user_errors.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace case_below_line
{
  using namespace Waker;
  using namespace ClayOnPeat;

  TEST(Ground, soil_below_the_line_may_be_another)
  {
    // Clay that lies below the line is as wet clay is.
    const Case<2>            level(*ground(
                          {"Materials/Names=clay, peat, wet clay",
                                      "Materials/clay/Below the line=wet clay",
                                      "Materials/clay/Initial strength=30",
                                      "Materials/wet clay/Unit weight=16",
                                      "Materials/wet clay/Saturated unit weight=18",
                                      "Materials/wet clay/Strength from=table",
                                      "Materials/wet clay/Strength table=0: 5, 90: 50",
                                      "Materials/wet clay/Residual strength=2"}),
                        MPI_COMM_SELF);
    const MaterialPoints<2> &points = level.initial_points;
    const auto              &values =
      points.scalars[points.find_scalar("undrained shear strength")].values;
    unsigned int n_wet = 0;
    for (std::size_t p = 0; p < points.n_points(); ++p)
      {
        const double y = points.initial_position[p][1];
        const double g = 9.81, volume = 0.0625;
        if (y > 3.)
          {
            EXPECT_EQ(points.material[p], 0u);
            EXPECT_EQ(values[p], 30.);
            EXPECT_NEAR(points.mass[p], 14. / g * volume, 1e-14);
          }
        else if (y > 2.)
          {
            ++n_wet;
            EXPECT_EQ(points.material[p], 2u);
            const double stress = 14. + 8. * (3. - y);
            EXPECT_NEAR(values[p], 5. + 0.5 * stress, 1e-12);
            EXPECT_NEAR(points.mass[p], 18. / g * volume, 1e-14);
          }
        else
          {
            EXPECT_EQ(points.material[p], 1u);
            EXPECT_NEAR(level.ground.at({0.75, y}, 1).vertical_stress,
                        14. + 8. + 1. * (2. - y),
                        1e-12);
          }
      }
    EXPECT_EQ(n_wet, 32u);
    // The weight is borne by the base.
    double weight = 0.;
    for (const double mass : points.mass)
      weight += 9.81 * mass;
    EXPECT_NEAR(weight, 2. * (14. + 18. + 2. * 11.), 1e-10);
  }


  TEST(Ground, what_is_below_the_line_is_another_material)
  {
    const std::string path = "--set Materials/clay/Below the line";
    for (const char *const name : {"sand", "clay", "clay, peat"})
      EXPECT_USER_ERROR(ground({std::string("Materials/clay/Below the line=") +
                                name}),
                        path,
                        name);
    EXPECT_USER_ERROR(ground({"Materials/clay/Below the line=peat",
                              "Materials/peat/Below the line=clay"}),
                      path,
                      "peat");
    EXPECT_USER_ERROR(ground({"Materials/clay/Below the line=peat",
                              "Inflow/Names=in",
                              "Inflow/in/Material=clay",
                              "Inflow/in/Face=left"}),
                      path,
                      "flows in");
  }


  // Without water in it, it cannot boil.
  TEST(Ground, drained_soil_that_stays_above_the_line_needs_no_special_water)
  {
    const auto with_water = [](const std::vector<std::string> &more) {
      std::vector<std::string> all = {"Materials/Names=clay, peat, wet clay",
                                      "Materials/clay/Model=Mohr-Coulomb",
                                      "Materials/clay/Below the line=wet clay",
                                      "Materials/wet clay/Unit weight=16",
                                      "Water/Side=left",
                                      "Water/Level=3",
                                      "Surface/Method=contour"};
      all.insert(all.end(), more.begin(), more.end());
      return ground(all);
    };
    const std::string soil = "Pore water/Pressure of=soil";
    EXPECT_NO_THROW(with_water({soil}));
    EXPECT_NO_THROW(with_water({"Water/Minimum support=0"}));
    for (const auto &more :
         {std::vector<std::string>{},
          std::vector<std::string>{soil, "Pore water/Largest suction=5"},
          std::vector<std::string>{soil, "Materials/peat/Model=Mohr-Coulomb"}})
      {
        std::vector<std::string> settings = more;
        settings.push_back("Water/Minimum support=0.01");
        EXPECT_USER_ERROR(with_water(settings),
                          "--set Water/Minimum support",
                          "drained");
      }
  }
} // namespace case_below_line
