// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>

#include "campaign_random_dyke.h"
#include "output_temporary_folder.h"
#include <gtest/gtest.h>

namespace campaign_measurements
{
  namespace
  {
    using namespace RandomDyke;


    /// A file of measurements that goes away again.
    struct Measured
    {
      explicit Measured(const std::string &lines)
      {
        put(name, lines);
      }

      const TemporaryFolder folder;
      const std::string     name = folder.file("measured.csv");
    };


    TEST(RandomProperties, measurements_are_kept)
    {
      const Measured measured("10.1, 2.1, 7.5\n16.1, 3.1, 16\n");
      for (const std::string &form :
           {std::string("normal"), std::string("lognormal")})
        for (const std::string &statistics :
             {std::string("cells"), std::string("points")})
          {
            const Drawn  drawn(*coarse({field + "Measurements=" + measured.name,
                                        field + "Distribution=" + form,
                                        field + "Statistics of=" + statistics}));
            unsigned int found = 0;
            for (std::size_t q = 0; q < drawn.strength().size(); ++q)
              {
                const Point<2> &x = drawn.state.points.position[q];
                for (const double value : {7.5, 16.})
                  if (x.distance(value < 10. ? Point<2>(10.125, 2.125)
                                             : Point<2>(16.125, 3.125)) < 1e-6)
                    {
                      EXPECT_NEAR(drawn.strength()[q], value, 1e-9);
                      ++found;
                    }
              }
            EXPECT_EQ(found, 2u);
          }
    }


    TEST(RandomProperties, impossible_measurements_are_refused)
    {
      const auto problem = [](const std::string              &line,
                              const std::vector<std::string> &overrides) {
        const Measured           measured("20.1, 3.1, 12\n" + line + "\n");
        std::vector<std::string> all = overrides;
        all.push_back(field + "Measurements=" + measured.name);
        try
          {
            const Drawn drawn(*coarse(all));
          }
        catch (const UserError &error)
          {
            EXPECT_EQ(error.where, field + "Measurements");
            return error.problem + "|" + error.allowed;
          }
        return std::string("nothing");
      };
      const auto has = [](const std::string &text, const std::string &part) {
        return text.find(part) != std::string::npos ? "" : text;
      };
      const std::string form = field + "Distribution=";
      EXPECT_EQ(problem("10.1, 2.1, 0", {}), "nothing"); // at the limit
      EXPECT_EQ(has(problem("10.1, 2.1, -1", {}), "value -1 at (10.1, 2.1)"),
                "");
      EXPECT_EQ(has(problem("10.1, 2.1, -1", {}), "at least 0"), "");
      EXPECT_EQ(has(problem("10.1, 2.1, 31", {field + "Maximum=30"}),
                    "at most 30"),
                "");
      EXPECT_EQ(has(problem("10.1, 2.1, 0", {form + "lognormal"}), "above 0"),
                "");
      EXPECT_EQ(has(problem("10.1, 2.1, 0", {form + "truncated normal"}),
                    "above 0"),
                "");
      EXPECT_EQ(has(problem("10.1, 2.1, 30",
                            {form + "beta", field + "Maximum=30"}),
                    "below 30"),
                "");
      EXPECT_EQ(has(problem("10.1, 2.1, 9",
                            {field + "Coefficient of variation=0"}),
                    "no spread"),
                "");
      // Beside the slope, inside the box around the dyke.
      EXPECT_EQ(has(problem("0.6, 4.6, 9", {}), "no points"), "");
    }
  } // namespace
} // namespace campaign_measurements
