// SPDX-License-Identifier: LGPL-2.1-or-later
// Parameters of soils with friction, and of a softening length: what is
// refused, and what is told.
#include <waker/base/errors.h>
#include <waker/case/parameters.h>
#include <waker/program/parameter_reader.h>
#include <waker/simulation/plausibility.h>

#include "program_case.h"
#include "warnings.h"
#include <gtest/gtest.h>

namespace program_friction
{
  using namespace Waker;
  using namespace ProgramCase;

  namespace
  {
    const std::string clay = "Materials/clay/";


    std::vector<std::string>
    sand(const std::vector<std::string> &more)
    {
      std::vector<std::string> all = {clay + "Model=Mohr-Coulomb",
                                      clay + "Initial strength=13", // default
                                      clay + "Residual strength=5",
                                      "Water/Side=none"};
      all.insert(all.end(), more.begin(), more.end());
      return all;
    }


    void
    expect_error(const std::vector<std::string> &overrides,
                 const std::string              &where,
                 const std::string              &what,
                 const std::string              &allowed)
    {
      try
        {
          read_parameters(write_case(good_case), overrides);
          ADD_FAILURE() << "no error; expected: " << what;
        }
      catch (const UserError &error)
        {
          EXPECT_NE(error.where.find(where), std::string::npos) << error.what();
          EXPECT_NE(error.problem.find(what), std::string::npos)
            << error.what();
          EXPECT_NE(error.allowed.find(allowed), std::string::npos)
            << error.what();
        }
    }


    std::vector<std::string>
    warnings(const std::vector<std::string> &overrides)
    {
      return strange_parameters(
        *read_parameters(write_case(good_case), overrides));
    }


    void
    expect_warning(const std::vector<std::string> &overrides,
                   const std::string              &text)
    {
      const std::string all = Warnings::joined(warnings(overrides));
      EXPECT_TRUE(Warnings::has(all, text)) << text << "\n" << all;
    }
  } // namespace


  TEST(Program, strengths_that_soil_with_friction_cannot_have)
  {
    EXPECT_TRUE(warnings(sand({})).empty());
    const std::string c = clay + "Cohesion", phi = clay + "Friction angle",
                      psi = clay + "Dilatancy angle",
                      t   = clay + "Tensile strength",
                      e   = clay + "Softening strain";
    expect_error(sand({c + "=-1"}), c, "-1 kPa", "at least 0");
    expect_error(sand({phi + "=89.1"}), phi, "89.1 degrees", "0 to 89");
    expect_error(sand({phi + "=-1"}), phi, "-1 degrees", "from 0 to 89");
    expect_error(sand({c + "=0", phi + "=0"}), c, "no strength", "above 0");
    expect_error(sand({psi + "=31"}),
                 psi,
                 "31 degrees",
                 "from 0 to the friction angle");
    expect_error(sand({t + "=-1"}), t, "-1", "0");
    expect_error(sand({c + "=nonsense"}), c, "nonsense", "");
    EXPECT_TRUE(warnings(sand({t + "=apex", c + "=1", psi + "=30"})).size() ==
                1); // a dilatancy angle of 30 degrees is strange
    // Softening.
    const std::string soft = e + "=0.3", c_r = clay + "Residual cohesion",
                      phi_r = clay + "Residual friction angle",
                      psi_r = clay + "Residual dilatancy angle";
    EXPECT_TRUE(warnings(sand({soft, c_r + "=2"})).empty());
    expect_error(sand({c_r + "=2"}), e, "is 0", "above 0");
    expect_error(sand({soft, c_r + "=6"}), c_r, "6 kPa", "to the cohesion");
    expect_error(sand({soft, phi_r + "=31"}),
                 phi_r,
                 "31 degrees",
                 "to the friction angle");
    expect_error(sand({soft, phi_r + "=20", psi_r + "=21"}),
                 psi_r,
                 "21 degrees",
                 "residual friction angle");
    expect_error(sand({e + "=0.001", c_r + "=0"}), e, "snap-back", "above 0.0");
  }


  TEST(Program, friction_under_water_is_refused)
  {
    const std::string model = clay + "Model";
    expect_error({model + "=Mohr-Coulomb"},
                 model,
                 "water stands on the left",
                 "none");
    // Without friction the pressure presses nothing together.
    // With a line it is not, if the water outside loads the same nodes.
    const std::string line = "Pore water/Phreatic line=-6, 4.75; 30, 0";
    expect_error({model + "=Mohr-Coulomb", line},
                 "Water/Minimum support",
                 "would boil",
                 "0");
    expect_error({model + "=Mohr-Coulomb", line, "Water/Minimum support=0"},
                 "Surface/Method",
                 "would boil",
                 "contour");
    const std::vector<std::string> drained = {model + "=Mohr-Coulomb",
                                              line,
                                              "Water/Minimum support=0",
                                              "Surface/Method=contour"};
    EXPECT_NO_THROW(warnings(drained));
    // One section is not where each place along z ends.
    std::vector<std::string> slice = drained;
    slice.insert(slice.end(),
                 {"Dimension=3",
                  "Grid/Lower corner=-6, 0, 0",
                  "Grid/Upper corner=42, 6, 1"});
    EXPECT_NO_THROW(warnings(slice));
    slice.push_back("Surface/Prismatic=true");
    expect_error(slice, "Surface/Prismatic", "would boil", "Dimension = 2");
    EXPECT_NO_THROW(warnings({model + "=Mohr-Coulomb",
                              clay + "Friction angle=0",
                              clay + "Tensile strength=apex"}));
    expect_error({model + "=Mohr-Coulomb", clay + "Friction angle=20 + y"},
                 model,
                 "water stands",
                 "none");
  }


  TEST(Program, softening_that_belongs_to_a_length)
  {
    // Points of clay with E = 1000 kPa snap back from -597 kPa on.
    const std::string h_s    = clay + "Softening modulus",
                      length = clay + "Softening length";
    EXPECT_TRUE(warnings({h_s + "=-400"}).empty());
    EXPECT_TRUE(warnings({h_s + "=-400", length + "=0.25"}).empty());
    expect_warning({h_s + "=-500"}, "snap back from -597");
    expect_warning({h_s + "=-250", length + "=0.125"}, "snap back from -298");
    expect_error({h_s + "=-400", length + "=0.125"},
                 h_s,
                 "snap-back",
                 "this cell size and softening length");
    expect_error({length + "=-1"}, length, "-1", "0");
    expect_warning(sand({clay + "Softening strain=0.05",
                         clay + "Residual friction angle=20"}),
                   "lose their friction at once");
  }


  TEST(Program, friction_that_soils_do_not_have)
  {
    expect_warning(sand({clay + "Cohesion=0"}), "shed their skin");
    expect_warning(sand({clay + "Friction angle=60"}),
                   "Friction angle is 60 degrees; soils have 10 to 50");
    expect_warning(sand({clay + "Friction angle=0.6"}),
                   "Friction angle is 0.6 degrees");
    expect_warning(sand({clay + "Cohesion=5000"}), "Cohesion is 5000 kPa");
  }
} // namespace program_friction
