// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/particles/feeder.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Waker
{
  namespace
  {
    /// In sub-cells: round-off of a time must not delay a row by a step.
    constexpr double round_off = 1e-9;
  } // namespace


  template <int dim>
  Feeder<dim>::Feeder(const BackgroundGrid<dim> &grid,
                      const InflowParameters    &parameters,
                      const unsigned int         n_points_1d,
                      const unsigned int         material,
                      const double               density,
                      const Variables           &variables)
    : h(grid.cell_size())
    , n_points_1d(n_points_1d)
    , direction(parameters.face_number() / 2)
    , inwards(parameters.face_number() % 2 == 0 ? 1. : -1.)
    , material(material)
    , density(density)
    , variables(variables)
    , opening(place_opening(grid, parameters, "Inflow/" + parameters.name))
  {
    inward[direction] = inwards * parameters.velocity;
  }


  template <int dim>
  void
  Feeder<dim>::fill(MaterialPoints<dim> &points, std::uint64_t &next_id) const
  {
    for (unsigned int row = 0; row < n_points_1d; ++row)
      append_row(h * (row + 1) / n_points_1d, points, next_id);
  }


  template <int dim>
  std::size_t
  Feeder<dim>::feed(const double         t,
                    std::uint64_t       &rows,
                    MaterialPoints<dim> &points,
                    std::uint64_t       &next_id) const
  {
    const std::size_t n_before = points.n_points();
    const double      advanced = inward.norm() * t * n_points_1d / h; // rows
    while (rows + 1 <= advanced + round_off)
      {
        ++rows;
        const double ahead = std::max(0., advanced - rows);
        append_row(h * (1. - ahead / n_points_1d), points, next_id);
      }
    return points.n_points() - n_before;
  }


  template <int dim>
  void
  Feeder<dim>::append_row(const double         depth,
                          MaterialPoints<dim> &points,
                          std::uint64_t       &next_id) const
  {
    const double                  size = h / n_points_1d;
    std::array<unsigned int, dim> n;
    std::size_t                   n_row = 1;
    for (unsigned int d = 0; d < dim; ++d)
      {
        n[d] = d == direction
                 ? 1
                 : std::lround((opening.upper[d] - opening.lower[d]) / size);
        n_row *= n[d];
      }

    const std::size_t first = points.n_points();
    // Zero; what the case does not have stays empty.
    if (first == 0)
      points.resize(n_row);
    else
      MaterialPoints<dim>::for_each_array(points,
                                          [&](const char *, auto &array) {
                                            if (!array.empty())
                                              array.resize(first + n_row);
                                          });

    for (std::size_t k = 0; k < n_row; ++k)
      {
        const std::size_t p = first + k;
        Point<dim>        x;
        std::size_t       rest = k;
        for (unsigned int d = 0; d < dim; ++d)
          {
            x[d] = d == direction
                     ? opening.lower[d] - inwards * (depth - 0.5 * size)
                     : opening.lower[d] + (rest % n[d] + 0.5) * size;
            rest /= n[d];
          }
        points.id[p]       = next_id++;
        points.material[p] = material;
        points.volume[p]   = std::pow(size, dim);
        points.mass[p]     = density * points.volume[p];
        for (unsigned int d = 0; d < dim; ++d)
          points.half_size[p][d] = 0.5 * size;
        points.position[p]         = x;
        points.initial_position[p] = x;
        points.velocity[p]         = inward;
        if (!points.initial_half_size.empty())
          points.initial_half_size[p] = points.half_size[p];
        if (!points.deformation.empty())
          points.deformation[p] = Tensor<2, dim>(unit_symmetric_tensor<dim>());
      }
    for (const auto &[name, value] : variables)
      if (const int i = points.find_scalar(name); i >= 0)
        std::fill(points.scalars[i].values.begin() + first,
                  points.scalars[i].values.end(),
                  value);
  }


  template class Feeder<2>;
  template class Feeder<3>;
} // namespace Waker
