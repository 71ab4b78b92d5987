// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_campaign_layered_ground_h
#define waker_tests_campaign_layered_ground_h

#include <waker/campaign/input.h>
#include <waker/campaign/random_properties.h>
#include <waker/program/parameter_reader.h>

#include "level_ground.h"
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <vector>

/// Level ground for random fields of layers: 2 m of sand on 2 m of clay on 2 m
/// of peat, the water at 4 m and daily at 3.5 m; 256 points a layer.
namespace LayeredGround
{
  using namespace Waker;

  constexpr double gamma_w = 10.;

  inline std::unique_ptr<Input>
  ground(const std::vector<std::string> &more)
  {
    const std::string text = LevelGround::text_of({8.,
                                                   7.,
                                                   {{"top", "sand", 4., 6.},
                                                    {"middle", "clay", 2., 4.},
                                                    {"below", "peat", 0., 2.}},
                                                   R"(
subsection Materials
  set Names = sand, clay, peat
  subsection sand
    set Model                 = Mohr-Coulomb
    set Unit weight           = 17
    set Saturated unit weight = 20
    set Friction angle        = 33
    set Dilatancy angle       = 3
  end
  subsection clay
    set Unit weight       = 15
    set Strength from     = SHANSEP
    set Strength ratio    = 0.3
    set Strength exponent = 0.9
    set POP               = 15
    set Residual strength = initial_strength/2
  end
  subsection peat
    set Unit weight       = 11
    set Strength from     = SHANSEP
    set Strength ratio    = 0.36
    set Strength exponent = 0.85
    set POP               = 20
    set Residual strength = 1
  end
end
)",
                                                   R"(
subsection Pore water
  set Phreatic line       = 0, 4; 8, 4
  set Daily phreatic line = 0, 3.5; 8, 3.5
end
subsection Random fields
  set Names = a
  subsection a
    set Material             = clay
    set Property             = strength ratio
    set Scales of fluctuation = 8, 1
  end
end
)"});
    return std::move(read_scenarios(LevelGround::written(text), more)[0]);
  }


  struct Drawn
  {
    explicit Drawn(const std::vector<std::string> &more,
                   const std::uint64_t             realisation = 0)
      : input(ground(more))
      , the_case(input->simulation, MPI_COMM_SELF)
      , properties(the_case, input->reliability.fields)
      , state(initial_state(the_case))
    {
      draw(realisation);
    }

    void
    draw(const std::uint64_t realisation)
    {
      state = initial_state(the_case);
      properties.apply(
        realisation_noise(1, realisation, properties.n_noise()).data(), state);
    }

    const std::vector<double> &
    values(const std::string &name) const
    {
      const MaterialPoints<2> &points = state.points;
      return points.scalar(name);
    }

    /// Of the material of this number.
    std::vector<std::size_t>
    points_of(const unsigned int material) const
    {
      std::vector<std::size_t> list;
      for (std::size_t q = 0; q < state.points.n_points(); ++q)
        if (state.points.material[q] == material)
          list.push_back(q);
      return list;
    }

    std::unique_ptr<Input> input;
    Case<2>                the_case;
    RandomProperties<2>    properties;
    State<2>               state;
  };


  /// Effective vertical stress (kPa) of the ground's own weights, at the height
  /// y below the sand; the water stands at `water`, at most 4 m.
  inline double
  stress(const double y, const double water)
  {
    const double soil =
      2. * 17. + (y < 2. ? 2. * 15. + (2. - y) * 11. : (4. - y) * 15.);
    return soil - gamma_w * std::max(water - y, 0.);
  }
} // namespace LayeredGround

#endif
