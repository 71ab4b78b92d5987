// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/errors.h>
#include <waker/campaign/input.h>
#include <waker/campaign/random_properties.h>
#include <waker/case/case.h>
#include <waker/program/declared_parameters.h>
#include <waker/program/parameter_reader.h>

#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <set>
#include <unistd.h>

namespace program_fuzz
{
  // Every parameter that there is, with values that nobody should give: they
  // are accepted or refused, and nothing else happens.

  using namespace Waker;

  namespace
  {
    /// A small case with something of everything. What is not given here has
    /// its default.
    const std::string small_case = R"(
subsection Grid
  set Lower corner = 0, 0
  set Upper corner = 4, 2
  set Cell size    = 1
end
subsection Materials
  set Names = clay
  subsection clay
    set Initial strength  = 10
    set Residual strength = 5
    set Softening modulus = -5
  end
end
subsection Soil profile
  set Layers = dyke
  subsection dyke
    set Material = clay
    set Polygon  = 0, 0; 4, 0; 4, 1; 0, 1
  end
end
subsection Boundary conditions
  set Names = base, side
  subsection base
    set Region = bottom
  end
  subsection side
    set Region       = left
    set Type         = prescribed
    set Displacement = 0.001*t; free
  end
end
subsection Pore water
  set Phreatic line = -1, -1; 5, -1
end
subsection Head lines
  set Names = aquifer
  subsection aquifer
    set Line = -1, -1; 5, -1
  end
end
subsection Reference lines
  set Names = ground
  subsection ground
    set Line             = -1, -1.5; 5, -1.5
    set Bottom head line = aquifer
  end
end
subsection Tractions
  set Names = wind
  subsection wind
    set Method = contour
    set Value  = 0; -1
    set Kind   = vector
  end
end
subsection Point loads
  set Names = man
  subsection man
    set From  = 2, 1
    set Force = 0, -1
  end
end
subsection Walls
  set Names = wall
  subsection wall
    set Line = 4, 0; 4, 1
  end
end
subsection Inflow
  set Names = in
  subsection in
    set Face     = right
    set Material = clay
    set Velocity = 1
  end
end
subsection Random fields
  set Names = strength
  subsection strength
    set Coefficient of variation = 0.1
  end
end
)";


    /// Good nowhere but in names and texts.
    const std::vector<std::string> never_good =
      {"0,25", "1e400", "1e308", "1e-300", "nan", "inf", "0x10", "rand()"};


    /// What wrong hands and wrong habits type; first what is never good.
    std::vector<std::string>
    odd_values()
    {
      std::vector<std::string>       values  = never_good;
      const std::vector<std::string> at_some = {"",
                                                "-inf",
                                                "1e-320",
                                                "-1e-320",
                                                "0",
                                                "-1",
                                                "0;25",
                                                "1; 2",
                                                "1: 2: 3",
                                                ";;;",
                                                ",,,",
                                                "1 2",
                                                "18446744073709551616",
                                                "text",
                                                "\"",
                                                "((",
                                                std::string(40000, '1'),
                                                std::string(40000, ',')};
      values.insert(values.end(), at_some.begin(), at_some.end());
      return values;
    }


    /// All parameters that are these, and a list of whole numbers, in which
    /// 0,25 are two.
    const std::set<std::string> texts = {"Output/Directory",
                                         "Risk/Level table",
                                         "Snapshots/Realisations"};


    enum class Answer
    {
      accepted,
      refused
    };


    /// Read and set up a case as `waker run --validate` does.
    /// Anything but a UserError or a NumericalFailure is let through.
    Answer
    validate(const std::string &file, const std::vector<std::string> &overrides)
    {
      try
        {
          const auto   scenarios = read_scenarios(file, overrides);
          const Input &input     = *scenarios[0];
          if (input.simulation.dimension == 2)
            {
              const Case<2> the_case(input.simulation, MPI_COMM_SELF);
              const RandomProperties<2> properties(the_case,
                                                   input.reliability.fields);
            }
        }
      catch (const UserError &error)
        {
          EXPECT_FALSE(error.where.empty());
          EXPECT_FALSE(error.problem.empty());
          EXPECT_FALSE(error.allowed.empty());
          EXPECT_LT(error.problem.size(), 100000u);
          return Answer::refused;
        }
      catch (const NumericalFailure &)
        {
          return Answer::refused;
        }
      return Answer::accepted;
    }
  } // namespace


  /// Of the case in a file of its own.
  class OddValues
  {
  public:
    const std::string file =
      testing::TempDir() + "waker_fuzz_" + std::to_string(getpid()) + ".prm";

    std::vector<DeclaredParameter> parameters;

    void
    try_values(const std::function<bool(const std::size_t parameter,
                                        const std::size_t value)> &takes);

    OddValues()
    {
      std::ofstream(file) << small_case;
      Input            input;
      ParameterHandler prm;
      declare_parameters(prm,
                         input,
                         {{"clay"},
                          {"dyke"},
                          {"base", "side"},
                          {"aquifer"},
                          {"ground"},
                          {"wind"},
                          {"man"},
                          {"grows"},
                          {"wall"},
                          {"out"},
                          {"in"},
                          {"strength"}});
      parameters = declared_parameters(prm);
    }

    ~OddValues()
    {
      ::unlink(file.c_str());
    }
  };


  TEST(Fuzz, the_case_itself_is_good)
  {
    const OddValues odd;
    EXPECT_EQ(validate(odd.file, {}), Answer::accepted);
    EXPECT_GT(odd.parameters.size(), 150u);
  }


  /// Each parameter with each value that `takes` says it shall get.
  void
  OddValues::try_values(
    const std::function<bool(const std::size_t parameter,
                             const std::size_t value)> &takes)
  {
    unsigned int                   n_refused = 0, n_texts = 0, n_never = 0;
    const std::vector<std::string> values = odd_values();
    for (std::size_t p = 0; p < parameters.size(); ++p)
      for (std::size_t v = 0; v < values.size(); ++v)
        {
          const DeclaredParameter &parameter = parameters[p];
          const std::string       &value     = values[v];
          if (!takes(p, v))
            continue;
          const std::string override_text = parameter.path() + "=" + value;
          SCOPED_TRACE(override_text.substr(0, 200));
          try
            {
              const Answer answer = validate(file, {override_text});
              // These are no numbers, wherever numbers are wanted.
              const bool wants_number =
                parameter.pattern.find("[Double") == 0 ||
                parameter.pattern.find("[Integer") == 0;
              const bool is_none =
                value.empty() || value == "1e400" || value == "1e308" ||
                value.find_first_not_of("-0123456789e") != std::string::npos;
              const bool is_never = v < never_good.size();
              const bool is_text  = texts.count(parameter.path()) > 0;
              if ((wants_number && is_none) || (is_never && !is_text))
                {
                  EXPECT_EQ(answer, Answer::refused);
                }
              n_refused +=
                is_never && !is_text && answer == Answer::refused ? 1 : 0;
              n_texts += is_never && is_text ? 1 : 0;
              n_never += is_never ? 1 : 0;
            }
          catch (const std::exception &error)
            {
              ADD_FAILURE() << "neither accepted nor refused: " << error.what();
            }
          catch (...)
            {
              ADD_FAILURE() << "no exception that a program can catch";
            }
        }
    EXPECT_EQ(n_refused + n_texts, n_never);
    EXPECT_GE(n_never, parameters.size()); // each gets one at least
    EXPECT_LE(n_texts, texts.size() * never_good.size());
  }


  TEST(Fuzz, every_parameter_with_odd_values_is_accepted_or_refused)
  {
    // In turn: each gets one that is never good, and two or three others.
    OddValues().try_values(
      [](const std::size_t parameter, const std::size_t value) {
        return (parameter + value) % never_good.size() == 0;
      });
  }


  TEST(Long, program_fuzz_every_parameter_with_every_odd_value)
  {
    OddValues().try_values(
      [](const std::size_t, const std::size_t) { return true; });
  }
} // namespace program_fuzz
