// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/fields/measurements.h>

#include "output_temporary_folder.h"
#include "user_errors.h"
#include <gtest/gtest.h>
#include <string>

namespace fields_measurements
{
  using namespace Waker;

  namespace
  {
    /// A file of measurements that goes when the test ends.
    class File
    {
    public:
      explicit File(const std::string &content)
        : name(folder.file("measurements.csv"))
      {
        put(name, content);
      }

    private:
      const TemporaryFolder folder;

    public:
      const std::string name;
    };



    const FieldLattice small{2,
                             {{10, 6, 1}},
                             {{0.5, 0.25, 1.}},
                             {{-1., 2., 0.}}};
  } // namespace



  TEST(Fields, measurements_are_read)
  {
    const File file("\xef\xbb\xbf# penetration test 7\r\n"
                    "\r\n"
                    "x, y, \"cone resistance\"   # m, m, kPa\r\n"
                    "-0.9, 2.1, 13.5\r\n"
                    "  4 ,3.5,  1.1e1  # upper corner of the lattice\r\n"
                    "1.2, 2.3, -4");
    const auto measurements = read_measurements(file.name, small);
    ASSERT_EQ(measurements.size(), 3u);
    EXPECT_EQ(measurements[0].position[0], -0.9);
    EXPECT_EQ(measurements[0].position[1], 2.1);
    EXPECT_EQ(measurements[0].value, 13.5);
    EXPECT_EQ(measurements[0].cell, 0u);
    EXPECT_EQ(measurements[0].line, 4u);
    EXPECT_EQ(measurements[1].cell, small.n() - 1);
    EXPECT_EQ(measurements[1].value, 11.);
    EXPECT_EQ(measurements[2].value, -4.);
    EXPECT_EQ(measurements[2].cell, 4u + 10u);
    EXPECT_EQ(measurements[2].line, 6u);

    const File line("1.5, 10\n2.5, 20\n");
    EXPECT_EQ(read_measurements(line.name,
                                {1, {{8, 1, 1}}, {{1., 1., 1.}}, {}})[1]
                .cell,
              2u);
  }



  TEST(Fields, errors_in_measurements_name_the_line)
  {
    const auto message = [](const std::string &content) -> std::string {
      const File file(content);
      try
        {
          read_measurements(file.name, small);
        }
      catch (const UserError &error)
        {
          return error.what();
        }
      return "";
    };
    const auto expect = [&](const std::string &content,
                            const std::string &part) {
      EXPECT_NE(message(content).find(part), std::string::npos)
        << message(content) << " has no " << part;
    };
    expect("x, y, value\n0, 2.1, 5\n0, 2.1\n", "measurements.csv:3");
    expect("0, 2.1, 5, 7\n", "3 numbers: x, y, value");
    expect("0, 2.1, 5kPa\n", "\"0, 2.1, 5kPa\"");
    expect("0, 2.1, nan\n", ":1");
    expect("0, 2.1, 1e999\n", ":1");
    expect("0, 2.1, 5, hard\n", ":1");
    expect("0; 2.1; 5\n", ":1");
    expect("0, 2.1, 5\nx, y, value\n", ":2");
    expect("x, y, value\nx, y, value\n", ":2");
    expect("0, 2.1,\n", ":1");
    // A first row is no row of titles, however its numbers are written.
    expect("\"0\"; \"2.1\"; \"5\"\n0, 2.1, 5\n", ":1");
    expect("0,5; 2,1; 5\n0, 2.1, 5\n", "decimals with a point");
    expect("\xef\xbb\xbf'0', 2.1, 5\n0, 2.1, 5\n", ":1");
    expect("x, y, 5\n0, 2.1, 5\n", ":1");
    expect("0, 1.9, 5\n", ":1: y = 1.9 m is outside");
    expect("4.1, 2.1, 5\n", "allowed: -1 to 4 m");
    expect("# nothing\n", "no measurements");
    EXPECT_USER_ERROR(read_measurements("/nowhere/at all.csv", small),
                      "/nowhere/at all.csv",
                      "cannot be read");
  }
} // namespace fields_measurements
