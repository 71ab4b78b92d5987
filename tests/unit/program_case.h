// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_program_case_h
#define waker_tests_program_case_h

#include "output_temporary_folder.h"
#include <gtest/gtest.h>
#include <string>

/// A case on disk, for the tests of reading.
namespace ProgramCase
{
  /// A complete case; line numbers below count in it.
  inline const std::string good_case = R"(# line 1
subsection Grid
  set Lower corner = -6, 0
  set Upper corner = 42, 6
  set Cell size    = 0.25 # line 5
end
subsection Materials
  set Names = clay
  subsection clay
    set Initial strength  = 10 # line 10
    set Residual strength = 3.85
    set Poisson's ratio   = 0.45
  end
end
subsection Soil profile # line 15
  set Layers = dyke
  subsection dyke
    set Material = clay
    set Polygon  = 0, 0; 30, 0; \
                   15, 5; 5, 5
  end
end
subsection Boundary conditions
  set Names = base
  subsection base # line 25
    set Region = bottom
  end
end
subsection Water
  set Side  = left # line 30
  set Level = 4.75
end
)";


  inline std::string
  write_case(const std::string &text)
  {
    // Tests may run at the same time, each in a process.
    return Waker::put_for_process("program_input.prm", text);
  }


  /// The good case with one piece of text replaced.
  inline std::string
  with(const std::string &from, const std::string &to)
  {
    std::string       text     = good_case;
    const std::size_t position = text.find(from);
    EXPECT_NE(position, std::string::npos) << from;
    return text.replace(position, from.size(), to);
  }
} // namespace ProgramCase

#endif
