// SPDX-License-Identifier: LGPL-2.1-or-later
// Random fields and strength reductions go by the roles of variables.
#include <waker/materials/von_mises_softening.h>

#include <gtest/gtest.h>

namespace materials_roles
{
  using namespace Waker;
  using Role = MaterialVariable::Role;

  TEST(Materials, roles_of_variables)
  {
    const VonMisesSoftening clay(1.5, 1000., 0.45, 13., 5., -50.);
    const LinearElastic     rock(1.5, 1000., 0.45);
    ASSERT_TRUE(variable_of(clay, Role::strength));
    EXPECT_EQ(variable_of(clay, Role::strength)->name,
              "undrained shear strength");
    EXPECT_EQ(variable_of(clay, Role::strength)->initial_value.number, 13.);
    ASSERT_TRUE(variable_of(clay, Role::residual_strength));
    EXPECT_EQ(variable_of(clay, Role::residual_strength)->name,
              "residual strength");
    EXPECT_EQ(variable_of(clay, Role::history)->name, "plastic strain");
    EXPECT_FALSE(variable_of(clay, Role::stiffness));
    EXPECT_FALSE(variable_of(rock, Role::strength));

    EXPECT_TRUE(is_strength(Role::strength));
    EXPECT_TRUE(is_strength(Role::residual_strength));
    EXPECT_FALSE(is_strength(Role::stiffness));
    EXPECT_FALSE(is_strength(Role::history));
  }
} // namespace materials_roles
