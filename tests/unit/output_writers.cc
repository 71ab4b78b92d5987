// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/utilities.h>

#include <waker/grid/background_grid.h>
#include <waker/loads/water_load.h>
#include <waker/output/grid_writer.h>
#include <waker/output/particle_writer.h>
#include <waker/output/surface_writer.h>
#include <waker/particles/material_points.h>
#include <waker/surface/shape/surface.h>

#include "output_temporary_folder.h"
#include <cstring>
#include <gtest/gtest.h>

namespace Waker::output_writers
{
  namespace
  {
    bool
    contains(const std::string &text, const std::string &part)
    {
      return text.find(part) != std::string::npos;
    }


    /// Bytes, before compression, of a <DataArray> whose tag contains `tag`:
    /// the second of four 32-bit numbers in front of its data.
    unsigned int
    n_bytes(const std::string &vtu, const std::string &tag)
    {
      const std::size_t at = vtu.find(tag);
      if (at == std::string::npos)
        return 0;
      // "<Points>" has no name; its array is the one that follows.
      const std::size_t array = tag[0] == '<' ? vtu.find("<DataArray", at) : at;
      const std::size_t begin =
        vtu.find_first_not_of(" \n", vtu.find('>', array) + 1);
      const std::vector<unsigned char> header =
        Utilities::decode_base64(vtu.substr(begin, 24));
      unsigned int numbers[4];
      std::memcpy(numbers, header.data(), sizeof(numbers));
      return numbers[0] == 1 ? numbers[1] : 0;
    }


    std::string
    piece(const unsigned int n_points, const unsigned int n_cells)
    {
      return "NumberOfPoints=\"" + std::to_string(n_points) +
             "\" NumberOfCells=\"" + std::to_string(n_cells) + "\"";
    }


    template <int dim>
    MaterialPoints<dim>
    make_points(const unsigned int n)
    {
      MaterialPoints<dim> points;
      for (unsigned int p = 0; p < n; ++p)
        {
          points.id.push_back(100 + p);
          points.material.push_back(0);
          points.mass.push_back(1.);
          points.volume.push_back(0.5);
          Point<dim> x;
          x[0] = p;
          points.initial_position.push_back(x);
          x[1] = 0.5;
          points.position.push_back(x);
          points.velocity.emplace_back();
          points.acceleration.emplace_back();
          points.half_size.emplace_back();
          points.stress.emplace_back();
        }
      points.scalar("undrained shear strength", 13.);
      return points;
    }


    template <int dim>
    void
    test_particles()
    {
      const TemporaryFolder folder;
      const std::string     path = folder.file("particles.vtu");
      const unsigned int    n    = 7;
      write_particles(make_points<dim>(n), 1.5, path);
      const std::string vtu = get(path);

      EXPECT_TRUE(contains(vtu, piece(n, n)));
      EXPECT_EQ(n_bytes(vtu, "Name=\"types\""), n);
      EXPECT_EQ(n_bytes(vtu, "Name=\"undrained_shear_strength\""), 4 * n);
      for (const char *const name : {"displacement", "velocity"})
        EXPECT_EQ(n_bytes(vtu, std::string("Name=\"") + name + "\""),
                  3 * 4 * n);
      for (const char *const name :
           {"material", "stress_xy", "mean_stress", "deviatoric_stress"})
        EXPECT_EQ(n_bytes(vtu, std::string("Name=\"") + name + "\""), 4 * n);
      EXPECT_EQ(n_bytes(vtu, "Name=\"id\""), 8 * n);
      EXPECT_EQ(n_bytes(vtu, "<Points>"), 8 * 3 * n);
      EXPECT_TRUE(contains(vtu, "</VTKFile>"));
    }
  } // namespace


  TEST(Output, particles_are_vertex_cells)
  {
    test_particles<2>();
    test_particles<3>();
  }


  TEST(Output, the_same_points_make_the_same_file)
  {
    const TemporaryFolder folder;
    write_particles(make_points<2>(5), 1., folder.file("a.vtu"));
    write_particles(make_points<2>(5), 1., folder.file("b.vtu"));
    EXPECT_EQ(get(folder.file("a.vtu")), get(folder.file("b.vtu")));
  }


  TEST(Output, surface_is_written_as_lines)
  {
    const TemporaryFolder folder;
    Surface               surface;
    surface.chains.resize(2);
    surface.chains[0].vertices = {{0., 0.}, {4., 0.}, {2., 2.}};
    surface.chains[0].on_face  = {2, -1, -1};
    surface.chains[1].vertices = {{5., 0.}, {6., 0.}, {6., 1.}, {5., 1.}};
    surface.chains[1].on_face  = {2, -1, -1, -1};
    const Facet<2> wetted = make_facet<2>({{Point<2>(), Point<2>(1., 1.)}});
    write_surface<2>(
      to_facets(surface), {wetted}, {}, 0., folder.file("surface.vtu"));

    const std::string vtu = get(folder.file("surface.vtu"));
    EXPECT_TRUE(contains(vtu, piece(2 * 8, 8)));
    EXPECT_EQ(n_bytes(vtu, "Name=\"types\""), 8u);
    for (const char *const name : {"chain", "on_face", "wetted", "pressure"})
      EXPECT_EQ(n_bytes(vtu, std::string("Name=\"") + name + "\""), 4 * 16u);
  }


  template <int dim>
  void
  test_grid(const Point<dim> &upper)
  {
    const TemporaryFolder     folder;
    const BackgroundGrid<dim> grid(Point<dim>(), upper, 1., MPI_COMM_SELF);
    std::vector<double>       mass(grid.n_nodes(), 0.);
    typename BackgroundGrid<dim>::Index inside;
    inside.fill(2);
    mass[grid.node(inside)] = 1.; // touches 2^dim cells
    NodalVector velocity(grid.n_dofs());
    GridFields  fields;
    fields.scalars = {{"proximity field", "", &mass}};
    fields.vectors = {{"velocity", "m/s", &velocity}};
    write_grid(grid, mass, fields, 0., folder.file("grid.vtu"));

    const std::string  vtu      = get(folder.file("grid.vtu"));
    const unsigned int n_cells  = 1 << dim;
    const unsigned int n_points = n_cells * n_cells;
    EXPECT_TRUE(contains(vtu, piece(n_points, n_cells)));
    EXPECT_EQ(n_bytes(vtu, "Name=\"types\""), n_cells);
    EXPECT_EQ(n_bytes(vtu, "Name=\"mass\""), 4 * n_points);
    EXPECT_EQ(n_bytes(vtu, "Name=\"proximity_field\""), 4 * n_points);
    EXPECT_EQ(n_bytes(vtu, "Name=\"velocity\""), 3 * 4 * n_points);
  }


  TEST(Output, grid_is_written_where_there_is_mass)
  {
    test_grid<2>(Point<2>(4., 3.));
    test_grid<3>(Point<3>(4., 3., 2.));
  }


  TEST(Output, grid_without_mass_is_an_empty_file_not_an_error)
  {
    const TemporaryFolder   folder;
    const BackgroundGrid<2> grid(Point<2>(),
                                 Point<2>(2., 2.),
                                 1.,
                                 MPI_COMM_SELF);
    write_grid(grid,
               std::vector<double>(grid.n_nodes(), 0.),
               {},
               0.,
               folder.file("grid.vtu"));
    const std::string vtu = get(folder.file("grid.vtu"));
    EXPECT_TRUE(contains(vtu, piece(0, 1)));
    EXPECT_TRUE(contains(vtu, "Name=\"mass\""));
    EXPECT_EQ(n_bytes(vtu, "Name=\"types\""), 1u);
  }


  TEST(Output, names_are_written_as_xml_wants_them)
  {
    const TemporaryFolder folder;
    MaterialPoints<2>     points = make_points<2>(3);
    points.scalar("load_wind & \"golf\" <1>_x", 1.);
    write_particles(points, 0., folder.file("particles.vtu"));
    EXPECT_TRUE(
      contains(get(folder.file("particles.vtu")),
               "Name=\"load_wind_&amp;_&quot;golf&quot;_&lt;1&gt;_x\""));
  }
} // namespace Waker::output_writers
