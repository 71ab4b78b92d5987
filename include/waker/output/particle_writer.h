// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_particle_writer_h
#define waker_output_particle_writer_h

#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace Waker
{
  using namespace dealii;

  template <int dim>
  struct MaterialPoints;

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
   * @param time of the state (s), stored in the file
   * @return checksum_of_text() of the file, for PvdSeries::add()
   */
  template <int dim>
  std::string
  write_particles(const MaterialPoints<dim> &points,
                  const double               time,
                  const std::string         &path,
                  const PointVectors<dim>   &vectors = {});
} // namespace Waker

#endif
