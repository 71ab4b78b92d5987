// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_output_vtu_h
#define waker_source_output_vtu_h

#include <deal.II/base/data_out_base.h>

#include <waker/output/files.h>

#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace Waker
{
  using namespace dealii;

  /**
   * What the writers share: the names of the components of patches' data, and
   * the way to a file. Private to the room, since deal.II's header is heavy.
   */
  class VtuFields
  {
  public:
    void
    add_scalar(std::string name, const std::string &unit)
    {
      for (char &c : name)
        if (c == ' ')
          c = '_';
      if (!unit.empty())
        units[name] = unit;
      names.push_back(name);
    }

    /// `dim` components that ParaView sees as one vector of three.
    void
    add_vector(std::string        name,
               const std::string &unit,
               const unsigned int dim)
    {
      const unsigned int first = names.size();
      for (unsigned int d = 0; d < dim; ++d)
        add_scalar(name, unit);
      name = names.back();
      ranges.emplace_back(
        first,
        first + dim - 1,
        name,
        DataComponentInterpretation::component_is_part_of_vector);
    }

    unsigned int
    n_components() const
    {
      return names.size();
    }

    /// Without a date in it: the same state makes the same file.
    template <int cell_dim, int dim>
    void
    write(const std::vector<DataOutBase::Patch<cell_dim, dim>> &patches,
          const double                                          time,
          const std::string                                    &path) const
    {
      const DataOutBase::VtkFlags flags(
        time,
        std::numeric_limits<unsigned int>::min(),
        /*print_date_and_time =*/false,
        DataOutBase::VtkFlags::best_speed,
        /*write_higher_order_cells =*/false,
        units);
      std::ostringstream out;
      DataOutBase::write_vtu(patches, names, ranges, flags, out);
      write_file(path, out.str());
    }

  private:
    using Range =
      std::tuple<unsigned int,
                 unsigned int,
                 std::string,
                 DataComponentInterpretation::DataComponentInterpretation>;

    std::vector<std::string>           names;
    std::vector<Range>                 ranges;
    std::map<std::string, std::string> units;
  };
} // namespace Waker

#endif
