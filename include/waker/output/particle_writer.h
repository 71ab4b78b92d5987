// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_output_particle_writer_h
#define waker_output_particle_writer_h

#include <string>

namespace Waker
{
  template <int dim>
  struct MaterialPoints;

  /**
   * Write the material points to a .vtu file, one vertex cell per point.
   *
   * Fields: id, material, mass, volume, displacement and velocity (vectors),
   * stress_xx, _yy, _zz, _xy, _xz, _yz (kPa, tension positive), mean_stress
   * p = -tr(stress) / 3 (kPa, compression positive), deviatoric_stress
   * q = sqrt(3 J2) (kPa), and every scalar of the points, spaces in its name
   * replaced by underscores: plastic_strain, undrained_shear_strength, ...
   *
   * Numbers are stored in single precision: these files are for looking.
   *
   * @param time of the state (s), stored in the file
   */
  template <int dim>
  void
  write_particles(const MaterialPoints<dim> &points,
                  const double               time,
                  const std::string         &path);
} // namespace Waker

#endif
