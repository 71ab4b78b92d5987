// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_particles_material_points_h
#define waker_particles_material_points_h

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace Waker
{
  using namespace dealii;

  /// A named scalar that a material keeps for each of its points.
  struct NamedArray
  {
    std::string         name;
    std::vector<double> values; // one per point
  };

  /**
   * The state of the material points: a structure of arrays, of length
   * n_points() or empty, indexed by the point's place in the arrays. A point is
   * known for ever by its `id`.
   *
   * `scalars` holds what the materials declare (Material::variables()): each
   * name appears once, whatever the number of materials that use it.
   *
   * The arrays that only some cases need are empty in the others: point loads,
   * and what a finite deformation is remembered by.
   */
  template <int dim>
  struct MaterialPoints
  {
    std::vector<std::uint64_t>         id;
    std::vector<std::uint32_t>         material;  // number in Case::materials
    std::vector<double>                mass;      // Mg (per m in 2D)
    std::vector<double>                volume;    // m^dim
    std::vector<Tensor<1, dim>>        half_size; // of the support domain, m
    std::vector<Point<dim>>            position;  // m
    std::vector<Point<dim>>            initial_position; // m
    std::vector<Tensor<1, dim>>        velocity;         // m/s
    std::vector<Tensor<1, dim>>        acceleration;     // m/s^2
    std::vector<SymmetricTensor<2, 3>> stress; // kPa, tension positive
    std::vector<NamedArray>            scalars;

    // Empty unless the case has them.
    std::vector<Tensor<1, dim>> load;              // dead load, kN
    std::vector<Tensor<1, dim>> initial_half_size; // m
    std::vector<Tensor<2, dim>> deformation;       // gradient F since t = 0

    std::size_t
    n_points() const
    {
      return id.size();
    }

    /// Make room for `n` points in the arrays that every case has.
    void
    resize(const std::size_t n)
    {
      for_each_array(*this, [&](const char *, auto &array) {
        if (static_cast<const void *>(&array) != &load &&
            static_cast<const void *>(&array) != &initial_half_size &&
            static_cast<const void *>(&array) != &deformation)
          array.resize(n);
      });
    }

    /// Number of a scalar in `scalars`, or -1 if no material declared it.
    int
    find_scalar(const std::string &name) const
    {
      for (unsigned int i = 0; i < scalars.size(); ++i)
        if (scalars[i].name == name)
          return i;
      return -1;
    }

    /// The scalar of this name. @throws std::out_of_range if there is none
    const std::vector<double> &
    scalar(const std::string &name) const
    {
      const int i = find_scalar(name);
      if (i < 0)
        throw std::out_of_range("no material keeps a scalar \"" + name +
                                "\" for its points");
      return scalars[i].values;
    }

    /// The scalar of this name; made, and filled with `value`, if it is new.
    std::vector<double> &
    scalar(const std::string &name, const double value = 0.)
    {
      const int i = find_scalar(name);
      if (i >= 0)
        return scalars[i].values;
      scalars.push_back({name, std::vector<double>(n_points(), value)});
      return scalars.back().values;
    }

    /// Call f(name, array) for every array of the points: what removal,
    /// checkpoints and migration loop over.
    template <typename Self, typename Function>
    static void
    for_each_array(Self &self, const Function &f)
    {
      f("id", self.id);
      f("material", self.material);
      f("mass", self.mass);
      f("volume", self.volume);
      f("half_size", self.half_size);
      f("position", self.position);
      f("initial_position", self.initial_position);
      f("velocity", self.velocity);
      f("acceleration", self.acceleration);
      f("stress", self.stress);
      f("load", self.load);
      f("initial half size", self.initial_half_size);
      f("deformation", self.deformation);
      for (auto &scalar : self.scalars)
        f(scalar.name.c_str(), scalar.values);
    }
  };
} // namespace Waker

#endif
