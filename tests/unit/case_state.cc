// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/case/state.h>

#include <cstring>
#include <gtest/gtest.h>
#include <string>
#include <type_traits>
#include <vector>

namespace case_state
{
  // What a checkpoint must hold. Two states that lack the same member have the
  // same bytes: a comparison of bytes does not see it.

  using namespace Waker;

  namespace
  {
    /// Different numbers for all members of an account that holds doubles only:
    /// also for those that are added one day.
    template <typename Account>
    void
    fill(Account &account, const double first)
    {
      static_assert(std::is_trivially_copyable_v<Account>);
      static_assert(sizeof(Account) % sizeof(double) == 0);
      std::vector<double> numbers(sizeof(Account) / sizeof(double));
      for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = first + 0.125 * i;
      std::memcpy(static_cast<void *>(&account),
                  numbers.data(),
                  sizeof(Account));
    }


    template <typename Account>
    bool
    same_bytes(const Account &a, const Account &b)
    {
      return std::memcmp(&a, &b, sizeof(Account)) == 0;
    }


    template <int dim>
    MaterialPoints<dim>
    three_points()
    {
      MaterialPoints<dim> points;
      points.scalar("strength");
      points.scalar("plastic strain");
      points.load.resize(3);
      points.initial_half_size.resize(3);
      points.deformation.resize(3);
      points.resize(3);
      // Any bytes do, as long as entries beside each other differ.
      unsigned int n = 0;
      MaterialPoints<dim>::for_each_array(
        points, [&](const char *, auto &values) {
          for (auto &value : values)
            {
              auto *const byte = reinterpret_cast<unsigned char *>(&value);
              for (std::size_t i = 0; i < sizeof value; ++i)
                byte[i] = static_cast<unsigned char>(1 + ++n % 63);
            }
        });
      return points;
    }


    template <int dim>
    void
    check_state()
    {
      State<dim> state;
      state.points           = three_points<dim>();
      state.time             = 1.5;
      state.step             = 17;
      state.surface_vertices = {{Point<dim>(), Point<dim>::unit_vector(0)}, {}};
      state.wall_tractions   = {Tensor<1, dim>(), Point<dim>::unit_vector(1)};
      state.mean_plastic_strain = 2.5;
      state.displacement_rate   = 3.5;
      state.settlement_rate     = 8.5;
      state.last_dt             = 4.5;
      state.halvings            = 2;
      state.steps_since_change  = 3;
      state.newton_iterations   = 5;
      state.linear_iterations   = 6;
      state.unconverged_steps   = 7;
      fill(state.energy, 100.);
      fill(state.rest, 200.);
      state.tractions.resize(2);
      fill(state.tractions[0], 210.);
      fill(state.tractions[1], 220.);
      state.loads            = {{1.5, 2.5, 3.5, true, 4.5, 5.5, 6.5},
                                {7.5, 8.5, 9.5, false, 10.5, 11.5, 12.5}};
      state.pore_water       = {13.25, {{14.25}, {15.25, 16.25}}};
      FlowAccount<dim> &flow = state.flow;
      flow.mass_start = 21.5, flow.mass_in = 22.5, flow.mass_out = 23.5;
      double number = 30.;
      for (Tensor<1, dim> *const v : {&flow.momentum_start,
                                      &flow.momentum_in,
                                      &flow.momentum_out,
                                      &flow.impulse,
                                      &flow.force})
        for (unsigned int d = 0; d < dim; ++d)
          (*v)[d] = ++number;
      flow.points_in = 41, flow.points_out = 42, flow.next_id = 43;
      flow.rows                         = {44, 45};
      state.failure.started             = true;
      state.failure.initial_width       = 11.5;
      state.failure.initial_height      = 12.5;
      state.failure.initial_time        = 13.5;
      state.failure.initial_time_thesis = 14.5;
      state.failure.flooding_time       = 15.5;
      fill(state.failure.inner_slide, 230.);
      fill(state.failure.outer_slide, 250.);
      state.failure.geometry.height   = 16.5;
      state.failure.geometry.width    = 17.5;
      state.failure.geometry.height_z = 18.5;
      state.failure.geometry.width_z  = 19.5;

      state.sliding.masses.resize(2);
      double     next = 300.;
      const auto set  = [&](const char *, double &number, SlidingQuantity) {
        number = ++next;
      };
      SlidingMasses::for_each_number(state.sliding, set);
      for (SlidingMass &mass : state.sliding.masses)
        SlidingMass::for_each_number(mass, set);

      State<dim> copy;
      copy.read(state.write());
      EXPECT_EQ(copy.time, 1.5);
      EXPECT_EQ(copy.step, 17u);
      EXPECT_EQ(copy.surface_vertices, state.surface_vertices);
      EXPECT_EQ(copy.wall_tractions, state.wall_tractions);
      EXPECT_EQ(copy.mean_plastic_strain, 2.5);
      EXPECT_EQ(copy.displacement_rate, 3.5);
      EXPECT_EQ(copy.settlement_rate, 8.5);
      EXPECT_EQ(copy.last_dt, 4.5);
      EXPECT_EQ(copy.halvings, 2u);
      EXPECT_EQ(copy.steps_since_change, 3u);
      EXPECT_EQ(copy.newton_iterations, 5u);
      EXPECT_EQ(copy.linear_iterations, 6u);
      EXPECT_EQ(copy.unconverged_steps, 7u);
      EXPECT_TRUE(same_bytes(copy.energy, state.energy));
      EXPECT_TRUE(same_bytes(copy.rest, state.rest));
      ASSERT_EQ(copy.tractions.size(), 2u);
      for (unsigned int i = 0; i < 2; ++i)
        EXPECT_TRUE(same_bytes(copy.tractions[i], state.tractions[i])) << i;
      ASSERT_EQ(copy.loads.size(), 2u);
      for (unsigned int i = 0; i < 2; ++i)
        {
          const LoadRecord &load = copy.loads[i];
          EXPECT_EQ(load.factor, state.loads[i].factor) << i;
          EXPECT_EQ(load.time, state.loads[i].time) << i;
          EXPECT_EQ(load.next, state.loads[i].next) << i;
          EXPECT_EQ(load.held, state.loads[i].held) << i;
          EXPECT_EQ(load.held_for, state.loads[i].held_for) << i;
          EXPECT_EQ(load.stop_time, state.loads[i].stop_time) << i;
          EXPECT_EQ(load.change_time, state.loads[i].change_time) << i;
        }
      EXPECT_TRUE(
        same_bytes(copy.failure.inner_slide, state.failure.inner_slide));
      EXPECT_TRUE(
        same_bytes(copy.failure.outer_slide, state.failure.outer_slide));
      EXPECT_EQ(copy.pore_water.level, 13.25);
      EXPECT_EQ(copy.pore_water.arrived, state.pore_water.arrived);
      EXPECT_EQ(copy.flow.mass_start, 21.5);
      EXPECT_EQ(copy.flow.mass_in, 22.5);
      EXPECT_EQ(copy.flow.mass_out, 23.5);
      EXPECT_EQ(copy.flow.momentum_start, flow.momentum_start);
      EXPECT_EQ(copy.flow.momentum_in, flow.momentum_in);
      EXPECT_EQ(copy.flow.momentum_out, flow.momentum_out);
      EXPECT_EQ(copy.flow.impulse, flow.impulse);
      EXPECT_EQ(copy.flow.force, flow.force);
      EXPECT_EQ(copy.flow.points_in, 41u);
      EXPECT_EQ(copy.flow.points_out, 42u);
      EXPECT_EQ(copy.flow.next_id, 43u);
      EXPECT_EQ(copy.flow.rows, flow.rows);
      EXPECT_TRUE(copy.failure.started);
      EXPECT_EQ(copy.failure.initial_width, 11.5);
      EXPECT_EQ(copy.failure.initial_height, 12.5);
      EXPECT_EQ(copy.failure.initial_time, 13.5);
      EXPECT_EQ(copy.failure.initial_time_thesis, 14.5);
      EXPECT_EQ(copy.failure.flooding_time, 15.5);
      EXPECT_EQ(copy.failure.geometry.height, 16.5);
      EXPECT_EQ(copy.failure.geometry.width, 17.5);
      EXPECT_EQ(copy.failure.geometry.height_z, 18.5);
      EXPECT_EQ(copy.failure.geometry.width_z, 19.5);
      next = 300.;
      const auto expect =
        [&](const char *const name, const double number, SlidingQuantity) {
          EXPECT_EQ(number, ++next) << name;
        };
      SlidingMasses::for_each_number(copy.sliding, expect);
      ASSERT_EQ(copy.sliding.masses.size(), 2u);
      for (const SlidingMass &mass : copy.sliding.masses)
        SlidingMass::for_each_number(mass, expect);
      EXPECT_GT(next, 320.);

      ASSERT_EQ(copy.points.n_points(), 3u);
      std::vector<std::string> bytes;
      for (const State<dim> *const one : {&state, &copy})
        {
          std::string  text;
          unsigned int n_arrays = 0;
          MaterialPoints<dim>::for_each_array(
            one->points, [&](const char *const name, const auto &values) {
              ++n_arrays;
              EXPECT_EQ(values.size(), 3u) << name;
              text += name;
              text.append(reinterpret_cast<const char *>(values.data()),
                          values.size() * sizeof values[0]);
            });
          EXPECT_GE(n_arrays, 15u);
          bytes.push_back(text);
        }
      EXPECT_TRUE(bytes[0] == bytes[1]);
    }
  } // namespace


  TEST(Case, a_state_returns_from_its_bytes_with_all_its_members)
  {
    check_state<2>();
    check_state<3>();
  }
} // namespace case_state
