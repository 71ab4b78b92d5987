// SPDX-License-Identifier: LGPL-2.1-or-later
// Parameters of nonlocal softening: what is refused, and what is told.
#include <waker/base/errors.h>
#include <waker/program/parameter_reader.h>
#include <waker/simulation/plausibility.h>

#include "program_case.h"
#include "warnings.h"
#include <gtest/gtest.h>

namespace program_nonlocal
{
  using namespace Waker;
  using namespace ProgramCase;

  namespace
  {
    const std::string clay   = "Materials/clay/";
    const std::string length = clay + "Averaging length";


    std::vector<std::string>
    nonlocal(const std::vector<std::string> &more)
    {
      std::vector<std::string> all = {clay + "Regularisation=nonlocal"};
      all.insert(all.end(), more.begin(), more.end());
      return all;
    }


    std::vector<std::string>
    warnings(const std::vector<std::string> &overrides)
    {
      return strange_parameters(
        *read_parameters(write_case(good_case), overrides));
    }


    void
    expect_warning(const std::vector<std::string> &overrides,
                   const std::string              &text)
    {
      const std::string all = Warnings::joined(warnings(overrides));
      EXPECT_TRUE(Warnings::has(all, text))
        << "no \"" << text << "\" in: " << all;
    }


    /// @param text in the error
    void
    expect_error(const std::vector<std::string> &overrides,
                 const std::string              &path,
                 const std::string              &text)
    {
      try
        {
          read_parameters(write_case(good_case), overrides);
          ADD_FAILURE() << "no error: " << overrides.back();
        }
      catch (const UserError &error)
        {
          EXPECT_NE(error.where.find(path), std::string::npos) << error.what();
          EXPECT_NE(std::string(error.what()).find(text), std::string::npos)
            << error.what();
          EXPECT_FALSE(error.allowed.empty()) << error.what();
        }
    }
  } // namespace


  TEST(Program, nonlocal_softening_that_is_right)
  {
    EXPECT_TRUE(warnings(nonlocal({length + "=0.5"})).empty());
    EXPECT_TRUE(warnings(nonlocal({length + "=0.25"})).empty());
    EXPECT_TRUE(warnings(nonlocal({length + "=0.5",
                                   clay + "Neighbour weight=Gaussian",
                                   clay + "Over-weight=1.5"}))
                  .empty());
    // Soil that does not soften needs no length.
    expect_warning(nonlocal({clay + "Model=linear elastic"}),
                   "soil that does not soften");
  }


  TEST(Program, averaging_lengths_that_are_refused)
  {
    // Points are 0.125 m apart.
    expect_error(nonlocal({}), length, "is 0 m");
    expect_error(nonlocal({length + "=0.12"}), length, "0.125 m");
    expect_error(nonlocal({length + "=0.5", "Grid/Cell size=1.5"}),
                 length,
                 "0.75 m");
    expect_error(nonlocal({length + "=1e5"}), length, "longer than the grid");
    for (const char *const value : {"-1", "1e+308", "nan", "inf"})
      {
        expect_error(nonlocal({length + "=" + value}), length, value);
        expect_error({length + "=" + value}, length, value); // unused
      }
    for (const char *const value : {"0.5", "11", "nan", "-2", "1e+308"})
      {
        const std::string n = clay + "Over-weight";
        expect_error(nonlocal({length + "=0.5", n + "=" + value}), n, value);
        expect_error({n + "=" + value}, n, value);
      }
    expect_error({clay + "Regularisation=gradient"},
                 clay + "Regularisation",
                 "gradient");
    expect_error({clay + "Neighbour weight=hat"},
                 clay + "Neighbour weight",
                 "hat");
    // A body that softens alike snaps back with the modulus as it is.
    expect_error(nonlocal({length + "=0.5", clay + "Softening modulus=-600"}),
                 clay + "Softening modulus",
                 "snap-back");
  }


  TEST(Program, averages_that_are_strange)
  {
    expect_warning(nonlocal({length + "=0.2"}),
                   "only 1.6 times the distance between points");
    expect_warning(nonlocal({length + "=20"}),
                   "18432 points each, 100 % of what the grid");
    expect_warning(nonlocal({length + "=0.5", clay + "Over-weight=1"}),
                   "Over-weight is 1");
    expect_warning(nonlocal({length + "=0.5", clay + "Softening modulus=-500"}),
                   "softening lags five steps or more");
    expect_warning(nonlocal({length + "=0.5", clay + "Softening length=0.25"}),
                   "Softening length is not used with Regularisation = "
                   "nonlocal");
    for (const std::string &unused : {length + "=0.5",
                                      clay + "Over-weight=3",
                                      clay + "Neighbour weight=Gaussian"})
      expect_warning({unused},
                     "not used with Regularisation = softening length");
  }
} // namespace program_nonlocal
