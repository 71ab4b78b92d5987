// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_source_output_vtu_h
#define waker_source_output_vtu_h

#include <deal.II/base/point.h>

#include <waker/base/own_rows.h>

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
   * Data are compressed (zlib, inline, base64), so many points at a time
   * (points_per_block). Nothing in the file depends on the date, or on how many
   * ranks write it: the same state makes the same file.
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

    /// So many points will come.
    void
    reserve(const std::size_t n_points);

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

    /// The same of points that ranks share: all ranks write the one file
    /// together. Not of polylines. Collective.
    /// @param rows which of all points have been added here
    std::string
    write(const double       time,
          const std::string &path,
          const OwnRows     &rows) const;

  private:
    struct Field
    {
      std::string       name;
      std::string       unit;
      Type              type;
      unsigned int      n_components; // in the file
      std::vector<char> data;         // of all points so far
    };

    std::size_t
    n_points() const;

    /// Of cells that begin at these points of this rank.
    std::vector<std::int64_t>
    cell_ends(const RowsInOrder &rows) const;

    Cell                      cell;
    std::vector<Field>        fields;
    unsigned int              next_field = 0, next_component = 0;
    std::vector<char>         positions;     // three doubles per point
    std::vector<std::int64_t> polyline_ends; // points before each end
  };
} // namespace Waker

#endif
