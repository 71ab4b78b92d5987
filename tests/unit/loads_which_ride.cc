// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/loads/traction_parameters.h>

#include "named.h"
#include <gtest/gtest.h>

namespace loads_which_ride
{
  using namespace Waker;

  TEST(Loads, which_tractions_ride)
  {
    TractionParameters t;
    t.name   = "load";
    t.method = TractionMethod::contour;
    EXPECT_FALSE(t.rides()); // no box
    t.from = {0., 0.};
    t.to   = {1., 1.};
    EXPECT_TRUE(t.rides());
    t.kind = TractionKind::vector;
    EXPECT_TRUE(t.rides());
    t.kind = TractionKind::hydrostatic; // a liquid
    EXPECT_FALSE(t.rides());
    t.kind = TractionKind::pressure;
    for (const char *const method : {"proximity field", "user surface"})
      {
        t.method = Named{method};
        EXPECT_TRUE(t.rides());
      }
    for (const char *const method :
         {"surface nodes", "volume", "updated points", "fixed points"})
      {
        t.method = Named{method};
        EXPECT_FALSE(t.rides()) << method;
      }
    t.method  = TractionMethod::contour;
    t.follows = TractionFollows::space;
    EXPECT_FALSE(t.rides());
    t.follows = TractionFollows::soil;
    t.from = t.to = {};
    EXPECT_TRUE(t.rides());

    // What cannot be is refused by name.
    const auto complaint = [](const char *const method,
                              const char *const follows,
                              const char *const kind) {
      TractionParameters p;
      p.name         = "load";
      p.method       = Named{method};
      p.follows      = Named{follows};
      p.kind         = Named{kind};
      p.value        = "1";
      p.level        = "1";
      p.surface_file = std::string(method) == "user surface" ? "file" : "";
      try
        {
          p.check(2,
                  p.method == TractionMethod::volume ? ShapeFunctions::linear
                                                     : ShapeFunctions::gimp);
        }
      catch (const UserError &error)
        {
          return error.where;
        }
      return std::string();
    };
    const std::string path = "Tractions/load/Follows";
    for (const char *const method : {"contour", "proximity field"})
      {
        EXPECT_EQ(complaint(method, "soil", "pressure"), "");
        EXPECT_EQ(complaint(method, "soil", "hydrostatic"), path);
        EXPECT_EQ(complaint(method, "space", "hydrostatic"), "");
      }
    EXPECT_EQ(complaint("user surface", "soil", "pressure"), "");
    for (const char *const method :
         {"surface nodes", "volume", "updated points"})
      {
        EXPECT_EQ(complaint(method, "soil", "pressure"), path) << method;
        EXPECT_EQ(complaint(method, "space", "pressure"), "") << method;
      }
    EXPECT_EQ(complaint("fixed points", "soil", "pressure"), "");
    EXPECT_EQ(complaint("fixed points", "automatic", "pressure"), "");
    EXPECT_EQ(complaint("fixed points", "space", "pressure"), path);
  }
} // namespace loads_which_ride
