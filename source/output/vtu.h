// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_output_vtu_h
#define waker_source_output_vtu_h

#include <deal.II/base/point.h>

#include <cstdint>
#include <string>
#include <vector>

namespace Waker
{
  using namespace dealii;

  /**
   * A .vtu file: cells of one kind, each with points of its own (any number of
   * them in a polyline), and fields on the points. What the writers share;
   * private to the room.
   *
   * deal.II's writer stores positions in single precision, which is 16 mm at
   * x = 155,000 m, and leaves a file without cells in a form that readers
   * refuse. Here positions have double precision, fields the one that they are
   * given, and a file without cells holds one cell without points: ParaView
   * and meshio read it, with all its fields.
   *
   * Data are compressed (zlib, inline, base64). Nothing in the file depends on
   * the date: the same state makes the same file.
   */
  class VtuFile
  {
  public:
    /// The numbers are VTK's.
    enum class Cell : unsigned char
    {
      vertex        = 1,
      line          = 3,
      polyline      = 4,
      triangle      = 5,
      quadrilateral = 9,
      hexahedron    = 12
    };

    /// How a field is stored. Whole numbers are for what is counted or named:
    /// programs that draw need not guess.
    enum class Type
    {
      real,   // single precision
      number, // 32 bits
      id      // 64 bits
    };

    explicit VtuFile(const Cell cell);

    /// @param name blanks become "_", what XML does not allow is replaced by
    ///        its entities
    /// @param unit may be empty
    void
    add_scalar(const std::string &name,
               const std::string &unit,
               const Type         type = Type::real);

    /// Two or three components; it is written with three.
    void
    add_vector(const std::string &name, const std::string &unit);

    /// Begin the next point (m); the points of a cell follow each other, in
    /// VTK's order. Its fields come next, all of them, in the order in which
    /// they were added.
    template <int dim>
    void
    add_point(const Point<dim> &x);

    void
    add_value(const double value);

    template <int dim>
    void
    add_value(const Tensor<1, dim> &value);

    /// The polyline that the last points belong to ends here.
    void
    end_polyline();

    /// @param time of the state (s), stored in the file
    /// @return checksum_of_text() of the file
    /// @throws as throw_cannot_write() if it cannot be written
    std::string
    write(const double time, const std::string &path) const;

  private:
    struct Field
    {
      std::string  name;
      std::string  unit;
      Type         type;
      unsigned int n_components; // in the file
    };

    std::string
    field_data(const Field &field, const unsigned int first) const;

    std::vector<std::int64_t>
    cell_ends() const;

    Cell                      cell;
    std::vector<Field>        fields;
    unsigned int              row_length = 0;
    std::vector<double>       positions;     // three per point
    std::vector<double>       values;        // row_length per point
    std::vector<std::int64_t> polyline_ends; // points before each end
  };
} // namespace Waker

#endif
