// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/read_file.h>
#include <waker/base/text.h>
#include <waker/fields/measurements.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace Waker
{
  namespace
  {
    const char *
    columns(const unsigned int dim)
    {
      return dim == 1   ? "x, value"
             : dim == 2 ? "x, y, value"
                        : "x, y, z, value";
    }



    /// @throws UserError the place is outside the lattice
    void
    check_inside(const Measurement  &measurement,
                 const FieldLattice &lattice,
                 const std::string  &where)
    {
      const char *names = "xyz";
      for (unsigned int d = 0; d < lattice.dim; ++d)
        {
          const double x     = measurement.position[d];
          const double lower = lattice.origin[d];
          const double upper =
            lower + lattice.n_cells[d] * lattice.cell_size[d];
          const double rounding = 1e-9 * lattice.cell_size[d];
          if (x < lower - rounding || x > upper + rounding)
            {
              std::ostringstream problem, allowed;
              problem << names[d] << " = " << x
                      << " m is outside the random field";
              allowed << lower << " to " << upper << " m";
              throw UserError(where, problem.str(), allowed.str());
            }
        }
    }
  } // namespace



  std::vector<Measurement>
  read_measurements(const std::string &file, const FieldLattice &lattice)
  {
    std::string text;
    try
      {
        text = read_input_file(file);
      }
    catch (const UserError &error)
      {
        throw UserError(file,
                        "the measurements: " + error.problem,
                        error.allowed + " with \"" + columns(lattice.dim) +
                          "\" in each line");
      }
    std::istringstream in(text);

    std::vector<Measurement> measurements;
    bool                     header_possible = true;
    unsigned int             number          = 0;
    for (std::string line; std::getline(in, line);)
      {
        ++number;
        if (number == 1)
          line = without_byte_order_mark(line);
        line = tidy(line.substr(0, line.find('#')));
        if (line.empty())
          continue;
        const bool is_first = header_possible;
        header_possible     = false;
        if (is_first && may_be_titles(line))
          continue;

        const std::string where = file + ":" + std::to_string(number);
        const std::vector<std::string> texts = split(line, ',');
        std::vector<double>            numbers(texts.size());
        bool                           good = texts.size() == lattice.dim + 1;
        for (std::size_t i = 0; i < texts.size(); ++i)
          good = read_number(texts[i], numbers[i]) && good;
        if (!good)
          throw UserError(where,
                          in_quotes(line),
                          std::to_string(lattice.dim + 1) +
                            " numbers: " + columns(lattice.dim) +
                            " (m, unit of the property), with commas between "
                            "them" +
                            decimals_with_a_point);

        Measurement measurement;
        std::copy_n(numbers.begin(), lattice.dim, measurement.position.begin());
        measurement.value = numbers.back();
        measurement.line  = number;
        check_inside(measurement, lattice, where);
        measurement.cell = lattice.cell_of(measurement.position);
        measurements.push_back(measurement);
      }
    if (measurements.empty())
      throw UserError(file, "no measurements in it", "at least one");
    return measurements;
  }
} // namespace Waker
