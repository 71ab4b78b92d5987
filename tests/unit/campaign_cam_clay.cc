// SPDX-License-Identifier: LGPL-2.1-or-later
// Random fields of what modified Cam clay starts from.
#include "cam_clay_ground.h"
#include "campaign_layered_ground.h"
#include "user_errors.h"
#include <algorithm>

namespace campaign_cam_clay
{
  using namespace Waker;
  using CamClayGround::isotropic_share;

  TEST(CamClayGround, random_fields_of_what_it_starts_from)
  {
    using LayeredGround::Drawn;
    const std::string        a    = "Random fields/a/";
    std::vector<std::string> soil = {"Materials/clay/Model=modified Cam clay",
                                     "Materials/clay/Friction angle=25",
                                     "Materials/clay/Strength from=initial "
                                     "strength",
                                     "Materials/clay/POP=15"};
    const auto               with = [&](std::vector<std::string> more) {
      more.insert(more.begin(), soil.begin(), soil.end());
      return more;
    };
    const Drawn pop(with({a + "Property=POP", a + "Standard deviation=3.5"}));
    double      least = 1e9, most = 0.;
    for (const std::size_t q : pop.points_of(1))
      {
        const double y = pop.state.points.initial_position[q][1];
        const double x = pop.values("POP")[q];
        least          = std::min(least, x);
        most           = std::max(most, x);
        ASSERT_NEAR(pop.values("preconsolidation pressure")[q],
                    isotropic_share() * (LayeredGround::stress(y, 3.5) + x),
                    1e-9);
      }
    EXPECT_GT(most - least, 5.);
    const Drawn ocr(with({"Random fields/Names=a, b",
                          a + "Property=OCR",
                          a + "Mean=1.5",
                          "Random fields/b/Material=clay",
                          "Random fields/b/Property=friction angle",
                          "Random fields/b/Coefficient of variation=0.1"}));
    ASSERT_FALSE(ocr.points_of(1).empty());
    for (const std::size_t q : ocr.points_of(1))
      {
        const double y = ocr.state.points.initial_position[q][1];
        const double given =
          isotropic_share() *
          (LayeredGround::stress(y, 3.5) * ocr.values("OCR")[q] + 15.);
        ASSERT_GE(ocr.values("preconsolidation pressure")[q], given - 1e-9);
        ASSERT_NE(ocr.values("friction angle")[q], 25.);
      }
    const Drawn own(with({a + "Property=preconsolidation pressure",
                          a + "Coefficient of variation=0.2"}));
    EXPECT_NE(own.values("preconsolidation pressure")[own.points_of(1)[0]],
              own.the_case.initial_points.scalar(
                "preconsolidation pressure")[own.points_of(1)[0]]);
    EXPECT_USER_ERROR(
      Drawn(with({"Random fields/Names=a, b",
                  a + "Property=POP",
                  a + "Standard deviation=3.5",
                  "Random fields/b/Material=clay",
                  "Random fields/b/Property=preconsolidation pressure"})),
      "Random fields/b/Property",
      "follows from what has a field, too");
    EXPECT_USER_ERROR(Drawn(with(
                        {a + "Property=Young's modulus", a + "Minimum=100"})),
                      "Random fields/a/Property",
                      "does not have");
  }


  TEST(CamClayGround, an_OCR_below_1_counts_as_1_and_is_counted)
  {
    using LayeredGround::Drawn;
    const std::string a     = "Random fields/a/";
    const auto        drawn = [&](const std::string &mean,
                           const std::string &minimum) {
      return Drawn({"Materials/clay/Model=modified Cam clay",
                    "Materials/clay/Friction angle=25",
                    "Materials/clay/Strength from=initial strength",
                    "Materials/clay/POP=15",
                    a + "Property=OCR",
                    a + "Mean=" + mean,
                    a + "Coefficient of variation=0.2",
                    a + "Minimum=" + minimum});
    };
    const Drawn low = drawn("1.2", "0");
    std::size_t n   = 0;
    for (const std::size_t q : low.points_of(1))
      if (low.values("OCR")[q] < 1.)
        {
          ++n;
          const double y = low.state.points.initial_position[q][1];
          ASSERT_NEAR(low.values("preconsolidation pressure")[q],
                      isotropic_share() * (LayeredGround::stress(y, 3.5) + 15.),
                      1e-9);
        }
    ASSERT_GT(n, 5u);
    EXPECT_EQ(low.properties.n_beyond_law(low.state), n);
    const auto lines = low.properties.cut_off(low.state);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].find("Random fields: at " + std::to_string(n) +
                            " of 256 points of the material \"clay\" the OCR "
                            "counts as the least that its law takes"),
              0u)
      << lines[0];
    EXPECT_NE(lines[0].find("allowed at least 1"), std::string::npos)
      << lines[0];
    // The control: a minimum of the field is no matter of the law.
    const Drawn cut = drawn("1.2", "1");
    EXPECT_EQ(cut.properties.n_beyond_law(cut.state), std::uint64_t(0));
    // On the average it is bad input, as in a material.
    EXPECT_NO_THROW(drawn("1", "0"));
    EXPECT_USER_ERROR(drawn("0.99", "0"),
                      "Random fields/a/Mean",
                      "makes the OCR 0.99 at (");
  }
} // namespace campaign_cam_clay
