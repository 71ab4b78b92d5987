// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_weight_load_h
#define waker_loads_weight_load_h

#include <waker/mapping/weights.h>
#include <waker/nodes/nodal_vector.h>
#include <waker/particles/material_points.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  using namespace dealii;

  /// Which points carry what is built up on a rectangle.
  enum class LoadedPoints
  {
    top,   // those at the surface
    column // all below it
  };

  constexpr const char *
  name_of(const LoadedPoints choice)
  {
    switch (choice)
      {
        case LoadedPoints::top:
          return "top";
        case LoadedPoints::column:
          return "column";
      }
    return nullptr;
  }


  /// Has what is built up inertia?
  enum class LoadMass
  {
    weight_alone,
    with_mass
  };

  constexpr const char *
  name_of(const LoadMass choice)
  {
    switch (choice)
      {
        case LoadMass::weight_alone:
          return "weight alone";
        case LoadMass::with_mass:
          return "with mass";
      }
    return nullptr;
  }


  /// Soil (or anything else) that is built up on a rectangle, as additional
  /// weight of the points below it.
  struct WeightLoadParameters
  {
    /// Of the rectangle, seen from above (m): x; in 3D x, z.
    std::vector<double> from;
    std::vector<double> to;
    double              unit_weight = 20.; // kN/m^3
    LoadedPoints        points      = LoadedPoints::top;
    LoadMass            mass        = LoadMass::weight_alone;

    void
    add_parameters(ParameterHandler &prm);

    /// @throws UserError `path` + "From", "To", "Unit weight"
    void
    check(const unsigned int dim, const std::string &path) const;

    /// Area of the rectangle (m^(dim-1)).
    double
    area() const;
  };


  /**
   * Weight (kN) that each point gets from a metre of soil on the rectangle.
   *
   * Every part of the rectangle loads the points whose support domain lies
   * below it, the highest one or all by their volume: the sum is unit weight
   * times area, however rectangle and points lie to each other.
   *
   * @throws UserError `path` + "From" if there is a part without soil below, or
   *         if the soil there is not level to within a cell
   */
  template <int dim>
  std::vector<double>
  weight_per_metre(const WeightLoadParameters &parameters,
                   const std::string          &path,
                   const double                cell_size,
                   const MaterialPoints<dim>  &points);


  /// Add `factor` times the weights of the points, as the points' own weight
  /// acts (eq. 2.27 of Remmerswaal 2023), along -y.
  /// @param weight of each point (kN)
  template <int dim>
  void
  add_weight(const std::vector<double> &weight,
             const double               factor,
             const Weights<dim>        &weights,
             NodalVector               &force);
} // namespace Waker

#endif
