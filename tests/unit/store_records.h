// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_store_records_h
#define waker_tests_store_records_h

#include <waker/store/campaign_info.h>
#include <waker/store/record.h>

#include <gtest/gtest.h>

namespace Waker
{
  /// A dyke that stands (even numbers) or slides twice and floods (odd ones).
  /// store_opens.py knows these numbers.
  inline Record
  synthetic_record(const unsigned int scenario, const std::uint64_t i)
  {
    const double k = static_cast<double>(i);

    Record record;
    record.scenario          = scenario;
    record.realisation       = i;
    record.stop_reason       = "end \"of\" time, 40 s";
    record.end_time          = 40.;
    record.initial_width     = 18. + scenario;
    record.initial_height    = 5.;
    record.residual_width    = record.initial_width;
    record.residual_height   = 5.;
    record.mean_strength     = 13. + 1. / (3. + k);
    record.least_strength    = 9. - 0.1 * k;
    record.steps             = 800 + i;
    record.newton_iterations = 2000;
    record.linear_iterations = 3000000000000u;
    record.wall_time         = 0.25;
    record.field_time        = 1e-3;
    if (i % 2 == 1)
      {
        record.outcome             = Outcome::flooding;
        record.attempts            = 2;
        record.initial_time        = 3.1 + 0.01 * k;
        record.initial_time_thesis = record.initial_time + 0.1;
        record.flooding_time       = 9.;
        record.residual_width      = 0.;
        record.residual_height     = 2. + 0.01 * k;
        record.inward              = {30. + k, 4.5, -1.25};
        record.first_inward        = {21., 1.5, -0.75};
        record.trace               = {{0., record.initial_width, 5.},
                                      {3., record.initial_width, 5.},
                                      {4., 12. - 0.01 * k, 5.},
                                      {7., 12. - 0.01 * k, 5.},
                                      {9., 0., record.residual_height},
                                      {40., 0., record.residual_height}};
      }
    return record;
  }


  /// Two slides of a slope in 3D, or of one in the plane.
  inline SlidingMasses
  synthetic_masses(const unsigned int dim)
  {
    SlidingMasses sliding;
    sliding.whole_volume         = 24.25;
    sliding.failed_volume        = 0.1 + 0.2; // more digits than it prints
    sliding.retrogression        = 1. / 3.;
    sliding.largest_displacement = 0.125;
    if (dim == 3)
      sliding.damaged_crest_width = 4.25;
    for (unsigned int k = 0; k < 2; ++k)
      {
        SlidingMass &mass = sliding.masses.emplace_back();
        mass.time         = 1.5 + 0.1 * k;
        mass.volume       = 0.2 - 0.1 * k;
        for (unsigned int d = 0; d < dim; ++d)
          {
            mass.centre[d] = 1.5 * d - k;
            mass.lower[d]  = mass.centre[d] - 1. / 7.;
            mass.upper[d]  = mass.centre[d] + 1.;
          }
        if (dim == 3)
          mass.width = 0.7;
      }
    return sliding;
  }


  inline CampaignInfo
  synthetic_campaign()
  {
    CampaignInfo info;
    info.version         = "0.1.0";
    info.compiler        = "g++";
    info.build_flags     = "-O3";
    info.seed            = 18446744073709551557u; // more than a double holds
    info.realisations    = 8;
    info.hash            = "0123abcd";
    info.swept_parameter = "Water/Level";
    info.scenarios       = {{"4.5", 4.5, 5., 0., {6., 0.5}, "aa"},
                            {"3,5 µm", 3.5, 5., 0., {}, "bb"}};
    info.parameters      = "# \"quoted\"\nsubsection Water\nend\n";
    return info;
  }


  /// The text with a part of it, which is there, as another one.
  inline std::string
  replaced(std::string text, const std::string &from, const std::string &to)
  {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  }
} // namespace Waker

#endif
