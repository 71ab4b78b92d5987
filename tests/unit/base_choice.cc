// SPDX-License-Identifier: LGPL-2.1-or-later
// Choices by their names: a wrong one must throw, wherever it comes from.
#include <deal.II/base/parameter_handler.h>

#include <waker/base/choice_parameter.h>
#include <waker/campaign/input.h>
#include <waker/program/parameter_printer.h>

#include "user_errors.h"
#include <gtest/gtest.h>

namespace base_choice
{
  using namespace Waker;

  namespace
  {
    enum class Colour
    {
      red,
      dark_red,
      blue
    };

    constexpr const char *
    name_of(const Colour colour)
    {
      switch (colour)
        {
          case Colour::red:
            return "red";
          case Colour::dark_red:
            return "dark red";
          case Colour::blue:
            return "blue";
        }
      return nullptr;
    }


    /// Every name is that of its value, and no other.
    template <typename Choice>
    void
    check_names(const std::size_t n)
    {
      const std::vector<Choice> all = all_choices<Choice>();
      EXPECT_EQ(all.size(), n);
      std::size_t n_checked = 0;
      for (const Choice choice : all)
        {
          SCOPED_TRACE(name_of(choice));
          EXPECT_EQ(choice_named<Choice>(name_of(choice), "A/B"), choice);
          for (const std::string &wrong : {std::string(name_of(choice)) + " ",
                                           std::string(name_of(choice)) + "s",
                                           std::string("")})
            EXPECT_USER_ERROR(choice_named<Choice>(wrong, "A/B"),
                              "A/B",
                              wrong + "\"");
          ++n_checked;
        }
      EXPECT_EQ(n_checked, n);
    }
  } // namespace


  TEST(Base, choice_has_one_table_of_names)
  {
    EXPECT_EQ(choice_list<Colour>(), "red, dark red, blue");
    EXPECT_EQ(choice_list<Colour>("|"), "red|dark red|blue");
    EXPECT_EQ(find_choice<Colour>("dark red"), Colour::dark_red);
    EXPECT_FALSE(find_choice<Colour>("red|dark red"));
    EXPECT_USER_ERROR(choice_named<Colour>("green", "Wall/Colour"),
                      "Wall/Colour",
                      "is \"green\"");
  }


  TEST(Base, choice_is_an_entry)
  {
    ParameterHandler prm;
    Colour           colour = Colour::blue;
    add_choice(prm, "Colour", colour, "Of the wall.");
    EXPECT_EQ(prm.get("Colour"), "blue");
    EXPECT_EQ(colour, Colour::blue);
    prm.set("Colour", "dark red");
    EXPECT_EQ(colour, Colour::dark_red);
    EXPECT_ANY_THROW(prm.set("Colour", "green"));
    EXPECT_EQ(colour, Colour::dark_red);
  }


  TEST(Base, names_of_all_choices)
  {
    check_names<Scheme>(4);
    check_names<Tangent>(2);
    check_names<StrainMeasure>(2);
    check_names<VolumetricStrain>(3);
    check_names<SupportDomains>(2);
    check_names<ShapeFunctions>(2);
    check_names<Placement>(3);
    check_names<BoxFace>(6);
    check_names<FixityRegion>(7);
    check_names<FixityType>(3);
    check_names<FixityMethod>(2);
    check_names<MaterialModel>(4);
    check_names<FrictionHolds>(2);
    check_names<VonMisesSoftening::Invariant>(2);
    check_names<Regularisation>(2);
    check_names<NeighbourWeight>(2);
    check_names<WaterSide>(3);
    check_names<SurfaceMethod>(2);
    check_names<TractionMethod>(7);
    check_names<TractionKind>(3);
    check_names<TractionFollows>(3);
    check_names<WallType>(3);
    check_names<Watched>(8);
    check_names<LoadProgrammeKind>(3);
    check_names<LoadTarget>(4);
    check_names<LoadedPoints>(2);
    check_names<LoadMass>(2);
    check_names<FieldProperty>(18);
    check_names<PorePressureOf>(2);
    check_names<StressFrom>(2);
    check_names<BalanceLaws>(2);
    check_names<FieldStatistics>(2);
    check_names<Marginal::Kind>(4);
    check_names<Correlation::Function>(3);
    check_names<Generator>(3);
    check_names<FailureReading>(4);
    check_names<CampaignTarget>(2);
    check_names<LevelSource>(3);
    check_names<ParameterFormat>(4);
  }


  TEST(Base, faces_come_first_among_regions)
  {
    for (const BoxFace face : all_choices<BoxFace>())
      EXPECT_STREQ(name_of(face), name_of(region_of(face)));
  }
} // namespace base_choice
