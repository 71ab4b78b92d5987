// SPDX-License-Identifier: LGPL-2.1-or-later
#include "vtu.h"

#include <deal.II/base/exceptions.h>

#include <waker/base/ranks.h>

#include "data_array.h"
#include "joint_file.h"
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <numeric>

namespace Waker
{
  namespace
  {
    constexpr std::size_t position_size = 3 * sizeof(double);


    /// Of a cell; 0: it has any number.
    unsigned int
    n_vertices(const VtuFile::Cell cell)
    {
      switch (cell)
        {
          case VtuFile::Cell::vertex:
            return 1;
          case VtuFile::Cell::line:
            return 2;
          case VtuFile::Cell::polyline:
            return 0;
          case VtuFile::Cell::triangle:
            return 3;
          case VtuFile::Cell::quadrilateral:
            return 4;
          case VtuFile::Cell::hexahedron:
            return 8;
        }
      Assert(false, ExcInternalError());
      return 0;
    }


    std::string
    escaped(const std::string &text)
    {
      std::string result;
      for (const char c : text)
        switch (c)
          {
            case '&':
              result += "&amp;";
              break;
            case '<':
              result += "&lt;";
              break;
            case '>':
              result += "&gt;";
              break;
            case '"':
              result += "&quot;";
              break;
            default:
              result += c;
          }
      return result;
    }


    template <typename T>
    void
    append(const T value, std::vector<char> &data)
    {
      const char *const bytes = reinterpret_cast<const char *>(&value);
      data.insert(data.end(), bytes, bytes + sizeof(T));
    }


    template <typename T>
    std::vector<char>
    bytes_of(const std::vector<T> &values)
    {
      const char *const begin = reinterpret_cast<const char *>(values.data());
      return std::vector<char>(begin, begin + values.size() * sizeof(T));
    }


    std::string
    type_name(const VtuFile::Type type)
    {
      switch (type)
        {
          case VtuFile::Type::real:
            return "Float32";
          case VtuFile::Type::number:
            return "Int32";
          case VtuFile::Type::id:
            return "Int64";
        }
      Assert(false, ExcInternalError());
      return "";
    }


    /// Bytes of a value.
    std::size_t
    size_of(const VtuFile::Type type)
    {
      return type == VtuFile::Type::id ? 8 : 4;
    }
  } // namespace


  VtuFile::VtuFile(const Cell cell)
    : cell(cell)
  {}


  void
  VtuFile::reserve(const std::size_t n_points)
  {
    positions.reserve(n_points * position_size);
    for (Field &field : fields)
      field.data.reserve(n_points * field.n_components * size_of(field.type));
  }


  void
  VtuFile::add_scalar(const std::string &name,
                      const std::string &unit,
                      const Type         type)
  {
    std::string safe = name;
    std::replace(safe.begin(), safe.end(), ' ', '_');
    fields.push_back({safe, unit, type, 1, {}});
  }


  void
  VtuFile::add_vector(const std::string &name, const std::string &unit)
  {
    add_scalar(name, unit);
    fields.back().n_components = 3;
  }


  template <int dim>
  void
  VtuFile::add_point(const Point<dim> &x)
  {
    AssertDimension(next_field + next_component, 0);
    for (unsigned int d = 0; d < 3; ++d)
      append(d < dim ? x[d] : 0., positions);
  }


  void
  VtuFile::add_value(const double value)
  {
    Field &field = fields[next_field];
    switch (field.type)
      {
        case Type::real:
          append(static_cast<float>(value), field.data);
          break;
        case Type::number:
          append(static_cast<std::int32_t>(value), field.data);
          break;
        case Type::id:
          append(static_cast<std::int64_t>(value), field.data);
          break;
      }
    if (++next_component < field.n_components)
      return;
    next_component = 0;
    next_field     = (next_field + 1) % fields.size();
  }


  template <int dim>
  void
  VtuFile::add_value(const Tensor<1, dim> &value)
  {
    for (unsigned int d = 0; d < 3; ++d)
      add_value(d < dim ? value[d] : 0.);
  }


  void
  VtuFile::end_polyline()
  {
    Assert(cell == Cell::polyline, ExcInternalError());
    polyline_ends.push_back(static_cast<std::int64_t>(n_points()));
  }


  std::size_t
  VtuFile::n_points() const
  {
    return positions.size() / position_size;
  }


  std::vector<std::int64_t>
  VtuFile::cell_ends(const RowsInOrder &rows) const
  {
    if (cell == Cell::polyline)
      return polyline_ends;
    const unsigned int n = n_vertices(cell);
    AssertDimension(rows.n_all % n, 0);
    std::vector<std::int64_t> ends;
    for (std::size_t p = rows.begin; p < rows.end; p += n)
      ends.push_back(static_cast<std::int64_t>(p + n));
    return ends;
  }


  std::string
  VtuFile::write(const double time, const std::string &path) const
  {
    return write(time, path, OwnRows(n_points()));
  }


  std::string
  VtuFile::write(const double       time,
                 const std::string &path,
                 const OwnRows     &own) const
  {
    AssertDimension(next_field + next_component, 0);
    const std::size_t n_in_cell = std::max(1u, n_vertices(cell));
    // Blocks of points are whole cells.
    Assert(own.numbers == nullptr ||
             (cell != Cell::polyline && points_per_block % n_in_cell == 0),
           ExcNotImplemented());
    const RowsInOrder         rows(own, points_per_block);
    std::vector<std::int64_t> connectivity(rows.end - rows.begin);
    std::iota(connectivity.begin(),
              connectivity.end(),
              static_cast<std::int64_t>(rows.begin));
    std::vector<std::int64_t>  ends = cell_ends(rows);
    std::vector<unsigned char> types(ends.size(),
                                     static_cast<unsigned char>(cell));
    std::size_t                n_cells =
      cell == Cell::polyline ? ends.size() : rows.n_all / n_in_cell;
    if (n_cells == 0)
      {
        // A polygon without corners: the one cell that both ParaView and
        // meshio read without any point.
        n_cells = 1;
        if (is_first_rank(own.communicator))
          {
            ends  = {0};
            types = {7};
          }
      }

    char time_text[32];
    std::snprintf(time_text, sizeof time_text, "%.17g", time);
    JointFile file(own.communicator, path);
    file.add_text(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
      "compressor=\"vtkZLibDataCompressor\" byte_order=\"LittleEndian\">\n"
      "<UnstructuredGrid>\n"
      "<FieldData>\n"
      "<DataArray type=\"Float64\" Name=\"TIME\" NumberOfTuples=\"1\" "
      "format=\"ascii\">" +
      std::string(time_text) +
      "</DataArray>\n</FieldData>\n<Piece NumberOfPoints=\"" +
      std::to_string(rows.n_all) + "\" NumberOfCells=\"" +
      std::to_string(n_cells) + "\">\n<Points>\n");
    const auto of_points = [&](const std::size_t size) {
      return DataRows{rows.n_all, points_per_block, size};
    };
    const auto of_cells = [&](const std::size_t size) {
      return DataRows{n_cells, points_per_block / n_in_cell, size};
    };
    std::vector<char> buffer;
    add_data_array("type=\"Float64\" NumberOfComponents=\"3\" units=\"m\"",
                   rows.values(positions, position_size, buffer),
                   of_points(position_size),
                   file);
    file.add_text("</Points>\n<Cells>\n");
    add_data_array("type=\"Int64\" Name=\"connectivity\"",
                   bytes_of(connectivity),
                   of_points(8),
                   file);
    add_data_array("type=\"Int64\" Name=\"offsets\"",
                   bytes_of(ends),
                   of_cells(8),
                   file);
    add_data_array("type=\"UInt8\" Name=\"types\"",
                   bytes_of(types),
                   of_cells(1),
                   file);
    file.add_text("</Cells>\n<PointData>\n");
    for (const Field &field : fields)
      {
        std::string attributes = "type=\"" + type_name(field.type) +
                                 "\" Name=\"" + escaped(field.name) + "\"";
        if (field.n_components > 1)
          attributes += " NumberOfComponents=\"" +
                        std::to_string(field.n_components) + "\"";
        if (!field.unit.empty())
          attributes += " units=\"" + escaped(field.unit) + "\"";
        const std::size_t size = field.n_components * size_of(field.type);
        add_data_array(attributes,
                       rows.values(field.data, size, buffer),
                       of_points(size),
                       file);
      }
    file.add_text("</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
    return file.write();
  }


  template void
  VtuFile::add_point(const Point<2> &);
  template void
  VtuFile::add_point(const Point<3> &);
  template void
  VtuFile::add_value(const Tensor<1, 2> &);
  template void
  VtuFile::add_value(const Tensor<1, 3> &);
} // namespace Waker
