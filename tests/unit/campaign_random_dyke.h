// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_campaign_random_dyke_h
#define waker_tests_campaign_random_dyke_h

#include <waker/campaign/input.h>
#include <waker/campaign/random_properties.h>
#include <waker/program/parameter_reader.h>

#include <memory>
#include <string>
#include <vector>

/// The dyke of chapter 5, coarse, with its random field, for the tests of
/// random properties.
namespace RandomDyke
{
  using namespace Waker;

  inline const std::string base_case =
    WAKER_SOURCE_DIRECTORY "/parameters/chapter5/analysis1.prm";
  inline const std::string field = "Random fields/strength/";

  /// Coarse: four points per metre.
  inline std::unique_ptr<Input>
  coarse(std::vector<std::string> overrides)
  {
    overrides.push_back("Grid/Cell size=0.5");
    return std::move(read_scenarios(base_case, overrides)[0]);
  }


  struct Drawn
  {
    Drawn(const Input &input, const std::uint64_t realisation = 0)
      : the_case(input.simulation, MPI_COMM_SELF)
      , properties(the_case, input.reliability.fields)
      , state(initial_state(the_case))
    {
      const std::vector<double> noise =
        realisation_noise(1, realisation, properties.n_noise());
      properties.apply(noise.data(), state);
    }

    const std::vector<double> &
    values(const std::string &name) const
    {
      return state.points.scalars[state.points.find_scalar(name)].values;
    }

    const std::vector<double> &
    strength() const
    {
      return values("undrained shear strength");
    }

    Case<2>             the_case;
    RandomProperties<2> properties;
    State<2>            state;
  };
} // namespace RandomDyke

#endif
