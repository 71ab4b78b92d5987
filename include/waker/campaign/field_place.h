// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_field_place_h
#define waker_campaign_field_place_h

#include <waker/case/case.h>
#include <waker/fields/lattice.h>

#include <array>
#include <string>
#include <vector>

namespace Waker
{
  template <int dim>
  std::array<double, 3>
  coordinates(const Point<dim> &x)
  {
    std::array<double, 3> result{};
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = x[d];
    return result;
  }


  /// Coordinates (m) in the lattice of a field: of a section in space.
  template <int dim>
  std::array<double, 3>
  field_coordinates(const Case<dim> &the_case, const Point<dim> &x);


  /**
   * Where the points of a case are in its random fields. Those of a section are
   * part of the fields of the case in space, in the layer of cells that begins
   * at its z or holds it.
   */
  template <int dim>
  class FieldPlace
  {
  public:
    /// @param the_case must outlive this object
    explicit FieldPlace(const Case<dim> &the_case);

    /// The cells that hold all points: aligned with the grid, by default its
    /// sub-cells, so that each support domain has its own (with Placement =
    /// rows: nearly).
    /// @param path of the field, "Random fields/strength"
    /// @throws UserError path + "/Cell size" if there are too many
    FieldLattice
    lattice(const std::vector<double> &cell_size,
            const std::string         &path) const;

    std::array<double, 3>
    of(const Point<dim> &x) const
    {
      return field_coordinates(*the_case, x);
    }

  private:
    const Case<dim>  *the_case;
    MaterialPoints<3> in_space; // if the case is a section
  };
} // namespace Waker

#endif
