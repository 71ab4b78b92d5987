// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_particle_writer_h
#define waker_output_particle_writer_h

#include <deal.II/base/tensor.h>

#include <waker/base/own_rows.h>
#include <waker/particles/material_points.h>

#include <string>
#include <vector>

namespace Waker
{
  using namespace dealii;

  /// A vector per point that is not among the points' arrays. The pointer is
  /// borrowed.
  template <int dim>
  struct PointVector
  {
    std::string                        name;
    std::string                        unit;
    const std::vector<Tensor<1, dim>> *values; // n_points long
  };

  template <int dim>
  using PointVectors = std::vector<PointVector<dim>>;

  /**
   * Write the material points to a .vtu file, one vertex cell per point.
   *
   * Fields: id, material, mass, volume, displacement and velocity (vectors),
   * stress_xx, _yy, _zz, _xy, _xz, _yz (kPa, tension positive), mean_stress
   * p = -tr(stress) / 3 (kPa, compression positive), deviatoric_stress
   * q = sqrt(3 J2) (kPa), and every scalar of the points, spaces in its name
   * replaced by underscores: plastic_strain, undrained_shear_strength, ...; and
   * `vectors`.
   *
   * Positions are stored in double precision, fields in single, id and
   * material as whole numbers: these files are for looking.
   *
   * Ranks that share the points write the one file together, each what is in
   * its range of them (RowsInOrder): it does not depend on who has which, nor
   * on their number. Collective.
   *
   * @param points of this rank
   * @param rows which of all points these are
   * @param time of the state (s), stored in the file
   * @param path the same on all ranks
   * @return checksum_of_text() of the file, for PvdSeries::add()
   * @throws as throw_cannot_write(), on all ranks
   */
  template <int dim>
  std::string
  write_particles(const MaterialPoints<dim> &points,
                  const OwnRows             &rows,
                  const double               time,
                  const std::string         &path,
                  const PointVectors<dim>   &vectors = {});

  /// All points, by a rank that is alone.
  template <int dim>
  std::string
  write_particles(const MaterialPoints<dim> &points,
                  const double               time,
                  const std::string         &path,
                  const PointVectors<dim>   &vectors = {})
  {
    return write_particles(
      points, OwnRows(points.id.size()), time, path, vectors);
  }
} // namespace Waker

#endif
