// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/grid/background_grid.h>
#include <waker/output/grid_writer.h>

#include "vtu.h"
#include <array>

namespace Waker
{
  namespace
  {
    /// Steps in node numbers from a cell's lower left node to its vertices, in
    /// VTK's order: around the lower face, then around the upper one.
    template <int dim>
    std::array<unsigned int, (1 << dim)>
    vertex_offsets(const BackgroundGrid<dim> &grid)
    {
      std::array<unsigned int, (1 << dim)> offsets{};
      for (unsigned int v = 0; v < offsets.size(); ++v)
        for (unsigned int d = 0; d < dim; ++d)
          if (((v ^ (d == 0 ? (v >> 1) & 1u : 0u)) >> d) & 1u)
            offsets[v] += grid.stride(d);
      return offsets;
    }
  } // namespace


  template <int dim>
  std::string
  write_grid(const BackgroundGrid<dim> &grid,
             const std::vector<double> &node_mass,
             const GridFields          &data,
             const double               time,
             const std::string         &path)
  {
    AssertDimension(node_mass.size(), grid.n_nodes());

    VtuFile file(dim == 2 ? VtuFile::Cell::quadrilateral
                          : VtuFile::Cell::hexahedron);
    file.add_scalar("mass", "Mg");
    for (const GridFields::Scalar &scalar : data.scalars)
      {
        AssertDimension(scalar.values->size(), grid.n_nodes());
        file.add_scalar(scalar.name, scalar.unit);
      }
    for (const GridFields::Vector &vector : data.vectors)
      {
        AssertDimension(vector.values->size(), grid.n_dofs());
        file.add_vector(vector.name, vector.unit);
      }

    const auto offsets = vertex_offsets(grid);
    for (unsigned int node = 0; node < grid.n_nodes(); ++node)
      {
        // The cell above and to the right of this node, if there is one.
        const auto index   = grid.node_index(node);
        bool       is_cell = true;
        for (unsigned int d = 0; d < dim; ++d)
          is_cell =
            is_cell &&
            index[d] + 1 < static_cast<int>(grid.n_nodes_per_direction()[d]);
        if (!is_cell)
          continue;
        bool has_mass = false;
        for (const unsigned int offset : offsets)
          has_mass = has_mass || node_mass[node + offset] > 0.;
        if (!has_mass)
          continue;

        for (const unsigned int offset : offsets)
          {
            const unsigned int i = node + offset;
            file.add_point(grid.node_position(i));
            file.add_value(node_mass[i]);
            for (const GridFields::Scalar &scalar : data.scalars)
              file.add_value((*scalar.values)[i]);
            for (const GridFields::Vector &vector : data.vectors)
              {
                Tensor<1, dim> value;
                for (unsigned int d = 0; d < dim; ++d)
                  value[d] = vector.values->local_element(dim * i + d);
                file.add_value(value);
              }
          }
      }
    return file.write(time, path);
  }


  template std::string
  write_grid(const BackgroundGrid<2> &,
             const std::vector<double> &,
             const GridFields &,
             const double,
             const std::string &);
  template std::string
  write_grid(const BackgroundGrid<3> &,
             const std::vector<double> &,
             const GridFields &,
             const double,
             const std::string &);
} // namespace Waker
