// SPDX-License-Identifier: LGPL-2.1-or-later
#include "vtu.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <waker/base/hash.h>
#include <waker/output/files.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <zlib.h>

namespace Waker
{
  namespace
  {
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


    /// VTK's blocks: how many, their size, size of the last; sizes when
    /// compressed; and the data.
    std::string
    compressed(const void *const data, const std::size_t n_bytes)
    {
      constexpr std::size_t      largest = std::size_t(1) << 26;
      const auto                *source  = static_cast<const Bytef *>(data);
      std::vector<std::uint32_t> header  = {
         0, static_cast<std::uint32_t>(std::min(largest, n_bytes)), 0};
      std::vector<unsigned char> packed;
      for (std::size_t begin = 0; begin < n_bytes; begin += largest)
        {
          const std::size_t n     = std::min(largest, n_bytes - begin);
          const std::size_t start = packed.size();
          uLongf            size  = compressBound(n);
          packed.resize(start + size);
          const int status =
            compress2(&packed[start], &size, source + begin, n, Z_BEST_SPEED);
          AssertThrow(status == Z_OK, ExcMessage("zlib cannot compress"));
          packed.resize(start + size);
          ++header[0];
          header[2] = n;
          header.push_back(size);
        }
      std::vector<unsigned char> bytes(header.size() * sizeof(header[0]));
      std::memcpy(bytes.data(), header.data(), bytes.size());
      return Utilities::encode_base64(bytes) + Utilities::encode_base64(packed);
    }


    /// A <DataArray>. Without entries as text: some readers take an empty
    /// compressed array for a damaged one.
    template <typename T>
    std::string
    array(const char *const     type,
          const std::string    &attributes,
          const std::vector<T> &data)
    {
      std::string text = std::string("<DataArray type=\"") + type + "\"" +
                         attributes + " format=\"" +
                         (data.empty() ? "ascii" : "binary") + "\">\n";
      if (!data.empty())
        text += compressed(data.data(), data.size() * sizeof(T));
      return text + "\n</DataArray>\n";
    }


    std::string
    name(const char *const text)
    {
      return std::string(" Name=\"") + text + "\"";
    }
  } // namespace


  VtuFile::VtuFile(const Cell cell)
    : cell(cell)
  {}


  void
  VtuFile::add_scalar(const std::string &name,
                      const std::string &unit,
                      const Type         type)
  {
    std::string safe = name;
    std::replace(safe.begin(), safe.end(), ' ', '_');
    fields.push_back({safe, unit, type, 1});
    ++row_length;
  }


  void
  VtuFile::add_vector(const std::string &name, const std::string &unit)
  {
    add_scalar(name, unit);
    fields.back().n_components = 3;
    row_length += 2;
  }


  template <int dim>
  void
  VtuFile::add_point(const Point<dim> &x)
  {
    AssertDimension(values.size() * 3, positions.size() * row_length);
    for (unsigned int d = 0; d < 3; ++d)
      positions.push_back(d < dim ? x[d] : 0.);
  }


  void
  VtuFile::add_value(const double value)
  {
    values.push_back(value);
  }


  template <int dim>
  void
  VtuFile::add_value(const Tensor<1, dim> &value)
  {
    for (unsigned int d = 0; d < 3; ++d)
      values.push_back(d < dim ? value[d] : 0.);
  }


  void
  VtuFile::end_polyline()
  {
    Assert(cell == Cell::polyline, ExcInternalError());
    polyline_ends.push_back(static_cast<std::int64_t>(positions.size() / 3));
  }


  std::vector<std::int64_t>
  VtuFile::cell_ends() const
  {
    if (cell == Cell::polyline)
      return polyline_ends;
    const std::size_t  n_points = positions.size() / 3;
    const unsigned int n        = n_vertices(cell);
    AssertDimension(n_points % n, 0);
    std::vector<std::int64_t> ends(n_points / n);
    for (std::size_t k = 0; k < ends.size(); ++k)
      ends[k] = static_cast<std::int64_t>((k + 1) * n);
    return ends;
  }


  std::string
  VtuFile::field_data(const Field &field, const unsigned int first) const
  {
    const std::size_t n_points = positions.size() / 3;
    const auto        collect  = [&](auto &data) {
      using T = typename std::decay_t<decltype(data)>::value_type;
      data.reserve(n_points * field.n_components);
      for (std::size_t p = 0; p < n_points; ++p)
        for (unsigned int c = 0; c < field.n_components; ++c)
          data.push_back(static_cast<T>(values[p * row_length + first + c]));
    };
    std::string attributes = name(escaped(field.name).c_str());
    if (field.n_components > 1)
      attributes +=
        " NumberOfComponents=\"" + std::to_string(field.n_components) + "\"";
    if (!field.unit.empty())
      attributes += " units=\"" + escaped(field.unit) + "\"";
    if (field.type == Type::real)
      {
        std::vector<float> data;
        collect(data);
        return array("Float32", attributes, data);
      }
    if (field.type == Type::number)
      {
        std::vector<std::int32_t> data;
        collect(data);
        return array("Int32", attributes, data);
      }
    std::vector<std::int64_t> data;
    collect(data);
    return array("Int64", attributes, data);
  }


  std::string
  VtuFile::write(const double time, const std::string &path) const
  {
    const std::size_t n_points = positions.size() / 3;
    AssertDimension(values.size(), n_points * row_length);

    std::vector<std::int64_t> connectivity(n_points);
    for (std::size_t p = 0; p < n_points; ++p)
      connectivity[p] = p;
    std::vector<std::int64_t>  offsets = cell_ends();
    std::vector<unsigned char> types(offsets.size(),
                                     static_cast<unsigned char>(cell));
    if (offsets.empty())
      {
        // A polygon without corners: the one cell that both ParaView and
        // meshio read without any point.
        offsets = {0};
        types   = {7};
      }

    char time_text[32];
    std::snprintf(time_text, sizeof time_text, "%.17g", time);
    std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
      "compressor=\"vtkZLibDataCompressor\" byte_order=\"LittleEndian\">\n"
      "<UnstructuredGrid>\n"
      "<FieldData>\n"
      "<DataArray type=\"Float64\" Name=\"TIME\" NumberOfTuples=\"1\" "
      "format=\"ascii\">";
    text += time_text;
    text +=
      "</DataArray>\n</FieldData>\n<Piece NumberOfPoints=\"" +
      std::to_string(n_points) + "\" NumberOfCells=\"" +
      std::to_string(offsets.size()) + "\">\n<Points>\n" +
      array("Float64", " NumberOfComponents=\"3\" units=\"m\"", positions) +
      "</Points>\n<Cells>\n" +
      array("Int64", name("connectivity"), connectivity) +
      array("Int64", name("offsets"), offsets) +
      array("UInt8", name("types"), types) + "</Cells>\n<PointData>\n";
    unsigned int first = 0;
    for (const Field &field : fields)
      {
        text += field_data(field, first);
        first += field.n_components;
      }
    text += "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    write_file(path, text);
    return checksum_of_text(text);
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
